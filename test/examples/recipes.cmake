# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes a function of each piece of code in doc/recipes.md, and a program that calls them all:
#
#   cmake -DRECIPES=recipes.md -DPROGRAM=recipes.cpp -P recipes.cmake

file(READ ${RECIPES} text)
string(REPLACE ";" "<semicolon>" text "${text}")
string(REPLACE "[" "<left>" text "${text}") # brackets and semicolons have a meaning in lists
string(REPLACE "]" "<right>" text "${text}")
string(REGEX MATCHALL "```cpp\n[^`]*```" blocks "${text}")
set(functions "")
set(calls "")
set(number 0)
foreach(block IN LISTS blocks)
  string(REGEX REPLACE "^```cpp\n|```$" "" block "${block}")
  string(APPEND functions "void recipe_${number}()\n{\n${block}}\n")
  string(APPEND calls "recipe_${number}();\n")
  math(EXPR number "${number} + 1")
endforeach()
if(number EQUAL 0)
  message(FATAL_ERROR "${RECIPES} has no code")
endif()
set(program "#include \"recipes.h\"\nnamespace {\n${functions}}\nint main()\n{\n${calls}}\n")
string(REPLACE "<semicolon>" ";" program "${program}")
string(REPLACE "<left>" "[" program "${program}")
string(REPLACE "<right>" "]" program "${program}")
file(WRITE ${PROGRAM} "${program}")
