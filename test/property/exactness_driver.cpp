// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the package with the reference on mesh files and sample surfaces, a line for each.

#include "reference/compare_with_reference.h"

#include <CGAL/IO/polygon_soup_io.h>
#include "samples/sample_surfaces.h"
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

IT::Indexed_triangles read(const std::string& path)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons))
    throw std::runtime_error("cannot be read");
  IT::Indexed_triangles surface;
  for (const Point& p : points)
    surface.points.push_back({p.x(), p.y(), p.z()});
  for (const std::vector<std::size_t>& polygon : polygons) {
    if (polygon.size() != 3)
      throw std::runtime_error("has a face that is not a triangle");
    surface.triangles.push_back({std::uint32_t(polygon[0]), std::uint32_t(polygon[1]), std::uint32_t(polygon[2])});
  }
  return surface;
}

double seconds_since(std::chrono::steady_clock::time_point start)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Surface>
bool report(const Surface& surface)
{
  const auto start = std::chrono::steady_clock::now();
  double package_seconds = 0;
  reference::Comparison_options options;
  options.go_further = [&] { return (package_seconds = seconds_since(start)) < 300; };
  const reference::Comparison c = reference::compare(surface, options);
  std::cout << " flips " << c.flips << " reference " << c.reference_flips << " ties " << c.ties << " stages";
  for (std::uint64_t count : c.stages.decided)
    std::cout << " " << count;
  std::cout << std::setprecision(4) << " ulp " << c.worst_length << " area " << c.worst_area << " cotangent "
            << c.worst_cotangent << " weight " << c.worst_weight << " sine 1e" << c.smallest_sine << " tie 1e"
            << c.largest_tie_sine << " rounding 1e" << c.inconsistency << " seconds " << package_seconds << " of "
            << seconds_since(start) << " disagreements " << c.disagreements.size() << "\n"
            << c.message() << std::flush;
  return c.agrees();
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::cout << "usage: " << argv[0] << " FILE|SAMPLE...\n";
    return 2;
  }
  bool all_agree = true;
  for (int n = 1; n < argc; ++n) {
    const std::string name = argv[n];
    std::cout << name << std::flush;
    try {
      if (std::ifstream(name))
        all_agree = report(read(name)) && all_agree;
      else
        all_agree = std::visit([](const auto& surface) { return report(surface); }, IT::make_sample(name)) && all_agree;
    } catch (const std::exception& error) {
      std::cout << " EXCEPTION " << error.what() << std::endl;
      all_agree = false;
    }
  }
  return all_agree ? 0 : 1;
}
