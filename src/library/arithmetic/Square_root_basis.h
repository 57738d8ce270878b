// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Square roots of rational numbers, reduced to independent ones.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SQUARE_ROOT_BASIS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SQUARE_ROOT_BASIS_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <boost/dynamic_bitset.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Thrown if exact numbers would exceed the agreed number or size.
class Too_costly : public std::exception
{
public:
  const char* what() const noexcept override { return "too many independent square roots"; }
};

// The largest primes below 2^31, in descending order.
inline std::vector<std::uint32_t> largest_primes(std::size_t number)
{
  static std::mutex mutex;
  static std::vector<std::uint32_t> known;
  const std::lock_guard<std::mutex> lock(mutex);
  for (std::uint32_t p = known.empty() ? 2147483647u : known.back() - 2; known.size() < number; p -= 2)
    if (mpz_probab_prime_p(data(Integer(p)), 30) > 0)
      known.push_back(p);
  return {known.begin(), known.begin() + std::ptrdiff_t(number)};
}

// Positive integers b_1, …, b_m such that no product of a non-empty subset is a square;
// then the 2^m products of their roots are linearly independent over Q (Besicovitch).
//
// Independence is proven by quadratic characters: were a product of some b and a new integer N a square, then for each
// prime that divides none of them the Legendre symbols would multiply to 1. So N is independent if the vectors of
// symbols are independent over the field of two elements; if they are not, they leave a single candidate subset, whose
// product with N is tested for being a square. There are always 64 more symbols than roots, so that independent numbers
// have independent symbols; if they do not, more are taken.
class Square_root_basis
{
public:
  // √q = coefficient · Π √b over these generators.
  struct Root
  {
    Rational coefficient;
    std::vector<std::uint32_t> generators;
  };

  static constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

  // \param maximum_size the number of generators at which Too_costly is thrown
  explicit Square_root_basis(const Interruption& interruption, std::size_t maximum_size = unlimited)
    : interruption_(interruption), maximum_size_(maximum_size)
  {}

  Root root(const Rational& q)
  {
    const Integer denominator = boost::multiprecision::denominator(q);
    const Integer n = boost::multiprecision::numerator(q) * denominator;
    if (n == 0)
      return {Rational(0), {}};
    // Most roots are rational multiples of a known one. Squares are found fast.
    if (mpz_perfect_square_p(data(n)))
      return {Rational(Integer(boost::multiprecision::sqrt(n)), denominator), {}};
    for (std::uint32_t i = 0; i < (std::min)(generators_.size(), few); ++i) {
      const Integer product = n * generators_[i];
      if (mpz_perfect_square_p(data(product)))
        return {Rational(Integer(boost::multiprecision::sqrt(product)), Integer(generators_[i] * denominator)), {i}};
    }
    if (maximum_size_ == 0)
      throw Too_costly();
    if (primes_.empty())
      rebuild(128);
    for (;;) {
      interruption_.check();
      Row row = reduced(n);
      if (row.vector.empty()) {
        rebuild(primes_.size());
        continue;
      }
      if (row.vector.any()) {
        if (generators_.size() == maximum_size_)
          throw Too_costly();
        const std::uint32_t number = std::uint32_t(generators_.size());
        generators_.push_back(n);
        if (generators_.size() + spare > number_of_symbols_)
          rebuild(2 * primes_.size());
        else
          insert(std::move(row), number);
        return {Rational(Integer(1), denominator), {number}};
      }
      Root result;
      Integer product = n, product_of_generators = 1;
      for (std::size_t i = row.mask.find_first(); i != row.mask.npos; i = row.mask.find_next(i)) {
        product *= generators_[i];
        product_of_generators *= generators_[i];
        result.generators.push_back(std::uint32_t(i));
      }
      Integer rest;
      const Integer r = boost::multiprecision::sqrt(product, rest);
      if (rest == 0) {
        result.coefficient = Rational(r, Integer(product_of_generators * denominator));
        return result;
      }
      rebuild(2 * primes_.size()); // the dependence is only an artefact of these primes
    }
  }

  std::size_t size() const { return generators_.size(); }
  const Integer& generator(std::size_t i) const { return generators_[i]; }

private:
  using Bits = boost::dynamic_bitset<std::uint64_t>;

  static constexpr std::size_t few = 4;
  static constexpr std::size_t spare = 64;

  // A reduced vector of symbols, and the generators that it combines.
  struct Row
  {
    Bits vector;
    Bits mask;
    std::size_t pivot;
  };

  // The symbols of n after reduction, and the generators that were combined. A prime that divides n says nothing about
  // products with n, so it is left out from then on. In that case the vector is empty, and the rows have to be built
  // anew.
  Row reduced(const Integer& n)
  {
    Row result{Bits(primes_.size()), Bits(generators_.size()), 0};
    bool is_valid = true;
    for (std::size_t i = 0; i < primes_.size(); ++i) {
      if (is_left_out_[i])
        continue;
      const int symbol = mpz_kronecker_ui(data(n), primes_[i]);
      if (symbol < 0)
        result.vector.set(i);
      if (symbol == 0) {
        is_left_out_.set(i);
        is_valid = false;
      }
    }
    if (!is_valid) {
      result.vector.clear();
      return result;
    }
    for (const Row& row : rows_)
      if (result.vector[row.pivot]) {
        result.vector ^= row.vector;
        result.mask ^= row.mask;
      }
    return result;
  }

  // Adds a nonzero row; each pivot is set in only one row.
  void insert(Row row, std::size_t number)
  {
    row.pivot = row.vector.find_first();
    row.mask.resize(generators_.size());
    row.mask.set(number);
    for (Row& other : rows_) {
      other.mask.resize(generators_.size());
      if (other.vector[row.pivot]) {
        other.vector ^= row.vector;
        other.mask ^= row.mask;
      }
    }
    rows_.push_back(std::move(row));
  }

  // Takes that many primes, or more if they do not tell the generators apart.
  void rebuild(std::size_t number_of_primes)
  {
    while (!can_build(number_of_primes))
      number_of_primes *= 2;
  }

  bool can_build(std::size_t number_of_primes)
  {
    primes_ = largest_primes(number_of_primes);
    is_left_out_.resize(number_of_primes);
    rows_.clear();
    for (std::size_t i = 0; i < generators_.size();) {
      interruption_.check();
      Row row = reduced(generators_[i]);
      if (row.vector.empty()) { // from the beginning, without the primes that divide this one
        rows_.clear();
        i = 0;
        continue;
      }
      if (row.vector.none())
        return false;
      insert(std::move(row), i++);
    }
    number_of_symbols_ = number_of_primes - is_left_out_.count();
    return generators_.size() + spare <= number_of_symbols_;
  }

  const Interruption& interruption_;
  std::size_t maximum_size_;
  std::vector<Integer> generators_;
  std::vector<std::uint32_t> primes_;
  Bits is_left_out_; // the primes that divide one of the integers
  std::size_t number_of_symbols_ = 0;
  std::vector<Row> rows_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SQUARE_ROOT_BASIS_H
