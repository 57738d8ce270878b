// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The input halfedges that an edge crosses, in order.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSED_HALFEDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSED_HALFEDGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Kept_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// The input halfedges that h crosses from its left to its right, in order: cached ones, or its own.
class Crossed_halfedges
{
public:
  // \pre something is crossed
  Crossed_halfedges(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index h,
                    const Interruption& interruption);
  Crossed_halfedges(const Crossed_halfedges&) = delete;
  Crossed_halfedges& operator=(const Crossed_halfedges&) = delete;

  std::size_t size() const { return crossed_.size(); }
  Halfedge_index operator[](std::size_t i) const { return crossed_[i]; }
  Halfedge_index front() const { return crossed_[0]; }

  // Finding this many takes no longer than looking them up.
  static constexpr std::size_t few = 8;

private:
  boost::container::small_vector<Halfedge_index, 16> own_;
  Crossed_range crossed_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CROSSED_HALFEDGES_H
