// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Ptolemy_length.h.

#include <CGAL/Intrinsic_triangulations/internal/measures/Ptolemy_length.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "../arithmetic/Mpfr_interval.h"
#include "../arithmetic/Prime_field.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr std::size_t number_of_primes = 3; // each with more than 61 bits
using Prime_residues = std::array<Prime_field::Number, number_of_primes>;

} // namespace

// The lengths before a flip, and what was needed of the exact length after it. Flips depend on each other in chains of any
// length, so nothing here is recursive.
struct Ptolemy_flip
{
  explicit Ptolemy_flip(const Ptolemy_hinge& h) : ij(h.ij), around{h.jk, h.ki, h.il, h.lj} {}
  ~Ptolemy_flip()
  {
    std::vector<std::shared_ptr<Ptolemy_flip>> released;
    release(released);
    while (!released.empty()) {
      const std::shared_ptr<Ptolemy_flip> flip = std::move(released.back());
      released.pop_back();
      if (flip.use_count() == 1)
        flip->release(released);
    }
  }

  template <class Visit>
  void for_each(const Visit& visit)
  {
    visit(ij);
    for (Ptolemy_length& length : around)
      visit(length);
  }
  void release(std::vector<std::shared_ptr<Ptolemy_flip>>& released)
  {
    for_each([&](Ptolemy_length& length) {
      if (length.flip)
        released.push_back(std::move(length.flip));
    });
  }

  Ptolemy_length ij;
  std::array<Ptolemy_length, 4> around; // jk, ki, il, lj
  // Guarded by the mutex:
  Mpfr_interval interval;
  Prime_residues residues{};
  bool has_residues = false;
};

namespace {

// Threads may decide about copies of a triangulation at once.
std::mutex& mutex()
{
  static std::mutex result;
  return result;
}

// Intervals of a given precision.
struct Intervals
{
  long precision;

  bool is_known(const Ptolemy_flip& flip) const { return flip.interval.precision() >= precision; }
  Mpfr_interval known(const Ptolemy_length& l) const
  {
    return l.flip ? l.flip->interval : Mpfr_interval(data(Rational(l.value)), (std::max)(precision, 53l));
  }
  void set(Ptolemy_flip& flip) const
  {
    const auto& [jk, ki, il, lj] = flip.around;
    flip.interval = (known(jk) * known(il) + known(ki) * known(lj)) / known(flip.ij);
  }
};

// Numbers modulo primes, for proofs that a number is zero: the same primes in each run.
struct Fields
{
  std::array<Prime_field, number_of_primes> fields;

  Fields()
  {
    Random_bits random(20260101);
    for (Prime_field& field : fields)
      field = Prime_field(random);
  }
  bool is_known(const Ptolemy_flip& flip) const { return flip.has_residues; }
  Prime_residues known(const Ptolemy_length& l) const
  {
    if (l.flip)
      return l.flip->residues;
    return for_each([&](const Prime_field& field, std::size_t) { return field.from_double(l.value); });
  }
  void set(Ptolemy_flip& flip) const
  {
    const Prime_residues ij = known(flip.ij), jk = known(flip.around[0]), ki = known(flip.around[1]),
                         il = known(flip.around[2]), lj = known(flip.around[3]);
    flip.residues = for_each([&](const Prime_field& f, std::size_t i) {
      return f.product(f.sum(f.product(jk[i], il[i]), f.product(ki[i], lj[i])),
                       f.power(ij[i], f.exponent_of_inverse()));
    });
    flip.has_residues = true;
  }
  template <class Operation>
  Prime_residues for_each(const Operation& operation) const
  {
    Prime_residues result;
    for (std::size_t i = 0; i < number_of_primes; ++i)
      result[i] = operation(fields[i], i);
    return result;
  }
};

// The value of a length, after those that it depends on. \pre the mutex is locked
template <class Numbers>
auto value_of(const Numbers& numbers, const Ptolemy_length& length)
{
  std::vector<Ptolemy_flip*> open;
  const auto add = [&](const Ptolemy_length& l) {
    if (l.flip && !numbers.is_known(*l.flip))
      open.push_back(l.flip.get());
  };
  add(length);
  while (!open.empty()) {
    Ptolemy_flip& flip = *open.back();
    const std::size_t n = open.size();
    flip.for_each(add);
    if (open.size() > n)
      continue;
    open.pop_back();
    numbers.set(flip);
  }
  return numbers.known(length);
}

bool is_tie(const Ptolemy_hinge& h)
{
  static const Fields numbers;
  const Prime_residues ij = value_of(numbers, h.ij), jk = value_of(numbers, h.jk), ki = value_of(numbers, h.ki),
                       il = value_of(numbers, h.il), lj = value_of(numbers, h.lj);
  const Prime_residues left_and_right = numbers.for_each([&](const Prime_field& f, std::size_t i) {
    const auto two = [&](Prime_field::Number a, Prime_field::Number b, Prime_field::Number c, Prime_field::Number d) {
      return f.sum(f.product(a, b), f.product(c, d));
    };
    return f.difference(f.product(f.product(ij[i], ij[i]), two(jk[i], ki[i], il[i], lj[i])),
                        f.product(two(jk[i], il[i], ki[i], lj[i]), two(ki[i], il[i], jk[i], lj[i])));
  });
  return left_and_right == Prime_residues{};
}

constexpr double half_ulp = 0x1p-53;
constexpr double largest_error = 0x1p-30; // most tests are far from a tie
constexpr long first_precision = 128;     // bits

} // namespace

Ptolemy_length rounded_once(const Ptolemy_length& length)
{
  if (!length.flip || length.relative_error <= 2 * half_ulp)
    return length;
  const std::lock_guard<std::mutex> lock(mutex());
  for (long precision = first_precision;; precision = doubled(precision)) {
    const Mpfr_interval x = value_of(Intervals{precision}, length);
    const double low = x.lower_double(), high = x.upper_double(); // two neighbors, or one
    if (high - low <= 2 * half_ulp * low)
      return {low, 2 * half_ulp, length.flip};
  }
}

Ptolemy_length flipped_length(const Ptolemy_hinge& h)
{
  // Nothing cancels: relative errors add up, and the four operations add at most 3 units.
  Ptolemy_length kl;
  kl.value = (h.jk.value * h.il.value + h.ki.value * h.lj.value) / h.ij.value;
  kl.relative_error =
    1.01 * ((std::max)(h.jk.relative_error + h.il.relative_error, h.ki.relative_error + h.lj.relative_error) +
            h.ij.relative_error) +
    4 * half_ulp;
  kl.flip = std::make_shared<Ptolemy_flip>(h);
  return kl.relative_error < largest_error ? kl : rounded_once(kl);
}

Sign exact_sign_of_Ptolemy_test(const Ptolemy_hinge& h)
{
  const std::lock_guard<std::mutex> lock(mutex());
  for (long precision = first_precision;; precision = doubled(precision)) {
    const Intervals numbers{precision};
    const Mpfr_interval ij = value_of(numbers, h.ij), jk = value_of(numbers, h.jk), ki = value_of(numbers, h.ki),
                        il = value_of(numbers, h.il), lj = value_of(numbers, h.lj);
    const auto sign = (ij * ij * (jk * ki + il * lj) - (jk * il + ki * lj) * (ki * il + jk * lj)).sign();
    if (is_certain(sign))
      return get_certain(sign);
    if (precision == first_precision && is_tie(h))
      return ZERO;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
