// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes in a command line that CLI11 takes for something else, or reports as something else.

#ifndef IDT_COMMAND_LINE_H
#define IDT_COMMAND_LINE_H

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace idt {

// Refuses an option that has no value: what comes next is empty, or looks like another option,
// which would become a file of that name and not do what it is for. `--edges=--verify` and
// `./--verify` are what they say.
// \exception Usage_error
void check_values(const CLI::App& app, const std::vector<std::string>& arguments);

// Parses.
// \exception CLI::ParseError that names a wrong word rather than what is missing beside it, and what it may be meant
//   for
void parse(CLI::App& app, int argc, const char* const* argv);

// Whether a result goes to the standard output: an option of the command that was parsed has the value "-".
bool writes_to_standard_output(const CLI::App& command);

// Declares an option with a value, which --help calls `type`.
template <class Value>
CLI::Option* add_option(CLI::App& command, const std::string& names, Value& value, const std::string& type,
                        const std::string& text)
{
  return command.add_option(names, value, text)->type_name(type);
}

// Lets an option have one of these words alone; a message names the nearest. --help lists them if `are_listed`,
// completion always.
CLI::Option* set_words(CLI::Option* option, const std::vector<std::string>& words, bool are_listed = true);

// The words that an option can have, none if it can have others.
std::vector<std::string> words_of(const CLI::Option& option);

// To be passed to transform(): accepts what fits into 64 bits without a sign. CLI11 reads a leading zero as the mark of
// an octal number, and makes the largest number of one that is larger.
CLI::Validator whole_number();

} // namespace idt

#endif // IDT_COMMAND_LINE_H
