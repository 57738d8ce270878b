// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finite fields with p² elements in which each rational number has a square root.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PRIME_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PRIME_FIELD_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <array>
#include <cmath>
#include <cstdint>

#if defined(_MSC_VER) && (defined(_M_X64) || defined(_M_ARM64))
#include <intrin.h>
#endif

namespace CGAL::Intrinsic_triangulations::internal {

// a b / 2^64, rounded down. For any compiler.
constexpr std::uint64_t upper_product_by_halves(std::uint64_t a, std::uint64_t b)
{
  const std::uint64_t half = 0xffffffffu;
  const std::uint64_t low = (a & half) * (b & half), middle = (a >> 32) * (b & half) + (low >> 32),
                      other_middle = (a & half) * (b >> 32) + (middle & half);
  return (a >> 32) * (b >> 32) + (middle >> 32) + (other_middle >> 32);
}

// The same, in one or two instructions if the compiler offers them.
inline std::uint64_t upper_product(std::uint64_t a, std::uint64_t b)
{
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  return std::uint64_t(Wide(a) * b >> 64);
#elif defined(_MSC_VER) && (defined(_M_X64) || defined(_M_ARM64))
  return __umulh(a, b);
#else
  return upper_product_by_halves(a, b);
#endif
}

// A pseudorandom sequence of 64-bit numbers (G. Steele, D. Lea, C. Flood 2014, "SplitMix").
class Random_bits
{
public:
  explicit Random_bits(std::uint64_t seed) : state_(seed) {}
  std::uint64_t operator()()
  {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

private:
  std::uint64_t state_;
};

// The integers modulo a prime p ≡ 3 (mod 4) between 2^61 and 2^62. Numbers are kept as x · 2^64
// modulo p, for which a product takes three multiplications and no division (P. Montgomery 1985).
class Prime_field
{
public:
  using Number = std::uint64_t;
  static constexpr int number_of_bits = 62; // of primes

  Prime_field() = default;
  // Takes a random prime.
  explicit Prime_field(Random_bits& random)
  {
    // Below 2^64 this is certain: since version 6.2, GMP begins with the test of Baillie, Pomerance, Selfridge and
    // Wagstaff, which no composite number on the list of J. Feitsma passes.
    static_assert(__GNU_MP_RELEASE >= 60200, "needs GMP 6.2 or later");
    std::uint64_t p;
    do
      p = (random() >> 2) | (std::uint64_t(1) << 61) | 3;
    while (mpz_probab_prime_p(data(Integer(p)), 30) == 0);
    set_modulus(p);
    const Number half = (one_ + (one_ % 2 == 0 ? 0 : p_)) / 2;
    Number small = one_, large = power(half, lowest_exponent);
    for (Number& power : small_powers_) {
      power = small;
      small = sum(small, small);
    }
    for (Number& power : large_powers_) {
      power = large;
      large = product(large, small);
    }
  }

  std::uint64_t prime() const { return p_; }
  Number one() const { return one_; }

  Number from_integer(mpz_srcptr n) const { return product(remainder(n), square_of_unit_); }

  Number from_double(double x) const
  {
    int exponent = 0;
    const auto mantissa = std::int64_t(std::ldexp(std::frexp(x, &exponent), 53));
    const auto place = std::uint64_t(exponent - 53 + lowest_exponent);
    const Number a = product(product(std::uint64_t(mantissa < 0 ? -mantissa : mantissa), square_of_unit_),
                             product(small_powers_[place % 64], large_powers_[place / 64]));
    return mantissa < 0 ? negative(a) : a;
  }

  Number sum(Number a, Number b) const
  {
    const Number c = a + b;
    return c >= p_ ? c - p_ : c;
  }
  Number difference(Number a, Number b) const { return a >= b ? a - b : a + p_ - b; }
  Number negative(Number a) const { return a == 0 ? 0 : p_ - a; }
  Number product(Number a, Number b) const
  {
    const Number u = unreduced_product(a, b);
    return u >= p_ ? u - p_ : u;
  }
  // The product, or p more, of numbers below 2 p: as 4 p < 2^64, (a b + m p) / 2^64 < 2 p. So in a chain of products
  // only the last one is reduced.
  Number unreduced_product(Number a, Number b) const
  {
#if defined(__SIZEOF_INT128__)
    __extension__ using Wide = unsigned __int128;
    const Wide t = Wide(a) * b;
    return Number((t + Wide(std::uint64_t(t) * minus_inverse_) * p_) >> 64);
#else
    // The lower halves of a b and m p sum to 2^64, or both are zero.
    const std::uint64_t lower = a * b;
    return upper_product(a, b) + upper_product(lower * minus_inverse_, p_) + (lower != 0);
#endif
  }
  Number power(Number a, std::uint64_t exponent) const
  {
    Number result = one_;
    for (; exponent != 0; exponent >>= 1, a = product(a, a))
      if (exponent & 1)
        result = product(result, a);
    return result;
  }
  // The power that is the inverse of every nonzero number.
  std::uint64_t exponent_of_inverse() const { return p_ - 2; }

private:
  void set_modulus(std::uint64_t p)
  {
    p_ = p;
    std::uint64_t inverse = p; // by Newton's method: right modulo 8, then modulo 64, ...
    for (int i = 0; i < 5; ++i)
      inverse *= 2 - p * inverse;
    minus_inverse_ = 0 - inverse;
    one_ = (0 - p) % p;
    Number x = one_; // 2^64, doubled 64 times
    for (int i = 0; i < 64; ++i)
      x = sum(x, x);
    square_of_unit_ = x;
  }

  // The nonnegative remainder of n divided by p.
  std::uint64_t remainder(mpz_srcptr n) const
  {
    if constexpr (sizeof(unsigned long) >= sizeof(std::uint64_t)) {
      return mpz_fdiv_ui(n, static_cast<unsigned long>(p_));
    } else { // as on Windows
      Integer r;
      mpz_fdiv_r(r.backend().data(), n, data(Integer(p_)));
      return static_cast<std::uint64_t>(r);
    }
  }

  std::uint64_t p_ = 0;
  std::uint64_t minus_inverse_ = 0; // of p modulo 2^64
  Number one_ = 0;
  Number square_of_unit_ = 0; // 2^128 modulo p
  // Powers of two of which doubles are multiples: 2^i, and 2^(64 i - lowest_exponent).
  static constexpr int lowest_exponent = 18 * 64;
  std::array<Number, 64> small_powers_{};
  std::array<Number, 34> large_powers_{};
};

// A number x + y w of the field with p² elements: w² = −1, since −1 is no square modulo p.
struct Gaussian_residue
{
  Prime_field::Number x = 0, y = 0;

  bool is_zero() const { return x == 0 && y == 0; }
};

inline Gaussian_residue sum(const Prime_field& f, Gaussian_residue a, Gaussian_residue b)
{
  return {f.sum(a.x, b.x), f.sum(a.y, b.y)};
}
inline Gaussian_residue difference(const Prime_field& f, Gaussian_residue a, Gaussian_residue b)
{
  return {f.difference(a.x, b.x), f.difference(a.y, b.y)};
}
inline Gaussian_residue product(const Prime_field& f, Gaussian_residue a, Gaussian_residue b)
{
  if ((a.y | b.y) == 0)
    return {f.product(a.x, b.x), 0};
  return {f.difference(f.product(a.x, b.x), f.product(a.y, b.y)), f.sum(f.product(a.x, b.y), f.product(a.y, b.x))};
}
inline Prime_field::Number squared_norm(const Prime_field& f, Gaussian_residue a)
{
  return f.sum(f.product(a.x, a.x), f.product(a.y, a.y));
}
// One of the two square roots of q: q or −q has one modulo p.
inline Gaussian_residue square_root(const Prime_field& f, Prime_field::Number q)
{
  const std::uint64_t exponent = (f.prime() + 1) / 4;
  const auto r = f.power(q, exponent);
  if (f.product(r, r) == q)
    return {r, 0};
  return {0, f.power(f.negative(q), exponent)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PRIME_FIELD_H
