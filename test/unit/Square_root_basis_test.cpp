// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Square roots reduced to independent ones, of integers that the primes which prove the
// independence divide, too.

#include "library/arithmetic/Square_root_basis.h"
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Rational;
using IT::internal::Square_root_basis;

// The square of coefficient · Π √b.
Rational square(const Square_root_basis& basis, const Square_root_basis::Root& root)
{
  Rational result = root.coefficient * root.coefficient;
  for (std::uint32_t i : root.generators)
    result *= Rational(basis.generator(i));
  return result;
}

// Reduces all of them, and expects this many independent ones.
void expect_basis(const std::vector<Rational>& numbers, std::size_t size)
{
  IT::internal::Interruption none;
  Square_root_basis basis(none);
  for (const Rational& q : numbers)
    EXPECT_EQ(square(basis, basis.root(q)), q) << q;
  EXPECT_EQ(basis.size(), size);
}

const Rational p = 2147483647, r = 2147483629; // the largest primes below 2^31

} // namespace

TEST(Square_root_basis, finds_products_of_roots)
{
  expect_basis({2, 3, 6, 8, Rational(3, 2), Rational(25, 9), 5, 30, Rational(7, 10), 21}, 4);
}

TEST(Square_root_basis, takes_multiples_of_its_primes)
{
  expect_basis({3 * p, 3, p, 12 * p}, 2);
  expect_basis({2, 3, 5, p, 6 * p, 10 * p, 15 * r, p * r, r, p * p, p * p * r}, 5);
  expect_basis({p * r, p, r}, 2);
  expect_basis({p * p * 7, 7, r * 7, Rational(1) / r}, 2);
}

TEST(Square_root_basis, takes_a_multiple_of_a_prime_after_many_others)
{
  std::vector<Rational> numbers;
  for (int n = 2; n < 120; ++n)
    numbers.push_back(n);
  for (int n = 2; n < 120; ++n)
    numbers.push_back(n % 2 == 0 ? n * p : n * r);
  expect_basis(numbers, 32); // the primes below 120, of which there are 30, and these two
}
