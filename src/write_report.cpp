// SPDX-License-Identifier: GPL-3.0-or-later

#include "Triangulation_result.h"

#include "peak_memory.h"
#include "text.h"

#include <iomanip>
#include <sstream>

namespace idt {
namespace {

class Report_writer
{
public:
  explicit Report_writer(std::ostream& os) : os_(os) {}

  void line(const char* label, const std::string& text)
  {
    os_ << "  " << std::left << std::setw(16) << label << text << '\n';
  }

private:
  std::ostream& os_;
};

std::string weights_text(const Weight_summary& summary)
{
  if (!summary.smallest)
    return "no interior edge";
  return "smallest " + in_short(*summary.smallest) + ", " + with_separators(summary.negative) +
         " negative";
}

} // namespace

void write_report(std::ostream& os, const Triangulation_result& result)
{
  const Surface_counts& counts = result.counts;
  const Outcome& outcome = result.outcome;
  const Surface& surface = result.surface;

  os << surface.path << '\n';
  Report_writer report(os);
  report.line("surface", counted(counts.vertices, "vertex", "vertices") + ", " +
                           counted(counts.edges, "edge", "edges") + ", " +
                           counted(counts.faces, "face", "faces"));
  report.line("topology",
              counted(counts.components, "component", "components") + ", " +
                counted(counts.boundary_edges, "boundary edge", "boundary edges") +
                ", Euler characteristic " + std::to_string(counts.euler_characteristic));
  for (const std::string& note : surface.notes)
    report.line("note", note);
  if (surface.mollification)
    report.line("mollified",
                counted(surface.mollification->number_of_changed_edges, "edge", "edges") +
                  " longer by at most " + in_short(surface.mollification->epsilon) + " (" +
                  in_short(100 * surface.mollification->largest_relative_change) + " %)");
  std::string number_type = name(result.options.number_type);
  if (result.options.number_type == Number_type::MPFR)
    number_type += ", " + std::to_string(result.options.precision) + " bits";
  report.line("number type", number_type);
  report.line("flips", with_separators(outcome.report.flips) + " in " +
                         with_separators(outcome.report.tests) + " tests");
  report.line("changed edges", with_separators(number_of_changed_edges(outcome)));
  if (result.overlay) {
    report.line("crossings", with_separators(result.overlay->crossings));
    report.line("simple edges", with_separators(result.overlay->simple));
    report.line("longest edge", counted(result.overlay->longest, "segment", "segments"));
  }
  report.line("loops", with_separators(counts.loops));
  report.line("multiple edges", with_separators(counts.multiple_edges));
  report.line("weights before", weights_text(outcome.weights_before));
  report.line("weights after", weights_text(outcome.weights_after));

  std::string times = "read " + seconds_text(surface.read_seconds) + ", build " +
                      seconds_text(surface.build_seconds + outcome.build_seconds) + ", flip " +
                      seconds_text(outcome.flip_seconds);
  if (result.overlay)
    times += ", overlay " + seconds_text(result.overlay->seconds);
  if (result.write_seconds > 0)
    times += ", write " + seconds_text(result.write_seconds);
  report.line("time", times);
  report.line("peak memory", in_short(double(peak_memory_bytes()) / (1 << 20)) + " MiB");
  report.line("status", describe_status(result));
}

} // namespace idt
