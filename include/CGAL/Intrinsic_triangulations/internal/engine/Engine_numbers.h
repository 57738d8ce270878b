// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths, angles, areas and weights from the exact engine, with bounds or rounded to doubles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ENGINE_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ENGINE_NUMBERS_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <array>
#include <complex>
#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers of all elements, with one corner laid out for each face. NaN if that is not accurate enough to round as
// individual layouts do.
struct Rounded_numbers
{
  explicit Rounded_numbers(const Delta_complex& complex);
  // As cotangent_weight() up to the last digits, or NaN. \pre e is not a border edge
  double cotangent_weight(const Delta_complex& complex, Edge_index e) const;
  // As angle() up to this relative error, or NaN. \pre h is not a border halfedge
  double angle(Halfedge_index h, double relative_error) const;

  Large_vector<double> lengths; // as length() returns them, up to the last digit
  Large_vector<double> areas;   // in the unit of the metric
  // Opposite to each halfedge of a face: `hi()`, `lo()` and `error()`, which is infinite unless the area is known to
  // be positive.
  Large_vector<std::array<double, 3>> cotangents;
};

// Only refers to the engine. Its functions are queries of the engine, which describes threads and exceptions.
class Engine_numbers
{
public:
  using Corner = Exact_engine::Corner;

  explicit Engine_numbers(const Exact_engine& engine)
    : engine_(engine), complex_(engine.connectivity()), correspondence_(engine.correspondence()),
      metric_(engine.metric())
  {}

  // ---------------------------------------------------------------- in the unit of the metric, with bounds

  // The corner opposite to h. \pre h is not a border halfedge
  Corner corner(Halfedge_index h) const;

  // The cotangents of the angles of a face: opposite to `halfedge(f)` and to the halfedges that follow.
  using Face_cotangents = std::array<Bounded_double_double, 3>;
  // Finds them by laying out one corner. The errors are infinite if the area is not known to be positive.
  void find_cotangents(Face_index f, Face_cotangents& result) const;
  // The same in doubles, in a fraction of the time. The errors are also infinite for long strips.
  using Rounded_face_cotangents = std::array<Double_with_bound, 3>;
  void find_cotangents(Face_index f, Rounded_face_cotangents& result) const;
  // Likewise four times the area of a face.
  Double_with_bound rounded_four_areas(Face_index f) const;

  // ---------------------------------------------------------------- in the unit of the input, rounded

  // The length of `e`, within one unit in the last place.
  double length(Edge_index e) const;

  // The cotangent of the angle opposite to `h`, up to `2^-50 (1 + |cot|)`.
  // \pre `h` is not a border halfedge, its face has positive area
  double cotangent(Halfedge_index h) const;

  // The angle opposite to `h`, up to a relative error of `2^-49` unless it is below `2^-400`. In a face of
  // zero area it is 0, or π rounded to `double`.
  // \pre `h` is not a border halfedge
  double angle(Halfedge_index h) const;

  // The sum of the cotangents of the one or two angles opposite to `e`, up to
  // `2^-49` times one plus the sum of their absolute values. A sum of zero is exactly zero, and the sign is right.
  // \pre `e` lies in faces of positive area
  double cotangent_weight(Edge_index e) const;

  // The area of `f`, up to a relative error of `2^-50`. A subnormal area is within two units in its last place, and
  // not zero.
  // \exception Invalid_surface_error if the unit of the input is so small or so large that the area leaves the range of
  //   `double`
  double area(Face_index f) const;

  // Finds the numbers of the faces from first to before last; other threads may do this for other faces.
  void find_numbers(std::size_t first, std::size_t last, Rounded_numbers& numbers) const;

  // As `edge_beginning()` of `Unfolding`, with errors of at most 2^-50 of the vector, or of the source if that is
  // longer.
  struct Edge_beginning
  {
    std::complex<double> source, vector;
    Halfedge_index reference;
  };
  Edge_beginning edge_beginning(Halfedge_index h) const;

  // The angle at the source of an input halfedge, in its face, up to 2^-50. \pre `prepare()` was called, h is not a
  // border halfedge
  double input_angle(Halfedge_index h) const;

  // Whether a face is known to be a triangle in space. Rounded numbers depend on that in the last place.
  bool is_known_to_be_straight(Face_index f) const;

private:
  friend class Engine_restorer;

  template <std::size_t N, class Evaluate>
  static std::array<std::complex<double>, N> rounded_vectors(Input_surface& surface, const Evaluate& evaluate);
  double cotangent(Halfedge_index h, const Corner& corner, Input_surface& surface) const;
  double signed_cotangent(Halfedge_index h, Input_surface& surface) const;
  template <class Real>
  struct Side_and_corner;
  template <class Unfolding_>
  Side_and_corner<Bounded_double_double> quickest_corner(Face_index f, const Unfolding_& unfolding) const;
  std::optional<Side_and_corner<Double_with_bound>> rounded_corner(Face_index f) const;

  const Exact_engine& engine_;
  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Input_metric& metric_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_ENGINE_NUMBERS_H
