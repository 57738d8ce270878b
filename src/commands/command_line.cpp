// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/command_line.h"

#include "system/Exit_status.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>
#include <utility>

namespace idt {
namespace {

const CLI::App* find_subcommand(const CLI::App& app, const std::string& name)
{
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (command->get_name() == name)
      return command;
  return nullptr;
}

// The number of letters to be left out, added, replaced, or exchanged with the next one.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = (std::min)({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = (std::min)(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

// "; did you mean WORD?" if one is near: with mistakes in a third of its letters at most, or the beginning of the word.
std::string suggestion(const std::string& word, const std::vector<std::string>& words)
{
  const auto distance = [&word](const std::string& other) {
    const bool is_beginning = word.size() > 2 && other.compare(0, word.size(), word) == 0;
    return is_beginning ? std::size_t(1) : edit_distance(word, other);
  };
  const auto nearest = std::min_element(
    words.begin(), words.end(), [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
  if (nearest == words.end() || 3 * distance(*nearest) > word.size())
    return std::string();
  return "; did you mean " + *nearest + "?";
}

// Suggests what an unknown argument could have meant.
std::vector<std::string> possible_words(const CLI::App& app, bool is_option)
{
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  std::vector<std::string> words;
  if (is_option)
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames())
        words.push_back("--" + name);
  else
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); }))
      words.push_back(sub->get_name());
  return words;
}

// For who names the output as a second input.
std::string output_advice(const CLI::App& app, const std::string& word)
{
  for (const CLI::App* command : app.get_subcommands())
    if (const CLI::Option* const output = command->get_option_no_throw("--output");
        output && output->count() == 0 && word[0] != '-' && word.find('.') != std::string::npos &&
        !std::filesystem::exists(word)) // which must not be lost
      return "; did you mean -o " + word + "?";
  return std::string();
}

// Which options write files, for who looks for one that all subcommands have.
std::string writing_options(const CLI::App& app)
{
  std::string names;
  for (const CLI::App* command : app.get_subcommands())
    for (const CLI::Option* option : command->get_options())
      if (option->get_description().compare(0, 6, "write ") == 0 && !option->get_lnames().empty())
        names += (names.empty() ? "; files are written by --" : ", --") + option->get_lnames().front();
  return names;
}

std::map<const CLI::Option*, std::vector<std::string>>& all_words()
{
  static std::map<const CLI::Option*, std::vector<std::string>> words;
  return words;
}

std::map<const CLI::Option*, std::vector<std::string>>& all_needs()
{
  static std::map<const CLI::Option*, std::vector<std::string>> needs;
  return needs;
}

bool is_given(const CLI::App& command, const std::string& option)
{
  const std::size_t end = option.find(' ');
  const CLI::Option& given = *command.get_option(option.substr(0, end));
  if (end == std::string::npos)
    return given.count() > 0;
  const std::vector<std::string>& values = given.results();
  const std::string value = option.substr(end + 1);
  return given.count() > 0 ? std::find(values.begin(), values.end(), value) != values.end()
                           : given.get_default_str().find(value) != std::string::npos;
}

// Refuses options that have no effect beside the others.
void check_effects(const CLI::App& command)
{
  const auto refuse = [](const CLI::Option* option, const std::string& needed) {
    throw CLI::ParseError(option->get_name() + " requires " + needed + ": it has no effect otherwise",
                          CLI::ExitCodes::RequiresError);
  };
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0)
      continue;
    if (option->check_lname("format") || option->check_lname("overlay-format"))
      if (!writes_to_standard_output(command))
        refuse(option, "a file named -, the standard output");
    const auto needs = all_needs().find(option);
    if (needs != all_needs().end() && std::none_of(needs->second.begin(), needs->second.end(),
                                                   [&](const std::string& other) { return is_given(command, other); }))
      refuse(option, boost::join(needs->second, " or "));
  }
}

bool takes_value(const CLI::Option& option) { return option.nonpositional() && option.get_items_expected_max() > 0; }

} // namespace

void check_values(const CLI::App& app, const std::vector<std::string>& arguments)
{
  const CLI::App* const command = arguments.empty() ? nullptr : find_subcommand(app, arguments[0]);
  if (command == nullptr)
    return;
  for (std::size_t i = 1; i + 1 < arguments.size() && arguments[i] != "--"; ++i) {
    const std::string &name = arguments[i], &value = arguments[i + 1];
    if (name.size() < 2 || name[0] != '-')
      continue;
    const CLI::Option* const option = command->get_option_no_throw(name);
    if (option == nullptr || !takes_value(*option))
      continue;
    if (value.compare(0, 2, "--") == 0)
      throw Usage_error(name + ": \"" + value + "\" is an option and no value; " + name + "=" + value +
                        " if it is meant");
    const char delimiter = option->get_delimiter();
    if (value.find_first_not_of(delimiter == 0 ? "" : std::string(1, delimiter)) == std::string::npos)
      throw Usage_error(name + ": must not be empty");
    ++i;
  }
}

void parse(CLI::App& app, std::vector<std::string> arguments)
{
  const bool is_help = !arguments.empty() && arguments[0] == "help";
  if (is_help)
    arguments.erase(arguments.begin());
  // CLI11 would print the help of the whole command for an unknown subcommand with --help.
  if (!arguments.empty() && arguments[0][0] != '-' && find_subcommand(app, arguments[0]) == nullptr) {
    std::vector<std::string> words = possible_words(app, false);
    words.push_back("help");
    const std::string near = suggestion(arguments[0], words);
    throw CLI::ParseError("There is no subcommand " + arguments[0] +
                            (near.empty() ? ", but " + boost::join(words, ", ") : near),
                          CLI::ExitCodes::ExtrasError);
  }
  if (is_help)
    arguments.push_back("--help");
  std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants them
  const auto name_unknown = [&app] {
    std::vector<std::string> unknown = app.remaining(true);
    if (unknown.empty())
      throw;
    const std::string word = unknown.front().substr(0, unknown.front().find('='));
    const bool is_output = word == "-o" || word == "--output";
    throw CLI::ParseError(CLI::ExtrasError({unknown.front()}).what() +
                            (is_output ? writing_options(app) : suggestion(word, possible_words(app, word[0] == '-'))) +
                            output_advice(app, word),
                          CLI::ExitCodes::ExtrasError);
  };
  // Messages of CLI11 are "Could not convert: --option = value", "--option: 1 required F missing" and "--option: At
  // Most 1 required but received 2".
  const auto say = [](const CLI::Error& error, const std::string& text) {
    throw CLI::ParseError(text, CLI::ExitCodes(error.get_exit_code()));
  };
  try {
    app.parse(std::move(arguments));
    for (const CLI::App* command : app.get_subcommands())
      check_effects(*command);
  } catch (const CLI::RequiredError&) {
    name_unknown();
  } catch (const CLI::ExtrasError&) {
    name_unknown();
  } catch (const CLI::ConversionError& error) {
    const std::string text = error.what();
    const std::size_t name = text.find("--"), value = text.find(" = ");
    if (name == std::string::npos || value == std::string::npos)
      throw;
    const std::string option = text.substr(name, value - name);
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::Option* const known = (chosen.empty() ? &app : chosen.front())->get_option_no_throw(option);
    const std::string word = text.substr(value + 3);
    say(error, known && !takes_value(*known) ? option + " takes no value: omit =" + word
                                             : option + ": \"" + word + "\" is not a number");
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string text = error.what();
    const std::size_t end = text.find(": ");
    if (end == std::string::npos)
      throw;
    say(error, text.substr(0, end) + (text.find("missing") == std::string::npos ? ": give it once, and one value"
                                                                                : ": its value is missing"));
  }
}

bool writes_to_standard_output(const CLI::App& command)
{
  for (const CLI::Option* option : command.get_options())
    if (option->nonpositional() && option->results() == std::vector<std::string>{"-"})
      return true;
  return false;
}

CLI::Option* set_words(CLI::Option* option, const std::vector<std::string>& words, bool are_listed)
{
  const std::string list = '{' + boost::join(words, ",") + '}';
  all_words()[option] = words;
  return option->check(CLI::Validator(
    [words, list](const std::string& value) {
      if (std::find(words.begin(), words.end(), value) != words.end())
        return std::string();
      const std::string near = suggestion(value, words);
      return "there is no \"" + value + '"' + (near.empty() ? ", but " + list : near);
    },
    are_listed ? list : std::string()));
}

CLI::Option* need_one_of(CLI::Option* option, const std::vector<std::string>& others)
{
  all_needs()[option] = others;
  return option;
}

std::vector<std::string> words_of(const CLI::Option& option)
{
  const auto found = all_words().find(&option);
  return found == all_words().end() ? std::vector<std::string>() : found->second;
}

CLI::Validator whole_number()
{
  CLI::Validator validator;
  validator.operation([](std::string& text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || rest != end)
      return "\"" + text + "\" is not a whole number from 0 to 18446744073709551615";
    text = std::to_string(number);
    return std::string();
  });
  return validator;
}

} // namespace idt
