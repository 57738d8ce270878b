// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt describe`: the command line as a manual page and as completion for shells, made from the declarations of the
// subcommands. Run by the build, and not listed by --help.

#include "commands/command_line.h"
#include "commands/commands.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <map>
#include <memory>

namespace idt {
namespace {

using Apps = std::vector<const CLI::App*>;
using Options = std::vector<const CLI::Option*>;

Apps subcommands(const CLI::App& app)
{
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

Options options(const CLI::App& app, bool are_positional)
{
  return app.get_options(
    [are_positional](const CLI::Option* option) { return option->nonpositional() != are_positional; });
}

// Text that roff shows as it is: a hyphen is a minus sign, and no line begins a request.
std::string escaped(const std::string& text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_line = i == 0 || text[i - 1] == '\n';
    if (begins_line && (text[i] == '.' || text[i] == '\''))
      result += "\\&";
    if (text[i] == '\\')
      result += "\\e";
    else if (text[i] == '-')
      result += "\\-";
    else
      result += text[i];
  }
  return result;
}

// Without additions of a validator.
std::string type_name(const CLI::Option& option)
{
  const std::string name = option.get_type_name();
  return name.substr(0, name.find(':'));
}

// What --help shows after the name of an option: the type or the words to choose from, and the default.
std::string value(const CLI::Option& option)
{
  const std::string name = option.get_type_name(), standard = option.get_default_str();
  const std::size_t words = name.find(":{");
  return (words == std::string::npos ? type_name(option) : name.substr(words + 1)) +
         (standard.empty() ? "" : '=' + standard);
}

void write_literally(std::ostream& os, const std::string& text)
{
  if (!text.empty())
    os << ".PP\n.nf\n" << escaped(text) << (text.back() == '\n' ? "" : "\n") << ".fi\n";
}

void write_manual_page(std::ostream& os, const CLI::App& app)
{
  os << ".TH IDT 1 \"\" \"Intrinsic_triangulations " IDT_VERSION "\" \"User commands\"\n"
     << ".SH NAME\nidt \\- " << escaped(app.get_description()) << "\n.SH SYNOPSIS\n";
  for (const CLI::App* command : subcommands(app)) {
    os << ".B idt " << command->get_name() << "\n[\\fIOPTION\\fR]...";
    for (const CLI::Option* option : options(*command, true))
      os << " \\fI" << escaped(option->get_name(true)) << "\\fR" << (option->get_items_expected_max() > 1 ? "..." : "");
    os << "\n.br\n";
  }
  os << ".SH COMMANDS\n";
  for (const CLI::App* command : subcommands(app)) {
    os << ".SS idt " << command->get_name() << '\n' << escaped(command->get_description()) << ".\n";
    for (const bool are_positional : {true, false})
      for (const CLI::Option* option : options(*command, are_positional)) {
        os << ".TP\n\\fB" << escaped(option->get_name(are_positional, !are_positional)) << "\\fR";
        if (!are_positional && option->get_items_expected_max() > 0)
          os << " \\fI" << escaped(value(*option)) << "\\fR";
        os << '\n' << escaped(option->get_description()) << '\n';
      }
    write_literally(os, command->get_footer());
  }
  os << ".SH EXIT STATUS\n" << escaped(app.get_footer());
}

std::string long_names(const CLI::App& app)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : options(app, false))
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return boost::join(names, " ");
}

// Completes the values of an option or argument that has only a few; file names after other options with a value, and
// for inputs.
void write_bash_completion(std::ostream& os, const CLI::App& app)
{
  std::string names;
  for (const CLI::App* command : subcommands(app))
    names += command->get_name() + ' ';
  os << "_idt()\n{\n  local word=\"${COMP_WORDS[COMP_CWORD]}\" words=\"\"\n"
     << "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n    words=\"" << names << long_names(app)
     << "\"\n  elif [[ \"$word\" == -* ]]; then\n    case \"${COMP_WORDS[1]}\" in\n";
  for (const CLI::App* command : subcommands(app))
    os << "      " << command->get_name() << ") words=\"" << long_names(*command) << "\" ;;\n";
  os << "    esac\n  else\n"
     << "    case \"${COMP_WORDS[1]} ${COMP_WORDS[COMP_CWORD-1]}\" in\n";
  for (const CLI::App* command : subcommands(app))
    for (const CLI::Option* option : command->get_options())
      if (const std::string values = boost::join(words_of(*option), " "); !values.empty())
        os << "      \"" << command->get_name() << ' '
           << (option->nonpositional() ? "--" + option->get_lnames().front() : command->get_name()) << "\") words=\""
           << values << "\" ;;\n";
  os << "    esac\n  fi\n"
     << "  mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n}\n"
     << "complete -o default -F _idt idt\n";
}

// A text as one word of zsh or fish. Zsh also ends the description of an option at a bracket, and its parts at colons.
std::string quoted(std::string text)
{
  boost::replace_all(text, "'", "'\"'\"'");
  return "'" + text + "'";
}
std::string described(std::string text)
{
  for (const char* const special : {"\\", "[", "]", ":"})
    boost::replace_all(text, special, std::string("\\") + special);
  return text;
}

// The value of an option or argument in zsh: a few words, or a file.
std::string zsh_value(const CLI::Option& option)
{
  const std::string words = boost::join(words_of(option), " ");
  return ':' + described(option.nonpositional() ? type_name(option) : option.get_name(true)) + ':' +
         (words.empty() ? "_files" : '(' + words + ')');
}

void write_zsh_completion(std::ostream& os, const CLI::App& app)
{
  os << "#compdef idt\n_idt()\n{\n  local -a commands=(\n";
  for (const CLI::App* command : subcommands(app))
    os << "    " << quoted(command->get_name() + ':' + described(command->get_description())) << '\n';
  os << "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
     << "  local command=$words[2]\n  shift words\n  (( CURRENT-- ))\n  case $command in\n";
  for (const CLI::App* command : subcommands(app)) {
    os << "    " << command->get_name() << ") _arguments";
    for (const CLI::Option* option : options(*command, false)) {
      const std::string rest = '[' + described(option->get_description()) + ']' +
                               (option->get_items_expected_max() > 0 ? zsh_value(*option) : std::string());
      for (const std::string& name : option->get_snames())
        os << " \\\n      " << quoted('-' + name + rest);
      for (const std::string& name : option->get_lnames())
        os << " \\\n      " << quoted("--" + name + rest);
    }
    for (const CLI::Option* option : options(*command, true))
      os << " \\\n      " << quoted((option->get_items_expected_max() > 1 ? "*" : "") + zsh_value(*option));
    os << " ;;\n";
  }
  os << "  esac\n}\n_idt \"$@\"\n";
}

void write_fish_completion(std::ostream& os, const CLI::App& app)
{
  for (const CLI::App* command : subcommands(app))
    os << "complete -c idt -n __fish_use_subcommand -f -a " << command->get_name() << " -d "
       << quoted(command->get_description()) << '\n';
  for (const CLI::App* command : subcommands(app))
    for (const CLI::Option* option : command->get_options()) {
      const std::string words = boost::join(words_of(*option), " ");
      if (!option->nonpositional() && words.empty())
        continue; // files, which fish completes by itself
      os << "complete -c idt -n '__fish_seen_subcommand_from " << command->get_name() << '\'';
      for (const std::string& name : option->get_snames())
        os << " -s " << name;
      for (const std::string& name : option->get_lnames())
        os << " -l " << name;
      if (!words.empty())
        os << (option->nonpositional() ? " -x" : " -f") << " -a " << quoted(words);
      else if (option->get_items_expected_max() > 0)
        os << " -r";
      os << " -d " << quoted(option->get_description()) << '\n';
    }
}

} // namespace

void add_describe_command(CLI::App& app, Selected_command& selected)
{
  const auto form = std::make_shared<std::string>();
  const std::map<std::string, void (*)(std::ostream&, const CLI::App&)> writers{
    {"bash-completion", &write_bash_completion},
    {"fish-completion", &write_fish_completion},
    {"manual-page", &write_manual_page},
    {"zsh-completion", &write_zsh_completion}};
  std::vector<std::string> forms;
  for (const auto& writer : writers)
    forms.push_back(writer.first);
  CLI::App& command = *app.add_subcommand("describe", "Describe the command line");
  command.group(""); // hidden
  set_words(command.add_option("FORM", *form, "what as"), forms)->required();
  command.callback([&app, &selected, form, writers] {
    selected = [&app, form, writers] {
      writers.at (*form)(std::cout, app);
      return Exit_status::DONE;
    };
  });
}

} // namespace idt
