// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Images in finite fields: the images of zero are zero, even if roots depend on each other, and those of other numbers
// are not.

#include "library/arithmetic/Residues.h"
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Integer;
using IT::internal::Interruption;
using IT::internal::Prime_fields;
using IT::internal::random_prime_fields;
using IT::internal::Rational;
using IT::internal::Residue_rings;
using IT::internal::Residues;

// The number of seeds for which a number goes to zero.
int number_of_zeros(const std::function<Residues(Residue_rings&)>& number, int seeds = 100)
{
  Interruption none;
  int result = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    Residue_rings rings(random_prime_fields(std::uint64_t(seed)), none);
    result += number(rings).is_zero();
    EXPECT_TRUE(rings.is_defined());
  }
  return result;
}

TEST(Residues, map_rationals)
{
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) {
              return r.rational(Rational(2, 3)) + r.rational(Rational(5, 7)) - r.rational(Rational(29, 21));
            }),
            100);
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) {
              return r.rational(Rational(-22, 7)) / r.rational(Rational(11, 3)) + r.rational(Rational(6, 7));
            }),
            100);
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return -r.rational(3) * r.rational(4) + r.rational(11); }), 0);
}

// The smallest number that is not zero, and one that is divisible by three of the four primes.
TEST(Residues, do_not_take_small_numbers_for_zero)
{
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return r.rational(Rational(Integer(1), Integer(1) << 100000)); }),
            0);
  Interruption none;
  for (std::size_t last = 0; last < 4; ++last) {
    const Prime_fields fields = random_prime_fields(last);
    Integer product = 1;
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (i != last)
        product *= fields[i].prime();
    Residue_rings rings(fields, none);
    EXPECT_FALSE(rings.rational(Rational(product)).is_zero());
    EXPECT_TRUE(rings.rational(Rational(product * fields[last].prime())).is_zero());
    EXPECT_TRUE(rings.is_defined());
    rings.rational(1) / rings.rational(Rational(product));
    EXPECT_FALSE(rings.is_defined());
  }
}

// If a prime divides a divisor or a generator, the images mean nothing.
TEST(Residues, tell_where_they_are_not_defined)
{
  Interruption none;
  const Prime_fields fields = random_prime_fields(1);
  const Integer p = fields[2].prime();
  {
    Residue_rings rings(fields, none);
    rings.rational(Rational(Integer(1), Integer(3 * p)));
    EXPECT_FALSE(rings.is_defined());
  }
  {
    Residue_rings rings(fields, none);
    rings.root(Rational(2 * p));
    EXPECT_FALSE(rings.is_defined());
  }
  {
    Residue_rings rings(fields, none);
    rings.root(2);
    rings.root(Rational(p * p * 2));
    rings.root(0);
    EXPECT_TRUE(rings.is_defined());
  }
}

TEST(Residues, roots_have_their_squares)
{
  for (const Rational& q : {Rational(2), Rational(9, 4), Rational(0), Rational(3, 7), Rational(1000003)})
    EXPECT_EQ(number_of_zeros([&](Residue_rings& r) { return r.root(q) * r.root(q) - r.rational(q); }), 100);
}

TEST(Residues, roots_of_multiples_by_squares_are_multiples)
{
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return r.root(18) - r.rational(3) * r.root(2); }), 100);
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return r.root(18) + r.rational(3) * r.root(2); }), 0);
  EXPECT_EQ(
    number_of_zeros([](Residue_rings& r) { return r.root(Rational(63, 25)) - r.rational(Rational(3, 5)) * r.root(7); }),
    100);
}

TEST(Residues, the_root_of_a_product_is_the_product_of_roots)
{
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return r.root(2) * r.root(3) - r.root(6); }), 100);
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) { return r.root(2) * r.root(3) + r.root(6); }), 0);
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) {
              const Residues sum = r.root(2) + r.root(3);
              return sum * sum - r.rational(5) - r.rational(2) * r.root(6);
            }),
            100);
  // Whichever of them is requested first.
  EXPECT_EQ(number_of_zeros([](Residue_rings& r) {
              const Residues six = r.root(6), three = r.root(3);
              return six / r.rational(3) * three - r.root(2);
            }),
            100);
}

// The product of all (1 + √b) is the sum of the roots of all products, in any order.
TEST(Residues, products_of_five_roots_expand)
{
  std::mt19937 random(3);
  for (const bool is_zero : {true, false})
    EXPECT_EQ(number_of_zeros([&](Residue_rings& r) {
                std::vector<int> factors{2, 3, 5, 77, 13};
                std::shuffle(factors.begin(), factors.end(), random);
                std::vector<int> products{1};
                for (const int b : factors)
                  for (std::size_t i = products.size(); i-- > 0;)
                    products.push_back(products[i] * b);
                std::shuffle(products.begin(), products.end(), random);
                Residues sum = r.rational(is_zero ? 0 : 1), product = r.rational(1);
                for (const int q : products)
                  sum = sum + r.root(q);
                for (const int b : factors)
                  product = product * (r.rational(1) + r.root(b));
                return product - sum;
              }),
              is_zero ? 100 : 0);
}

TEST(Residues, a_first_division_by_zero_leaves_nothing_defined)
{
  Interruption none;
  Residue_rings rings(random_prime_fields(0), none);
  EXPECT_TRUE(rings.is_defined());
  rings.rational(1) / rings.rational(0);
  EXPECT_FALSE(rings.is_defined());
}

// Signs are drawn for each root and each prime: none is always the same, and no two always go together.
TEST(Residues, the_signs_of_roots_are_random)
{
  Interruption none;
  int equal_images = 0;
  constexpr int roots = 6, seeds = 200;
  for (int seed = 0; seed < seeds; ++seed) {
    const Prime_fields fields = random_prime_fields(std::uint64_t(seed));
    Residue_rings rings(fields, none);
    for (int i = 0; i < roots; ++i) {
      const int q = std::vector<int>{2, 3, 5, 7, 11, 13}[std::size_t(i)];
      // With the first prime alone: the product of the others makes the other images zero.
      Integer others = 1;
      for (std::size_t j = 1; j < fields.size(); ++j)
        others *= fields[j].prime();
      const auto f = fields[0];
      const auto root = square_root(f, f.from_double(q));
      if (root.y != 0)
        continue;
      const Integer r(f.product(root.x, 1));
      equal_images +=
        ((rings.root(q) - rings.rational(Rational(r))) * rings.rational(Rational(others))).is_zero() ? 1 : -1;
    }
  }
  EXPECT_LT(std::abs(equal_images), 150); // of about 600, the difference of both signs
}

TEST(Residues, the_same_seed_gives_the_same_fields)
{
  const auto primes = [](std::uint64_t seed) {
    std::vector<std::uint64_t> result;
    for (const auto& field : random_prime_fields(seed))
      result.push_back(field.prime());
    return result;
  };
  EXPECT_EQ(primes(5), primes(5));
  EXPECT_NE(primes(5), primes(6));
  std::vector<std::uint64_t> p = primes(5);
  std::sort(p.begin(), p.end());
  EXPECT_EQ(std::adjacent_find(p.begin(), p.end()), p.end());
}

// The formula of the documentation: four primes of more than 2^54, each bad for at most h / 61 of them.
TEST(Residues, certainty_is_that_of_the_documentation)
{
  const auto documented = [](double n, double b) {
    const double h = 32 * n * b + 24 * (n + 1);
    return -4 * (std::log2(h / 61) - 54);
  };
  for (const double n : {1., 10., 1e4, 1e6})
    for (const double b : {1., 200., 6000.}) {
      const double certainty = Residue_rings::certainty(n, b);
      EXPECT_LE(certainty, documented(n, b));
      EXPECT_NEAR(certainty, documented(n, b), 0.2);
      EXPECT_LT(Residue_rings::certainty(2 * n, b), certainty);
      EXPECT_LT(Residue_rings::certainty(n, 2 * b), certainty);
    }
  EXPECT_GT(Residue_rings::certainty(1e4, 200), 128);
  EXPECT_LT(Residue_rings::certainty(1e6, 6000), 128);
  // Fields without information add nothing to the bound, and never subtract.
  EXPECT_EQ(Residue_rings::certainty(1e9, 1e9), 0);
  EXPECT_EQ(Residue_rings::certainty(1e300, 1e300), 0);
}

} // namespace
