// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How paths stand after they were shortened.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_REPORT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_REPORT_H

#include <CGAL/Intrinsic_triangulations/config.h>

#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief how a path of a `Geodesic_path_network` stands.
enum class Geodesic_status {
  GEODESIC,       ///< locally shortest: at each inner vertex that is not fixed, the angles on both sides are at least π
  CONTRACTIBLE,   ///< a closed curve that was shrunk to a point
  BLOCKED,        ///< it can only be shortened over an edge of the network, or over edges that cannot be flipped
  NOT_IMPROVABLE, ///< a loop of one edge that is no geodesic, for which no shorter path of edges was found
  UNFINISHED      ///< the budget did not suffice, or the visitor cancelled the run
};

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief the result of `Geodesic_path_network::shorten()`.
struct Geodesic_report
{
  /// the worst status of all paths, in the order of the enumeration; a contractible one does not worsen it
  Geodesic_status status = Geodesic_status::GEODESIC;
  std::uint64_t flips = 0; ///< the number of flips
  std::uint64_t steps = 0; ///< how often a part of a path was replaced by a shorter one
  std::uint64_t tests = 0; ///< the number of edges that were looked at
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_REPORT_H
