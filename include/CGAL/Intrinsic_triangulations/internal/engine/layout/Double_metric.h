// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of the input in doubles with error bounds (see Unfolding.h).

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DOUBLE_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DOUBLE_METRIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Disk.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/metric_images.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// As ratios_in_space(), in doubles.
inline std::optional<Corner_ratios<Double_disk>> rounded_ratios_in_space(const Delta_complex& input,
                                                                         const Points& points, Halfedge_index ij)
{
  if (points.empty())
    return std::nullopt;
  const Vertex_index i = input.source(ij);
  const auto u = difference<double>(points, i, input.target(ij)),
             v = difference<double>(points, i, input.target(input.next(ij))), n = cross_product(u, v);
  const double s = scalar_product(u, u), s_v = scalar_product(v, v);
  if (!(s > 1e-100 && s < 1e100 && s_v > 1e-100 && s_v < 1e100))
    return std::nullopt;
  const double reciprocal = 1 / s, x = scalar_product(u, v) * reciprocal,
               y = rounded_sqrt(scalar_product(n, n)) * reciprocal;
  // In units of 2^-53, s is good to 6 of itself, the scalar product to 6 of |u| |v|, and the area to 10 of that (see
  // Filtered_edge_length_traits::Construct_face_data), so that x + iy is good to 2^-48 of its absolute value.
  const Double_disk at_source(x, y, 0x1p-47 * rounded_sqrt(x * x + y * y));
  return Corner_ratios<Double_disk>{at_source, Double_disk(1, 0, 0) - at_source};
}

class Double_metric
{
public:
  using Real = Double_with_bound;
  using Vector = Double_disk;

  // \param surface with fans of triangles, which are not used without it
  Double_metric(const Delta_complex& input, const Input_metric& metric, const Interruption& interruption,
                Input_surface* surface = nullptr)
    : input_(input), metric_(metric), interruption_(interruption), surface_(surface)
  {}

  Real constant(double x) const { return Real(x); }
  Real squared_length(Edge_index e) const
  {
    if (metric_.points().empty())
      return Real(metric_.squared_length_double_double(input_, e));
    const Halfedge_index h = input_.halfedge(e);
    const double s =
      squared_distance_3(metric_.points()[input_.source(h).idx()], metric_.points()[input_.target(h).idx()]);
    constexpr double of_underflow = 0x1p-1072; // of three squares
    return {s, 0x1p-49 * s + of_underflow};
  }
  Real four_areas(Face_index f) const { return Real(metric_.four_areas_double_double(input_, f)); }
  // To compute them takes no longer than to look for them.
  template <class Compute>
  const Corner_ratios<Vector>& remembered(Halfedge_index h, const Compute& compute)
  {
    const auto in_space = rounded_ratios_in_space(input_, metric_.points(), h);
    ratios_ = in_space ? *in_space : compute();
    return ratios_;
  }
  bool keeps_fans() const { return surface_ != nullptr; }
  Vector fan_ratio(Halfedge_index from, Halfedge_index to, bool is_counterclockwise)
  {
    const Double_double_disk z = Double_double_metric(*surface_).fan_ratio(from, to, is_counterclockwise);
    return {Real(z.x()), Real(z.y())};
  }
  // Triangles in one plane are laid out like others: exact zeros are not asked for.
  std::false_type is_flat(Halfedge_index) const { return {}; }
  const Interruption& interruption() const { return interruption_; }

private:
  const Delta_complex& input_;
  const Input_metric& metric_;
  const Interruption& interruption_;
  Input_surface* surface_;
  Corner_ratios<Vector> ratios_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DOUBLE_METRIC_H
