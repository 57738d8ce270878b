// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Exact decisions and trustworthy numbers from the input and the integers alone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Stage_counts.h>
#include <CGAL/Intrinsic_triangulations/Tie_proof.h>
#include <CGAL/Intrinsic_triangulations/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Coplanar_hinge.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Developed_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Late_stages.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Straight_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/area_in_input_unit.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/corner_signs.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/metric_images.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief the exact geometry of a current triangulation: the metric of the input, and
/// where the input lies in the current triangulation.
///
/// Every answer is a function of the input and of the connectivity and does not depend on
/// the flips that led there.
class Exact_geometry
{
  using Double_double = internal::Bounded_double_double;

public:
  /// a corner in double-doubles with error bounds.
  using Corner = Unfolding<internal::Double_double_metric>::Corner;
  /// the corners opposite to an edge, k to its left and l to its right.
  using Opposite_corners = internal::Opposite_corners<internal::Double_double_metric>;

  /// constructs the geometry of a triangulation that has not been flipped yet.
  explicit Exact_geometry(Input_metric metric) : metric_(std::move(metric)) {}

  /// \name Copies
  /// What only speeds up queries is not copied.
  /// @{

  /// copies, moves or assigns the geometry.
  Exact_geometry(const Exact_geometry& other)
    : correspondence_(other.correspondence_), metric_(other.metric_), counts_(other.counts_),
      journal_(other.journal_), straight_faces_(other.straight_faces_)
  {
    set_tie_proof(other.tie_proof());
  }
  Exact_geometry(Exact_geometry&& other)
    : correspondence_(std::move(other.correspondence_)), metric_(std::move(other.metric_)),
      counts_(other.counts_), journal_(std::move(other.journal_)),
      straight_faces_(std::move(other.straight_faces_))
  {
    set_tie_proof(other.tie_proof());
  }
  Exact_geometry& operator=(Exact_geometry other)
  {
    correspondence_ = std::move(other.correspondence_);
    metric_ = std::move(other.metric_);
    counts_ = other.counts_;
    journal_ = std::move(other.journal_);
    straight_faces_ = std::move(other.straight_faces_);
    set_tie_proof(other.tie_proof());
    developed_faces_ = {};
    images_.reset();
    is_close_call_.clear();
    surface_.reset();
    return *this;
  }
  /// @}

  /// returns where the input lies in the current triangulation.
  const Correspondence& correspondence() const { return correspondence_; }
  /// returns the metric of the input.
  const Input_metric& metric() const { return metric_; }
  /// returns how the tests that reached the exact stages were decided.
  const Stage_counts& stage_counts() const { return counts_; }

  /// \brief follows a flip, before that of the connectivity.
  ///
  /// \param complex the triangulation
  /// \param around the halfedges around the edge
  /// \return whether the new edge is known to be a straight line between two of the points
  /// \exception Integer_overflow_error as `prepare()` and `flip()` of `Correspondence`
  bool flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (correspondence_.number_of_journaled_flips() + journal_.size() >= longest_journal * std::size_t(complex.number_of_edges())) {
      start_straight_faces(complex);
      prepare(complex);
    }
    correspondence_.flip(around);
    const Edge_index e = complex.edge(around.ij);
    if (straight_faces_)
      return follow(complex, e);
    if (correspondence_.is_prepared())
      journal_.push_back(e);
    return false;
  }
  /// returns whether flips may be appended: as long as no query was made.
  bool can_append() const { return !correspondence_.is_prepared() && !straight_faces_; }
  /// as `append()` of `Correspondence`. \pre `can_append()`
  void append(std::vector<Hinge_halfedges> flips) { correspondence_.append(std::move(flips)); }

  /// makes the queries below possible; as `Correspondence::prepare()`.
  void prepare(const Delta_complex& complex)
  {
    if (surface_)
      return;
    if (!correspondence_.is_prepared()) {
      std::vector<Edge_index> journal = correspondence_.prepare(complex);
      if (!straight_faces_)
        journal_ = std::move(journal);
    }
    surface_ = std::make_unique<internal::Input_surface>(correspondence_.input(), metric_, settings_);
  }

  /// \brief sets what decisions accept as a tie from now on.
  void set_tie_proof(Tie_proof tie_proof) { settings_.tie_proof = tie_proof; }
  /// returns what decisions accept as a tie.
  Tie_proof tie_proof() const { return settings_.tie_proof; }

  /// \brief sets a function that is called from time to time during a single decision that takes
  /// long: if it returns `false`, the decision ends with a `Cancelled_error`, and nothing is changed.
  ///
  /// An empty function, as at the beginning, never ends one. Copies do not take it over.
  /// \return the function that was set before
  std::function<bool()> set_interruption(std::function<bool()> go_further)
  {
    return settings_.interruption.exchange(std::move(go_further));
  }

  /// \cond SKIP_IN_MANUAL
  // For work that makes many short decisions.
  void check_interruption() { settings_.interruption.check(); }

  // The input as the images of its metric see it. \pre `prepare()` was called
  internal::Input_surface& input_surface() const { return *surface_; }
  /// \endcond

  /// \brief returns the sign of `cot k + cot l` for the angles opposite to `e`, exactly.
  ///
  /// Where both faces have zero area, it is `NEGATIVE` if both angles are π, and `ZERO`
  /// otherwise. Calls `prepare()`, unless both faces lie in one plane in space.
  /// \pre `e` lies between two different faces
  /// \param complex the triangulation
  /// \param e the edge
  /// \param corners receives the two corners
  /// \exception Undecided_error if a proof is demanded of each tie, and takes too long
  /// \exception Cancelled_error if the function that was given to `set_interruption()` says so
  Sign sign_of_cotangents(const Delta_complex& complex, Edge_index e,
                          std::optional<Opposite_corners>& corners)
  {
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    start_straight_faces(complex);
    if (straight_faces_->are_coplanar(complex, metric_.points(), h))
      return decided(Stage::COPLANAR,
                     internal::Coplanar_hinge(complex, metric_.points(), h).sign_of_cotangents());
    prepare(complex);
    is_close_call_.resize(complex.number_of_edges());
    is_close_call_[e.idx()] = true;
    corners = Opposite_corners{developed_corner(complex, h), developed_corner(complex, g)};
    // Layouts that were carried along are not the best, but what they do not decide is almost
    // always a tie.
    const Uncertain<Sign> sign = internal::sign_of_cotangents(corners->k, corners->l);
    if (is_certain(sign))
      return decided(Stage::UNFOLDING, sign);
    if (is_straight(complex.face(h)) && is_straight(complex.face(g)))
      return decided(Stage::RATIONAL, internal::sign_of_cotangents(
                                        internal::rational_corner(complex, metric_.points(), h),
                                        internal::rational_corner(complex, metric_.points(), g)));
    if (const std::optional<Sign> tie = sign_by_images(complex, e, *corners))
      return decided(Stage::MODULAR, *tie);
    const auto decision =
      late_stages(complex).sign_of_cotangents(internal::corners_beside(complex, e));
    if (decision.is_rational && !images_)
      carry_images();
    return decided(decision.stage, decision.sign);
  }

  /// \brief as above, but by the unfolding alone: what is known of the flips before, as
  /// that a face is straight in space, is not used. Not counted as a test of the algorithm.
  Sign sign_by_unfolding(const Delta_complex& complex, Edge_index e) const
  {
    internal::Double_double_metric metric(*surface_);
    const internal::Two_corners beside = internal::corners_beside(complex, e);
    const Opposite_corners corners = internal::unfolded_corners(
      Unfolding<internal::Double_double_metric>(complex, correspondence_, metric), beside);
    const Uncertain<Sign> sign = internal::sign_of_cotangents(corners.k, corners.l);
    return is_certain(sign) ? get_certain(sign)
                            : late_stages(complex).sign_of_cotangents(beside).sign;
  }

  /// as above, without the corners; not counted as a test of the algorithm.
  Sign sign_of_cotangents(const Delta_complex& complex, Edge_index e)
  {
    const Stage_counts counts = counts_;
    std::optional<Opposite_corners> corners;
    const Sign sign = sign_of_cotangents(complex, e, corners);
    counts_ = counts;
    return sign;
  }

  /// \brief returns whether the two faces of `e` form a strictly convex quadrilateral.
  /// \pre `prepare()` was called; `e` lies between two different faces
  /// \exception Undecided_error as `sign_of_cotangents()`
  bool is_convex(const Delta_complex& complex, Edge_index e)
  {
    // At both ends of e the two angles have to sum to less than π.
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    for (const internal::Two_corners& at_end :
         {internal::Two_corners{complex.next(h), complex.prev(g)},
          internal::Two_corners{complex.prev(h), complex.next(g)}}) {
      const Uncertain<Sign> sign = internal::sign_of_cotangents(
        corner(complex, at_end.opposite_to_k), corner(complex, at_end.opposite_to_l));
      if ((is_certain(sign) ? get_certain(sign)
                            : late_stages(complex).sign_of_cotangents(at_end).sign) != POSITIVE)
        return false;
    }
    return true;
  }

  /// returns the sign of the area of `f`, laid out over the input. It is `NEGATIVE` only if
  /// some flip was made in a hinge that is not convex. \pre `prepare()` was called
  Sign sign_of_area(const Delta_complex& complex, Face_index f) const
  {
    const Halfedge_index h = complex.halfedge(f);
    const Uncertain<Sign> sign = unfolded_corner(complex, h).four_areas.sign();
    return is_certain(sign) ? get_certain(sign) : late_stages(complex).sign_of_area(h);
  }

  /// returns the length of `e` in the unit of the input, within one unit in the last
  /// place. \pre `prepare()` was called
  double length(const Delta_complex& complex, Edge_index e) const
  {
    internal::Double_double_metric metric(*surface_);
    const Double_double s =
      Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).squared_length(e);
    if (s.relative_error() < 0x1p-70) {
      const Double_double l = sqrt(s);
      return std::ldexp(l.hi() + l.lo(), metric_.unit_exponent());
    }
    return std::ldexp(late_stages(complex).length(e), metric_.unit_exponent());
  }

  /// returns an interval around the length of `e`, in the unit of the input.
  /// \pre `prepare()` was called
  Interval_nt<> length_interval(const Delta_complex& complex, Edge_index e) const
  {
    internal::Double_double_metric metric(*surface_);
    const Double_double l = sqrt(
      Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).squared_length(e));
    double low, high;
    if (l.error() < 0x1p-60 * l.hi()) {
      low = high = l.hi();
      while (low - l.hi() > l.lo() - 1.01 * l.error())
        low = std::nextafter(low, 0.);
      while (high - l.hi() < l.lo() + 1.01 * l.error())
        high = std::nextafter(high, 2 * high);
    } else {
      const internal::Mpfr_interval m = sqrt(late_stages(complex).squared_length(e, 128));
      low = m.lower_double();
      high = m.upper_double();
    }
    // Where the scaling is not exact, it is wrong by less than the next double.
    low = std::ldexp(low, metric_.unit_exponent());
    high = std::ldexp(high, metric_.unit_exponent());
    if (low >= (std::numeric_limits<double>::min)())
      return Interval_nt<>(low, high);
    return Interval_nt<>((std::max)(0., std::nextafter(low, 0.)), std::nextafter(high, 1.));
  }

  /// returns the cotangent of the angle opposite to `h`, up to `2^-50 (1 + |cot|)`.
  /// \pre `prepare()` was called; `h` is not a border halfedge, its face has positive area
  double cotangent(const Delta_complex& complex, Halfedge_index h)
  {
    const Corner c = corner(complex, h);
    const double value = c.p.hi() / c.four_areas.hi();
    if (c.four_areas.relative_error() < 0x1p-60 &&
        c.p.error() < 0x1p-60 * (std::abs(c.p.hi()) + c.four_areas.hi()))
      return value;
    return late_stages(complex).number_of_corner(
      h, [](const auto& corner) { return corner.p / corner.four_areas; },
      [](double width, double magnitude) { return width <= 0x1p-51 * (1 + magnitude); });
  }

  /// returns the sum of the cotangents of the one or two angles opposite to `e`, up to
  /// `2^-49` times one plus the sum of their absolute values. A sum of zero is exactly zero, and the sign is right.
  /// \pre `prepare()` was called; `e` lies in faces of positive area
  double cotangent_weight(const Delta_complex& complex, Edge_index e)
  {
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    if (complex.is_border(h))
      return cotangent(complex, g);
    if (complex.is_border(g))
      return cotangent(complex, h);
    const Corner k = corner(complex, h), l = corner(complex, g);
    const Double_double weight = k.p / k.four_areas + l.p / l.four_areas;
    const Uncertain<Sign> sign = weight.sign();
    if (is_certain(sign) && weight.error() < 0x1p-52 * (1 + std::abs(weight.hi())))
      return weight.hi();
    const double sum = cotangent(complex, h) + cotangent(complex, g);
    if (!complex.is_flippable(e))
      return sum;
    const Sign exact_sign = sign_of_cotangents(complex, e);
    if (exact_sign == ZERO)
      return 0;
    return CGAL::sign(sum) == exact_sign ? sum : late_stages(complex).sum_of_cotangents(internal::corners_beside(complex, e));
  }

  /// returns the area of `f` in the unit of the input, up to a relative error of `2^-50`.
  /// \pre `prepare()` was called
  /// \exception Invalid_surface_error if the unit of the input is so small or so large that
  ///   the area leaves the range of `double`
  double area(const Delta_complex& complex, Face_index f)
  {
    const Halfedge_index h = complex.halfedge(f);
    const Double_double a = corner(complex, h).four_areas;
    const double value = a.is_zero() || a.relative_error() < 0x1p-54
                           ? a.hi()
                         : sign_of_area(complex, f) == ZERO
                           ? 0
                           : late_stages(complex).number_of_corner(
                               h, [](const auto& corner) { return corner.four_areas; },
                               [](double width, double magnitude) {
                                 return width <= 0x1p-51 * magnitude;
                               });
    return internal::area_in_input_unit(value / 4, metric_.unit_exponent(), f);
  }

  /// returns whether two vertices coincide: whether `e` has length zero.
  /// \pre `prepare()` was called
  bool has_length_zero(const Delta_complex& complex, Edge_index e) const
  {
    for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
      if (!complex.is_border(h) && developed_faces_.contains(complex.face(h)))
        if (certainly(developed_faces_.corner(complex, h).s_opposite.sign() == POSITIVE))
          return false;
    internal::Double_double_metric metric(*surface_);
    const Double_double s =
      Unfolding<internal::Double_double_metric>(complex, correspondence_, metric).squared_length(e);
    if (is_certain(s.sign()))
      return s.is_zero();
    return late_stages(complex).has_length_zero(e);
  }

  /// returns the corner opposite to `h`, in double-doubles with error bounds and in the
  /// unit of the metric. \pre `prepare()` was called; `h` is not a border halfedge
  Corner corner(const Delta_complex& complex, Halfedge_index h)
  {
    start_straight_faces(complex);
    if (is_straight(complex.face(h)))
      return straight_corner(complex, h);
    return unfolded_corner(complex, h);
  }

private:
  using Image_corner = Unfolding<internal::Residue_metric>::Corner;
  using Developed_faces =
    internal::Developed_faces<internal::Bounded_double_double, internal::Double_double_disk, Corner, Image_corner>;

  // In flips for each edge. A journal is not to become much larger than the triangulation.
  static constexpr std::size_t longest_journal = 8;

  // Finds out which faces are straight, by repeating the flips; flip() keeps it up from then on.
  void start_straight_faces(const Delta_complex& complex)
  {
    if (!straight_faces_)
      find_straight_faces(complex);
  }

  BOOST_NOINLINE void find_straight_faces(const Delta_complex& complex)
  {
    internal::Straight_faces straight_faces(complex.number_of_faces(), metric_.points().size());
    if (!metric_.points().empty()) {
      std::vector<Edge_index> flips = correspondence_.journaled_flips(complex);
      flips.insert(flips.end(), journal_.begin(), journal_.end());
      Delta_complex copy = complex;
      for (std::size_t i = flips.size(); i-- > 0;)
        copy.flip_back(flips[i]);
      for (Edge_index e : flips) {
        straight_faces.flip(copy, metric_.points(), e);
        copy.flip(e);
      }
    }
    straight_faces_ = std::move(straight_faces);
    std::vector<Edge_index>().swap(journal_);
  }

  // Keeps up what is known of the faces, before the flip of the connectivity. Returns whether
  // the new faces are straight.
  BOOST_NOINLINE bool follow(const Delta_complex& complex, Edge_index e)
  {
    const bool is_close_call = !is_close_call_.empty() && is_close_call_[e.idx()];
    using Known_corner = Developed_faces::Known_corner;
    developed_faces_.flip(complex, e, is_close_call, [&](Halfedge_index h, bool needs_image) -> std::optional<Known_corner> {
      if (!is_straight(complex.face(h)))
        return std::nullopt;
      return Known_corner{straight_corner(complex, h),
                          needs_image ? image_of_straight_corner(complex, h) : std::nullopt};
    });
    if (is_close_call)
      is_close_call_[e.idx()] = false;
    return straight_faces_->flip(complex, metric_.points(), e);
  }

  bool is_straight(Face_index f) const { return (*straight_faces_)(f); }

  // As corner(), from what is kept of tests before.
  Corner developed_corner(const Delta_complex& complex, Halfedge_index h)
  {
    const Face_index f = complex.face(h);
    if (is_straight(f))
      return straight_corner(complex, h);
    if (developed_faces_.contains(f))
      return developed_faces_.corner(complex, h);
    internal::Crossing_sequences sequences;
    internal::Double_double_metric metric(*surface_);
    const Corner c = Unfolding<internal::Double_double_metric>(complex, correspondence_, metric, sequences)
                       .opposite_corner(h);
    developed_faces_.insert(complex, h, {c, image([&] {
                                           return Unfolding<internal::Residue_metric>(complex, correspondence_, images_->metric, sequences)
                                             .opposite_corner(h);
                                         })});
    return c;
  }

  Corner unfolded_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    internal::Double_double_metric metric(*surface_);
    return Unfolding<internal::Double_double_metric>(complex, correspondence_, metric)
      .opposite_corner(h);
  }

  struct Carried_images
  {
    explicit Carried_images(internal::Input_surface& surface)
      : rings(surface.prime_fields(0), surface.interruption(), 0), metric(surface, {rings})
    {}
    internal::Residue_rings rings; // without irrational roots
    internal::Residue_metric metric;
  };

  // A tie seldom comes alone. From the first one on, images of corners in finite fields are carried along by the
  // flips, where all areas are rational: this saves laying out strips of thousands of triangles for each tie.
  void carry_images()
  {
    images_ = std::make_unique<Carried_images>(*surface_);
    developed_faces_ = {};
  }

  template <class Compute>
  std::optional<Image_corner> image(const Compute& compute) const
  {
    if (!images_)
      return std::nullopt;
    try {
      const Image_corner result = compute();
      return images_->rings.is_defined() ? std::make_optional(result) : std::nullopt;
    } catch (const internal::Too_costly&) {
      return std::nullopt;
    }
  }

  std::optional<Image_corner> image_of_straight_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    return image([&] { return internal::image_of_straight_corner(complex, metric_.points(), h, images_->rings); });
  }

  // The sign of the sum of cotangents, if images that were carried along tell that the edge is a tie, or that both
  // faces have no area.
  std::optional<Sign> sign_by_images(const Delta_complex& complex, Edge_index e, const Opposite_corners& corners) const
  {
    if (!images_ || !surface_->accepts_probable_ties())
      return std::nullopt;
    const auto find = [&](Halfedge_index h) {
      const Face_index f = complex.face(h);
      return is_straight(f)                 ? image_of_straight_corner(complex, h)
             : developed_faces_.contains(f) ? developed_faces_.image_of_corner(complex, h)
                                            : std::nullopt;
    };
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    const std::optional<Image_corner> k = find(h), l = k ? find(g) : std::nullopt;
    if (!k || !l || !(k->p * l->four_areas + l->p * k->four_areas).is_zero() || !images_->rings.is_defined() ||
        internal::Residue_rings::certainty(number_of_quantities(complex, h) + number_of_quantities(complex, g),
                                           surface_->largest_size()) < 128)
      return std::nullopt;
    if (is_positive(corners.k.four_areas) && is_positive(corners.l.four_areas))
      return ZERO;
    const Uncertain<Sign> p_k = corners.k.p.sign(), p_l = corners.l.p.sign();
    if (k->four_areas.is_zero() && l->four_areas.is_zero() && is_certain(p_k) && is_certain(p_l))
      return internal::sign_of_tie(get_certain(p_k), get_certain(p_l));
    return std::nullopt;
  }

  static bool is_positive(const Double_double& x) { return certainly(x.sign() == POSITIVE); }

  // A bound on the number of input quantities that the corner opposite to h is a function of.
  double number_of_quantities(const Delta_complex& complex, Halfedge_index h) const
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    return double(coordinates.number_of_crossings(complex.edge(complex.next(h)))) +
           double(coordinates.number_of_crossings(complex.edge(complex.prev(h)))) +
           double(coordinates.triangle_crossings(complex, h).e_k) + 16;
  }

  Corner straight_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    return internal::straight_corner<Corner>(complex, metric_.points(), h);
  }

  internal::Late_stages late_stages(const Delta_complex& complex) const
  {
    return {complex, correspondence_, *surface_};
  }

  Sign decided(Stage stage, Uncertain<Sign> sign)
  {
    ++counts_.decided[std::size_t(stage)];
    if (get_certain(sign) == ZERO)
      ++counts_.ties;
    return get_certain(sign);
  }

  Correspondence correspondence_;
  Input_metric metric_;
  Stage_counts counts_;
  std::vector<Edge_index> journal_; // the flips until it was asked which faces are straight
  std::optional<internal::Straight_faces> straight_faces_;
  Developed_faces developed_faces_;
  // A test took more than double since the last flip of the edge.
  std::vector<bool> is_close_call_;
  mutable internal::Decision_settings settings_;
  std::unique_ptr<Carried_images> images_;           // of the developed faces, from the first tie on
  std::unique_ptr<internal::Input_surface> surface_; // refers to the members above
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_GEOMETRY_H
