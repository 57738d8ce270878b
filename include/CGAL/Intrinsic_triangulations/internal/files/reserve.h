// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Room for what a file may hold.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_RESERVE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_RESERVE_H

#include <CGAL/Intrinsic_triangulations/internal/system/Huge_page_allocator.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Makes room for n more elements, in huge pages: what is not used of it costs address space alone, and page faults would take as
// long as reading.
template <class T>
void reserve(std::vector<T>& elements, const std::uintmax_t n)
{
  elements.reserve(elements.size() + static_cast<std::size_t>(n));
  wish_for_huge_pages(elements.data() + elements.size(), (elements.capacity() - elements.size()) * sizeof(T));
}

// The same for points and triangles.
inline void reserve(Polygon_soup& soup, const std::uintmax_t points, const std::uintmax_t triangles)
{
  reserve(soup.points, points);
  reserve(soup.triangles, triangles);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_RESERVE_H
