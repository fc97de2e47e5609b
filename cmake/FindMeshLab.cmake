# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds the headers of a MeshLab and the library that its plugins link.
#
# Input, either LAPLACIAN_SIMPLIFY_HOST (a host that scripts/hosts has fetched into the cache folder), or
#   MESHLAB_SOURCE_DIR      a source tree of MeshLab, vcglib included
#   MESHLAB_COMMON_LIBRARY  libmeshlab-common.so of the program that shall load the plugin
#   MESHLAB_SCALAR          float or double, as that program was built
# Without a library only what needs no MeshLab can be built: vcg_ext, its tests, the tables.
#
# Output: targets MeshLab::VCG (headers of vcglib) and, with a library, MeshLab::Common; MeshLab_VERSION (with
# the "d" of double builds), MeshLab_API (2020 or 2022: the plugin interface that the version speaks).
# A combination that the program would refuse, or crash on, is refused here.

set(MESHLAB_COMMON_LIBRARY "" CACHE FILEPATH "libmeshlab-common.so of the MeshLab that loads the plugin")
set(MESHLAB_SCALAR "float" CACHE STRING "Scalar type of that MeshLab: float or double")
set_property(CACHE MESHLAB_SCALAR PROPERTY STRINGS float double)

# Sets the variables that the user left empty to what scripts/hosts stored for LAPLACIAN_SIMPLIFY_HOST.
function(meshlab_take_from_cache_folder)
    set(cache_home "$ENV{XDG_CACHE_HOME}")
    if(NOT cache_home)
        set(cache_home "$ENV{HOME}/.cache")
    endif()
    set(description "${cache_home}/laplacian-simplify/hosts/${LAPLACIAN_SIMPLIFY_HOST}/host.cmake")
    if(NOT EXISTS "${description}")
        message(FATAL_ERROR "MeshLab host '${LAPLACIAN_SIMPLIFY_HOST}' is not there (${description}). "
            "Run: scripts/hosts ${LAPLACIAN_SIMPLIFY_HOST}")
    endif()
    include("${description}")
    foreach(name IN ITEMS MESHLAB_SOURCE_DIR MESHLAB_COMMON_LIBRARY)
        if(NOT ${name})
            set(${name} "${HOST_${name}}" PARENT_SCOPE)
        endif()
    endforeach()
endfunction()

# Sets <result> to the first group of <pattern> in the printable strings of the library, or to nothing.
function(meshlab_search_library pattern result)
    file(STRINGS "${MESHLAB_COMMON_LIBRARY}" found REGEX "${pattern}" LIMIT_COUNT 1)
    set(${result} "" PARENT_SCOPE)
    if(found MATCHES "${pattern}")
        set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
    endif()
endfunction()

# Refuses a version whose plugin interface is not one of the two that the adapters speak.
function(meshlab_choose_interface version result)
    if(version STREQUAL "2020.09")
        set(${result} 2020 PARENT_SCOPE)
    elseif(version MATCHES "^20[0-9][0-9]\\.[0-9][0-9]$" AND version VERSION_GREATER_EQUAL 2022.02
            AND version VERSION_LESS_EQUAL 2025.07)
        set(${result} 2022 PARENT_SCOPE)
    else()
        message(FATAL_ERROR "MeshLab version '${version}' is unknown to this plugin: "
            "it fits 2020.09 and 2022.02 to 2025.07 (${MESHLAB_SOURCE_DIR}/ML_VERSION)")
    endif()
endfunction()

# Refuses a scalar or a library that cannot work with the headers of <version>.
function(meshlab_check_library version)
    if(NOT EXISTS "${MESHLAB_COMMON_LIBRARY}")
        message(FATAL_ERROR "MESHLAB_COMMON_LIBRARY = '${MESHLAB_COMMON_LIBRARY}' does not exist")
    endif()
    if(version STREQUAL "2020.09" AND MESHLAB_SCALAR STREQUAL "double")
        message(FATAL_ERROR "MESHLAB_SCALAR = double cannot fit MeshLab 2020.09: "
            "it loads a plugin without asking for its scalar and crashes when the plugin runs")
    endif()
    # RichShot's constructor names vcg::Shot<f> or vcg::Shot<d> in every version.
    meshlab_search_library("RichShotf?C1ERK7QStringRKN3vcg4ShotI([fd])" letter)
    if(letter STREQUAL "f")
        set(built_with float)
    elseif(letter STREQUAL "d")
        set(built_with double)
    endif()
    if(built_with AND NOT built_with STREQUAL MESHLAB_SCALAR)
        message(FATAL_ERROR "MESHLAB_SCALAR = ${MESHLAB_SCALAR} cannot fit ${MESHLAB_COMMON_LIBRARY}: "
            "it was built with ${built_with}")
    endif()
    meshlab_search_library("(20[0-9][0-9]\\.[0-9][0-9])" library_version)
    if(library_version AND NOT library_version STREQUAL version)
        message(FATAL_ERROR "The sources in ${MESHLAB_SOURCE_DIR} are MeshLab ${version}, "
            "but ${MESHLAB_COMMON_LIBRARY} is ${library_version}")
    endif()
endfunction()

if(LAPLACIAN_SIMPLIFY_HOST)
    meshlab_take_from_cache_folder()
endif()
if(NOT MESHLAB_SCALAR MATCHES "^(float|double)$")
    message(FATAL_ERROR "MESHLAB_SCALAR = '${MESHLAB_SCALAR}' is neither float nor double")
endif()
# Debian's tarballs differ in where the top is, so src itself is accepted too.
if(NOT EXISTS "${MESHLAB_SOURCE_DIR}/ML_VERSION" AND EXISTS "${MESHLAB_SOURCE_DIR}/../ML_VERSION")
    cmake_path(GET MESHLAB_SOURCE_DIR PARENT_PATH MESHLAB_SOURCE_DIR)
endif()
if(NOT EXISTS "${MESHLAB_SOURCE_DIR}/ML_VERSION")
    message(FATAL_ERROR "MESHLAB_SOURCE_DIR = '${MESHLAB_SOURCE_DIR}' is no MeshLab source tree: "
        "it has no ML_VERSION. Choose a preset, or give -DMESHLAB_SOURCE_DIR= -DMESHLAB_COMMON_LIBRARY= "
        "-DMESHLAB_SCALAR=")
endif()
file(READ "${MESHLAB_SOURCE_DIR}/ML_VERSION" MeshLab_VERSION)
string(STRIP "${MeshLab_VERSION}" MeshLab_VERSION)
meshlab_choose_interface("${MeshLab_VERSION}" MeshLab_API)
set(MeshLab_VERSION_OF_HEADERS "${MeshLab_VERSION}")

find_path(MeshLab_VCG_INCLUDE_DIR vcg/complex/complex.h NO_CACHE NO_DEFAULT_PATH
    PATHS "${MESHLAB_SOURCE_DIR}/src/vcglib" "${MESHLAB_SOURCE_DIR}/vcglib")
if(MeshLab_VCG_INCLUDE_DIR AND NOT TARGET MeshLab::VCG)
    find_package(Eigen3 REQUIRED NO_MODULE)
    add_library(MeshLab::VCG INTERFACE IMPORTED)
    set_target_properties(MeshLab::VCG PROPERTIES
        INTERFACE_LINK_LIBRARIES Eigen3::Eigen
        INTERFACE_INCLUDE_DIRECTORIES "${MeshLab_VCG_INCLUDE_DIR}")
endif()

if(LAPLACIAN_SIMPLIFY_PLUGIN AND MESHLAB_COMMON_LIBRARY)
    meshlab_check_library("${MeshLab_VERSION}")
    if(MESHLAB_SCALAR STREQUAL "double")
        string(APPEND MeshLab_VERSION d)
    endif()
    find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets OpenGL Xml)
    find_path(GLEW_INCLUDE_DIR GL/glew.h REQUIRED)
    add_library(MeshLab::Common SHARED IMPORTED)
    set_target_properties(MeshLab::Common PROPERTIES
        IMPORTED_LOCATION "${MESHLAB_COMMON_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${MESHLAB_SOURCE_DIR}/src;${GLEW_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS "MESHLAB_SCALAR=${MESHLAB_SCALAR};MESHLAB_VERSION=${MeshLab_VERSION}"
        INTERFACE_LINK_LIBRARIES "MeshLab::VCG;Qt5::Widgets;Qt5::OpenGL;Qt5::Xml")
    message(STATUS "Plugin for MeshLab ${MeshLab_VERSION}, ${MESHLAB_SCALAR}: ${MESHLAB_COMMON_LIBRARY}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MeshLab REQUIRED_VARS MESHLAB_SOURCE_DIR MeshLab_VCG_INCLUDE_DIR
    VERSION_VAR MeshLab_VERSION_OF_HEADERS)
