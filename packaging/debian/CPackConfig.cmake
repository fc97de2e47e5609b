# SPDX-FileCopyrightText: 2026 The Laplacian Simplify authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The .deb of a folder that scripts/package has filled, DEB_FILES in the environment. DEB_LIBRARIES are the packages of
# libraries that the plugin needs. MeshLab 2020.09 loads any plugin without asking what it was built for, so the version is a dependency.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME meshlab-plugin-laplacian-simplify)
set(CPACK_PACKAGE_FILE_NAME ${CPACK_PACKAGE_NAME}) # the .deb has the name that DEB-DEFAULT gives it
set(CPACK_PACKAGE_VENDOR "The Laplacian Simplify authors")
set(CPACK_INSTALLED_DIRECTORIES "$ENV{DEB_FILES};/")
set(CPACK_PACKAGING_INSTALL_PREFIX /)
set(CPACK_STRIP_FILES OFF) # it is stripped
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "$ENV{DEB_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "$ENV{DEB_LIBRARIES}, meshlab (>= 2020.09), meshlab (<< 2020.10)")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mesh simplification that preserves features, for MeshLab")
set(CPACK_PACKAGE_DESCRIPTION
"Five filters for MeshLab. A shape descriptor, the Laplacian of the surface,
tells where creases, corners and fine details are; a simplification that
collapses edges in the order of a quadric error preserves these as long as
possible and measures the distance to the original in both directions.

The method follows Laplacian-Based Feature Preserving Mesh Simplification
(Zhang, Ma, Zhou and Wu, 2012). In MeshLab, press Ctrl+F and type Laplacian.")
