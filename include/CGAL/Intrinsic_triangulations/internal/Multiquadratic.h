// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers of a multiquadratic field Q(√b_1, …, √b_m) in canonical form.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MULTIQUADRATIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MULTIQUADRATIC_H

#include <CGAL/Intrinsic_triangulations/internal/Rational.h>

#include <bitset>
#include <cstddef>
#include <exception>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Is thrown where a canonical form would become too large, or where the primes below do
// not suffice to prove an independence.
class Too_many_roots : public std::exception
{
public:
  const char* what() const noexcept override { return "too many independent square roots"; }
};

// A set of roots.
using Root_mask = std::bitset<192>;

// Positive integers b_1, …, b_m such that no product of a non-empty subset is a square;
// then the 2^m products of their roots are linearly independent over Q (Besicovitch).
//
// Independence is proven by quadratic characters: were a product of some b and a new
// integer N a square, then for each prime that divides none of them the Legendre symbols
// would multiply to 1. So N is independent if the vectors of symbols are independent over
// the field of two elements; if they are not, they leave a single candidate subset, and
// whether its product with N is a square is seen by trying.
class Square_root_basis
{
public:
  // √q = coefficient · Π √b over the bits of mask.
  struct Root
  {
    Root_mask mask;
    Rational coefficient;
  };

  // \param maximum_size the number of roots from which on Too_many_roots is thrown
  explicit Square_root_basis(std::size_t maximum_size = Root_mask().size())
    : maximum_size_(maximum_size)
  {}

  Root root(const Rational& q)
  {
    const Integer denominator = boost::multiprecision::denominator(q);
    const Integer n = boost::multiprecision::numerator(q) * denominator;
    if (n == 0)
      return {Root_mask(), Rational(0)};
    // Most are rational multiples of one root that is known. Squares are found fast.
    if (mpz_perfect_square_p(data(n)))
      return {Root_mask(), Rational(boost::multiprecision::sqrt(n), denominator)};
    for (std::size_t i = 0; i < generators_.size(); ++i) {
      const Integer with_generator = n * generators_[i];
      if (mpz_perfect_square_p(data(with_generator)))
        return {Root_mask().set(i), Rational(boost::multiprecision::sqrt(with_generator),
                                             Integer(generators_[i] * denominator))};
    }
    Integer product = n, product_of_generators = 1;
    Characters vector = characters(n);
    Root_mask mask;
    for (const Row& row : rows_)
      if (vector[row.pivot]) {
        vector ^= row.vector;
        mask ^= row.mask;
      }
    for (std::size_t i = 0; i < generators_.size(); ++i)
      if (mask[i]) {
        product *= generators_[i];
        product_of_generators *= generators_[i];
      }
    if (vector.none()) {
      Integer r, rest;
      r = boost::multiprecision::sqrt(product, rest);
      if (rest != 0)
        throw Too_many_roots(); // the primes see a dependence that is none
      return {mask, Rational(r, Integer(product_of_generators * denominator))};
    }
    if (generators_.size() == maximum_size_)
      throw Too_many_roots();
    const Root_mask own = Root_mask().set(generators_.size());
    generators_.push_back(n);
    std::size_t pivot = 0;
    while (!vector[pivot])
      ++pivot;
    for (Row& row : rows_)
      if (row.vector[pivot]) {
        row.vector ^= vector;
        row.mask ^= mask | own;
      }
    rows_.push_back({vector, mask | own, pivot});
    return {own, Rational(Integer(1), denominator)};
  }

  std::size_t size() const { return generators_.size(); }
  const Integer& generator(std::size_t i) const { return generators_[i]; }

private:
  // More than roots, so that those which are independent have independent symbols.
  static constexpr std::size_t number_of_primes = Root_mask().size() + 64;
  using Characters = std::bitset<number_of_primes>;

  // A reduced vector of symbols and the generators that it combines.
  struct Row
  {
    Characters vector;
    Root_mask mask;
    std::size_t pivot;
  };

  // The primes below 2^31 from the top.
  static const std::vector<unsigned long>& primes()
  {
    static const std::vector<unsigned long> list = [] {
      std::vector<unsigned long> result;
      for (unsigned long p = 2147483647ul; result.size() < number_of_primes; p -= 2) {
        const Integer n = p;
        if (mpz_probab_prime_p(data(n), 30) > 0)
          result.push_back(p);
      }
      return result;
    }();
    return list;
  }

  Characters characters(const Integer& n)
  {
    Characters result;
    for (std::size_t i = 0; i < number_of_primes; ++i) {
      const int symbol = mpz_kronecker_ui(data(n), primes()[i]);
      result[i] = symbol < 0;
      if (symbol == 0 && !left_out_[i])
        leave_out(i);
    }
    return result & ~left_out_;
  }

  // A prime that divides one of the integers says nothing of products with it: from then on it is
  // not used for any.
  void leave_out(std::size_t prime)
  {
    left_out_.set(prime);
    for (Row& row : rows_)
      row.vector.reset(prime);
    for (Row& row : rows_) {
      if (row.pivot != prime)
        continue;
      if (row.vector.none())
        throw Too_many_roots();
      row.pivot = 0;
      while (!row.vector[row.pivot])
        ++row.pivot;
      for (Row& other : rows_)
        if (&other != &row && other.vector[row.pivot]) {
          other.vector ^= row.vector;
          other.mask ^= row.mask;
        }
    }
  }

  std::size_t maximum_size_;
  std::vector<Integer> generators_;
  std::vector<Row> rows_;
  Characters left_out_; // the primes that divide a generator or were found to divide another integer
};

// A sum of rational multiples of products of roots, each product once, none with
// coefficient zero: the number is zero exactly if there is no term.
class Multiquadratic
{
public:
  explicit Multiquadratic(const Square_root_basis* basis = nullptr) : basis_(basis) {}
  Multiquadratic(const Square_root_basis* basis, const Root_mask& mask, const Rational& coefficient)
    : basis_(basis)
  {
    if (coefficient != 0)
      terms_.emplace(mask, coefficient);
  }

  bool is_zero() const { return terms_.empty(); }

  friend Multiquadratic operator-(const Multiquadratic& a)
  {
    Multiquadratic r(a);
    for (auto& term : r.terms_)
      term.second = -term.second;
    return r;
  }
  friend Multiquadratic operator+(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r(a);
    for (const auto& term : b.terms_)
      r.add(term.first, term.second);
    return r;
  }
  friend Multiquadratic operator-(const Multiquadratic& a, const Multiquadratic& b)
  {
    return a + -b;
  }
  friend Multiquadratic operator*(const Multiquadratic& a, const Multiquadratic& b)
  {
    if (a.terms_.size() * b.terms_.size() > maximum_number_of_products)
      throw Too_many_roots();
    Multiquadratic r(a.basis_ ? a.basis_ : b.basis_);
    for (const auto& x : a.terms_)
      for (const auto& y : b.terms_) {
        Rational coefficient = x.second * y.second;
        const Root_mask common = x.first & y.first;
        for (std::size_t i = 0; i < r.basis_->size() && common.any(); ++i)
          if (common[i])
            coefficient *= r.basis_->generator(i);
        r.add(x.first ^ y.first, coefficient);
      }
    return r;
  }
  // The divisor is rational: unfolding divides by input quantities alone.
  friend Multiquadratic operator/(const Multiquadratic& a, const Multiquadratic& b)
  {
    Multiquadratic r(a);
    for (auto& term : r.terms_)
      term.second /= b.terms_.begin()->second;
    return r;
  }

private:
  static constexpr std::size_t maximum_number_of_products = 1 << 22;

  void add(const Root_mask& mask, const Rational& coefficient)
  {
    const auto position = terms_.emplace(mask, Rational(0)).first;
    position->second += coefficient;
    if (position->second == 0)
      terms_.erase(position);
  }

  const Square_root_basis* basis_;
  std::unordered_map<Root_mask, Rational> terms_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MULTIQUADRATIC_H
