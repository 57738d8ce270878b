// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the package with the reference on mesh files and sample surfaces, a line for each; or prints results that
// other builds of this program must reproduce.

#include "reference/compare_with_reference.h"

#include "symmetric_surfaces.h"
#include "samples/sample_surfaces.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
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
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

samples::Indexed_triangles read(const std::string& path)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(path, points, polygons))
    throw std::runtime_error("cannot be read");
  samples::Indexed_triangles surface;
  for (const Point& p : points)
    surface.points.push_back({p.x(), p.y(), p.z()});
  for (const std::vector<std::size_t>& polygon : polygons) {
    if (polygon.size() != 3)
      throw std::runtime_error("has a face that is not a triangle");
    surface.triangles.push_back({std::uint32_t(polygon[0]), std::uint32_t(polygon[1]), std::uint32_t(polygon[2])});
  }
  return surface;
}

void write(const std::string& path, const samples::Indexed_triangles& surface)
{
  std::ofstream file(path);
  file << "OFF\n" << surface.points.size() << " " << surface.triangles.size() << " 0\n" << std::setprecision(17);
  for (const std::array<double, 3>& p : surface.points)
    file << p[0] << " " << p[1] << " " << p[2] << "\n";
  for (const std::array<std::uint32_t, 3>& t : surface.triangles)
    file << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
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

// The hardest cases for rounding: ties, near ties, and long strips.
std::vector<std::pair<std::string, samples::Indexed_triangles>> families()
{
  std::vector<std::pair<std::string, samples::Indexed_triangles>> result;
  for (std::size_t n : {12, 80, 185, 360})
    for (std::uint64_t seed : {0, 10}) {
      const std::string suffix = "_" + std::to_string(n) + (seed == 0 ? "" : "_rotated");
      result.emplace_back("prism" + suffix, samples::prism(n, seed));
      const std::size_t side = n / 12 + 1;
      result.emplace_back("grid" + suffix, samples::random_diagonal_grid(side, side, n, seed));
      result.emplace_back("cap" + suffix, samples::cap(1. / double(n * n * n * n), seed));
    }
  for (std::size_t n : {10, 20, 40}) {
    const std::string suffix = "_" + std::to_string(n);
    result.emplace_back("sphere" + suffix, samples::latitude_longitude_sphere(n, n / 2));
    result.emplace_back("sheet" + suffix, samples::sliver_sheet(n, 1e-9, 1e-9));
    result.emplace_back("sheared_grid" + suffix, samples::sheared_grid(n, n, 5));
    result.emplace_back("pillow" + suffix, samples::pillow(n));
    result.emplace_back("lantern" + suffix, samples::Schwarz_lantern(n, n));
    result.emplace_back("torus" + suffix, samples::bad_torus(n, n, n));
  }
  for (int folds : {1, 3, 5})
    result.emplace_back("mirrored_" + std::to_string(folds), symmetric_surfaces::mirrored_sheet(folds, true).mesh);
  return result;
}

// The edges that the package finds, whatever its own verification says of them.
void print_edges(const samples::Indexed_triangles& surface)
{
  const auto result = IT::intrinsic_Delaunay_triangulation(surface.points, surface.triangles);
  const IT::Delta_complex& complex = result.triangulation.connectivity();
  std::uint64_t hash = 0xcbf29ce484222325; // FNV-1a
  for (IT::Halfedge_index h : complex.halfedges())
    hash = (hash ^ complex.target(h).idx()) * 0x100000001b3;
  const auto verification = IT::verify_Delaunay(result.triangulation);
  std::cout << " flips " << result.report.flips << " edges " << hash << " ties " << verification.ties
            << " not Delaunay " << verification.not_Delaunay.size() + verification.inverted.size() << std::endl;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::cout << "usage: " << argv[0] << " FILE|SAMPLE...\n"
              << "       " << argv[0] << " --write-families FOLDER\n"
              << "       " << argv[0] << " --edges FILE...\n";
    return 2;
  }
#if defined(__FMA__) && defined(__GNUC__)
  if (!__builtin_cpu_supports("fma")) {
    std::cout << "skipped: compiled for a processor with fused multiply-adds\n";
    return 77;
  }
#endif
  bool all_agree = true;
  const auto guarded = [&all_agree](const std::string& name, const auto& function) {
    std::cout << name << std::flush;
    try {
      all_agree = function() && all_agree;
    } catch (const std::exception& error) {
      std::cout << " EXCEPTION " << error.what() << std::endl;
      all_agree = false;
    }
  };
  const std::string first = argv[1];
  const bool prints_edges = first == "--edges";
  if (first == "--write-families" && argc == 3) {
    for (const auto& [name, surface] : families())
      write(argv[2] + ("/" + name) + ".off", surface);
    return 0;
  }
  for (int n = prints_edges ? 2 : 1; n < argc; ++n) {
    const std::string name = argv[n];
    guarded(name, [&] {
      if (prints_edges)
        return print_edges(read(name)), true;
      if (std::ifstream(name))
        return report(read(name));
      return std::visit([](const auto& surface) { return report(surface); }, samples::make_sample(name));
    });
  }
  return all_agree ? 0 : 1;
}
