// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A triangulation as a Python object.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H

#include "python/Signal_watch.h"
#include "python/arrays.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace idt_python {

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Calls from several Python threads wait for each other.
class Surface
{
public:
  // \pre the triangulation was not flipped yet, or was read from a file
  explicit Surface(Triangulation triangulation, bool is_read = false) : triangulation_(std::move(triangulation))
  {
    const IT::Delta_complex& complex = is_read ? triangulation_.input() : triangulation_.connectivity();
    input_sides_.reserve(complex.number_of_faces());
    for (IT::Face_index f : complex.faces())
      input_sides_.push_back(complex.halfedge(f));
    triangulation_.set_interruption(&Signal_watch::goes_on);
  }
  Surface(Triangulation triangulation, std::vector<IT::Halfedge_index> input_sides)
    : triangulation_(std::move(triangulation)), input_sides_(std::move(input_sides))
  {
    triangulation_.set_interruption(&Signal_watch::goes_on);
  }
  Surface(const Surface& other) : Surface(other, std::lock_guard<std::mutex>(other.mutex_)) {}
  Surface& operator=(const Surface&) = delete;

  // Calls a function with the triangulation, without Python's lock. Our lock is taken afterwards: a thread that waits
  // for it must not hold Python's, which the owner of ours may request.
  template <class Function>
  auto use(const Function& function)
  {
    return without_lock([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return function(triangulation_);
    });
  }

  // The first side of each input face, as given: the library remembers faces and sides, but not which side is the
  // first.
  const std::vector<IT::Halfedge_index>& input_sides() const { return input_sides_; }

private:
  Surface(const Surface& other, const std::lock_guard<std::mutex>&)
    : triangulation_(other.triangulation_), input_sides_(other.input_sides_)
  {
    triangulation_.set_interruption(&Signal_watch::goes_on);
  }

  Triangulation triangulation_;
  std::vector<IT::Halfedge_index> input_sides_;
  mutable std::mutex mutex_;
};

// Points of a surface as arrays: the number of a face, and three coordinates for its corners in order.
class Point_table
{
public:
  // \param first_side the side of the face that begins at its first corner
  void append(const IT::Delta_complex& complex, const IT::Surface_point& point, IT::Halfedge_index first_side)
  {
    faces_.push_back(complex.face(first_side).idx());
    coordinates_.push_back(IT::coordinates_from(complex, point, first_side));
  }

  py::tuple to_arrays() { return py::make_tuple(to_array(std::move(faces_)), to_array(std::move(coordinates_))); }

private:
  std::vector<std::int64_t> faces_;
  std::vector<std::array<double, 3>> coordinates_;
};

// Values at vertices, in the form that the heat methods take.
inline std::vector<std::pair<IT::Vertex_index, double>> values_at(const Indices& vertices, const Doubles& values)
{
  const auto v = copied(vertices);
  const auto x = copied(values);
  require(v.size() == x.size(), "there are not as many values as vertices");
  std::vector<std::pair<IT::Vertex_index, double>> result;
  for (std::size_t i = 0; i < v.size(); ++i)
    result.emplace_back(IT::Vertex_index(v[i]), x[i]);
  return result;
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H
