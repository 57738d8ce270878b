// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_engine: corners, laid out or from what earlier questions left.

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include "Exact_engine_memory.h"
#include "layout/Unfolding.h"
#include "decide/Exact_fallback.h"
#include "decide/corner_signs.h"
#include "layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Vertex_positions Exact_engine::positions() const { return memory_->positions(metric_); }

std::optional<Exact_engine::Image_corner> Exact_engine::image_of_straight_corner(Halfedge_index h) const
{
  return memory_->image(
    [&] { return internal::image_of_straight_corner(connectivity_, positions(), h, memory_->images->rings); });
}

// A tie seldom comes alone. From the first one on, flips carry images of corners in finite fields along if all areas
// are rational: this saves laying out strips of thousands of triangles for each tie.
void Exact_engine::carry_images()
{
  memory_->images = std::make_unique<Memory::Carried_images>(new_surface());
  memory_->developed_faces = {};
  memory_->split_face.reset();
}

// As corner(), but uses data of earlier tests.
Exact_engine::Corner Exact_engine::developed_corner(Halfedge_index h, bool in_doubles)
{
  Memory& memory = *memory_;
  const Face_index f = connectivity_.face(h);
  if (is_straight(f))
    return straight_corner(h, in_doubles);
  if (!memory.developed_faces.contains(h))
    memory.developed_faces.insert(connectivity_,
                                  laid_out(correspondence().coordinates().side_with_most_crossings(connectivity_, f)));
  return memory.developed_faces.contains(h) ? memory.developed_faces.corner(connectivity_, h, in_doubles)
                                            : unfolded_corner(h, *input_surface());
}

// The corner opposite to h. \pre the integers and the faces follow
Known_corner Exact_engine::laid_out(Halfedge_index h)
{
  Memory& memory = *memory_;
  if (const double number = number_of_quantities(h); number > short_strip && !memory.images &&
                                                     !metric_.points().empty() &&
                                                     memory.is_time_to_repeat_flips(connectivity_, number)) {
    memory.developed_faces =
      std::move(Repeated_flips(connectivity_, memory.log, positions(), decisions().interruption).faces());
    if (memory.developed_faces.contains(h))
      return {h, memory.developed_faces.corner(connectivity_, h), std::nullopt};
  }
  return {
    h, unfolded_corner(h, *input_surface()), memory_->image([&] {
      return Unfolding<Residue_metric>(connectivity_, correspondence(), memory_->images->metric).opposite_corner(h);
    })};
}

Exact_engine::Corner Exact_engine::kept_corner(Halfedge_index h)
{
  const Standard_arithmetic arithmetic;
  prepare();
  find_straight_faces();
  if (memory_->developed_faces.contains(h))
    return developed_corner(h);
  memory_->note_question(connectivity_.number_of_edges());
  // Carrying a face along, with the faces that flips join it to, takes longer than laying out a short strip again.
  return number_of_quantities(h) <= short_strip ? corner(h, *input_surface()) : developed_corner(h);
}

std::vector<std::pair<Halfedge_index, Exact_engine::Corner>> Exact_engine::kept_corners_at(Vertex_index v)
{
  const Standard_arithmetic arithmetic;
  prepare();
  find_straight_faces();
  Memory& memory = *memory_;
  std::vector<std::pair<Halfedge_index, Corner>> result;
  const auto number_of_crossings = [&](Halfedge_index h) {
    return correspondence().coordinates().number_of_crossings(connectivity_.edge(h));
  };
  if (const auto whole = std::exchange(memory.split_face, std::nullopt)) {
    const auto cost = [&](Halfedge_index side) {
      return number_of_crossings(connectivity_.next(side)) + number_of_crossings(connectivity_.prev(side));
    };
    const auto cheapest = std::min_element(whole->sides.begin(), whole->sides.end(),
                                           [&](auto one, auto other) { return cost(one) < cost(other); });
    memory.developed_faces.keep_parts(connectivity_, *whole, laid_out(*cheapest));
  }
  bool are_all_developed = true;
  std::int64_t number = 0;
  const Halfedge_index first = connectivity_.opposite(connectivity_.halfedge(v));
  for (Halfedge_index vi = first;;) {
    number += number_of_crossings(vi);
    const Halfedge_index side = connectivity_.next(vi);
    if (!connectivity_.is_border(vi) && !memory.developed_faces.contains(vi))
      are_all_developed = false;
    else if (!connectivity_.is_border(vi) && are_all_developed)
      result.emplace_back(side, memory.developed_faces.corner(connectivity_, side));
    if ((vi = connectivity_.next_around_source(vi)) == first)
      break;
  }
  if (are_all_developed)
    return result;
  result = corners_at(v);
  if (number > long_star)
    for (const auto& [side, corner] : result)
      memory.developed_faces.insert(connectivity_, {side, corner, std::nullopt});
  return result;
}

std::vector<std::pair<Halfedge_index, Exact_engine::Corner>> Exact_engine::corners_at(Vertex_index v) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = prepared_surface(); // a removal needs to know the straight faces, too
  Double_double_metric metric(*surface);
  std::vector<std::pair<Halfedge_index, Corner>> result;
  Unfolding<Double_double_metric>(connectivity_, correspondence(), metric)
    .for_each_corner_at(v, [&](Halfedge_index h, const Corner& c) { result.emplace_back(h, c); });
  return result;
}

Exact_engine::Corner Exact_engine::corner(Halfedge_index h, Input_surface& surface) const
{
  return is_straight(connectivity_.face(h)) ? straight_corner(h) : unfolded_corner(h, surface);
}

Exact_engine::Corner Exact_engine::unfolded_corner(Halfedge_index h, Input_surface& surface) const
{
  Double_double_metric metric(surface);
  return Unfolding<Double_double_metric>(connectivity_, correspondence(), metric).opposite_corner(h);
}

Bounded_double_double Exact_engine::squared_length(Edge_index e, Input_surface& surface) const
{
  Double_double_metric metric(surface);
  return Unfolding<Double_double_metric>(connectivity_, correspondence(), metric).squared_length(e);
}

Exact_fallback Exact_engine::exact_fallback(Input_surface& surface) const
{
  return {connectivity_, correspondence(), surface};
}

bool Exact_engine::is_straight(Face_index f) const { return (*memory_->straight_faces)(f); }

Exact_engine::Corner Exact_engine::straight_corner(Halfedge_index h, bool in_doubles) const
{
  return internal::straight_corner(connectivity_, positions(), h, in_doubles);
}

} // namespace CGAL::Intrinsic_triangulations::internal
