// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Compares the overlay that the integers give with the one that was updated flip by flip.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ARE_SAME_OVERLAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ARE_SAME_OVERLAY_H

#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/config.h>

#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// Says how the two differ, or nothing. Crossings have no numbers in common: those of
// `incremental` are learnt along the intrinsic edges.
std::string difference_of_overlays(const Overlay& overlay, const Incremental_overlay& incremental);

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns whether two overlays are the same: whether each edge of both triangulations has
/// the same crossings in the same order, and the same edges coincide, in the same direction.
///
/// The numbers of segments and crossings may differ. O(size).
/// \param overlay built from the integers
/// \param incremental updated flip by flip
/// \param verbose whether the first difference is described on `std::cerr`
bool are_same_overlay(const Overlay& overlay, const Incremental_overlay& incremental,
                      bool verbose = false);

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/overlay/are_same_overlay_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ARE_SAME_OVERLAY_H
