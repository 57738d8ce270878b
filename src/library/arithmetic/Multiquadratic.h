// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Numbers of a multiquadratic field Q(√b_1, …, √b_m) in canonical form.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "Square_root_basis.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations::internal {

// The field of all requested roots, and the remaining budget of work in it. The number of terms can double with each
// root; once the budget is spent, Too_costly is thrown.
class Multiquadratic_field
{
public:
  // A set of roots.
  using Mask = std::uint64_t;

  static constexpr std::size_t most_roots = 64;

  // \param work a bound on the number of terms that are computed; a large one counts more than once
  // \param number_of_roots the maximum number of roots, up to `most_roots`; with none, the field consists of the
  //   rationals, and irrational roots throw Too_costly
  Multiquadratic_field(const Interruption& interruption, std::size_t work, std::size_t number_of_roots = most_roots)
    : basis_(interruption, number_of_roots), interruption_(interruption), work_(work)
  {}

  Square_root_basis& basis() { return basis_; }

  void take(std::size_t work)
  {
    interruption_.check();
    if (work > work_)
      throw Too_costly();
    work_ -= work;
  }

private:
  Square_root_basis basis_;
  const Interruption& interruption_;
  std::size_t work_;
};

// A rational number plus a sum of rational multiples of products of roots, where each product occurs once and no
// coefficient is zero. So the number is zero exactly if the rational part is zero and there are no terms.
class Multiquadratic
{
  using Mask = Multiquadratic_field::Mask;

public:
  explicit Multiquadratic(Multiquadratic_field* field = nullptr) : field_(field) {}
  Multiquadratic(Multiquadratic_field* field, Mask mask, const Rational& coefficient) : field_(field)
  {
    add(mask, coefficient);
  }

  bool is_zero() const { return rational_ == 0 && terms_.empty(); }

  // \pre there are no roots in it
  const Rational& rational() const
  {
    CGAL_precondition(terms_.empty());
    return rational_;
  }

  friend Multiquadratic operator-(const Multiquadratic& a)
  {
    Multiquadratic r = a.copy();
    r.rational_ = -r.rational_;
    for (auto& term : r.terms_)
      term.second = -term.second;
    return r;
  }
  friend Multiquadratic operator+(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r = a.copy();
    if (b.field_)
      b.field_->take(b.terms_.size());
    b.for_each_term([&](Mask mask, const Rational& coefficient) { r.add(mask, coefficient); });
    return r;
  }
  friend Multiquadratic operator-(const Multiquadratic& a, const Multiquadratic& b) { return a + -b; }
  friend Multiquadratic operator*(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r(a.field_ ? a.field_ : b.field_);
    a.for_each_term([&](Mask of_x, const Rational& x) {
      b.for_each_term([&](Mask of_y, const Rational& y) {
        Rational coefficient = x * y;
        Mask common = of_x & of_y;
        for (std::size_t i = 0; common != 0; ++i, common >>= 1)
          if (common & 1)
            coefficient *= r.field_->basis().generator(i);
        // Cancelling common factors takes time proportional to the square of its size.
        const std::size_t size = mpz_size(mpq_numref(data(coefficient))) + mpz_size(mpq_denref(data(coefficient)));
        r.field_->take(1 + size * size / 256);
        r.add(of_x ^ of_y, coefficient);
      });
    });
    return r;
  }
  // The divisor is rational: unfolding divides only by input quantities.
  friend Multiquadratic operator/(const Multiquadratic& a, const Multiquadratic& b)
  {
    CGAL_precondition(b.rational() != 0);
    Multiquadratic r = a.copy();
    r.rational_ /= b.rational();
    for (auto& term : r.terms_)
      term.second /= b.rational();
    return r;
  }

private:
  // Some tens of megabytes.
  static constexpr std::size_t most_terms = std::size_t(1) << 16;

  Multiquadratic copy() const
  {
    if (field_)
      field_->take(terms_.size());
    return *this;
  }

  template <class Visit>
  void for_each_term(const Visit& visit) const
  {
    if (rational_ != 0)
      visit(0, rational_);
    for (const auto& [mask, coefficient] : terms_)
      visit(mask, coefficient);
  }

  void add(Mask mask, const Rational& coefficient)
  {
    if (mask == 0) {
      rational_ += coefficient;
      return;
    }
    const auto position = terms_.emplace(mask, Rational(0)).first;
    position->second += coefficient;
    if (position->second == 0)
      terms_.erase(position);
    else if (terms_.size() > most_terms)
      throw Too_costly();
  }

  Multiquadratic_field* field_;
  Rational rational_;
  std::unordered_map<Mask, Rational> terms_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H
