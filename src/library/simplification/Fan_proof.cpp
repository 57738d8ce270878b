// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The factors by which the steps of a simplification change lengths, in intervals.

#include "Fan_proof.h"
#include "flat_layout.h"

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Interval = CGAL::Interval_nt<false>;
using Protector = Interval::Protector;

constexpr double unbounded = std::numeric_limits<double>::infinity();

Interval squared(double x) { return CGAL::square(Interval(x)); }
Interval heron(double a, double b, double c)
{
  return squared_four_areas_from_lengths(Interval(a), Interval(b), Interval(c));
}
double largest_magnitude(const Interval& x) { return (std::max)(-x.inf(), x.sup()); }

// The change of a new face that overlaps two others.
Squared_change either(const Squared_change& a, const Squared_change& b)
{
  return {(std::min)(a.down, b.down), (std::max)(a.up, b.up)};
}

Squared_change product(const Squared_change& a, const Interval& down, const Interval& up)
{
  return {(Interval(a.down) * Interval(down.inf())).inf(), (Interval(a.up) * Interval(up.sup())).sup()};
}

// False if a factor is NaN.
bool is_within(const Squared_change& change, double limit)
{
  return change.up <= limit && (Interval(change.down) * Interval(limit)).inf() >= 1;
}

} // namespace

Squared_change product(const Squared_change& a, const Squared_change& b)
{
  const Protector protector;
  return product(a, Interval(b.down), Interval(b.up));
}

// From the rounded triangle to the other one, the eigenvalues of M are the roots of x² − 2hx + d, with |d| <=
// total²/area.
Squared_change change_by_rounding(const std::array<double, 3>& sides)
{
  const Protector protector;
  const Interval area = heron(sides[0], sides[1], sides[2]);
  if (!(area.inf() > 0))
    return {0, unbounded};
  Interval half(0), total(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const double up = std::nextafter(std::nextafter(sides[i], unbounded), unbounded);
    const Interval off(largest_magnitude(squared(up) - squared(sides[i])));
    const Interval across = squared(sides[(i + 1) % 3]) + squared(sides[(i + 2) % 3]) - squared(sides[i]);
    half += Interval(largest_magnitude(across)) * off;
    total += off;
  }
  half /= area;
  const double most = (half + CGAL::sqrt(CGAL::square(half) + CGAL::square(total) / area)).sup();
  if (!(most < 1))
    return {0, unbounded};
  return {(Interval(1) - Interval(most)).inf(), (Interval(1) / (Interval(1) - Interval(most))).sup()};
}

namespace {

using Bounded_point = Planar_vector<Interval>;

// The steps of a proof, in order; each returns whether it succeeds.
class Removal_proof
{
public:
  Removal_proof(const Fan& fan, const Fan_triangulation& triangulation)
    : fan_(fan), triangulation_(triangulation), points_(fan.size(), {Interval(0), Interval(0)}), changes_(fan.changes)
  {}

  // The triangles are triangles, and lie in the plane side by side.
  bool lay_out()
  {
    const Fan_array<Ear>& ears = triangulation_.ears;
    const Ear& core = ears.back();
    points_[core.before] = {Interval(0), Interval(0)};
    points_[core.tip] = {Interval(core.before_tip), Interval(0)};
    if (!lay_out(core.before, core.tip, core.after, core.after_before, core.tip_after, core.before_tip))
      return false;
    for (std::size_t i = ears.size() - 1; i-- > 0;) {
      const Ear& ear = ears[i];
      if (!lay_out(ear.after, ear.before, ear.tip, ear.tip_after, ear.before_tip, ear.after_before))
        return false;
    }
    Bounded_point sum{Interval(0), Interval(0)};
    Interval weights(0);
    const std::uint32_t corners[] = {core.before, core.tip, core.after};
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval weight(triangulation_.place[i]);
      sum = sum + points_[corners[i]] * Bounded_point(weight, Interval(0));
      weights += weight;
    }
    if (!(weights.inf() > 0))
      return false;
    for (Bounded_point& p : points_)
      p = p - sum / weights;
    return true;
  }

  // The images of the faces surround the place once, or fill the half plane beside the line.
  bool is_one_to_one() const
  {
    for (std::size_t j = 0; j < fan_.link.size(); ++j)
      if (!(determinant(points_[j], points_[fan_.after(j)]).inf() > 0))
        return false;
    if (!fan_.is_closed) {
      const Bounded_point &begin = points_.back(), line = points_.front() - begin;
      for (std::size_t j = 1; j + 1 < points_.size(); ++j)
        if (!(determinant(line, points_[j] - begin).inf() > 0))
          return false;
      return true;
    }
    // How often they cross a ray whose direction is not that of any edge of a grid.
    int crossings = 0;
    const auto side = [this](std::size_t j) {
      const Interval y = points_[j].x() * Interval(0.8312475) + points_[j].y() * Interval(0.5558923);
      return y.inf() > 0 ? 1 : y.sup() < 0 ? -1 : 0;
    };
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const int here = side(j), next = side(fan_.after(j));
      if (here == 0)
        return false;
      crossings += here < 0 && next > 0;
    }
    return crossings == 1;
  }

  bool find_changes(double limit)
  {
    for (std::size_t j = 0; j < fan_.link.size(); ++j) {
      const std::size_t k = fan_.after(j);
      const Interval area = heron(fan_.spokes[j], fan_.spokes[k], fan_.link[j]);
      if (!(area.inf() > 0))
        return false;
      const Interval s = squared(fan_.spokes[j]), t = squared(fan_.spokes[k]), c = squared(fan_.link[j]);
      const auto [down, up] = squared_factors(s, t, c, area, image(j) - s, image(k) - t);
      if (!(down.inf() > 0))
        return false;
      changes_[j] = product(changes_[j], down, up);
      if (!is_within(changes_[j], limit))
        return false;
    }
    return true;
  }

  // Behind a triangle lies what lies behind the triangles that contain it: the two at its tip, as long as the place is
  // not behind it.
  void share(Fan_array<Squared_change>& result)
  {
    bool is_shared_by_all = false;
    result.clear();
    for (const Ear& ear : triangulation_.ears) {
      Squared_change& change = changes_[ear.before];
      change = either(change, changes_[ear.tip]);
      if (&ear != &triangulation_.ears.back()) {
        if (!(determinant(points_[ear.before], points_[ear.after]).inf() >= 0))
          is_shared_by_all = true;
      } else if (fan_.is_closed) {
        change = either(change, changes_[ear.after]);
      }
      result.push_back(change);
    }
    if (!is_shared_by_all)
      return;
    for (const Squared_change& change : result)
      result.front() = either(result.front(), change);
    for (std::size_t j = 0; j < fan_.link.size(); ++j)
      result.front() = either(result.front(), changes_[j]);
    std::fill(result.begin(), result.end(), Squared_change(result.front()));
  }

private:
  Interval image(std::size_t j) const { return CGAL::square(points_[j].x()) + CGAL::square(points_[j].y()); }

  // The third corner of a triangle to the left of its side from p to q.
  bool lay_out(std::size_t p, std::size_t q, std::size_t third, double from_p, double from_q, double side)
  {
    const Interval area = heron(side, from_p, from_q);
    if (!(area.inf() > 0))
      return false;
    points_[third] = third_corner(points_[p], points_[q], side, from_p, from_q, CGAL::sqrt(area));
    return true;
  }

  const Fan& fan_;
  const Fan_triangulation& triangulation_;
  Fan_array<Bounded_point> points_;
  Fan_array<Squared_change> changes_; // of the fan's faces, and of what is left of them when ears are cut off
};

} // namespace

bool prove_removal(const Fan& fan, const Fan_triangulation& triangulation, double limit,
                   Fan_array<Squared_change>& changes)
{
  const Protector protector;
  Removal_proof proof(fan, triangulation);
  if (!proof.lay_out() || !proof.is_one_to_one() || !proof.find_changes(limit))
    return false;
  proof.share(changes);
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
