# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Where CPack does not do what Debian's own programs do: it takes a link for as long as the file where it leads, and has scripts
# that call ldconfig, for which dpkg has a trigger.

foreach(package IN LISTS CPACK_PACKAGE_FILES)
  set(folder ${package}.contents)
  execute_process(COMMAND dpkg-deb --raw-extract ${package} ${folder} COMMAND_ERROR_IS_FATAL ANY)
  if(EXISTS ${folder}/DEBIAN/shlibs)
    file(REMOVE ${folder}/DEBIAN/postinst ${folder}/DEBIAN/postrm)
    file(WRITE ${folder}/DEBIAN/triggers "activate-noawait ldconfig\n")
  endif()
  # In KB, each file rounded up; a folder or a link counts as 1.
  set(size 0)
  file(GLOB_RECURSE names LIST_DIRECTORIES ON ${folder}/usr/*)
  foreach(name IN LISTS names)
    set(bytes 1)
    if(NOT IS_DIRECTORY ${name} AND NOT IS_SYMLINK ${name})
      file(SIZE ${name} bytes)
    endif()
    math(EXPR size "${size} + (${bytes} + 1023) / 1024")
  endforeach()
  file(READ ${folder}/DEBIAN/control control)
  string(REGEX REPLACE "Installed-Size: [0-9]+" "Installed-Size: ${size}" control "${control}")
  file(WRITE ${folder}/DEBIAN/control "${control}")
  execute_process(COMMAND dpkg-deb --root-owner-group -Zxz --build ${folder} ${package} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${folder})
endforeach()
