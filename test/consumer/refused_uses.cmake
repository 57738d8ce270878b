# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The first error of a wrong use says in one sentence what is wrong.

set(ENV{PKG_CONFIG_PATH} ${PACKAGE_PREFIX}/${PKGCONFIG_DIR})
execute_process(COMMAND ${PKG_CONFIG} --cflags Intrinsic_triangulations
  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
function(expect_refusal macro sentence) # [ONLY]: it is the only error
  execute_process(COMMAND ${COMPILER} -fsyntax-only -D${macro} ${flags} ${SOURCE}
    RESULT_VARIABLE status ERROR_VARIABLE messages)
  string(REGEX MATCHALL "error: [^\n]*" errors "${messages}")
  list(LENGTH errors number_of_errors)
  string(REGEX MATCH "error: [^\n]*" first "${messages}")
  if(status EQUAL 0 OR NOT first MATCHES "${sentence}" OR ("${ARGN}" STREQUAL ONLY AND NOT number_of_errors EQUAL 1))
    message(FATAL_ERROR "${macro}: status ${status}, ${number_of_errors} errors, ${first}\n${messages}")
  endif()
endfunction()
foreach(traits Edge_length_traits Half_angle_traits)
  expect_refusal(NUMBERS_WITHOUT_ROOTS=${traits} "must be a field with square root that CGAL knows: take double, a float of Boost" ONLY)
endforeach()
expect_refusal(POINTS_WITHOUT_COORDINATES "vertex_point_map: its values have to be points of CGAL")
expect_refusal(CONSTRAINTS_OF_VERTICES "edge_is_constrained_map: its keys have to be the edges of the mesh")
expect_refusal(VALUES_THAT_ARE_TEXTS "values have to be added and, from the left, multiplied by a double")
if(NOT flags MATCHES "[Ee]igen" AND NOT EXISTS /usr/include/Eigen AND NOT EXISTS /usr/local/include/Eigen)
  expect_refusal(WITHOUT_EIGEN "This header needs Eigen 3")
endif()
