// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Fields with p² elements keep the laws of a field, agree with integers modulo p, and have square roots.

#include "library/arithmetic/Residues.h"
#include "library/arithmetic/Prime_field.h"
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::data;
using IT::internal::Gaussian_residue;
using IT::internal::Integer;
using IT::internal::Prime_field;
using IT::internal::Random_bits;

// Recovers x from its stored form, by a product with the number 1.
Integer integer(const Prime_field& f, Prime_field::Number a) { return Integer(f.product(a, 1)); }

Integer modulo(const Prime_field& f, const Integer& x)
{
  const Integer p(f.prime());
  return ((x % p) + p) % p;
}

bool are_equal(Gaussian_residue a, Gaussian_residue b) { return a.x == b.x && a.y == b.y; }

Prime_field::Number image(const Prime_field& f, const Integer& x) { return f.from_integer(IT::internal::data(x)); }

// Numbers at the ends of the range among random ones.
std::vector<Prime_field::Number> numbers(const Prime_field& f, Random_bits& random)
{
  std::vector<Prime_field::Number> result{
    0, 1, 2, f.one(), f.negative(f.one()), f.prime() - 1, f.prime() - 2, f.prime() / 2, f.prime() / 2 + 1};
  for (int i = 0; i < 8; ++i)
    result.push_back(random() % f.prime());
  return result;
}

std::vector<Gaussian_residue> elements(const Prime_field& f, Random_bits& random)
{
  std::vector<Gaussian_residue> result;
  const auto parts = numbers(f, random);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.push_back({parts[i], 0});
    result.push_back({0, parts[i]});
    result.push_back({parts[i], parts[(i + 3) % parts.size()]});
  }
  return result;
}

TEST(Upper_product, is_the_quotient_of_exact_integers)
{
  Random_bits random(1);
  std::vector<std::uint64_t> numbers = {
    0, 1, 2, 0xffffffffu, 0x100000000u, 0x100000001u, ~std::uint64_t(0), ~std::uint64_t(0) - 1};
  for (int i = 0; i < 200; ++i)
    numbers.push_back(random() >> i % 64);
  for (std::uint64_t a : numbers)
    for (std::uint64_t b : numbers) {
      const auto expected = static_cast<std::uint64_t>(Integer(Integer(a) * b >> 64));
      EXPECT_EQ(IT::internal::upper_product(a, b), expected) << a << ' ' << b;
      EXPECT_EQ(IT::internal::upper_product_by_halves(a, b), expected) << a << ' ' << b;
    }
}

TEST(Prime_field, primes_are_random_and_have_the_size_and_residue_that_are_promised)
{
  Random_bits random(1);
  std::set<std::uint64_t> primes;
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t p = Prime_field(random).prime();
    EXPECT_EQ(p % 4, 3u);
    EXPECT_GT(p, std::uint64_t(1) << 61);
    EXPECT_LT(p, std::uint64_t(1) << 62);
    EXPECT_GT(mpz_probab_prime_p(data(Integer(p)), 40), 0);
    primes.insert(p);
  }
  EXPECT_EQ(primes.size(), 200u);
}

TEST(Prime_field, the_primes_are_those_that_GMP_takes_for_primes)
{
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    Random_bits ours(seed), others(seed);
    const Prime_field f(ours);
    std::uint64_t p;
    do
      p = (others() >> 2) | (std::uint64_t(1) << 61) | 3;
    while (mpz_probab_prime_p(data(Integer(p)), 25) == 0);
    EXPECT_EQ(f.prime(), p) << seed;
  }
}

TEST(Prime_field, products_that_are_not_reduced_stay_below_twice_the_prime)
{
  Random_bits random(19);
  for (int i = 0; i < 20; ++i) {
    const Prime_field f(random);
    const std::uint64_t p = f.prime();
    std::vector<Prime_field::Number> factors{2 * p - 1, 2 * p - 2, p, p + 1};
    for (Prime_field::Number x : numbers(f, random))
      factors.insert(factors.end(), {x, x + p});
    for (Prime_field::Number a : factors)
      for (Prime_field::Number b : factors) {
        const Prime_field::Number product = f.unreduced_product(a, b);
        EXPECT_LT(product, 2 * p);
        EXPECT_EQ(product % p, f.product(a % p, b % p)) << a << ' ' << b;
        EXPECT_LT(f.product(a, b), p);
      }
  }
}

TEST(Prime_field, the_same_seed_gives_the_same_fields)
{
  Random_bits first(7), again(7), other(8);
  for (int i = 0; i < 5; ++i) {
    const std::uint64_t p = Prime_field(first).prime();
    EXPECT_EQ(p, Prime_field(again).prime());
    EXPECT_NE(p, Prime_field(other).prime());
  }
}

TEST(Prime_field, agrees_with_integers)
{
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random_bits random(seed);
    const Prime_field f(random);
    EXPECT_EQ(integer(f, f.one()), 1);
    for (const auto a : numbers(f, random)) {
      EXPECT_EQ(integer(f, f.negative(a)), modulo(f, -integer(f, a)));
      EXPECT_LT(f.negative(a), f.prime());
      if (a != 0) {
        EXPECT_EQ(f.product(a, f.power(a, f.exponent_of_inverse())), f.one());
      }
      for (const auto b : numbers(f, random)) {
        const Integer x = integer(f, a), y = integer(f, b);
        EXPECT_EQ(integer(f, f.sum(a, b)), modulo(f, x + y));
        EXPECT_EQ(integer(f, f.difference(a, b)), modulo(f, x - y));
        EXPECT_EQ(integer(f, f.product(a, b)), modulo(f, x * y));
        // Numbers are compared in their stored form.
        for (const auto c : {f.sum(a, b), f.difference(a, b), f.product(a, b)})
          EXPECT_LT(c, f.prime());
      }
    }
    const Integer p(f.prime());
    for (const Integer& x : {Integer(0), Integer(1), Integer(-1), p, Integer(-p), Integer(p - 1),
                             Integer(p * p * p + 5), Integer(-p * p - 7), Integer(Integer(1) << 5000)})
      EXPECT_EQ(integer(f, image(f, x)), modulo(f, x)) << x;
    EXPECT_EQ(f.power(image(f, 3), 0), f.one());
    EXPECT_EQ(f.power(image(f, 3), 100), image(f, boost::multiprecision::pow(Integer(3), 100)));
    EXPECT_EQ(f.power(image(f, 3), f.prime() - 1), f.one());
  }
}

// A double is an integer times a power of two.
TEST(Prime_field, a_double_goes_where_its_numerator_over_its_denominator_goes)
{
  Random_bits random(3);
  const Prime_field f(random);
  std::vector<double> doubles{
    0., -0., 1., -1., 0.1, 3., 0x1p62, 0x1p-1022, 0x1p-1074, -3 * 0x1p-1074, 0x1.fffffffffffffp1023};
  for (int i = 0; i < 200; ++i)
    doubles.push_back(std::ldexp(double(std::int64_t(random())), int(random() % 1900) - 1000));
  for (double x : doubles) {
    const IT::internal::Rational q(x);
    const auto denominator = image(f, boost::multiprecision::denominator(q));
    EXPECT_EQ(f.product(f.from_double(x), denominator), image(f, boost::multiprecision::numerator(q))) << x;
  }
}

TEST(Prime_field, the_extension_is_a_field)
{
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Random_bits random(seed);
    const Prime_field f(random);
    const Gaussian_residue zero, one{f.one(), 0}, w{0, f.one()};
    EXPECT_TRUE(are_equal(product(f, w, w), difference(f, zero, one)));
    const std::vector<Gaussian_residue> all = elements(f, random);
    for (const auto a : all) {
      EXPECT_TRUE(are_equal(sum(f, a, zero), a));
      EXPECT_TRUE(are_equal(product(f, a, one), a));
      EXPECT_TRUE(difference(f, a, a).is_zero());
      const auto inverses = IT::internal::inverses({f, f, f, f}, {zero, one, w, a});
      EXPECT_TRUE(inverses[0].is_zero());
      EXPECT_TRUE(are_equal(inverses[1], one));
      EXPECT_TRUE(are_equal(inverses[2], difference(f, zero, w)));
      if (!a.is_zero()) {
        EXPECT_TRUE(are_equal(product(f, a, inverses[3]), one));
      }
      for (const auto b : all) {
        EXPECT_TRUE(are_equal(sum(f, a, b), sum(f, b, a)));
        EXPECT_TRUE(are_equal(product(f, a, b), product(f, b, a)));
        EXPECT_EQ(product(f, a, b).is_zero(), a.is_zero() || b.is_zero());
        EXPECT_TRUE(are_equal(sum(f, difference(f, a, b), b), a));
        for (const auto c : all) {
          EXPECT_TRUE(are_equal(sum(f, sum(f, a, b), c), sum(f, a, sum(f, b, c))));
          EXPECT_TRUE(are_equal(product(f, product(f, a, b), c), product(f, a, product(f, b, c))));
          EXPECT_TRUE(are_equal(product(f, a, sum(f, b, c)), sum(f, product(f, a, b), product(f, a, c))));
        }
      }
    }
  }
}

TEST(Prime_field, each_integer_has_a_square_root)
{
  int in_the_prime_field = 0, beside_it = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random_bits random(seed);
    const Prime_field f(random);
    for (int i = -100; i <= 100; ++i) {
      const Prime_field::Number q = image(f, i);
      const Gaussian_residue r = square_root(f, q);
      EXPECT_TRUE(are_equal(product(f, r, r), {q, 0})) << i;
      const bool is_square = mpz_kronecker(data(Integer(i)), data(Integer(f.prime()))) >= 0;
      EXPECT_EQ(r.y == 0, is_square) << i;
      ++(is_square ? in_the_prime_field : beside_it);
    }
  }
  EXPECT_GT(in_the_prime_field, 500);
  EXPECT_GT(beside_it, 500);
}

} // namespace
