# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# What this project's own programs are compiled with beside what its headers ask of everybody
# (vcg_ext/CMakeLists.txt): warnings, sanitizers, and no -march=native, so that every processor of an architecture
# gives the same bits.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE_PROGRAM ccache)
mark_as_advanced(CCACHE_PROGRAM)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(project_options INTERFACE)
target_compile_options(project_options INTERFACE
    -Wall -Wextra -Wshadow -Wconversion $<$<BOOL:${LAPLACIAN_SIMPLIFY_WARNINGS_AS_ERRORS}>:-Werror>)
if(LAPLACIAN_SIMPLIFY_SANITIZE)
    # Left out of "undefined" is what stops a program anyway or what "address" finds: null, misaligned and foreign
    # memory. It made compiling two and a half times as long. "address" checks by
    # calls instead of in place: the same errors, and compiling takes a little more than half as long.
    target_compile_options(project_options INTERFACE
        -fsanitize=${LAPLACIAN_SIMPLIFY_SANITIZE} -fno-sanitize-recover=undefined -fno-omit-frame-pointer
        -fno-sanitize=null,alignment,object-size,pointer-overflow
        $<$<CXX_COMPILER_ID:GNU>:SHELL:--param asan-instrumentation-with-call-threshold=0>)
    target_link_options(project_options INTERFACE -fsanitize=${LAPLACIAN_SIMPLIFY_SANITIZE})
endif()
