# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later

file(REMOVE_RECURSE ${PREFIX})
execute_process(
  COMMAND ${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${PREFIX} --config ${CONFIG}
  COMMAND_ERROR_IS_FATAL ANY)

foreach(file include/CGAL/Intrinsic_triangulations/errors.h
    ${LIBRARY_DIR}/cmake/Intrinsic_triangulations/Intrinsic_triangulationsConfig.cmake
    ${LIBRARY_DIR}/pkgconfig/Intrinsic_triangulations.pc ${LIBRARY_DIR}/${LIBRARY})
  if(NOT EXISTS ${PREFIX}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
if(INSTALLED_COMMAND)
  foreach(file ${INSTALLED_COMMAND} ${PREFIX}/share/man/man1/idt.1
      ${PREFIX}/share/bash-completion/completions/idt ${PREFIX}/share/zsh/site-functions/_idt
      ${PREFIX}/share/fish/vendor_completions.d/idt.fish)
    if(NOT EXISTS ${file})
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
endif()
# The installed files must not know where they were built.
file(GLOB_RECURSE files ${PREFIX}/*.cmake ${PREFIX}/*.pc)
foreach(file IN LISTS files)
  file(READ ${file} text)
  string(FIND "${text}" "${BINARY_DIR}" position)
  if(NOT position EQUAL -1)
    message(FATAL_ERROR "${file} names the build folder")
  endif()
endforeach()
