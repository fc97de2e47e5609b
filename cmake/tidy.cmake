# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Target "tidy": clang-tidy over the sources that were named with analyse_sources(), each again only after it or a
# header of the project has changed. It is the one of the project's Python environment (scripts/lib/python.sh): other
# versions find other things.
set(cache_home "$ENV{XDG_CACHE_HOME}")
if(NOT cache_home)
    set(cache_home "$ENV{HOME}/.cache")
endif()
unset(CLANG_TIDY_PROGRAM CACHE) # an older tree may remember another one
find_program(CLANG_TIDY_PROGRAM clang-tidy PATHS ${cache_home}/laplacian-simplify/python/bin NO_DEFAULT_PATH)
mark_as_advanced(CLANG_TIDY_PROGRAM)

# Where omp.h is; the other headers there come after Clang's own.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=include
    OUTPUT_VARIABLE compiler_headers OUTPUT_STRIP_TRAILING_WHITESPACE)
add_custom_target(tidy)

# analyse_sources(<target>): the .cpp files of the target. No-op where there is no clang-tidy.
function(analyse_sources target)
    if(NOT CLANG_TIDY_PROGRAM)
        return()
    endif()
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/vcg_ext/*.h
        ${PROJECT_SOURCE_DIR}/filter_laplacian_simplify/*.h ${PROJECT_SOURCE_DIR}/python/library/*.h
        ${PROJECT_SOURCE_DIR}/tests/*.h)
    get_target_property(sources ${target} SOURCES)
    get_target_property(folder ${target} SOURCE_DIR)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
        cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder})
        cmake_path(GET source STEM name)
        set(stamp ${CMAKE_BINARY_DIR}/tidy/${target}.${name}.done)
        add_custom_command(OUTPUT ${stamp}
            COMMAND ${CLANG_TIDY_PROGRAM} --quiet -p ${CMAKE_BINARY_DIR}
                --extra-arg=-idirafter${compiler_headers}
                --extra-arg=-Wno-error ${source}
            COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
            DEPENDS ${source} ${headers} ${PROJECT_SOURCE_DIR}/.clang-tidy
            COMMENT "clang-tidy ${name}.cpp" VERBATIM)
        add_custom_target(tidy_${target}_${name} DEPENDS ${stamp})
        add_dependencies(tidy tidy_${target}_${name})
        add_dependencies(tidy_${target}_${name} ${target})
    endforeach()
endfunction()
