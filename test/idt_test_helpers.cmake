# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A test is one line in the CMakeLists.txt of its folder. The name of the folder
# (unit, property, regress, fuzz) becomes its label: `ctest -L unit`.

# Clang reads test/precompiled.h compiled, which saves half of its time. GCC would gain a fifth, for
# 600 MB and half a minute, so it sees what each source includes by itself.
function(idt_precompile_headers target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_precompile_headers(${target} REUSE_FROM idt_test_headers)
  endif()
endfunction()

# Compiles with less optimization: -O1 in two thirds of the time; -O0, which the presets `day` and `sanitize` set, in a third.
set(INTRINSIC_TRIANGULATIONS_TEST_OPTIMIZATION "$<$<CONFIG:Release>:-O1>" CACHE STRING "The compiler's option for the optimization of tests")
function(idt_compile_quickly target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:${INTRINSIC_TRIANGULATIONS_TEST_OPTIMIZATION}>)
endfunction()

# Writes one source of several: first what any of them includes, then each in a namespace of its own, so that names may recur.
function(idt_join_sources result)
  set(includes)
  set(bodies)
  foreach(source IN LISTS ARGN)
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(stem ${source} NAME_WE)
    file(STRINGS ${source} lines REGEX "^#[ ]*include ")
    list(APPEND includes ${lines})
    string(APPEND bodies "namespace ${stem} {\n#include \"${source}\"\n}\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  endforeach()
  list(REMOVE_DUPLICATES includes)
  list(JOIN includes "\n" includes)
  file(CONFIGURE OUTPUT ${result} @ONLY CONTENT "@includes@\n@bodies@")
endfunction()

set(test_timeout 900)
if(CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(test_timeout 3000) # an emulated processor
endif()

# add_idt_test(NAME SOURCE... [SANITIZE] [SANITIZE_AT_NIGHT] [THREADS] [LIBRARIES TARGET...] [PREFIX PREFIX] [OPTIMIZE] [TOGETHER] [NIGHT]
#              [NIGHT_CASES CASE...])
#
# One GoogleTest executable, each of whose cases is a test of its own in CTest.
# SANITIZE marks a test that the sanitizer lane of .ci/run builds and runs; SANITIZE_AT_NIGHT one that `scripts/test --all` runs, as it
# takes long there, or computes much with numbers and little with memory; THREADS one that has several threads, for the preset
# `thread-sanitize`. OPTIMIZE compiles with -O1 in every preset, for a test that computes for long. TOGETHER compiles all sources as one, which
# takes half of the time: most of it goes into what they include. NIGHT marks a test that rarely tells what others do not: the preset `day`
# leaves it out, or those of NIGHT_CASES, which compute for long.
function(add_idt_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SANITIZE;SANITIZE_AT_NIGHT;THREADS;OPTIMIZE;TOGETHER;NIGHT" "PREFIX" "LIBRARIES;NIGHT_CASES")
  if(arg_NIGHT AND NOT INTRINSIC_TRIANGULATIONS_NIGHT_TESTS)
    return()
  endif()
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set_property(DIRECTORY PROPERTY LABELS ${folder})

  set(sources ${arg_UNPARSED_ARGUMENTS})
  if(arg_TOGETHER)
    idt_join_sources(${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp ${sources})
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  endif()
  add_executable(${name} ${sources})
  target_link_libraries(${name} PRIVATE
    Intrinsic_triangulations::Intrinsic_triangulations
    Intrinsic_triangulations_own_options
    ${arg_LIBRARIES}
    GTest::gtest_main)
  if(arg_TOGETHER)
    # GCC takes each of these sources for a header, where a fixture in a namespace without a name would be wrong.
    target_compile_options(${name} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)
  endif()
  if(arg_OPTIMIZE)
    target_compile_options(${name} PRIVATE $<$<AND:$<CONFIG:Release>,$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>>:-O1>)
  else()
    idt_compile_quickly(${name})
    # TBB changes what the headers of CGAL define.
    if(NOT "CGAL::TBB_support" IN_LIST arg_LIBRARIES)
      idt_precompile_headers(${name})
    endif()
  endif()
  # CMAKE_CURRENT_FUNCTION_LIST_DIR is test/, where the shared headers are.
  target_include_directories(${name} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR} ${CMAKE_CURRENT_SOURCE_DIR})

  set(label)
  if(arg_SANITIZE)
    set(label LABELS sanitize)
    add_dependencies(sanitize_tests ${name})
  elseif(arg_SANITIZE_AT_NIGHT)
    set(label LABELS night)
    add_dependencies(night_tests ${name})
  elseif(arg_THREADS)
    set(label LABELS threads)
    add_dependencies(thread_tests ${name})
  endif()
  set(prefix)
  if(arg_PREFIX)
    set(prefix TEST_PREFIX ${arg_PREFIX})
  endif()
  set(filter)
  if(arg_NIGHT_CASES AND NOT INTRINSIC_TRIANGULATIONS_NIGHT_TESTS)
    list(JOIN arg_NIGHT_CASES ":" cases)
    set(filter TEST_FILTER "-${cases}")
  endif()
  gtest_discover_tests(${name}
    ${prefix}
    ${filter}
    DISCOVERY_MODE PRE_TEST
    DISCOVERY_TIMEOUT 120
    PROPERTIES ${label} TIMEOUT ${test_timeout})
endfunction()

# add_idt_number_type_tests(NAME BODY NUMBER_TYPE... [SANITIZE_TYPES NUMBER_TYPE...]
#                           [options of add_idt_test])
#
# The tests in the header BODY, once for each number type: one executable
# NAME_<number type> from one generated source, so that these compile apart. The
# header uses the type `Number_type`, which number_types/<number type>.h defines.
# With SANITIZE_TYPES, the sanitizer lane takes the tests of those types.
function(add_idt_number_type_tests name body)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SANITIZE_TYPES;LIBRARIES;NIGHT_CASES")
  get_filename_component(body ${body} ABSOLUTE)
  foreach(number_type IN LISTS arg_UNPARSED_ARGUMENTS)
    set(number_type_header
      ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/number_types/${number_type}.h)
    if(NOT EXISTS ${number_type_header})
      message(FATAL_ERROR "${name}: there is no ${number_type_header}")
    endif()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}_${number_type}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT
      "#include \"@number_type_header@\"\n#include \"@body@\"\n")
    set(options)
    if(number_type IN_LIST arg_SANITIZE_TYPES)
      list(APPEND options SANITIZE)
    endif()
    add_idt_test(${name}_${number_type} ${source} ${options}
      PREFIX "${number_type}."
      LIBRARIES ${arg_LIBRARIES}
      NIGHT_CASES ${arg_NIGHT_CASES})
  endforeach()
endfunction()
