// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of the input in the rings in which edges are unfolded (see Unfolding.h).

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_IMAGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_IMAGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../../arithmetic/Planar_vector.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Decisions.h>
#include "Fan_positions.h"
#include "Unfolding.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include "../../arithmetic/Disk.h"
#include "../../arithmetic/Mpfr_disk.h"
#include "../../arithmetic/Multiquadratic.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "../../arithmetic/Residues.h"
#include "../../arithmetic/Split_double_double.h"
#include "../../arithmetic/Square_root_basis.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include "../../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include "../../system/Scratch_pool.h"
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <CGAL/enum.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Facts about the input, found on first use. Threads that ask at the same time find the same.
class Input_properties
{
public:
  Input_properties(const Delta_complex& connectivity, const Input_metric& metric)
    : connectivity_(connectivity), metric_(metric),
      flatness_(metric.points().empty() ? 0 : connectivity.number_of_edges(), UNKNOWN)
  {}

  // Whether the faces of an edge lie in one plane.
  BOOST_FORCEINLINE bool is_flat(Halfedge_index h)
  {
    if (flatness_.empty())
      return false;
    std::uint8_t& stored = flatness_[connectivity_.edge(h).idx()];
    std::uint8_t flatness = relaxed_load(stored);
    if (flatness == UNKNOWN) {
      flatness =
        connectivity_.is_flippable(connectivity_.edge(h)) && internal::is_flat(connectivity_, metric_.points(), h)
          ? FLAT
          : BENT;
      relaxed_store(stored, flatness);
    }
    return flatness == FLAT;
  }
  // A bound on the sizes of the numbers of the metric (see Input_metric).
  double largest_size()
  {
    double size = relaxed_load(largest_size_);
    if (size == 0) {
      size = metric_.largest_size();
      relaxed_store(largest_size_, size);
    }
    return size;
  }

private:
  enum Flatness : std::uint8_t {
    UNKNOWN,
    FLAT,
    BENT
  };

  const Delta_complex& connectivity_;
  const Input_metric& metric_;
  Large_vector<std::uint8_t> flatness_;
  double largest_size_ = 0;
};

template <class Image>
class Rational_metric;
struct Mpfr_image;
using Mpfr_metric = Rational_metric<Mpfr_image>;

// The input with all images of its metric, and their caches.
class Input_surface
{
public:
  Input_surface(const Delta_complex& connectivity, const Input_metric& metric, const Decisions& decisions,
                Input_properties& properties)
    : connectivity_(connectivity), metric_(metric), decisions_(decisions), properties_(properties),
      ratios_(2 * std::size_t(connectivity.number_of_edges())),
      ratios_in_plane_(2 * std::size_t(connectivity.number_of_edges()))
  {}

  const Delta_complex& connectivity() const { return connectivity_; }
  const Input_metric& metric() const { return metric_; }

  const Interruption& interruption() const { return decisions_.interruption; }
  bool accepts_probable_ties() const { return decisions_.tie_proof == Tie_proof::PROBABLE_IF_COSTLY; }

  // Number `number` in a sequence of pseudorandom fields that is the same in each run.
  const Prime_fields& prime_fields(std::size_t number)
  {
    while (prime_fields_.size() <= number)
      prime_fields_.push_back(random_prime_fields(metric_.hash() + prime_fields_.size()));
    return prime_fields_[number];
  }

  // A bound on the sizes of the numbers of the metric, and, if points on the input enter, of any double, since
  // coordinates may be any doubles.
  double largest_size(bool has_points)
  {
    return has_points ? (std::max)(size_of_double, properties_.largest_size()) : properties_.largest_size();
  }

  BOOST_FORCEINLINE bool is_flat(Halfedge_index h) { return properties_.is_flat(h); }

  // Neighboring edges cross the same triangles.
  template <class Compute>
  const Corner_ratios<Double_double_disk>& remembered(Halfedge_index h, const Compute& compute)
  {
    return ratios_(h, h.idx(), compute);
  }
  // The same for ratios of vectors within a plane.
  template <class Compute>
  const Double_double_disk& remembered(Halfedge_index h, Vertex_index from, Vertex_index to, const Compute& compute)
  {
    const std::uint32_t hash = (h.idx() * 0x9e3779b1u) ^ (from.idx() * 0x85ebca6bu) ^ (to.idx() * 0xc2b2ae35u);
    return ratios_in_plane_({h, from, to}, hash >> 16, compute);
  }

  Fan_positions& fans() { return fans_; }

  // Valid until the next call.
  Mpfr_metric& mpfr_metric(long precision);

private:
  // Twice the digits before and after the point.
  static constexpr double size_of_double = 2 * (1024 + 1074 + 53);

  const Delta_complex& connectivity_;
  const Input_metric& metric_;
  const Decisions& decisions_;
  Input_properties& properties_; // which all threads share
  std::deque<Prime_fields> prime_fields_;
  Direct_mapped_cache<Halfedge_index, Corner_ratios<Double_double_disk>> ratios_;
  Direct_mapped_cache<std::tuple<Halfedge_index, Vertex_index, Vertex_index>, Double_double_disk> ratios_in_plane_;
  Fan_positions fans_;
  std::map<long, std::shared_ptr<Mpfr_metric>> mpfr_metrics_; // by precision
};

// As Metric_frame::ratios(), in half of the time: one bound for all errors instead of a running one. Empty without
// points, or if something could underflow, as in nearly flat faces.
inline std::optional<Corner_ratios<Double_double_disk>> ratios_in_space(const Delta_complex& input,
                                                                        const Points& points, Halfedge_index ij)
{
  if (points.empty())
    return std::nullopt;
  const auto &p = points[input.source(ij).idx()], &q = points[input.target(ij).idx()],
             &r = points[input.target(input.next(ij)).idx()];
  const Split_vector<double> u = split_vector(p, q), v = split_vector(p, r);
  const Split_double_double<double> s = split_scalar_product(u, u), square = split_squared_area(u, v);
  const double s_v = rough_square(v);
  if (!(s.hi > 1e-100 && s.hi < 1e100 && s_v > 1e-100 && s_v < 1e100 && square.hi > 1e-200))
    return std::nullopt;
  const double reciprocal = 1 / s.hi;
  const Split_double_double<double> x = quotient(split_scalar_product(u, v), s, reciprocal),
                                    y = quotient(square_root(square), s, reciprocal);
  // Errors of products of the vectors are at most 2^-102 times the products of their lengths, so the relative error of
  // x + iy is at most 2^-99.
  const double error = 0x1p-97 * rounded_sqrt(s_v * reciprocal);
  const Bounded_double_double at_source(x.hi, x.lo, error), height(y.hi, y.lo, error);
  return Corner_ratios<Double_double_disk>{{at_source, height}, {Bounded_double_double(1) - at_source, -height}};
}

// An Input_surface that belongs to one call.
class Surface_lease : public Scratch_pool<Input_surface>::Lease
{
public:
  Surface_lease(Lease&& lease) : Lease(std::move(lease)) {}
};

// The metric in double-doubles with error bounds.
class Double_double_metric
{
public:
  static constexpr bool has_accurate_ratios = false;
  using Real = Bounded_double_double;
  using Vector = Double_double_disk;

  explicit Double_double_metric(Input_surface& surface) : surface_(surface) {}

  Real constant(double x) const { return Real(x); }
  Real squared_length(Edge_index e) const
  {
    return surface_.metric().squared_length_double_double(surface_.connectivity(), e);
  }
  Real four_areas(Face_index f) const { return surface_.metric().four_areas_double_double(surface_.connectivity(), f); }
  template <class Compute>
  const Corner_ratios<Vector>& remembered(Halfedge_index h, const Compute& compute)
  {
    return surface_.remembered(h, [&] {
      const auto in_space = ratios_in_space(surface_.connectivity(), surface_.metric().points(), h);
      return in_space ? *in_space : compute();
    });
  }
  std::true_type keeps_fans() const { return {}; }
  Vector fan_ratio(Halfedge_index from, Halfedge_index to, bool is_counterclockwise)
  {
    const Metric_frame<Double_double_metric> frame(surface_.connectivity(), *this);
    return surface_.fans().ratio(surface_.connectivity(), from, to, is_counterclockwise, [&](Halfedge_index h) {
      interruption().check();
      return frame.ratios(h).at_source;
    });
  }
  bool is_flat(Halfedge_index h) { return surface_.is_flat(h); }
  const Interruption& interruption() { return surface_.interruption(); }
  Vector ratio_in_plane(Halfedge_index h, Vertex_index from, Vertex_index to)
  {
    return surface_.remembered(h, from, to, [&]() -> Vector {
      const Delta_complex& c = surface_.connectivity();
      const Points& points = surface_.metric().points();
      const Vertex_index i = c.source(h), j = c.target(h);
      const auto u = difference<Real>(points, i, j), w = difference<Real>(points, from, to);
      const auto normal = cross_product(u, w);
      const Real s = scalar_product(u, u);
      const Real height = sqrt(scalar_product(normal, normal)) / s;
      const Sign side = sign_of_normals(points, {i, j}, {from, to}, {i, j}, {i, apex(c, h)});
      return {scalar_product(u, w) / s, side == NEGATIVE ? -height : height};
    });
  }

private:
  Input_surface& surface_;
};

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

// The metric in doubles with error bounds.
class Double_metric
{
public:
  static constexpr bool has_accurate_ratios = false;
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
  // Computing them takes no longer than looking them up.
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
  // Triangles in one plane are laid out like others: exact zeros are not needed.
  std::false_type is_flat(Halfedge_index) const { return {}; }
  const Interruption& interruption() const { return interruption_; }

private:
  const Delta_complex& input_;
  const Input_metric& metric_;
  const Interruption& interruption_;
  Input_surface* surface_;
  Corner_ratios<Vector> ratios_;
};

// The metric in a ring that is given by the images of the rationals, of their square roots, and of coordinates, which
// may stay in a smaller ring until they meet roots. Remembers recent results, and counts the requested quantities.
//
// Where the image rounds, scalar and cross products of sides give each number with an error relative to the sides that
// it belongs to. Squared lengths of very different sides would cancel, and all digits of the coordinates would be
// needed.
template <class Image>
class Rational_metric
{
public:
  using Real = typename Image::Real;
  using Vector = typename Image::Vector;

  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

  // \param largest_count the number of quantities at which Too_costly is thrown
  Rational_metric(Input_surface& surface, Image image, std::size_t largest_count = unlimited)
    : surface_(surface), image_(image), largest_count_(largest_count)
  {}

  std::size_t number_of_quantities() const { return count_; }
  // A bound on the sizes of these quantities.
  double largest_size() const { return surface_.largest_size(has_points_); }

  // 0, 1, or a coordinate of a point on the input.
  Real constant(double x)
  {
    count();
    has_points_ = has_points_ || (x != 0 && x != 1);
    return image_.real(image_.coordinate(x));
  }
  Real squared_length(Edge_index e)
  {
    count();
    const Delta_complex& c = surface_.connectivity();
    if (surface_.metric().points().empty())
      return image_.rational(Intrinsic_triangulations::squared_length(surface_.metric(), c, e));
    const auto u = vector(c.source(c.halfedge(e)), c.target(c.halfedge(e)));
    return image_.real(scalar_product(u, u));
  }
  Real four_areas(Face_index f)
  {
    count();
    return remembered_in(roots_, f, [&]() -> Real {
      if constexpr (Image::is_rounded)
        if (!surface_.metric().points().empty()) {
          const auto n = normal(f);
          const Real square = scalar_product(n, n), root = sqrt(square);
          if (certainly(square.sign() == POSITIVE))
            return root + root;
        }
      return image_.root(squared_four_areas(surface_.metric(), surface_.connectivity(), f));
    });
  }
  static constexpr bool has_accurate_ratios = Image::is_rounded;
  template <class Compute>
  const Corner_ratios<Vector>& remembered(Halfedge_index h, const Compute& compute)
  {
    count();
    return remembered_in(ratios_, h, [&]() -> Corner_ratios<Vector> {
      if constexpr (Image::is_rounded)
        if (!surface_.metric().points().empty())
          return ratios_of_points(h);
      return compute();
    });
  }
  std::false_type keeps_fans() const { return {}; }
  bool is_flat(Halfedge_index h) { return surface_.is_flat(h); }
  const Interruption& interruption() { return surface_.interruption(); }
  Vector ratio_in_plane(Halfedge_index h, Vertex_index from, Vertex_index to)
  {
    count();
    const Base& base = remembered_in(bases_, h, [&] { return base_of(h); });
    const auto w = vector(from, to);
    return {image_.real(scalar_product(base.side, w)) * base.side_unit,
            image_.real(scalar_product(base.height, w)) * base.height_unit};
  }

private:
  using Coordinate = typename Image::Coordinate;

  Corner_ratios<Vector> ratios_of_points(Halfedge_index h)
  {
    const Delta_complex& c = surface_.connectivity();
    const Vertex_index i = c.source(h), j = c.target(h), k = apex(c, h);
    const auto u = vector(i, j);
    const Real s = scalar_product(u, u), height = four_areas(c.face(h)) / (s + s);
    return {Vector(scalar_product(u, vector(i, k)) / s, height), Vector(scalar_product(u, vector(k, j)) / s, -height)};
  }

  // A normal as long as twice the area, from the shorter sides, since errors are relative to the lengths of the
  // factors.
  Vector_3<Coordinate> normal(Face_index f)
  {
    const Delta_complex& c = surface_.connectivity();
    const Halfedge_index h = side_with_largest(c, f, [&](Halfedge_index side) {
      const auto d = difference<double>(surface_.metric().points(), c.source(side), c.target(side));
      return (std::max)({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    });
    const Vertex_index k = apex(c, h);
    return cross_product(vector(k, c.source(h)), vector(k, c.target(h)));
  }

  // Computed once for all ratios to a halfedge, with its triangle to its left: the side u, a multiple of the height, n
  // × u with the normal n, and the factors for scalar products with either.
  struct Base
  {
    Vector_3<Coordinate> side, height;
    Real side_unit, height_unit;
  };

  Base base_of(Halfedge_index h)
  {
    const Delta_complex& c = surface_.connectivity();
    const auto u = vector(c.source(h), c.target(h)), n = normal(c.face(h));
    const Coordinate s = scalar_product(u, u);
    // Twice |u|² |n|², where four_areas is twice |n|.
    const Coordinate divisor = (s + s) * scalar_product(n, n);
    return {u, cross_product(n, u), image_.real(image_.coordinate(1)) / image_.real(s),
            four_areas(c.face(h)) / image_.real(divisor)};
  }

  Vector_3<Coordinate> vector(Vertex_index from, Vertex_index to)
  {
    const Vector_3<Coordinate> p = position(from); // a copy, because the other may displace it
    const Vector_3<Coordinate>& q = position(to);
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }
  const Vector_3<Coordinate>& position(Vertex_index v)
  {
    return remembered_in(positions_, v, [&] {
      const std::array<double, 3>& p = surface_.metric().points()[v.idx()];
      return Vector_3<Coordinate>{image_.coordinate(p[0]), image_.coordinate(p[1]), image_.coordinate(p[2])};
    });
  }

  void count()
  {
    surface_.interruption().check();
    if (++count_ > largest_count_)
      throw Too_costly();
  }

  // Forgets everything when it has grown large.
  template <class Map, class Compute>
  static const typename Map::mapped_type& remembered_in(Map& map, const typename Map::key_type& key,
                                                        const Compute& compute)
  {
    const auto position = map.find(key);
    if (position != map.end())
      return position->second;
    typename Map::mapped_type value = compute();
    if (map.size() == 4096)
      map.clear();
    return map.emplace(key, std::move(value)).first->second;
  }

  Input_surface& surface_;
  Image image_;
  std::size_t largest_count_;
  std::size_t count_ = 0;
  bool has_points_ = false;
  std::unordered_map<Halfedge_index, Corner_ratios<Vector>> ratios_;
  std::unordered_map<Face_index, Real> roots_;
  std::unordered_map<Halfedge_index, Base> bases_;
  std::unordered_map<Vertex_index, Vector_3<Coordinate>> positions_;
};

// Multiple-precision intervals.
struct Mpfr_image
{
  static constexpr bool is_rounded = true;
  using Real = Mpfr_interval;
  using Coordinate = Mpfr_interval;
  using Vector = Mpfr_disk;
  Real rational(const Rational& x) const { return Real(data(x), precision); }
  Real coordinate(double x) const { return Real(x, precision); }
  const Real& real(const Real& x) const { return x; }
  Real root(const Rational& x) const { return sqrt(rational(x)); }
  long precision;
};

// The multiquadratic field of the requested roots; without any, the rationals.
struct Multiquadratic_image
{
  static constexpr bool is_rounded = false;
  using Real = Multiquadratic;
  using Coordinate = Rational;
  using Vector = Planar_vector<Real>;
  Real rational(const Rational& x) const { return Real(&field, 0, x); }
  Rational coordinate(double x) const { return Rational(x); }
  Real real(const Rational& x) const { return rational(x); }
  Real root(const Rational& x) const
  {
    const Square_root_basis::Root root = field.basis().root(x);
    Multiquadratic_field::Mask mask = 0;
    for (std::uint32_t i : root.generators)
      mask |= Multiquadratic_field::Mask(1) << i;
    return Real(&field, mask, root.coefficient);
  }
  Multiquadratic_field& field;
};

// Finite fields.
struct Residue_image
{
  static constexpr bool is_rounded = false;
  using Real = Residues;
  using Coordinate = Residues;
  using Vector = Planar_vector<Real>;
  Residues coordinate(double x) const { return rings.number(x); }
  Real real(const Residues& x) const { return x; }
  Real rational(const Rational& x) const { return rings.rational(x); }
  Real root(const Rational& x) const { return rings.root(x); }
  Residue_rings& rings;
};

using Multiquadratic_metric = Rational_metric<Multiquadratic_image>;
using Residue_metric = Rational_metric<Residue_image>;

inline Mpfr_metric& Input_surface::mpfr_metric(long precision)
{
  constexpr long largest_kept = 1024; // in bits
  std::shared_ptr<Mpfr_metric>& metric = mpfr_metrics_[(std::min)(precision, largest_kept + 1)];
  if (!metric || precision > largest_kept)
    metric = std::make_shared<Mpfr_metric>(*this, Mpfr_image{precision});
  return *metric;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_METRIC_IMAGES_H
