# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# What `cpack` makes of an installation: an archive, or with INTRINSIC_TRIANGULATIONS_DEBIAN_PACKAGES a Debian package of each
# component. scripts/make_packages makes them in bare systems.

set(CPACK_PACKAGE_NAME intrinsic-triangulations)
set(CPACK_PACKAGE_VENDOR "The Intrinsic_triangulations developers")
# Debian wants an address, and the developers have none; no domain has this end.
set(CPACK_PACKAGE_CONTACT "${CPACK_PACKAGE_VENDOR} <nobody@intrinsic-triangulations.invalid>"
  CACHE STRING "Who answers for packages: NAME <ADDRESS>")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR TGZ)

if(INTRINSIC_TRIANGULATIONS_DEBIAN_PACKAGES)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SOURCE ${CPACK_PACKAGE_NAME})
  set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_POST_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/finish_packages.cmake)
  set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # each package has its own
  # A package for Debian 13 is newer than that for Debian 12.
  file(STRINGS /etc/os-release debian REGEX "^VERSION_ID=")
  string(REGEX REPLACE "[^0-9]" "" debian "${debian}")
  set(CPACK_DEBIAN_PACKAGE_RELEASE 1~deb${debian})
  set(version ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
  set(soname ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  file(READ ${PROJECT_SOURCE_DIR}/LICENSE text_of_licence)
  file(READ ${PROJECT_SOURCE_DIR}/src/python/NOTICE.txt notice)
  string(TIMESTAMP today "%a, %d %b %Y %H:%M:%S +0000" UTC)
  set(changelog ${PROJECT_BINARY_DIR}/packages/changelog.Debian)
  file(WRITE ${changelog} "${CPACK_PACKAGE_NAME} (${version}) stable; urgency=medium\n\n"
    "  * Version ${PROJECT_VERSION}: changelog.gz says what is new.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${today}\n")
  configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_BINARY_DIR}/packages/changelog COPYONLY)
  execute_process(COMMAND gzip -9nf changelog changelog.Debian WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/packages
    COMMAND_ERROR_IS_FATAL ANY)

  set(description "Triangulated surfaces get better triangles and stay the same surfaces: no
vertex moves, and no length changes. On these triangles, equations are solved,
distances measured, and straight paths found. Every decision is exact.")

  # \param summary one line of at most 80 characters; \param licence sentences, the first of which says what the package is under
  function(add_package component name section summary licence depends recommends)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    string(TOUPPER ${component} COMPONENT)
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${name})
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_SECTION ${section})
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_DEPENDS ${depends})
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_RECOMMENDS ${recommends})
    set(CPACK_COMPONENT_${COMPONENT}_DESCRIPTION "${summary}\n${description}")
    foreach(variable COMPONENTS_ALL DEBIAN_${COMPONENT}_PACKAGE_NAME DEBIAN_${COMPONENT}_PACKAGE_SECTION
        DEBIAN_${COMPONENT}_PACKAGE_DEPENDS DEBIAN_${COMPONENT}_PACKAGE_RECOMMENDS COMPONENT_${COMPONENT}_DESCRIPTION)
      set(CPACK_${variable} "${CPACK_${variable}}" PARENT_SCOPE)
    endforeach()
    set(text "${name}: ${licence}\nTexts: /usr/share/common-licenses/GPL-3 and LGPL-3\n\n${text_of_licence}")
    if(licence MATCHES "With parts")
      string(APPEND text "\n${notice}")
    endif()
    file(WRITE ${PROJECT_BINARY_DIR}/packages/${name}/copyright "${text}")
    install(FILES ${PROJECT_BINARY_DIR}/packages/${name}/copyright ${changelog}.gz ${PROJECT_BINARY_DIR}/packages/changelog.gz
      DESTINATION share/doc/${name} COMPONENT ${component})
  endfunction()

  set(CPACK_COMPONENTS_ALL)
  add_package(library libintrinsic-triangulations${soname} libs
    "Intrinsic Delaunay triangulations: shared library" "LGPL-3.0-or-later." "" "")
  add_package(development libintrinsic-triangulations-dev libdevel
    "Intrinsic Delaunay triangulations: headers, static library, examples"
    "LGPL-3.0-or-later. The examples, libIntrinsic_triangulations_repair.a and the three headers that share/doc/Intrinsic_triangulations/LICENSE names: GPL-3.0-or-later."
    "libintrinsic-triangulations${soname} (= ${version}), libcgal-dev (>= 5.5)" "g++, cmake, pkgconf, libeigen3-dev, libspectra-dev")
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/debian/lintian-overrides
    DESTINATION share/lintian/overrides RENAME libintrinsic-triangulations-dev COMPONENT development)
  if(TARGET idt)
    add_package(command intrinsic-triangulations math
      "Intrinsic Delaunay triangulations: the command idt"
      "GPL-3.0-or-later. With parts under MIT, BSD-3-Clause, MPL-2.0 and BSL-1.0." "" "")
  endif()
  if(TARGET intrinsic_triangulations_python)
    find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
    math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/postinst;${PROJECT_SOURCE_DIR}/cmake/debian/prerm")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
    add_package(python python3-intrinsic-triangulations python
      "Intrinsic Delaunay triangulations: the Python package"
      "LGPL-3.0-or-later. The modules _point_cloud and _repair: GPL-3.0-or-later. With parts under BSD-3-Clause, MPL-2.0 and BSL-1.0."
      "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy, python3-scipy"
      "intrinsic-triangulations")
  endif()
endif()
include(CPack)
