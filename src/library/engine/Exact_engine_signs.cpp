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
#include "decide/Ladder.h"
#include "decide/Exact_fallback.h"
#include "decide/Parallel_folds.h"
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

// The corners opposite to two halfedges as the stages of a decision see them (see Ladder.h): here, from the input and the
// integers alone.
class Exact_engine::Corners
{
public:
  Corners(const Exact_engine& engine, const Two_corners& at, Input_surface* surface)
    : engine_(engine), at_(at), surface_(surface)
  {}

  std::optional<Sign> sign_in_plane() const { return std::nullopt; }
  bool may_be_laid_out() const { return true; }
  std::optional<Sign> sign_in_doubles() const { return std::nullopt; }
  std::optional<Sign> sign_in_double_doubles()
  {
    corners_ = {engine_.unfolded_corner(at_.opposite_to_k, *surface_),
                engine_.unfolded_corner(at_.opposite_to_l, *surface_)};
    return sign_of_cotangents(corners_->k, corners_->l);
  }
  std::optional<Sign> sign_of_carried_images() const { return std::nullopt; }
  std::optional<Sign> sign_laid_out_anew() const { return std::nullopt; }
  std::optional<Exact_decision> sign_by_exact_stages() const
  {
    return engine_.exact_fallback(*surface_).sign_of_cotangents(at_, *corners_);
  }

protected:
  const Exact_engine& engine_;
  const Two_corners at_;
  Input_surface* surface_;                  // may be taken later
  std::optional<Opposite_corners> corners_; // once they are laid out
};

// Also uses knowledge about the faces, but stores nothing.
class Exact_engine::Known_corners : public Corners
{
public:
  // \param surface if the caller has taken it
  Known_corners(const Exact_engine& engine, const Two_corners& at, Means means, Input_surface* surface = nullptr)
    : Corners(engine, at, surface), means_(means)
  {}

  std::optional<Sign> sign_in_plane() const
  {
    engine_.find_straight_faces();
    return engine_.sign_in_plane(at_, std::as_const(*engine_.memory_->straight_faces));
  }
  bool may_be_laid_out()
  {
    if (means_ == Means::PLANES || (means_ == Means::SHORT_STRIPS && !are_short()))
      return false;
    if (!surface_)
      surface_ = &*lease_.emplace(means_ == Means::ALL ? engine_.surface_for_query() : engine_.input_surface());
    corners_ = {engine_.known_corner(at_.opposite_to_k, *surface_), engine_.known_corner(at_.opposite_to_l, *surface_)};
    return true;
  }
  std::optional<Sign> sign_in_double_doubles() const { return engine_.sign_by_corners(at_, *corners_); }
  std::optional<Sign> sign_of_carried_images() const
  {
    return means_ == Means::ALL ? engine_.sign_by_images(at_, *corners_, *surface_, false) : std::nullopt;
  }
  std::optional<Exact_decision> sign_by_exact_stages() const
  {
    return means_ == Means::ALL ? Corners::sign_by_exact_stages() : std::nullopt;
  }

private:
  bool are_short() const
  {
    engine_.prepare();
    for (Halfedge_index side : {at_.opposite_to_k, at_.opposite_to_l})
      if (!engine_.is_straight(engine_.connectivity_.face(side)) && engine_.number_of_quantities(side) > short_strip)
        return false;
    return true;
  }

  Means means_;
  std::optional<Surface_lease> lease_;
};

// Likewise, and remembers data that makes tests after the next flips cheap.
class Exact_engine::Kept_corners : public Corners
{
public:
  // \param corners receives the corners once they are laid out
  Kept_corners(Exact_engine& engine, Edge_index e, std::optional<Opposite_corners>& corners)
    : Corners(engine, corners_beside(engine.connectivity_, e), nullptr), engine_(engine), e_(e), kept_(corners)
  {}

  std::optional<Sign> sign_in_plane() { return engine_.sign_in_plane(at_, *engine_.memory_->straight_faces); }
  bool may_be_laid_out()
  {
    const std::size_t number_of_edges = engine_.connectivity_.number_of_edges();
    engine_.memory_->is_close_call.resize(number_of_edges);
    engine_.memory_->is_close_call[e_.idx()] = true;
    if (are_straight()) // flips need not lay out more
      return true;
    engine_.prepare();
    engine_.memory_->note_question(number_of_edges);
    return true;
  }
  std::optional<Sign> sign_in_doubles() { return internal::sign_in_doubles(lay_out(true)); }
  std::optional<Sign> sign_in_double_doubles() { return engine_.sign_by_corners(at_, lay_out(false)); }
  std::optional<Sign> sign_of_carried_images() const
  {
    return engine_.sign_by_images(at_, *kept_, *engine_.input_surface(), true);
  }
  std::optional<Sign> sign_laid_out_anew()
  {
    if (are_straight())
      return std::nullopt;
    for (Halfedge_index side : {at_.opposite_to_k, at_.opposite_to_l})
      engine_.memory_->developed_faces.forget(engine_.connectivity_, side);
    return sign_in_double_doubles();
  }
  std::optional<Exact_decision> sign_by_exact_stages()
  {
    const Exact_decision decision = engine_.exact_fallback(*engine_.input_surface()).sign_of_cotangents(at_, *kept_);
    if (decision.is_rational && !engine_.memory_->images)
      engine_.carry_images();
    return decision;
  }

private:
  bool are_straight() const
  {
    return engine_.is_straight(engine_.connectivity_.face(at_.opposite_to_k)) &&
           engine_.is_straight(engine_.connectivity_.face(at_.opposite_to_l));
  }
  const Opposite_corners& lay_out(bool in_doubles)
  {
    return kept_.emplace(Opposite_corners{engine_.developed_corner(at_.opposite_to_k, in_doubles),
                                          engine_.developed_corner(at_.opposite_to_l, in_doubles)});
  }

  Exact_engine& engine_;
  Edge_index e_;
  std::optional<Opposite_corners>& kept_;
};

Sign Exact_engine::decide(Edge_index e, std::optional<Opposite_corners>& corners)
{
  find_straight_faces();
  if (correspondence().number_of_inserted_vertices() != 0) {
    prepare();
    recognize_straight_face(connectivity_.halfedge(e));
    recognize_straight_face(connectivity_.opposite(connectivity_.halfedge(e)));
  }
  const Exact_decision decision = *sign_by_stages(Kept_corners(*this, e, corners));
  memory_->decisions.counts.add(decision.stage, decision.sign == ZERO);
  return decision.sign;
}

std::optional<Exact_decision> Exact_engine::test(Edge_index e, Means means) const
{
  const Standard_arithmetic arithmetic;
  const Two_corners at = corners_beside(connectivity_, e);
  if (means != Means::UNFOLDING)
    return sign_by_stages(Known_corners(*this, at, means));
  prepare();
  return sign_by_stages(Corners(*this, at, &*input_surface()));
}

Exact_decision Exact_engine::test(Edge_index e, Input_surface& surface) const
{
  return *sign_by_stages(Known_corners(*this, corners_beside(connectivity_, e), Means::ALL, &surface));
}

bool Exact_engine::is_convex(Edge_index e) const
{
  const Standard_arithmetic arithmetic;
  find_straight_faces();
  const Surface_lease surface = surface_for_query();
  // At both ends of e the two angles have to sum to less than π.
  const Halfedge_index h = connectivity_.halfedge(e), g = connectivity_.opposite(h);
  for (const Two_corners& at_end : {Two_corners{connectivity_.next(h), connectivity_.prev(g)},
                                    Two_corners{connectivity_.prev(h), connectivity_.next(g)}})
    if (sign_by_stages(Known_corners(*this, at_end, Means::ALL, &*surface))->sign != POSITIVE)
      return false;
  return true;
}

// \param straight_faces the straight faces of the memory; if const, nothing is remembered
template <class Straight_faces>
std::optional<Sign> Exact_engine::sign_in_plane(const Two_corners& at, Straight_faces& straight_faces) const
{
  const Vertex_positions all = positions();
  if (!is_hinge(connectivity_, at) || !straight_faces.are_coplanar(connectivity_, all, at.opposite_to_k))
    return std::nullopt;
  return Coplanar_hinge(connectivity_, all, at.opposite_to_k).sign_of_cotangents();
}

std::optional<Sign> Exact_engine::sign_by_corners(const Two_corners& at, const Opposite_corners& corners) const
{
  if (const std::optional<Sign> sign = sign_of_cotangents(corners.k, corners.l))
    return sign;
  prepare();
  if (is_hinge(connectivity_, at))
    if (const auto weight = weight_by_other_diagonal(at.opposite_to_k, corners); weight && is_certain(weight->sign()))
      return get_certain(weight->sign());
  return std::nullopt;
}

// The sum of the cotangents opposite to kl = h, if its faces make up two faces of the input with the edge ij: in nearly
// flat grids, often. The angles sum to 2π, so sin(i + j) = -sin(k + l), and with w_kl = sin(i + j) / (sin i sin j) it
// follows that w_kl = -w_ij A_ijk A_jil / (A_ilk A_jkl): however small w_ij is, its points determine it accurately.
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

// As `corner()`, but uses data of earlier tests.
Exact_engine::Corner Exact_engine::known_corner(Halfedge_index h, Input_surface& surface) const
{
  return !is_straight(connectivity_.face(h)) && memory_->developed_faces.contains(h)
           ? memory_->developed_faces.corner(connectivity_, h)
           : corner(h, surface);
}

// A bound on the number of input quantities on which the corner opposite to h depends.
double Exact_engine::number_of_quantities(Halfedge_index h) const
{
  const Normal_coordinates& coordinates = correspondence().coordinates();
  return double(coordinates.number_of_crossings(connectivity_.edge(connectivity_.next(h)))) +
         double(coordinates.number_of_crossings(connectivity_.edge(connectivity_.prev(h)))) +
         double(coordinates.triangle_crossings(connectivity_, h).e_k) + 16;
}

// The sign of the sum of cotangents, if images that were carried along tell that the angles sum to π, or that both
// faces have no area.
// \param makes_images whether images of straight faces may be computed, in rings that all threads share
std::optional<Sign> Exact_engine::sign_by_images(const Two_corners& at, const Opposite_corners& corners,
                                                 Input_surface& surface, bool makes_images) const
{
  const Memory& memory = *memory_;
  if (!memory.images || !surface.accepts_probable_ties())
    return std::nullopt;
  const auto [h, g] = at;
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
  find_straight_faces(); // forgets developed faces whose flips were not followed
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
