// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Exact_geometry: signs, each from the first stage that decides it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_SIGNS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_SIGNS_IMPL_H

#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Coplanar_hinge.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Double_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_geometry_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_sign.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_fallback.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Sign_in_plane.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Vertex_positions.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/corner_signs.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/metric_images.h>

#include <CGAL/Uncertain.h>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::decide(const Delta_complex& complex, Edge_index e, std::optional<Opposite_corners>& corners)
{
  Memory& memory = *memory_;
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  find_straight_faces(complex);
  if (correspondence_.number_of_inserted_vertices() != 0) {
    prepare(complex);
    recognize_straight_face(complex, h);
    recognize_straight_face(complex, g);
  }
  if (const std::optional<Test> test = test_in_plane(complex, h, *memory.straight_faces))
    return memory.decided(*test);
  prepare(complex);
  const Surface_lease surface = input_surface();
  memory.is_close_call.resize(complex.number_of_edges());
  memory.is_close_call[e.idx()] = true;
  const auto test_by_developed_corners = [&] {
    corners = Opposite_corners{developed_corner(complex, h, *surface), developed_corner(complex, g, *surface)};
    return test_by_corners(complex, h, *corners);
  };
  if (const std::optional<Test> test = test_by_developed_corners())
    return memory.decided(*test);
  const auto find_image = [&](Halfedge_index side) {
    return is_straight(complex.face(side)) ? image_of_straight_corner(complex, side) : image_of_developed_corner(complex, side);
  };
  if (const std::optional<Sign> tie = sign_by_images(complex, e, *corners, *surface, find_image))
    return memory.decided({Stage::MODULAR, *tie});
  // Layouts that were carried along are not the best.
  bool is_laid_out_anew = false;
  for (Halfedge_index side : {h, g})
    if (!is_straight(complex.face(side))) {
      memory.developed_faces.forget(complex.face(side));
      is_laid_out_anew = true;
    }
  if (is_laid_out_anew)
    if (const std::optional<Test> test = test_by_developed_corners())
      return memory.decided(*test);
  const auto decision = exact_fallback(complex, *surface).sign_of_cotangents(internal::corners_beside(complex, e));
  if (decision.is_rational && !memory.images)
    carry_images();
  return memory.decided({decision.stage, decision.sign});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_inserted_corner(const Delta_complex& complex, Halfedge_index h) const
{
  return positions().has_inserted_corner(complex, h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void Exact_geometry::count(const Stage_counts& counts)
{
  memory_->counts += counts;
}

// \param straight_faces those of the memory; if they are const, nothing is remembered
template <class Straight_faces>
std::optional<Exact_geometry::Test> Exact_geometry::test_in_plane(const Delta_complex& complex, Halfedge_index h,
                                                                  Straight_faces& straight_faces) const
{
  const internal::Vertex_positions all = positions();
  if (!straight_faces.are_coplanar(complex, all, h))
    return std::nullopt;
  if (all.has_inserted_corner(complex, h) || all.has_inserted_corner(complex, complex.opposite(h)))
    return Test{Stage::COPLANAR, internal::Sign_in_plane(complex, all, h)()};
  return Test{Stage::COPLANAR, internal::Coplanar_hinge(complex, metric_.points(), h).sign_of_cotangents()};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_in_plane(const Delta_complex& complex, Edge_index e) const
{
  find_straight_faces(complex);
  const Memory& memory = *memory_;
  return test_in_plane(complex, complex.halfedge(e), *memory.straight_faces);
}

// From the corners beside h.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_by_corners(const Delta_complex& complex, Halfedge_index h,
                                                                    const Opposite_corners& corners) const
{
  const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
  if (is_certain(sign))
    return Test{Stage::UNFOLDING, get_certain(sign)};
  if (const auto weight = weight_by_other_diagonal(complex, h, corners); weight && is_certain(weight->sign()))
    return Test{Stage::UNFOLDING, get_certain(weight->sign())};
  return std::nullopt;
}

// The sum of the cotangents opposite to kl = h, where its faces make up two faces of the input with the edge ij. Nearly flat grids are full of
// such edges. The angles sum to 2π, so that sin(i + j) = -sin(k + l), and with w_kl = sin(i + j) / (sin i sin j) it follows that
// w_kl = -w_ij A_ijk A_jil / (A_ilk A_jkl): however small w_ij is, its points tell it well.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<internal::Bounded_double_double> Exact_geometry::weight_by_other_diagonal(const Delta_complex& complex, Halfedge_index h,
                                                                                        const Opposite_corners& corners) const
{
  const Normal_coordinates& coordinates = correspondence_.coordinates();
  if (metric_.points().empty() || coordinates.number_of_crossings(complex.edge(h)) != 1)
    return std::nullopt;
  const Halfedge_index g = complex.opposite(h);
  for (Halfedge_index side : {complex.next(h), complex.prev(h), complex.next(g), complex.prev(g)})
    if (!coordinates.is_original(complex.edge(side)) || correspondence_.is_inserted(complex.source(side)))
      return std::nullopt;
  const internal::Bounded_double_double areas = corners.k.four_areas * corners.l.four_areas;
  if (!certainly(areas.sign() == POSITIVE))
    return std::nullopt;
  const Delta_complex& input = correspondence_.input();
  const Halfedge_index ji = input.next(correspondence_.input_halfedge(complex.next(h)));
  const Corner k = internal::straight_corner<Corner>(input, positions(), input.opposite(ji)),
               l = internal::straight_corner<Corner>(input, positions(), ji);
  return -(k.p * l.four_areas + l.p * k.four_areas) / areas;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::optional<Exact_geometry::Test> Exact_geometry::test_by_short_strips(const Delta_complex& complex, Edge_index e) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  find_straight_faces(complex);
  const Halfedge_index h = complex.halfedge(e);
  for (Halfedge_index side : {h, complex.opposite(h)})
    if (!is_straight(complex.face(side)) && number_of_quantities(complex, side) > short_strip)
      return std::nullopt;
  return test_by_corners(complex, h, known_corners(complex, h, *input_surface()));
}

// As `corner()`, from what is kept of tests before.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Corner Exact_geometry::known_corner(const Delta_complex& complex, Halfedge_index h, internal::Input_surface& surface) const
{
  const Face_index f = complex.face(h);
  return !is_straight(f) && memory_->developed_faces.contains(f) ? memory_->developed_faces.corner(complex, h)
                                                                 : corner(complex, h, surface);
}
// On both sides of h.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Opposite_corners Exact_geometry::known_corners(const Delta_complex& complex, Halfedge_index h,
                                                               internal::Input_surface& surface) const
{
  return {known_corner(complex, h, surface), known_corner(complex, complex.opposite(h), surface)};
}

// A bound on the number of input quantities that the corner opposite to h is a function of.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
double Exact_geometry::number_of_quantities(const Delta_complex& complex, Halfedge_index h) const
{
  const Normal_coordinates& coordinates = correspondence_.coordinates();
  return double(coordinates.number_of_crossings(complex.edge(complex.next(h)))) +
         double(coordinates.number_of_crossings(complex.edge(complex.prev(h)))) +
         double(coordinates.triangle_crossings(complex, h).e_k) + 16;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_cotangents(const Delta_complex& complex, Edge_index e) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  find_straight_faces(complex);
  return sign_of_cotangents(complex, e, *input_surface());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_cotangents(const Delta_complex& complex, Edge_index e, internal::Input_surface& surface) const
{
  if (const std::optional<Test> test = test_in_plane(complex, e))
    return test->sign;
  const Halfedge_index h = complex.halfedge(e);
  const Opposite_corners corners = known_corners(complex, h, surface);
  if (const std::optional<Test> test = test_by_corners(complex, h, corners))
    return test->sign;
  // New images would be computed in rings that all threads share.
  const auto find_image = [&](Halfedge_index side) { return image_of_developed_corner(complex, side); };
  if (const std::optional<Sign> tie = sign_by_images(complex, e, corners, surface, find_image))
    return *tie;
  return exact_fallback(complex, surface).sign_of_cotangents(internal::corners_beside(complex, e)).sign;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_by_unfolding(const Delta_complex& complex, Edge_index e) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  const Surface_lease surface = input_surface();
  internal::Double_double_metric metric(*surface);
  const internal::Two_corners beside = internal::corners_beside(complex, e);
  const Opposite_corners corners = internal::unfolded_corners(
    Unfolding<internal::Double_double_metric>(complex, correspondence_, metric), beside);
  const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
  return is_certain(sign) ? get_certain(sign) : exact_fallback(complex, *surface).sign_of_cotangents(beside).sign;
}

// The sign of the sum of cotangents, if images that were carried along tell that the edge is a tie, or that both
// faces have no area.
template <class FindImage>
std::optional<Sign> Exact_geometry::sign_by_images(const Delta_complex& complex, Edge_index e,
                                                   const Opposite_corners& corners, internal::Input_surface& surface,
                                                   const FindImage& find_image) const
{
  const Memory& memory = *memory_;
  if (!memory.images || !surface.accepts_probable_ties())
    return std::nullopt;
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  const auto k = find_image(h), l = k ? find_image(g) : std::nullopt;
  if (!k || !l || !(k->p * l->four_areas + l->p * k->four_areas).is_zero() || !memory.images->rings.is_defined())
    return std::nullopt;
  const double number = number_of_quantities(complex, h) + number_of_quantities(complex, g);
  if (internal::Residue_rings::certainty(number, surface.largest_size(correspondence_.number_of_inserted_vertices() != 0)) < 128)
    return std::nullopt;
  const auto is_positive = [](const internal::Bounded_double_double& x) { return certainly(x.sign() == POSITIVE); };
  if (is_positive(corners.k.four_areas) && is_positive(corners.l.four_areas))
    return ZERO;
  const Uncertain<Sign> p_k = corners.k.p.sign(), p_l = corners.l.p.sign();
  if (k->four_areas.is_zero() && l->four_areas.is_zero() && is_certain(p_k) && is_certain(p_l))
    return internal::sign_of_tie(get_certain(p_k), get_certain(p_l));
  return std::nullopt;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::is_convex(const Delta_complex& complex, Edge_index e) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  find_straight_faces(complex);
  const Surface_lease surface = input_surface();
  // At both ends of e the two angles have to sum to less than π.
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  for (const internal::Two_corners& at_end :
       {internal::Two_corners{complex.next(h), complex.prev(g)},
        internal::Two_corners{complex.prev(h), complex.next(g)}}) {
    const Uncertain<Sign> sign = internal::sign_of_cotangents(known_corner(complex, at_end.opposite_to_k, *surface),
                                                              known_corner(complex, at_end.opposite_to_l, *surface));
    if ((is_certain(sign) ? get_certain(sign) : exact_fallback(complex, *surface).sign_of_cotangents(at_end).sign) !=
        POSITIVE)
      return false;
  }
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_area(const Delta_complex& complex, Face_index f) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  return sign_of_area(complex, f, *input_surface());
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_input_face_area(Face_index f) const
{
  const internal::Standard_arithmetic arithmetic;
  const Delta_complex& input = correspondence_.input();
  const Uncertain<Sign> sign = metric_.four_areas_double_double(input, f).sign();
  return is_certain(sign) ? get_certain(sign) != ZERO : squared_four_areas(metric_, input, f) != 0;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::sign_of_area(const Delta_complex& complex, Face_index f, internal::Input_surface& surface) const
{
  const Halfedge_index h = complex.halfedge(f);
  const Uncertain<Sign> sign = unfolded_corner(complex, h, surface).four_areas.sign();
  return is_certain(sign) ? get_certain(sign) : exact_fallback(complex, surface).sign_of_area(h);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
bool Exact_geometry::has_length_zero(const Delta_complex& complex, Edge_index e) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  const auto& developed_faces = memory_->developed_faces;
  for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
    if (!complex.is_border(h) && developed_faces.contains(complex.face(h)))
      if (certainly(developed_faces.corner(complex, h).s_opposite.sign() == POSITIVE))
        return false;
  const Surface_lease surface = input_surface();
  const internal::Bounded_double_double s = squared_length(complex, e, *surface);
  return is_certain(s.sign()) ? s.is_zero() : exact_fallback(complex, *surface).has_length_zero(e);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Sign Exact_geometry::side_of(const Delta_complex& complex, Halfedge_index h, std::int64_t position, const Surface_point& point) const
{
  const internal::Standard_arithmetic arithmetic;
  prepare(complex);
  const auto area_beside = [&](auto& metric) {
    return Unfolding<std::decay_t<decltype(metric)>>(complex, correspondence_, metric).area_beside(h, position, point);
  };
  internal::Double_metric doubles(correspondence_.input(), metric_, interruption());
  if (const Uncertain<Sign> sign = area_beside(doubles).sign(); is_certain(sign))
    return get_certain(sign);
  if (!metric_.points().empty()) {
    find_straight_faces(complex);
    for (Halfedge_index side : {h, complex.opposite(h)})
      if (!complex.is_border(side) && is_straight(complex.face(side)))
        if (const std::optional<Sign> sign = internal::side_in_plane(complex, positions(), side, point))
          return *sign * (side == h ? POSITIVE : NEGATIVE);
  }
  return internal::exact_sign(*input_surface(), area_beside, [&] {
    return "that a point lies on edge " + std::to_string(complex.edge(h).idx());
  });
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_EXACT_EXACT_GEOMETRY_SIGNS_IMPL_H
