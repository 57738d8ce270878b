# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The program in README.md, compiled against the installed package with the flags of pkg-config, or against a checkout by the command
# that README.md gives, prints what README.md says.

file(REMOVE_RECURSE ${BINARY_DIR})
file(MAKE_DIRECTORY ${BINARY_DIR})
file(READ ${README} text)
if(NOT text MATCHES "```cpp\n(#include[^`]*)```")
  message(FATAL_ERROR "README.md has no program")
endif()
file(WRITE ${BINARY_DIR}/program.cpp "${CMAKE_MATCH_1}")
if(NOT text MATCHES "\n\n((    [-0-9.e]+ [-0-9.e]+\n)+)\n")
  message(FATAL_ERROR "README.md does not say what the program prints")
endif()
string(REPLACE "    " "" expected "${CMAKE_MATCH_1}")

if(WAY STREQUAL "checkout")
  if(NOT text MATCHES "\n    g\\+\\+ ([^\n]* program.cpp[^\n]*)\n")
    message(FATAL_ERROR "README.md does not say how to compile in a checkout")
  endif()
  set(flags "${CMAKE_MATCH_1}")
  get_filename_component(checkout ${README} DIRECTORY)
  foreach(folder include src)
    file(CREATE_LINK ${checkout}/${folder} ${BINARY_DIR}/${folder} SYMBOLIC)
  endforeach()
else()
  if(NOT text MATCHES "\n    g\\+\\+ program.cpp \\$\\(pkg-config --cflags --libs ([A-Za-z_]+)\\)\n")
    message(FATAL_ERROR "README.md does not say how to compile with pkg-config")
  endif()
  set(package ${CMAKE_MATCH_1})
  set(ENV{PKG_CONFIG_PATH} ${PACKAGE_PREFIX}/${PKGCONFIG_DIR})
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs ${package}
    OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(PREPEND flags "-O1 program.cpp ")
endif()
separate_arguments(flags UNIX_COMMAND "${flags}")
execute_process(COMMAND ${COMPILER} ${flags} -o program
  WORKING_DIRECTORY ${BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${BINARY_DIR}/program OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "the program printed\n${output}and README.md says\n${expected}")
endif()
