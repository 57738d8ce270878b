// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of any content, in any format that the command reads: each is refused with a message that names it, or it is a
// surface that can be made Delaunay and has the faces of the file.

#include "input/Surface.h"
#include "check_core.h"
#include "faces_of_file.h"
#include "fuzz_target.h"
#include "system/system_calls.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace {

using fuzz::require;
namespace IT = CGAL::Intrinsic_triangulations;
using Defect = IT::Invalid_surface_error::Defect;

constexpr std::uint32_t most_faces = 40; // that are worth the time
constexpr std::uint64_t flip_budget = 30;
constexpr std::uint32_t crossing_budget = 80;

// A temporary file of this process.
class Input_file
{
public:
  Input_file() : folder_(idt::make_temporary_folder()) { require(!folder_.empty(), "there is room for a file"); }
  Input_file(const Input_file&) = delete;
  Input_file& operator=(const Input_file&) = delete;
  ~Input_file()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string write(const std::string& extension, const std::uint8_t* data, std::size_t size) const
  {
    const std::string path = folder_ + "/input." + extension;
    std::filesystem::remove(path);
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(data), std::streamsize(size));
    return path;
  }

private:
  std::string folder_;
};

template <class Traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const idt::Surface& surface)
{
  if (surface.has_points())
    return IT::Intrinsic_triangulation<Traits>(surface.connectivity, surface.points);
  return IT::Intrinsic_triangulation<Traits>::from_lengths(surface.connectivity, surface.lengths);
}

bool has_face_without_area(const fuzz::Filtered_triangulation& triangulation)
{
  const auto& complex = triangulation.connectivity();
  for (IT::Face_index f : complex.faces())
    if (IT::internal::engine(triangulation).sign_of_area(f) == CGAL::ZERO)
      return true;
  return false;
}

void check_exact(const idt::Surface& surface)
{
  auto triangulation = make_triangulation<IT::Filtered_edge_length_traits>(surface);
  const bool has_no_area = has_face_without_area(triangulation);
  fuzz::Recording_visitor record(triangulation.connectivity(), crossing_budget);
  try {
    const IT::Flip_report report =
      IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(record)).maximum_number(flip_budget));
    require(report.status != IT::Flip_status::NOT_FLIPPABLE && report.status != IT::Flip_status::INCONSISTENT &&
              report.status != IT::Flip_status::UNDECIDED,
            "exact decisions do not contradict each other");
    require(triangulation.connectivity().is_valid(true), "the connectivity is valid");
    require(report.status != IT::Flip_status::DELAUNAY || IT::verify_Delaunay(triangulation).is_Delaunay(),
            "the result is Delaunay");
  } catch (const IT::Invalid_surface_error& error) {
    require(has_no_area && error.defect() == Defect::ZERO_LENGTH_EDGE,
            std::string("flips fail for no good reason: ") + error.what());
  }
}

void check_rounded(const idt::Surface& surface)
{
  auto triangulation = make_triangulation<IT::Edge_length_traits<double>>(surface);
  IT::flip_to_Delaunay(triangulation, CGAL::parameters::maximum_number(flip_budget));
  require(triangulation.connectivity().is_valid(true), "the connectivity is valid after rounded flips");
}

// That of the contents, if the name tells another one.
std::string format_of(const IT::Polygon_soup& soup, const std::string& by_name)
{
  const std::string text = "the contents are those of a file whose name ends with .";
  for (const std::string& warning : soup.warnings)
    if (warning.compare(0, text.size(), text) == 0)
      return warning.substr(text.size());
  return by_name;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<const char*, 6> extensions{"off", "obj", "ply", "stl", "ts", "gluing"};
  static const Input_file file;
  if (size == 0)
    return 0;
  const std::string path = file.write(extensions[data[0] % extensions.size()], data + 1, size - 1);
  idt::Surface surface;
  try {
    surface = idt::load_surface(path);
  } catch (const IT::Error& error) {
    const std::string message = error.what();
    require(message.size() > path.size() + 2 && message.compare(0, path.size() + 2, path + ": ") == 0,
            "a message begins with the name of the file: " + message);
    return 0;
  }
  if (const std::string extension = extensions[data[0] % extensions.size()]; extension != "gluing") {
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const IT::Polygon_soup soup = IT::read_polygon_soup(path);
    const std::string difference = faces_of_file::difference(format_of(soup, extension), bytes, soup);
    require(difference.empty(), "what was read is what the file holds: " + difference);
  }
  require(surface.connectivity.is_valid(true), "what was read is a surface");
  require(surface.connectivity.number_of_faces() > 0, "a surface has a face");
  if (surface.connectivity.number_of_faces() > most_faces)
    return 0;
  try {
    check_exact(surface);
    check_rounded(surface);
  } catch (const IT::Invalid_surface_error& error) {
    // The lengths of a gluing file are looked at here for the first time, and so is whether the
    // small coordinates keep their bits beside the large ones.
    require(error.what()[0] != 0, "an exception has a message");
    require(!surface.has_points() || error.defect() == Defect::OUT_OF_RANGE,
            std::string("what was examined and accepted is refused: ") + error.what());
  }
  return 0;
}
