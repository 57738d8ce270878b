// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The walk to the piece of an input face that contains a point.

#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/enum.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Triangle_piece piece_of_point(const Exact_engine& engine, const Triangle_piece& start, const Surface_point& point)
{
  const Delta_complex& complex = engine.connectivity();
  const Normal_coordinates& coordinates = engine.correspondence().coordinates();
  struct Step
  {
    std::array<Triangle_piece, 3> names;
    std::size_t next_name;
    bool has_left; // across another name
  };
  constexpr std::size_t few_steps = 64;
  boost::container::small_vector<Step, 4> way;
  std::set<std::pair<Halfedge_index, std::int64_t>> entered; // each piece by the first of its names
  std::size_t number_of_steps = 0;
  const auto enter = [&](const Triangle_piece& piece, std::size_t first_name) {
    const auto names = coordinates.names(complex, piece);
    if (number_of_steps >= few_steps) {
      std::pair<Halfedge_index, std::int64_t> first(piece.side, piece.gap);
      for (const Triangle_piece& name : names)
        if (name.side.is_valid())
          first = (std::min)(first, {name.side, name.gap});
      if (!entered.insert(first).second)
        return;
    }
    way.push_back({names, first_name, false});
  };
  for (enter(start, 0); !way.empty(); ++number_of_steps) {
    if (number_of_steps % 1024 == 1023)
      engine.decisions().interruption.check();
    Step& here = way.back();
    std::optional<Triangle_piece> across;
    while (here.next_name < here.names.size() && !across) {
      const Triangle_piece& name = here.names[here.next_name++];
      // A side that coincides with an input edge has the whole input face on one side.
      if (name.side.is_valid() && !coordinates.is_original(complex.edge(name.side)) &&
          engine.side_of(name.side, name.gap, point) == NEGATIVE)
        across = {complex.opposite(name.side), coordinates.number_of_crossings(complex.edge(name.side)) - name.gap};
    }
    if (across) {
      here.has_left = true;
      enter(*across, 1); // not back
    } else if (here.has_left) {
      way.pop_back();
    } else {
      return here.names[0];
    }
  }
  throw Arithmetic_error("no piece of an input face contains a point of it: please report the surface, and how the "
                         "program was compiled");
}

Triangle_piece piece_at_source(const Delta_complex& complex, const Correspondence& correspondence,
                               Halfedge_index input_halfedge)
{
  const auto [side, position] =
    start_of_input_edge(complex, correspondence, correspondence.input().source(input_halfedge), input_halfedge);
  return {side, position + 1};
}

} // namespace CGAL::Intrinsic_triangulations::internal
