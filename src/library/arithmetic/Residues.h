// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The images of numbers in several finite fields at once: a number whose images are not zero is
// not zero.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RESIDUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RESIDUES_H

#include "Prime_field.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include "Square_root_basis.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Fields with random primes.
using Prime_fields = std::array<Prime_field, 4>;

inline Prime_fields random_prime_fields(std::uint64_t seed)
{
  Random_bits random(seed);
  Prime_fields fields;
  for (Prime_field& field : fields)
    field = Prime_field(random);
  return fields;
}

// The inverse in each field; the inverse of zero is zero. A power is a chain of products, each of which waits for the
// previous one, so the chains of all fields run side by side, three bits of the exponent at a time.
inline std::array<Gaussian_residue, std::tuple_size<Prime_fields>::value>
inverses(const Prime_fields& fields, const std::array<Gaussian_residue, std::tuple_size<Prime_fields>::value>& a)
{
  constexpr std::size_t n = std::tuple_size<Prime_fields>::value;
  constexpr int window = 3, number_of_windows = (Prime_field::number_of_bits + window - 1) / window;
  constexpr std::size_t size = std::size_t(1) << window;
  std::array<std::array<Prime_field::Number, n>, size> small; // powers of the norms x² + y²
  for (std::size_t i = 0; i < n; ++i) {
    small[0][i] = fields[i].one();
    small[1][i] = squared_norm(fields[i], a[i]);
  }
  for (std::size_t k = 2; k < size; ++k)
    for (std::size_t i = 0; i < n; ++i)
      small[k][i] = fields[i].unreduced_product(small[k - 1][i], small[1][i]);
  const auto factor = [&](std::size_t i, int w) {
    return small[(fields[i].exponent_of_inverse() >> (window * w)) % size][i];
  };
  std::array<Prime_field::Number, n> power;
  for (std::size_t i = 0; i < n; ++i)
    power[i] = factor(i, number_of_windows - 1);
  for (int w = number_of_windows - 1; w-- > 0;) {
    for (int bit = 0; bit < window; ++bit)
      for (std::size_t i = 0; i < n; ++i)
        power[i] = fields[i].unreduced_product(power[i], power[i]);
    for (std::size_t i = 0; i < n; ++i)
      power[i] = fields[i].unreduced_product(power[i], factor(i, w));
  }
  std::array<Gaussian_residue, n> result;
  for (std::size_t i = 0; i < n; ++i)
    result[i] = {fields[i].product(a[i].x, power[i]), fields[i].negative(fields[i].product(a[i].y, power[i]))};
  return result;
}

class Residue_rings;

// A number, represented by its images.
class Residues
{
public:
  explicit Residues(Residue_rings* rings = nullptr) : rings_(rings) {}

  bool is_zero() const
  {
    return std::all_of(images_.begin(), images_.end(), [](const Gaussian_residue& x) { return x.is_zero(); });
  }

  friend Residues operator+(const Residues& a, const Residues& b);
  friend Residues operator-(const Residues& a, const Residues& b);
  friend Residues operator-(const Residues& a);
  friend Residues operator*(const Residues& a, const Residues& b);
  friend Residues operator/(const Residues& a, const Residues& b);

private:
  friend class Residue_rings;

  template <class Operation>
  static Residues combined(const Residues& a, const Residues& b, const Operation& operation);

  Residue_rings* rings_;
  std::array<Gaussian_residue, std::tuple_size<Prime_fields>::value> images_;
};

// Homomorphisms from the numbers that arise from rationals and their square roots by additions, multiplications and
// divisions by numbers that the primes do not divide.
//
// The roots of the generators of a basis go to roots of their images, with signs at random, and all
// other roots are multiples of products of these. (If each root went to some root of its own image, √8 might go
// to −2 times the image of √2.)
//
// How likely it is that a number V ≠ 0 goes to zero: let d V be an algebraic integer, d a product of
// numbers that p does not divide, and let |σ(d V)| <= 2^h for each of the 2^m automorphisms σ that
// change signs of generators' roots. The norm Π σ(d V) is an integer, not zero, and divisible by p
// as often as there are σ with φ(σ(V)) = 0, since a prime that divides no generator does not ramify.
// So of all pairs of a prime above 2^61 and signs, a fraction of at most h / (61 · number of primes)
// is bad, whatever m is. There are more than 2^54 such primes ≡ 3 (mod 4) below 2^62.
class Residue_rings
{
public:
  // \param maximum_number_of_roots the number of independent roots at which Too_costly is thrown
  Residue_rings(const Prime_fields& fields, const Interruption& interruption,
                std::size_t maximum_number_of_roots = Square_root_basis::unlimited)
    : fields_(fields), basis_(interruption, maximum_number_of_roots)
  {
    last_divisor_ = inverse_ = map([](const Prime_field& f) { return Gaussian_residue{f.one(), 0}; });
  }
  Residue_rings(const Residue_rings&) = delete;
  Residue_rings& operator=(const Residue_rings&) = delete;

  // Whether no prime has divided a number that it must not divide; otherwise the images mean nothing.
  bool is_defined() const { return is_defined_; }

  Residues rational(const Rational& x)
  {
    const Residues n = from_integer(mpq_numref(data(x)));
    const mpz_srcptr denominator = mpq_denref(data(x));
    return mpz_cmp_ui(denominator, 1) == 0 ? n : n / from_integer(denominator);
  }

  Residues number(double x)
  {
    return map([x](const Prime_field& f) { return Gaussian_residue{f.from_double(x), 0}; });
  }

  Residues root(const Rational& x)
  {
    const Square_root_basis::Root root = basis_.root(x);
    Residues result = rational(root.coefficient);
    for (std::uint32_t i : root.generators)
      result = result * image_of_generator(i);
    return result;
  }

  // −log2 of a bound on the probability that a nonzero number V goes to zero in all fields, for a polynomial V in n
  // quantities: rational numbers x, roots √x, and the parts of vectors that are sums of three such numbers divided by
  // an x. Its degree in each quantity is at most 8.
  //
  // With 2^B above all numerators and denominators, where B is `largest_size`, each quantity and its conjugates are
  // below 3 · 2^(2 B) and have a denominator below 2^(2 B); V has at most 2^(24 (n + 1)) terms.
  // So h <= 8 n · 4 B + 24 (n + 1), where 8 is the degree, and 24 is generous.
  static double certainty(double n, double largest_size)
  {
    const double h = 32 * n * largest_size + 24 * (n + 1);
    return double(std::tuple_size<Prime_fields>::value) * (std::max)(0., 54 + 5.9 - std::log2(h));
  }

private:
  friend class Residues;
  friend Residues operator/(const Residues& a, const Residues& b);

  template <class ImageIn>
  Residues map(const ImageIn& image_in)
  {
    Residues result(this);
    for (std::size_t i = 0; i < fields_.size(); ++i)
      result.images_[i] = image_in(fields_[i]);
    return result;
  }

  Residues from_integer(mpz_srcptr n)
  {
    return map([&](const Prime_field& f) { return Gaussian_residue{f.from_integer(n), 0}; });
  }

  const Residues& image_of_generator(std::size_t i)
  {
    for (std::size_t j = images_of_generators_.size(); j <= i; ++j)
      images_of_generators_.push_back(map([&](const Prime_field& f) {
        const Prime_field::Number q = f.from_integer(data(basis_.generator(j)));
        is_defined_ = is_defined_ && q != 0;
        const Gaussian_residue r = square_root(f, q);
        // The sign is a pseudorandom function of the generator.
        return (Random_bits(q ^ f.prime())() & 1) ? difference(f, {}, r) : r;
      }));
    return images_of_generators_[i];
  }

  // Most divisions have the same divisor as the previous one.
  const Residues& inverse(const Residues& a)
  {
    const auto is_same = [](const Gaussian_residue& x, const Gaussian_residue& y) { return x.x == y.x && x.y == y.y; };
    if (!std::equal(a.images_.begin(), a.images_.end(), last_divisor_.images_.begin(), is_same)) {
      last_divisor_ = a;
      inverse_.images_ = inverses(fields_, a.images_);
      is_defined_ = is_defined_ && std::none_of(a.images_.begin(), a.images_.end(),
                                                [](const Gaussian_residue& x) { return x.is_zero(); });
    }
    return inverse_;
  }

  Prime_fields fields_;
  Square_root_basis basis_;
  std::vector<Residues> images_of_generators_;
  Residues last_divisor_, inverse_;
  bool is_defined_ = true;
};

template <class Operation>
Residues Residues::combined(const Residues& a, const Residues& b, const Operation& operation)
{
  Residues r(a.rings_);
  for (std::size_t i = 0; i < r.images_.size(); ++i)
    r.images_[i] = operation(a.rings_->fields_[i], a.images_[i], b.images_[i]);
  return r;
}
inline Residues operator+(const Residues& a, const Residues& b)
{
  return Residues::combined(a, b, [](const auto& f, auto x, auto y) { return sum(f, x, y); });
}
inline Residues operator-(const Residues& a, const Residues& b)
{
  return Residues::combined(a, b, [](const auto& f, auto x, auto y) { return difference(f, x, y); });
}
inline Residues operator-(const Residues& a) { return Residues(a.rings_) - a; }
inline Residues operator*(const Residues& a, const Residues& b)
{
  return Residues::combined(a, b, [](const auto& f, auto x, auto y) { return product(f, x, y); });
}
inline Residues operator/(const Residues& a, const Residues& b) { return a * a.rings_->inverse(b); }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_RESIDUES_H
