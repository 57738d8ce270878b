# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later

file(REMOVE_RECURSE ${BINARY_DIR})
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BINARY_DIR} -G ${GENERATOR}
    -D CMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}
    -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
    -D CMAKE_PREFIX_PATH=${PACKAGE_PREFIX}
    -D PACKAGE_SOURCE_DIR=${PACKAGE_SOURCE_DIR}
    # Where the library is built with the program: shared, in a program that hides its own names.
    -D BUILD_SHARED_LIBS=${SHARED}
    -D CMAKE_CXX_VISIBILITY_PRESET=hidden
    -D CMAKE_VISIBILITY_INLINES_HIDDEN=ON
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${CMAKE_COMMAND} --build ${BINARY_DIR} --parallel 1
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(
  COMMAND ${BINARY_DIR}/consumer
  OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL "OK\n")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()
