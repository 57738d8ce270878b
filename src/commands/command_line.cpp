// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/command_line.h"

#include "system/Exit_status.h"

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

namespace idt {
namespace {

const CLI::App* find_subcommand(const CLI::App& app, const std::string& name)
{
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    if (command->get_name() == name)
      return command;
  return nullptr;
}

bool takes_value(const CLI::Option& option)
{
  return option.nonpositional() && option.get_items_expected_max() > 0;
}

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

void parse(CLI::App& app, int argc, const char* const* argv)
{
  try {
    app.parse(argc, argv);
  } catch (const CLI::RequiredError&) {
    const std::vector<std::string> unknown = app.remaining(true);
    if (unknown.empty())
      throw;
    throw CLI::ExtrasError(unknown);
  }
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
