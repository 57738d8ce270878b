# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A number type that cannot serve ends the compilation with one error, which says why and what to take.

set(ENV{PKG_CONFIG_PATH} ${PACKAGE_PREFIX}/${PKGCONFIG_DIR})
execute_process(COMMAND ${PKG_CONFIG} --cflags Intrinsic_triangulations
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
foreach(traits Edge_length_traits Half_angle_traits)
  execute_process(COMMAND ${COMPILER} -fsyntax-only -DTRAITS=${traits} ${flags} ${SOURCE}
    RESULT_VARIABLE status ERROR_VARIABLE messages)
  string(REGEX MATCHALL "error: [^\n]*" errors "${messages}")
  list(LENGTH errors number_of_errors)
  if(status EQUAL 0 OR NOT number_of_errors EQUAL 1 OR
      NOT errors MATCHES "must be a field with square root that CGAL knows: take double, a float of Boost")
    message(FATAL_ERROR "${traits}: status ${status}, ${number_of_errors} errors:\n${messages}")
  endif()
endforeach()
