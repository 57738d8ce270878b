// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A strip of triangles in the plane, and where the straight line through it crosses the edges
// between them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_STRIP_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_STRIP_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The line begins at 0, and the first triangle is there. Each edge that is crossed keeps one end
// of the edge before.
class Strip_layout
{
  using Number = Split_double_double<double>;
  using Complex = Split_complex;

public:
  // Starts with the ends of the first edge that is crossed.
  void start(const Complex& left, const Complex& right)
  {
    first_left_ = left_ = left;
    first_right_ = right_ = right;
    distance_ = (std::max)(modulus(left), modulus(right));
    turns_.clear();
  }

  // Adds an edge, by its end that is not one of the edge before.
  void add(const Complex& apex, bool keeps_left)
  {
    (keeps_left ? right_ : left_) = apex;
    turns_.push_back({apex, keeps_left});
    distance_ = (std::max)(distance_, modulus(apex));
  }

  // The ends of the last edge.
  const Complex& left() const { return left_; }
  const Complex& right() const { return right_; }
  std::size_t number_of_edges() const { return turns_.size() + 1; }
  // No end of an edge is further from 0.
  double distance() const { return distance_; }

  // Areas that the line makes with an edge.
  struct Crossing
  {
    Number left, right, along;

    // which part of the edge is to the left
    double from_left() const { return fraction(left); }
    double from_right() const { return fraction(right); }
    // where the edge is on the line
    double on_line() const { return fraction(along); }

  private:
    double fraction(const Number& part) const
    {
      const Number whole = left + right;
      return quotient(part, whole, 1 / whole.hi).hi;
    }
  };

  // Calls `visit(crossing)` for each edge. All fractions are good to 2^-52, if cross products of
  // points that are up to `distance()` and `modulus(target)` from 0 are good to `error`.
  // \return whether all are so good; what is visited before one is not may not be
  template <class Visit>
  bool finish(const Complex& target, double error, const Visit& visit)
  {
    // Quotients of cross products that are good to 2^-55 are good to 2^-54, before they are rounded.
    const double enough = 0x1p55 * error;
    left_ = first_left_;
    right_ = first_right_;
    Crossing crossing{cross_product(target, left_), cross_product(right_, target),
                      cross_product(right_, left_)};
    for (auto turn = turns_.begin();; ++turn) {
      if (!(crossing.left.hi >= enough && crossing.right.hi >= enough &&
            crossing.along.hi >= enough))
        return false;
      visit(crossing);
      if (turn == turns_.end())
        return true;
      (turn->keeps_left ? right_ : left_) = turn->apex;
      if (turn->keeps_left)
        crossing.right = cross_product(right_, target);
      else
        crossing.left = cross_product(target, left_);
      crossing.along = cross_product(right_, left_);
    }
  }

private:
  struct Turn
  {
    Complex apex;
    bool keeps_left;
  };

  Complex first_left_, first_right_, left_, right_;
  std::vector<Turn> turns_;
  double distance_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_STRIP_LAYOUT_H
