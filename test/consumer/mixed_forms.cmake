# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A program may mix units that use the library with header-only ones. Units for different instruction sets do not link.

file(REMOVE_RECURSE ${BINARY_DIR})
file(MAKE_DIRECTORY ${BINARY_DIR})
set(ENV{PKG_CONFIG_PATH} ${PACKAGE_PREFIX}/${PKGCONFIG_DIR})
foreach(package Intrinsic_triangulations Intrinsic_triangulations_compiled)
  foreach(kind cflags libs)
    execute_process(COMMAND ${PKG_CONFIG} --${kind} ${package}
      OUTPUT_VARIABLE ${package}_${kind} OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(${package}_${kind} UNIX_COMMAND "${${package}_${kind}}")
  endforeach()
endforeach()

# One source for both units: a triangulation of two triangles, by name.
file(WRITE ${BINARY_DIR}/unit.cpp [[
#ifdef WITHOUT_SSE2
#include <CGAL/FPU.h>
#undef CGAL_HAS_SSE2
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
double NAME() { return CGAL::Intrinsic_triangulations::internal::Two_doubles(1., 2.).second(); }
#else
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <array>
#include <vector>
double NAME()
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  const auto result = CGAL::Intrinsic_triangulations::intrinsic_Delaunay_triangulation(points, triangles);
  double sum = 0;
  for (auto e : result.triangulation.connectivity().edges())
    sum += result.triangulation.length(e);
  return sum;
}
#endif
]])
file(WRITE ${BINARY_DIR}/main.cpp [[
double header_only();
double compiled();
int main() { return header_only() == compiled() ? 0 : 1; }
]])
function(compile object)
  execute_process(COMMAND ${COMPILER} -O0 ${ARGN} -o ${object} WORKING_DIRECTORY ${BINARY_DIR} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
compile(header_only.o -c unit.cpp -DNAME=header_only ${Intrinsic_triangulations_cflags})
compile(compiled.o -c unit.cpp -DNAME=compiled ${Intrinsic_triangulations_compiled_cflags})
compile(program main.cpp header_only.o compiled.o ${Intrinsic_triangulations_compiled_libs})
execute_process(COMMAND ${BINARY_DIR}/program COMMAND_ERROR_IS_FATAL ANY)

if(CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "x86_64")
  compile(other.o -c unit.cpp -DNAME=header_only -DWITHOUT_SSE2 ${Intrinsic_triangulations_cflags})
  execute_process(COMMAND ${COMPILER} main.cpp other.o compiled.o ${Intrinsic_triangulations_compiled_libs} -o wrong
    WORKING_DIRECTORY ${BINARY_DIR} RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(status EQUAL 0 OR NOT messages MATCHES "multiple definition of.*Intrinsic_triangulations_needs_same_CGAL_HAS_SSE2_in_all_units")
    message(FATAL_ERROR "units for different instruction sets were linked, status ${status}:\n${messages}")
  endif()
endif()
