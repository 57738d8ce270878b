// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/distance_lines.h"

#include "commands/command_line.h"
#include "commands/commands.h"
#include "input/formats/vtp.h"
#include "output/Output_file.h"
#include "system/Interruption.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Points = std::vector<std::array<double, 3>>;

constexpr double most_steps = 10000;

void check_path(const std::string& option, const std::string& path)
{
  const std::string type = extension_with_format(path, "csv");
  if (!path.empty() && type != ".csv" && type != ".vtp" && type != ".obj")
    throw Usage_error(option + ": " + path + ": lines are written as a file whose name ends in .csv, .vtp or .obj");
}

std::vector<double> multiples(double step, double largest)
{
  const double n = std::floor(largest / step);
  if (n > most_steps)
    throw Usage_error("--isoline-step: up to the largest distance, " + in_short(largest) + ", there are " +
                      in_short(n) + " steps of " + in_short(step) + ": give a larger one, " +
                      with_separators(std::uint64_t(most_steps)) + " steps are the most");
  std::vector<double> result;
  for (double i = 1; i <= n; ++i)
    result.push_back(i * step);
  return result;
}

struct Line_writer
{
  const IT::Delta_complex& input;
  const Points& points;
  const std::vector<IT::Surface_line>& lines;
  bool are_isolines;

  std::array<double, 3> place(const IT::Surface_point& p) const { return IT::point_in_space(input, points, p); }
  static bool is_closed(const IT::Surface_line& line)
  {
    const IT::Surface_point &p = line.points.front(), &q = line.points.back();
    return p.halfedge == q.halfedge && p.coordinates == q.coordinates;
  }

  // The barycentric coordinates belong to the vertices named beside them.
  void write_csv(std::ostream& os) const
  {
    os << "line,face,vertex_0,vertex_1,vertex_2,coordinate_0,coordinate_1,coordinate_2"
       << (points.empty() ? "" : ",x,y,z") << (are_isolines ? ",distance\n" : ",source_0,source_1\n");
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const IT::Surface_point& p : lines[i].points) {
        const IT::Halfedge_index h = p.halfedge;
        os << i << ',' << input.face(h).idx() << ',' << input.source(h).idx() << ',' << input.target(h).idx() << ','
           << input.target(input.next(h)).idx();
        for (double x : p.coordinates)
          os << ',' << in_full(x);
        if (!points.empty())
          for (double x : place(p))
            os << ',' << in_full(x);
        if (are_isolines)
          os << ',' << in_full(lines[i].distance) << '\n';
        else
          os << ',' << lines[i].sources[0] << ',' << lines[i].sources[1] << '\n';
      }
  }

  // A closed line has its first point only once.
  void write_obj(std::ostream& os) const
  {
    std::size_t n = 1;
    for (const IT::Surface_line& line : lines) {
      if (are_isolines)
        os << "g distance_" << in_full(line.distance) << '\n';
      else
        os << "g sources_" << line.sources[0] << '_' << line.sources[1] << '\n';
      const std::size_t size = line.points.size() - (is_closed(line) ? 1 : 0);
      for (std::size_t i = 0; i < size; ++i) {
        const auto [x, y, z] = place(line.points[i]);
        os << "v " << in_full(x) << ' ' << in_full(y) << ' ' << in_full(z) << '\n';
      }
      os << 'l';
      for (std::size_t i = 0; i < line.points.size(); ++i)
        os << ' ' << n + i % size;
      os << '\n';
      n += size;
    }
  }

  void write_vtp(std::ostream& os) const
  {
    Named_values faces{"input_face", {}, 1, "Int32"}, distances{"distance", {}}, first{"source_0", {}, 1, "Int32"},
      second{"source_1", {}, 1, "Int32"};
    Points places;
    Flat_polygons polylines;
    for (const IT::Surface_line& line : lines) {
      for (const IT::Surface_point& p : line.points) {
        polylines.corners.push_back(std::uint32_t(places.size()));
        places.push_back(place(p));
        faces.values.push_back(input.face(p.halfedge).idx());
      }
      polylines.ends.push_back(places.size());
      distances.values.push_back(line.distance);
      first.values.push_back(line.sources[0]);
      second.values.push_back(line.sources[1]);
    }
    idt::write_vtp(os, places, Flat_polygons(), {faces}, polylines,
                   are_isolines ? std::vector<Named_values>{distances} : std::vector<Named_values>{first, second});
  }

  void write(const std::string& path) const
  {
    const std::string type = extension_with_format(path, "csv");
    write_file(path, [&](std::ostream& os) {
      if (type == ".vtp")
        write_vtp(os);
      else if (type == ".obj")
        write_obj(os);
      else
        write_csv(os);
    });
  }
};

} // namespace

void Line_options::add_options(CLI::App& command)
{
  add_option(command, "--isolines", distances, "D[,D...]",
             "the lines at these distances from the sources; with --signed, negative ones are to the right")
    ->delimiter(',')
    ->allow_extra_args(false);
  add_option(command, "--isoline-step", step, "S", "the lines at all multiples of a distance");
  add_option(command, "--lines", lines_path, "F.(csv|vtp|obj)",
             "write the isolines as polylines on the input; the table can be a --source-curve");
  add_option(command, "--borders", borders_path, "F.(csv|vtp|obj)",
             "write the lines where the nearest source changes, likewise; sources are numbered as for --labels");
  add_option(command, "--chord-tolerance", chord_tolerance, "T",
             "by how much the distance at a point between those of a line may differ, in the unit of the input; by "
             "default a ten-thousandth of the largest distance");
}

void Line_options::check(bool are_signed, bool has_view) const
{
  check_path("--lines", lines_path);
  check_path("--borders", borders_path);
  if (has_isolines() && lines_path.empty() && !has_view)
    throw Usage_error("--isolines needs --lines or --view, to write or show them");
  if (!lines_path.empty() && !has_isolines())
    throw Usage_error("--lines needs --isolines or --isoline-step");
  if (!distances.empty() && step)
    throw Usage_error("--isolines and --isoline-step exclude each other");
  if (chord_tolerance && !are_wanted())
    throw Usage_error("--chord-tolerance needs --isolines, --isoline-step or --borders");
  for (double d : distances)
    if (!std::isfinite(d) || d == 0 || (d < 0 && !are_signed))
      throw Usage_error("--isolines: " + in_short(d) + " is " +
                        (d == 0  ? "the distance of the sources themselves"
                         : d < 0 ? "negative: the right side of a curve needs --signed"
                                 : "no finite distance"));
  if (step && !(*step > 0 && std::isfinite(*step)))
    throw Usage_error("--isoline-step: S is a positive number");
  if (chord_tolerance && !(*chord_tolerance > 0 && std::isfinite(*chord_tolerance)))
    throw Usage_error("--chord-tolerance: T is a positive number");
}

void Distance_lines::show(View& view, const Points& points) const
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto* found : {&isolines, &borders})
    if (*found)
      for (const IT::Surface_line& line : (*found)->lines) {
        view.path.push_back({none, none, none});
        for (const IT::Surface_point& p : line.points)
          view.path.push_back(IT::point_in_space(input, points, p));
      }
  view.path_name = !borders ? "the isolines" : !isolines ? "the borders" : "the isolines and borders";
}

std::vector<std::string> Distance_lines::warnings() const
{
  std::vector<std::string> result;
  if (isolines && isolines->lines.empty())
    result.push_back("--isoline-step: there is no isoline, as no point is so far from the sources");
  if (borders && borders->lines.empty())
    result.push_back("--borders: there is no border, as no two sources have cells that meet");
  return result;
}

std::string Distance_lines::text() const
{
  std::string result;
  if (isolines)
    result = counted(isolines->lines.size(), "isoline", "isolines");
  if (borders)
    result += (isolines ? ", " : "") + counted(borders->lines.size(), "border", "borders");
  return result;
}

void Distance_lines::write(const Line_options& options, const Points& points) const
{
  for (const std::string& path : {options.lines_path, options.borders_path})
    if (points.empty() && !path.empty() && extension_with_format(path, "csv") != ".csv")
      throw Usage_error(path + ": the input has only lengths, no points: write a .csv file");
  if (isolines)
    Line_writer{input, points, isolines->lines, true}.write(options.lines_path);
  if (borders)
    Line_writer{input, points, borders->lines, false}.write(options.borders_path);
}

void Distance_lines::set_signs(const std::vector<std::vector<IT::Surface_point>>& curve)
{
  if (!isolines)
    return;
  std::vector<IT::Surface_point> points;
  for (const IT::Surface_line& line : isolines->lines)
    points.push_back(line.points.front());
  const std::vector<CGAL::Sign> sides = IT::sides_of_curve(input, curve, points);
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (sides[i] == CGAL::NEGATIVE)
      isolines->lines[i].distance = -isolines->lines[i].distance;
}

// A distance is expected to be there if it was given, and not made from a step.
void Distance_lines::keep_wanted(const Line_options& options, bool are_signed, const std::vector<double>& of_vertices)
{
  if (!isolines || options.step)
    return;
  std::vector<IT::Surface_line>& lines = isolines->lines;
  if (are_signed)
    lines.erase(std::remove_if(lines.begin(), lines.end(),
                               [&](const IT::Surface_line& line) {
                                 return std::count(options.distances.begin(), options.distances.end(), line.distance) ==
                                        0;
                               }),
                lines.end());
  for (double d : options.distances) {
    if (std::any_of(lines.begin(), lines.end(), [d](const IT::Surface_line& line) { return line.distance == d; }))
      continue;
    double farthest = 0;
    for (double x : of_vertices)
      if (std::isfinite(x) && x * d > 0 && std::abs(x) > std::abs(farthest))
        farthest = x;
    throw Usage_error("--isolines: no line has the distance " + in_short(d) + ": the vertex farthest " +
                      (!are_signed ? "from the sources"
                       : d > 0     ? "to the left of the curve"
                                   : "to the right of the curve") +
                      " has " + in_short(farthest));
  }
}

Distance_lines find_lines(const Line_options& options,
                          const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>& triangulation,
                          const std::vector<IT::Geodesic_source>& sources, double tolerance, double largest)
{
  const auto np = CGAL::parameters::tolerance(tolerance)
                    .maximum_deviation(options.chord_tolerance.value_or(std::numeric_limits<double>::infinity()))
                    .visitor([] { return !is_interrupted(); });
  Distance_lines result;
  result.input = triangulation.input();
  if (options.has_isolines()) {
    std::vector<double> distances = options.distances;
    if (options.step) {
      double longest = 0; // no point of a face is farther from its corners
      for (IT::Edge_index e : triangulation.connectivity().edges())
        longest = (std::max)(longest, triangulation.length(e));
      distances = multiples(*options.step, largest + longest);
    }
    for (double& d : distances)
      d = std::abs(d);
    result.isolines = IT::isolines(triangulation, sources, distances, np);
  }
  if (!options.borders_path.empty())
    result.borders = IT::borders_of_cells(triangulation, sources, np);
  return result;
}

} // namespace idt
