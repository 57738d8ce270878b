# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# An example builds where it is installed, and runs; with EXAMPLES=all in the environment, all of them build.

file(REMOVE_RECURSE ${BINARY_DIR})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BINARY_DIR} -G ${GENERATOR}
    -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}
    -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D CMAKE_PREFIX_PATH=${PACKAGE_PREFIX}
  COMMAND_ERROR_IS_FATAL ANY)
set(target ${EXAMPLE})
if("$ENV{EXAMPLES}" STREQUAL "all")
  set(target all)
endif()
execute_process(
  COMMAND ${CMAKE_COMMAND} --build ${BINARY_DIR} --parallel 1 --target ${target}
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BINARY_DIR}/${EXAMPLE} COMMAND_ERROR_IS_FATAL ANY)
