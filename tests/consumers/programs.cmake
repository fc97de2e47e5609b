# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The programs of docs/examples as another project builds them, every warning an error, in the headers as well. With
# VCGLIB_DIR also the one that has a VCG mesh.
set(STANDARDS 17 20 CACHE STRING "Standards of C++, a program for each")
cmake_path(SET examples NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../docs/examples)

# add_consumer(<name> <library>)
function(add_consumer name library)
    foreach(standard IN LISTS STANDARDS)
        add_executable(${name}_${standard} ${examples}/${name}.cpp)
        target_link_libraries(${name}_${standard} PRIVATE ${library})
        target_compile_options(${name}_${standard} PRIVATE -Wall -Wextra -Wshadow -Werror)
        set_target_properties(${name}_${standard} PROPERTIES
            CXX_STANDARD ${standard}
            CXX_STANDARD_REQUIRED ON
            CXX_EXTENSIONS OFF
            NO_SYSTEM_FROM_IMPORTED ON) # the warnings of installed headers count, too
    endforeach()
endfunction()

add_consumer(simplify_arrays laplacian_simplify::core)
if(VCGLIB_DIR)
    add_consumer(simplify_vcg_mesh laplacian_simplify::vcg_ext)
    foreach(standard IN LISTS STANDARDS)
        target_include_directories(simplify_vcg_mesh_${standard} SYSTEM PRIVATE ${VCGLIB_DIR})
    endforeach()
endif()
