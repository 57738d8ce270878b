# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What `cpack` makes of an installation: an archive, and a Debian package of headers and command.

set(CPACK_PACKAGE_NAME intrinsic-triangulations)
set(CPACK_PACKAGE_VENDOR "The Intrinsic_triangulations developers")
set(CPACK_PACKAGE_CONTACT "${CPACK_PACKAGE_VENDOR}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR TGZ)
find_program(DPKG_PROGRAM NAMES dpkg)
if(DPKG_PROGRAM)
  list(APPEND CPACK_GENERATOR DEB)
endif()

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libeigen3-dev, libspectra-dev")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
