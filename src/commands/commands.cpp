// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"

#include "commands/command_line.h"
#include "input/standard_input.h"
#include "system/Interruption.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <exception>
#include <new>

namespace idt {
namespace {

Exit_status say(const std::string& message, Exit_status status)
{
  std::cout.flush();
  if (!message.empty()) // the standard output has no reader
    std::cerr << "idt: " << message << std::endl;
  return status;
}

} // namespace

CLI::Option* add_repair_option(CLI::App& command, Repair_options& repair)
{
  CLI::Option* const result = command.add_flag(
    "--repair", repair.is_wanted,
    "first turn a mesh that is not a surface into one: triangulate polygons, orient faces, cut where more than two "
    "faces or several fans meet, close seams, remove duplicate faces and unused vertices; everything is reported");
  add_option(command, "--stitch", repair.stitching_tolerance, "T",
             "split edges at the vertices where others end within them, exactly or not farther than T from them, "
             "and merge border vertices that are not farther than T apart")
    ->needs(result);
  return result;
}

void add_view_option(CLI::App& command, std::string& path)
{
  add_option(command, "--view", path, "F.html", "write a page that shows the result in a browser, as `idt view` does");
}

Exit_status report_current_exception(const std::string& input)
{
  const std::string prefix = input.empty() ? std::string() : input + ": ";
  const auto named = [&prefix, &input](const char* text) {
    const std::string message = with_shown_names(text);
    return message.compare(0, input.size(), input) == 0 ? message : prefix + message;
  };
  namespace IT = CGAL::Intrinsic_triangulations;
  try {
    throw;
  } catch (const Usage_error& error) {
    return say(error.what(), Exit_status::WRONG_USAGE);
  } catch (const Output_error& error) {
    return say(error.what(), Exit_status::OUTPUT_FAILED);
  } catch (const IT::Invalid_surface_error& error) {
    return say(named(error.what()), Exit_status::UNUSABLE_INPUT);
  } catch (const IT::Invalid_argument_error& error) {
    return say(named(error.what()), Exit_status::UNUSABLE_INPUT); // of a table, or of an option for this surface
  } catch (const IT::Invalid_point_error& error) {
    return say(named(error.what()), Exit_status::UNUSABLE_INPUT);
  } catch (const IT::Error& error) {
    return say(named(error.what()), Exit_status::NOT_FINISHED);
  } catch (const std::bad_alloc&) {
    return say(prefix + "there is not enough memory", Exit_status::OUTPUT_FAILED);
  } catch (const std::exception& error) {
    return say(prefix + "internal error: " + error.what(), Exit_status::OUTPUT_FAILED);
  }
}

Exit_status for_each_input(const std::vector<std::string>& inputs,
                           const std::function<Exit_status(const std::string&)>& function)
{
  Exit_status status = Exit_status::DONE;
  for (const std::string& input : inputs) {
    if (is_interrupted()) {
      keep_first_failure(status, say(input + ": cancelled", Exit_status::NOT_FINISHED));
      break;
    }
    try {
      const Exit_status end = function(input);
      keep_first_failure(status, end);
      if (end == Exit_status::OUTPUT_FAILED)
        break;
    } catch (const Output_error&) {
      keep_first_failure(status, report_current_exception());
      break;
    } catch (...) {
      keep_first_failure(status, report_current_exception(input));
    }
  }
  return status;
}

} // namespace idt
