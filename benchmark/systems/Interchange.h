// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data that the programs of this folder exchange: surfaces and results, as files on one machine. This depends
// neither on this package nor on any other, so that each system is built with only its own headers.

#ifndef IDT_BENCHMARK_SYSTEMS_INTERCHANGE_H
#define IDT_BENCHMARK_SYSTEMS_INTERCHANGE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace systems {

// Side 3 f + i runs from corner i of face f to corner (i + 1) % 3.
struct Triangles
{
  std::vector<std::array<std::uint32_t, 3>> corners; // vertices, counterclockwise
  std::vector<std::int64_t> opposite;                // of each side; -1 on the border
  std::vector<double> lengths;                       // of each side

  std::size_t number_of_sides() const { return 3 * corners.size(); }
  std::uint32_t source(std::size_t side) const { return corners[side / 3][side % 3]; }
  std::uint32_t target(std::size_t side) const { return source(next(side)); }
  std::uint32_t apex(std::size_t side) const { return source(next(next(side))); }
  static std::size_t next(std::size_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
};

struct Surface
{
  std::uint64_t number_of_vertices = 0;
  std::vector<std::array<double, 3>> points; // empty if the lengths define the surface
  Triangles triangles;                       // without lengths if there are points

  bool is_gluing() const { return points.empty(); }
};

struct Matrix_entry
{
  std::uint32_t row, column;
  double value;
};

struct Result
{
  double triangulation_seconds = 0;    // from the mesh to the finished intrinsic Delaunay triangulation
  double task_seconds = 0;             // the additional time for overlay or Laplacian
  Triangles triangles;                 // for the tasks triangulation and overlay
  std::vector<std::int64_t> crossings; // for the overlay: how many input edges each side crosses
  // For the Laplacian: half of the sum of the cotangents, negative off the diagonal; entries in the same place add up.
  std::vector<Matrix_entry> Laplacian;
};

namespace internal {

template <class T>
void write(std::ostream& os, const std::vector<T>& values)
{
  static_assert(std::is_trivially_copyable_v<T>);
  const std::uint64_t size = values.size();
  os.write(reinterpret_cast<const char*>(&size), sizeof size);
  os.write(reinterpret_cast<const char*>(values.data()), std::streamsize(size * sizeof(T)));
}

template <class T>
void read(std::istream& is, std::vector<T>& values)
{
  std::uint64_t size = 0;
  is.read(reinterpret_cast<char*>(&size), sizeof size);
  if (!is)
    throw std::runtime_error("the file is cut off");
  values.resize(size);
  is.read(reinterpret_cast<char*>(values.data()), std::streamsize(size * sizeof(T)));
  if (!is)
    throw std::runtime_error("the file is cut off");
}

template <class Stream>
Stream open(const std::string& path)
{
  Stream stream(path, std::ios::binary);
  if (!stream)
    throw std::runtime_error(path + ": cannot be opened");
  return stream;
}

} // namespace internal

inline void write_surface(const std::string& path, const Surface& surface)
{
  auto os = internal::open<std::ofstream>(path);
  internal::write(os, std::vector<std::uint64_t>{surface.number_of_vertices});
  internal::write(os, surface.points);
  internal::write(os, surface.triangles.corners);
  internal::write(os, surface.triangles.opposite);
  internal::write(os, surface.triangles.lengths);
}

inline Surface read_surface(const std::string& path)
{
  auto is = internal::open<std::ifstream>(path);
  Surface surface;
  std::vector<std::uint64_t> number;
  internal::read(is, number);
  surface.number_of_vertices = number.at(0);
  internal::read(is, surface.points);
  internal::read(is, surface.triangles.corners);
  internal::read(is, surface.triangles.opposite);
  internal::read(is, surface.triangles.lengths);
  return surface;
}

inline void write_result(const std::string& path, const Result& result)
{
  auto os = internal::open<std::ofstream>(path);
  internal::write(os, std::vector<double>{result.triangulation_seconds, result.task_seconds});
  internal::write(os, result.triangles.corners);
  internal::write(os, result.triangles.opposite);
  internal::write(os, result.triangles.lengths);
  internal::write(os, result.crossings);
  internal::write(os, result.Laplacian);
}

inline Result read_result(const std::string& path)
{
  auto is = internal::open<std::ifstream>(path);
  Result result;
  std::vector<double> seconds;
  internal::read(is, seconds);
  result.triangulation_seconds = seconds.at(0);
  result.task_seconds = seconds.at(1);
  internal::read(is, result.triangles.corners);
  internal::read(is, result.triangles.opposite);
  internal::read(is, result.triangles.lengths);
  internal::read(is, result.crossings);
  internal::read(is, result.Laplacian);
  return result;
}

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_INTERCHANGE_H
