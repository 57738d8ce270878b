// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Correspondence.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include "Flip_log.h"
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Correspondence::catch_up(const Delta_complex& complex, const Flip_log& log, const Block_runner& run)
{
  if (knows_input_ && log.number_of_unread(Flip_log::INTEGERS) == 0)
    return;
  crossings_.clear(); // they have not followed the flips
  Normal_coordinates coordinates;
  Delta_complex input;
  if (!knows_input_)
    input = complex.copied([&](std::size_t n, const auto& f) { run(n, elements_of_block, f); });
  std::vector<Edge_index> flipped_edges;
  const std::function<void()> tasks[] = {
    [&] {
      coordinates = knows_input_ ? coordinates_ : Normal_coordinates(complex); // as many elements as the input
      flipped_edges.reserve(log.number_of_unread(Flip_log::INTEGERS));
      log.for_each_unread(Flip_log::INTEGERS, [&](const Hinge_halfedges& around) {
        coordinates.flip(around);
        flipped_edges.push_back(complex.edge(around.ij));
      });
    },
    [&] {
      if (!knows_input_)
        log.for_each_unread_backwards(Flip_log::INTEGERS,
                                      [&](const Hinge_halfedges& around) { input.flip_back(around); });
    }};
  run(2, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      tasks[i]();
  });
  coordinates_ = std::move(coordinates);
  if (!knows_input_)
    input_ = std::move(input);
  knows_input_ = true;
  if (!locations_.empty())
    for (Edge_index e : flipped_edges)
      for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
        turn_around(h, complex.source(h));
  else
    shorten_walks(flipped_edges, run);
}

void Correspondence::flip_with_crossings(const Delta_complex& complex, const Hinge_halfedges& around)
{
  const Edge_index e = complex.edge(around.ij);
  Kept_crossings::Flipped flipped = crossings_.flipped(
    complex, coordinates_, around, coordinates_.is_original(e) ? input_halfedge(around.ij) : Halfedge_index());
  coordinates_.flip(around);
  crossings_.flip(e, std::move(flipped));
}

void Correspondence::split_face(const Delta_complex& complex, const Triangle_piece& piece,
                                const Surface_point& location)
{
  CGAL_precondition(knows_input_ && location.dimension() == 2);
  make_room(locations_, 1);
  coordinates_.split_face(complex, piece);
  crossings_.split_face(complex, coordinates_, piece);
  locations_.push_back(location);
  Halfedge_index from_corner(2 * complex.number_of_edges() + 1);
  for (Halfedge_index side : {piece.side, complex.next(piece.side), complex.prev(piece.side)}) {
    turn_around(from_corner, complex.source(side));
    from_corner = Halfedge_index(from_corner.idx() + 2);
  }
}

void Correspondence::split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location)
{
  CGAL_precondition(knows_input_ && location.dimension() == 1);
  make_room(locations_, 1);
  coordinates_.split_edge(complex, h, input_halfedge(h));
  crossings_.split_edge(complex, coordinates_, h);
  locations_.push_back(location);
  Halfedge_index from_corner(2 * complex.number_of_edges() + 1);
  turn_around(from_corner, complex.target(h));
  for (Halfedge_index side : {h, complex.opposite(h)}) {
    if (complex.is_border(side))
      continue;
    from_corner = Halfedge_index(from_corner.idx() + 2);
    turn_around(from_corner, complex.target(complex.next(side)));
  }
}

void Correspondence::unsplit_edge(const Delta_complex& complex, Halfedge_index h)
{
  const Edge_index e = complex.edge(h);
  const std::int64_t number_before = coordinates_.number_of_crossings(e);
  coordinates_.unsplit_edge(complex, h, location(complex.target(h)).dimension() == 1);
  crossings_.forget(e, number_before);
}

void Correspondence::remove(const Removed_elements& removed)
{
  crossings_.remove(coordinates_, removed);
  coordinates_.remove(removed);
  remove_entries(locations_, removed.vertices, input_.number_of_vertices());
}

void Correspondence::shorten_walks(const std::vector<Edge_index>& edges, const Block_runner& run)
{
  try {
    std::vector<Halfedge_index> long_walks;
    std::mutex mutex;
    run(edges.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
      std::vector<Halfedge_index> found;
      for (std::size_t i = first; i < last; ++i)
        for (std::uint32_t side : {0u, 1u}) {
          const Halfedge_index h(2 * edges[i].idx() + side);
          if (coordinates_.roundabout(h).steps > longest_walk)
            found.push_back(h);
        }
      const std::lock_guard<std::mutex> lock(mutex);
      long_walks.insert(long_walks.end(), found.begin(), found.end());
    });
    for (Halfedge_index h : long_walks)
      shorten_walk(h);
  } catch (const std::bad_alloc&) {
  }
}

void Correspondence::shorten_walk(Halfedge_index h)
{
  const Roundabout r = coordinates_.roundabout(h);
  if (r.steps <= longest_walk)
    return;
  if (!around_) {
    try {
      around_.emplace(input_);
    } catch (const std::bad_alloc&) {
      return;
    }
  }
  coordinates_.set_roundabout(h, around_->advanced(input_, r.base, r.steps));
}

void Correspondence::turn_around(Halfedge_index h, Vertex_index source)
{
  if (!is_inserted(source)) {
    shorten_walk(h);
    return;
  }
  const Roundabout r = coordinates_.roundabout(h);
  if (r.base.is_valid() && r.steps != 0)
    coordinates_.set_roundabout(h, r.steps % 2 == 0 ? r.base : input_.opposite(r.base));
}

} // namespace CGAL::Intrinsic_triangulations::internal
