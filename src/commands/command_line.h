// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mistakes in a command line that CLI11 misinterprets or reports misleadingly.

#ifndef IDT_COMMAND_LINE_H
#define IDT_COMMAND_LINE_H

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace idt {

// Refuses an option without a value: one followed by an empty argument, or by something that looks like another option,
// which would otherwise become a file name. `--edges=--verify` and `./--verify` are accepted.
// \exception Usage_error
void check_values(const CLI::App& app, const std::vector<std::string>& arguments);

// Parses; a first word `help` asks for help.
// \exception CLI::ParseError that names a wrong word and a likely meaning, rather than a missing argument beside it
void parse(CLI::App& app, std::vector<std::string> arguments);

// Whether a result goes to the standard output, that is, whether an option of the parsed command has the value "-".
bool writes_to_standard_output(const CLI::App& command);

// Declares an option with a value, which --help names `type`.
template <class Value>
CLI::Option* add_option(CLI::App& command, const std::string& names, Value& value, const std::string& type,
                        const std::string& text)
{
  return command.add_option(names, value, text)->type_name(type);
}

// Restricts an option to these words; a message names the nearest one. --help lists them if `are_listed`, completion
// always.
CLI::Option* set_words(CLI::Option* option, const std::vector<std::string>& words, bool are_listed = true);

// Lets an option be given only with one of others, without which it has no effect: "--verify", or "--number-type mpfr" if
// only that value will do.
CLI::Option* need_one_of(CLI::Option* option, const std::vector<std::string>& others);

// The words that an option accepts, or none if it accepts others.
std::vector<std::string> words_of(const CLI::Option& option);

// For transform(): accepts unsigned numbers of 64 bits. CLI11 takes a leading zero for the mark of an octal number, and
// turns a number that is too large into the largest one.
CLI::Validator whole_number();

} // namespace idt

#endif // IDT_COMMAND_LINE_H
