// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_engine: signs, each from the first stage that decides it.

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include "Exact_engine_memory.h"
#include "layout/Unfolding.h"
#include "decide/Coplanar_hinge.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include "decide/Exact_sign.h"
#include "decide/Exact_fallback.h"
#include "layout/Parallel_folds.h"
#include "layout/Vertex_positions.h"
#include "decide/corner_signs.h"
#include "layout/metric_images.h"

#include <CGAL/Uncertain.h>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Sign Exact_engine::decide(Edge_index e, std::optional<Opposite_corners>& corners)
{
  Memory& memory = *memory_;
  const Halfedge_index h = connectivity_.halfedge(e), g = connectivity_.opposite(h);
  find_straight_faces();
  if (correspondence().number_of_inserted_vertices() != 0) {
    prepare();
    recognize_straight_face(h);
    recognize_straight_face(g);
  }
  if (const std::optional<Test> test = test_in_plane(h, *memory.straight_faces))
    return memory.decided(*test);
  prepare();
  memory.is_close_call.resize(connectivity_.number_of_edges());
  memory.is_close_call[e.idx()] = true;
  memory.note_question(connectivity_.number_of_edges());
  const auto test_by_developed_corners = [&](bool in_doubles) {
    corners = Opposite_corners{developed_corner(h, in_doubles), developed_corner(g, in_doubles)};
    return test_by_corners(h, *corners);
  };
  for (bool in_doubles : {true, false}) // the first suffices for most tests that the filter leaves open
    if (const std::optional<Test> test = test_by_developed_corners(in_doubles))
      return memory.decided(*test);
  if (const std::optional<Sign> tie = sign_by_images(e, *corners, *input_surface(), true))
    return memory.decided({Stage::MODULAR, *tie});
  // Layouts that were carried along are not the best.
  bool is_laid_out_anew = false;
  for (Halfedge_index side : {h, g})
    if (!is_straight(connectivity_.face(side))) {
      memory.developed_faces.forget(connectivity_, side);
      is_laid_out_anew = true;
    }
  if (is_laid_out_anew)
    if (const std::optional<Test> test = test_by_developed_corners(false))
      return memory.decided(*test);
  const auto decision = exact_fallback(*input_surface()).sign_of_cotangents(corners_beside(connectivity_, e));
  if (decision.is_rational && !memory.images)
    carry_images();
  return memory.decided({decision.stage, decision.sign});
}

// \param straight_faces those of the memory; if they are const, nothing is remembered
template <class Straight_faces>
std::optional<Exact_engine::Test> Exact_engine::test_in_plane(Halfedge_index h, Straight_faces& straight_faces) const
{
  const Vertex_positions all = positions();
  if (!straight_faces.are_coplanar(connectivity_, all, h))
    return std::nullopt;
  return Test{Stage::COPLANAR, Coplanar_hinge(connectivity_, all, h).sign_of_cotangents()};
}

std::optional<Exact_engine::Test> Exact_engine::test(Edge_index e, Means means) const
{
  const Standard_arithmetic arithmetic;
  const Halfedge_index h = connectivity_.halfedge(e);
  switch (means) {
  case Means::PLANES:
    find_straight_faces();
    return test_in_plane(h, std::as_const(*memory_->straight_faces));
  case Means::SHORT_STRIPS:
    find_straight_faces();
    prepare();
    for (Halfedge_index side : {h, connectivity_.opposite(h)})
      if (!is_straight(connectivity_.face(side)) && number_of_quantities(side) > short_strip)
        return std::nullopt;
    return test_by_corners(h, known_corners(h, *input_surface()));
  case Means::UNFOLDING: {
    prepare();
    const Surface_lease surface = input_surface();
    Double_double_metric metric(*surface);
    const Two_corners beside = corners_beside(connectivity_, e);
    const Opposite_corners corners =
      unfolded_corners(Unfolding<Double_double_metric>(connectivity_, correspondence(), metric), beside);
    if (const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l); is_certain(sign))
      return Test{Stage::UNFOLDING, get_certain(sign)};
    const auto decision = exact_fallback(*surface).sign_of_cotangents(beside);
    return Test{decision.stage, decision.sign};
  }
  case Means::ALL:
    break;
  }
  return test(e, *prepared_surface());
}

// From the corners beside h.
std::optional<Exact_engine::Test> Exact_engine::test_by_corners(Halfedge_index h, const Opposite_corners& corners) const
{
  const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
  if (is_certain(sign))
    return Test{Stage::UNFOLDING, get_certain(sign)};
  if (const auto weight = weight_by_other_diagonal(h, corners); weight && is_certain(weight->sign()))
    return Test{Stage::UNFOLDING, get_certain(weight->sign())};
  return std::nullopt;
}

// The sum of the cotangents opposite to kl = h, where its faces make up two faces of the input with the edge ij. Nearly
// flat grids are full of such edges. The angles sum to 2π, so that sin(i + j) = -sin(k + l), and with w_kl = sin(i + j)
// / (sin i sin j) it follows that w_kl = -w_ij A_ijk A_jil / (A_ilk A_jkl): however small w_ij is, its points tell it
// well.
std::optional<Bounded_double_double> Exact_engine::weight_by_other_diagonal(Halfedge_index h,
                                                                            const Opposite_corners& corners) const
{
  const Normal_coordinates& coordinates = correspondence().coordinates();
  if (metric_.points().empty() || coordinates.number_of_crossings(connectivity_.edge(h)) != 1)
    return std::nullopt;
  const Halfedge_index g = connectivity_.opposite(h);
  for (Halfedge_index side :
       {connectivity_.next(h), connectivity_.prev(h), connectivity_.next(g), connectivity_.prev(g)})
    if (!coordinates.is_original(connectivity_.edge(side)) || correspondence().is_inserted(connectivity_.source(side)))
      return std::nullopt;
  const Bounded_double_double areas = corners.k.four_areas * corners.l.four_areas;
  if (!certainly(areas.sign() == POSITIVE))
    return std::nullopt;
  const Delta_complex& input = correspondence().input();
  const Halfedge_index ji = input.next(correspondence().input_halfedge(connectivity_.next(h)));
  const Corner k = internal::straight_corner(input, positions(), input.opposite(ji)),
               l = internal::straight_corner(input, positions(), ji);
  return -(k.p * l.four_areas + l.p * k.four_areas) / areas;
}

// As `corner()`, from what is kept of tests before.
Exact_engine::Corner Exact_engine::known_corner(Halfedge_index h, Input_surface& surface) const
{
  return !is_straight(connectivity_.face(h)) && memory_->developed_faces.contains(h)
           ? memory_->developed_faces.corner(connectivity_, h)
           : corner(h, surface);
}
// On both sides of h.
Exact_engine::Opposite_corners Exact_engine::known_corners(Halfedge_index h, Input_surface& surface) const
{
  return {known_corner(h, surface), known_corner(connectivity_.opposite(h), surface)};
}

// A bound on the number of input quantities that the corner opposite to h is a function of.
double Exact_engine::number_of_quantities(Halfedge_index h) const
{
  const Normal_coordinates& coordinates = correspondence().coordinates();
  return double(coordinates.number_of_crossings(connectivity_.edge(connectivity_.next(h)))) +
         double(coordinates.number_of_crossings(connectivity_.edge(connectivity_.prev(h)))) +
         double(coordinates.triangle_crossings(connectivity_, h).e_k) + 16;
}

Exact_engine::Test Exact_engine::test(Edge_index e, Input_surface& surface) const
{
  const Halfedge_index h = connectivity_.halfedge(e);
  if (const std::optional<Test> test = test_in_plane(h, std::as_const(*memory_->straight_faces)))
    return *test;
  const Opposite_corners corners = known_corners(h, surface);
  if (const std::optional<Test> test = test_by_corners(h, corners))
    return *test;
  if (const std::optional<Sign> tie = sign_by_images(e, corners, surface, false))
    return {Stage::MODULAR, *tie};
  const auto decision = exact_fallback(surface).sign_of_cotangents(corners_beside(connectivity_, e));
  return {decision.stage, decision.sign};
}

// The sign of the sum of cotangents, if images that were carried along tell that the edge is a tie, or that both
// faces have no area.
// \param makes_images whether images of straight faces may be computed, in rings that all threads share
std::optional<Sign> Exact_engine::sign_by_images(Edge_index e, const Opposite_corners& corners, Input_surface& surface,
                                                 bool makes_images) const
{
  const Memory& memory = *memory_;
  if (!memory.images || !surface.accepts_probable_ties())
    return std::nullopt;
  const Halfedge_index h = connectivity_.halfedge(e), g = connectivity_.opposite(h);
  const auto find_image = [&](Halfedge_index side) -> std::optional<Image_corner> {
    if (makes_images && is_straight(connectivity_.face(side)))
      return image_of_straight_corner(side);
    if (memory.developed_faces.contains(side))
      return memory.developed_faces.image_of_corner(connectivity_, side);
    return std::nullopt;
  };
  const auto k = find_image(h), l = k ? find_image(g) : std::nullopt;
  if (!k || !l || !(k->p * l->four_areas + l->p * k->four_areas).is_zero() || !memory.images->rings.is_defined())
    return std::nullopt;
  const double number = number_of_quantities(h) + number_of_quantities(g);
  if (Residue_rings::certainty(number, surface.largest_size(correspondence().number_of_inserted_vertices() != 0)) < 128)
    return std::nullopt;
  const auto is_positive = [](const Bounded_double_double& x) { return certainly(x.sign() == POSITIVE); };
  if (is_positive(corners.k.four_areas) && is_positive(corners.l.four_areas))
    return ZERO;
  const Uncertain<Sign> p_k = corners.k.p.sign(), p_l = corners.l.p.sign();
  if (k->four_areas.is_zero() && l->four_areas.is_zero() && is_certain(p_k) && is_certain(p_l))
    return sign_of_tie(get_certain(p_k), get_certain(p_l));
  return std::nullopt;
}

bool Exact_engine::is_convex(Edge_index e) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = prepared_surface();
  // At both ends of e the two angles have to sum to less than π.
  const Halfedge_index h = connectivity_.halfedge(e), g = connectivity_.opposite(h);
  for (const Two_corners& at_end : {Two_corners{connectivity_.next(h), connectivity_.prev(g)},
                                    Two_corners{connectivity_.prev(h), connectivity_.next(g)}}) {
    const Uncertain<Sign> sign = internal::sign_of_cotangents(known_corner(at_end.opposite_to_k, *surface),
                                                              known_corner(at_end.opposite_to_l, *surface));
    if ((is_certain(sign) ? get_certain(sign) : exact_fallback(*surface).sign_of_cotangents(at_end).sign) != POSITIVE)
      return false;
  }
  return true;
}

Sign Exact_engine::sign_of_area(Face_index f) const
{
  const Standard_arithmetic arithmetic;
  prepare();
  return sign_of_area(f, *input_surface());
}

Sign Exact_engine::sign_of_area(Face_index f, Input_surface& surface) const
{
  const Halfedge_index h = connectivity_.halfedge(f);
  const Uncertain<Sign> sign = unfolded_corner(h, surface).four_areas.sign();
  return is_certain(sign) ? get_certain(sign) : exact_fallback(surface).sign_of_area(h);
}

bool Exact_engine::has_length_zero(Edge_index e) const
{
  const Standard_arithmetic arithmetic;
  prepare();
  const auto& developed_faces = memory_->developed_faces;
  for (Halfedge_index h : {connectivity_.halfedge(e), connectivity_.opposite(connectivity_.halfedge(e))})
    if (!connectivity_.is_border(h) && developed_faces.contains(h))
      if (certainly(developed_faces.corner(connectivity_, h).s_opposite.sign() == POSITIVE))
        return false;
  const Surface_lease surface = input_surface();
  const Bounded_double_double s = squared_length(e, *surface);
  return is_certain(s.sign()) ? s.is_zero() : exact_fallback(*surface).has_length_zero(e);
}

Sign Exact_engine::side_of(Halfedge_index h, std::int64_t position, const Surface_point& point) const
{
  const Standard_arithmetic arithmetic;
  prepare();
  const auto area_beside = [&](auto& metric) {
    return Unfolding<std::decay_t<decltype(metric)>>(connectivity_, correspondence(), metric)
      .area_beside(h, position, point);
  };
  const Surface_lease surface = input_surface();
  Double_metric doubles(correspondence().input(), metric_, decisions().interruption, &*surface);
  if (const Uncertain<Sign> sign = area_beside(doubles).sign(); is_certain(sign))
    return get_certain(sign);
  if (!metric_.points().empty()) {
    find_straight_faces();
    for (Halfedge_index side : {h, connectivity_.opposite(h)})
      if (!connectivity_.is_border(side) && is_straight(connectivity_.face(side)))
        if (const std::optional<Sign> sign = side_in_plane(connectivity_, positions(), side, point))
          return *sign * (side == h ? POSITIVE : NEGATIVE);
  }
  return exact_sign(
    *surface, area_beside, [&] { return "that a point lies on edge " + std::to_string(connectivity_.edge(h).idx()); },
    [&] { return Parallel_folds(connectivity_, correspondence(), *surface).contains(h, positions(), point); });
}

} // namespace CGAL::Intrinsic_triangulations::internal
