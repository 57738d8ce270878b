// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points of a surface as arrays: the number of a face, and three coordinates for its corners in order.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H

#include "python/arrays.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <array>
#include <cstdint>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

// The points of a result.
class Point_table
{
public:
  // \param first_side the side of the face that begins at its first corner
  void append(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
              const CGAL::Intrinsic_triangulations::Surface_point& point,
              CGAL::Intrinsic_triangulations::Halfedge_index first_side)
  {
    faces_.push_back(complex.face(first_side).idx());
    for (double x : CGAL::Intrinsic_triangulations::coordinates_from(complex, point, first_side))
      coordinates_.push_back(x);
  }

  py::tuple to_arrays() { return py::make_tuple(to_array(std::move(faces_)), to_array(std::move(coordinates_), 3)); }

private:
  std::vector<std::int64_t> faces_;
  std::vector<double> coordinates_;
};

// Reads bytes where they are.
class Bytes_in_place : public std::streambuf
{
public:
  // \param bytes which have to live as long
  explicit Bytes_in_place(const py::bytes& bytes)
  {
    char* data = nullptr;
    py::ssize_t size = 0;
    if (PyBytes_AsStringAndSize(bytes.ptr(), &data, &size) != 0)
      throw py::error_already_set();
    setg(data, data, data + size);
  }
};

// Appends bytes to a text, which a stream of strings would copy in the end.
class Bytes_to_text : public std::streambuf
{
public:
  std::string text;

private:
  std::streamsize xsputn(const char* s, std::streamsize n) override
  {
    text.append(s, std::size_t(n));
    return n;
  }
  int_type overflow(int_type c) override
  {
    text.push_back(traits_type::to_char_type(c));
    return c;
  }
};

// The first sides of faces as numbers, for another process, and back.
inline py::array sides_to_array(const std::vector<IT::Halfedge_index>& sides)
{
  std::vector<std::uint32_t> numbers;
  for (IT::Halfedge_index h : sides)
    numbers.push_back(h.idx());
  return to_array(std::move(numbers));
}
inline std::vector<IT::Halfedge_index> sides_of_array(const Indices& numbers)
{
  std::vector<IT::Halfedge_index> sides;
  for (std::uint32_t h : copied(numbers))
    sides.push_back(IT::Halfedge_index(h));
  return sides;
}
inline void check_sides(const IT::Delta_complex& input, const std::vector<IT::Halfedge_index>& sides)
{
  bool are_good = sides.size() == input.number_of_faces();
  for (std::uint32_t f = 0; are_good && f < sides.size(); ++f)
    are_good = sides[f].idx() < input.number_of_halfedges() && input.face(sides[f]) == IT::Face_index(f);
  if (!are_good)
    throw IT::Invalid_argument_error("the state of a surface has sides that are none of its faces");
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H
