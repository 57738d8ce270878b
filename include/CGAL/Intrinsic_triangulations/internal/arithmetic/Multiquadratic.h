// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Numbers of a multiquadratic field Q(√b_1, …, √b_m) in canonical form.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Square_root_basis.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations::internal {

// The field of all roots that are asked for, and how much work may still be done in it. The number
// of terms can double with each root: Too_costly is thrown when the work is used up.
class Multiquadratic_field
{
public:
  // A set of roots.
  using Mask = std::uint64_t;

  // \param work a bound on the number of terms that are computed; a large one counts more than once
  Multiquadratic_field(const Interruption& interruption, std::size_t work)
    : basis_(interruption, 64), interruption_(interruption), work_(work)
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

// A sum of rational multiples of products of roots, each product once, none with
// coefficient zero: the number is zero exactly if there is no term.
class Multiquadratic
{
  using Mask = Multiquadratic_field::Mask;

public:
  explicit Multiquadratic(Multiquadratic_field* field = nullptr) : field_(field) {}
  Multiquadratic(Multiquadratic_field* field, Mask mask, const Rational& coefficient) : field_(field)
  {
    if (coefficient != 0)
      terms_.emplace(mask, coefficient);
  }

  bool is_zero() const { return terms_.empty(); }

  friend Multiquadratic operator-(const Multiquadratic& a)
  {
    Multiquadratic r = a.copy();
    for (auto& term : r.terms_)
      term.second = -term.second;
    return r;
  }
  friend Multiquadratic operator+(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r = a.copy();
    if (!b.is_zero())
      b.field_->take(b.terms_.size());
    for (const auto& term : b.terms_)
      r.add(term.first, term.second);
    return r;
  }
  friend Multiquadratic operator-(const Multiquadratic& a, const Multiquadratic& b) { return a + -b; }
  friend Multiquadratic operator*(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r(a.field_ ? a.field_ : b.field_);
    for (const auto& x : a.terms_)
      for (const auto& y : b.terms_) {
        Rational coefficient = x.second * y.second;
        Mask common = x.first & y.first;
        for (std::size_t i = 0; common != 0; ++i, common >>= 1)
          if (common & 1)
            coefficient *= r.field_->basis().generator(i);
        // To cancel its common factors takes time proportional to the square of its size.
        const std::size_t size = mpz_size(mpq_numref(data(coefficient))) + mpz_size(mpq_denref(data(coefficient)));
        r.field_->take(1 + size * size / 256);
        r.add(x.first ^ y.first, coefficient);
      }
    return r;
  }
  // The divisor is rational: unfolding divides by input quantities alone.
  friend Multiquadratic operator/(const Multiquadratic& a, const Multiquadratic& b)
  {
    CGAL_precondition(b.terms_.size() == 1 && b.terms_.begin()->first == 0);
    Multiquadratic r = a.copy();
    for (auto& term : r.terms_)
      term.second /= b.terms_.begin()->second;
    return r;
  }

private:
  // Some tens of megabytes.
  static constexpr std::size_t most_terms = std::size_t(1) << 16;

  Multiquadratic copy() const
  {
    if (!is_zero())
      field_->take(terms_.size());
    return *this;
  }

  void add(Mask mask, const Rational& coefficient)
  {
    const auto position = terms_.emplace(mask, Rational(0)).first;
    position->second += coefficient;
    if (position->second == 0)
      terms_.erase(position);
    else if (terms_.size() > most_terms)
      throw Too_costly();
  }

  Multiquadratic_field* field_;
  std::unordered_map<Mask, Rational> terms_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_MULTIQUADRATIC_H
