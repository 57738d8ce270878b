// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A triangulation as an object of Python.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H

#include "python/Signal_watch.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace idt_python {

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Calls from several threads of Python wait for each other.
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
  Surface(const Surface& other) : Surface(other, std::lock_guard<std::mutex>(other.mutex_)) {}
  Surface& operator=(const Surface&) = delete;

  // Calls a function with the triangulation, without Python's lock. Ours is taken afterwards: who waits for
  // it must not hold the other, which the one who has it may ask for.
  template <class Function>
  auto use(const Function& function)
  {
    return without_lock([&] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return function(triangulation_);
    });
  }

  // The first side of each input face, as it was given: the library remembers faces and sides, but not which is the
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

// The corners of a face: the sources of its three sides.
inline void append_corners(const IT::Delta_complex& complex, IT::Face_index f, std::vector<std::int64_t>& corners)
{
  IT::Halfedge_index h = complex.halfedge(f);
  for (int i = 0; i < 3; ++i, h = complex.next(h))
    corners.push_back(complex.source(h).idx());
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_H
