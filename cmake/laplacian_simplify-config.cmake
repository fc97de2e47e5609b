# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# find_package(laplacian_simplify 0.1 [COMPONENTS core vcg_ext]) gives laplacian_simplify::core, which needs nothing
# but threads, and laplacian_simplify::vcg_ext, which needs Eigen and a vcglib on the program's include path.
# -DLAPLACIAN_SIMPLIFY_OPENMP=OFF: threads of the standard library instead of OpenMP's.
include(CMakeFindDependencyMacro)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_dependency(Threads)
if(NOT DEFINED LAPLACIAN_SIMPLIFY_OPENMP OR LAPLACIAN_SIMPLIFY_OPENMP)
    find_package(OpenMP QUIET COMPONENTS CXX)
endif()
if("vcg_ext" IN_LIST laplacian_simplify_FIND_COMPONENTS)
    find_dependency(Eigen3 NO_MODULE)
else()
    find_package(Eigen3 QUIET NO_MODULE)
endif()
include("${CMAKE_CURRENT_LIST_DIR}/laplacian_simplify-targets.cmake")
foreach(component IN LISTS laplacian_simplify_FIND_COMPONENTS)
    if(TARGET laplacian_simplify::${component})
        set(laplacian_simplify_${component}_FOUND TRUE)
    elseif(laplacian_simplify_FIND_REQUIRED_${component})
        set(laplacian_simplify_FOUND FALSE)
        set(laplacian_simplify_NOT_FOUND_MESSAGE "laplacian_simplify has no component '${component}': core, vcg_ext")
    endif()
endforeach()
