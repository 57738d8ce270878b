// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points and polygons as CGAL's readers fill them.

#ifndef IDT_FORMATS_POLYGON_SOUP_H
#define IDT_FORMATS_POLYGON_SOUP_H

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace idt {

// The corners of a polygon while it is read: no allocation for triangles and
// quadrangles, and no attempt to hold a number of corners that only a broken
// file announces.
class Corners : public boost::container::small_vector<std::uint32_t, 4>
{
  using Base = boost::container::small_vector<std::uint32_t, 4>;

public:
  void resize(const std::size_t size)
  {
    if (size > (std::size_t(1) << 24))
      throw std::length_error("a face claims to have " + std::to_string(size) + " corners");
    Base::resize(size);
  }
};
using Points = std::vector<CGAL::Simple_cartesian<double>::Point_3>;
using Polygons = std::vector<Corners>;

} // namespace idt

#endif // IDT_FORMATS_POLYGON_SOUP_H
