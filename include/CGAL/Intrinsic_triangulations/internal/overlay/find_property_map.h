// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A property map of a CGAL::Surface_mesh by its name, in all versions of CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_FIND_PROPERTY_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_FIND_PROPERTY_MAP_H

#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The map that the mesh has by this name, or one that converts to false. CGAL 5 gives a pair of a map and
// whether it is there, CGAL 6 an optional map.
template <class Index, class Value, class SurfaceMesh>
auto find_property_map(const SurfaceMesh& mesh, const std::string& name)
{
  using Map = typename SurfaceMesh::template Property_map<Index, Value>;
  const auto found = mesh.template property_map<Index, Value>(name);
  if constexpr (std::is_same<decltype(found), const std::pair<Map, bool>>::value)
    return found.first;
  else
    return found.value_or(Map());
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_FIND_PROPERTY_MAP_H
