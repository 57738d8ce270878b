// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many random fans and strips of triangles with one to eight roots: finite fields take for zero what the
// expansion in a multiquadratic field proves to be zero, and nothing else.

#include "library/arithmetic/Planar_vector.h"
#include "library/arithmetic/Multiquadratic.h"
#include "library/arithmetic/Residues.h"
#include "library/engine/layout/metric_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::internal;

// A triangle by its squared lengths: its root is that of 4 s t − (s + t − u)². The ratio of the second side to the
// first one can be conjugated: then the triangle lies on the other side.
struct Triangle
{
  int s, t, u;
  bool is_reflected = false;

  int p() const { return s + t - u; }
  int q() const { return 4 * s * t - p() * p(); }

  template <class Image>
  typename Image::Vector ratio(const Image& image) const
  {
    const auto height = image.root(q()) / image.rational(2 * s);
    return {image.rational(Rational(p(), 2 * s)), is_reflected ? -height : height};
  }
};

template <class Vector>
Vector conjugate(const Vector& z)
{
  return {z.x(), -z.y()};
}

// Two corners with a fan of triangles each. The sum of the angles is a multiple of π if the imaginary part of
// the product is zero.
struct Two_fans
{
  std::vector<Triangle> first, second;

  template <class Image>
  bool is_zero(const Image& image) const
  {
    typename Image::Vector z(image.rational(1), image.rational(0));
    for (const Triangle& t : first)
      z = z * t.ratio(image);
    for (const Triangle& t : second)
      z = z * conjugate(t.ratio(image));
    return z.y().is_zero();
  }
};

// Two strips that begin with the same side: whether they end at the same height. The first is laid out from its
// beginning, the second from its end.
struct Two_strips
{
  std::vector<Triangle> first, second;

  template <class Image>
  bool is_zero(const Image& image) const
  {
    const typename Image::Vector one(image.rational(1), image.rational(0));
    typename Image::Vector position = one, direction = one;
    for (const Triangle& t : first) {
      direction = direction * t.ratio(image);
      position = position + direction;
    }
    typename Image::Vector other = one;
    for (std::size_t i = second.size(); i-- > 0;)
      other = one + second[i].ratio(image) * other;
    return (position - other).y().is_zero();
  }
};

class Random_triangles
{
public:
  explicit Random_triangles(std::uint64_t seed) : random_(seed) {}

  int below(int n) { return int(random_() % std::uint64_t(n)); }

  // From one to eight, half as often as the number before.
  std::vector<Triangle> triangles()
  {
    std::vector<Triangle> result{triangle()};
    while (result.size() < 8 && below(2) == 0)
      result.push_back(triangle());
    return result;
  }

  Triangle triangle()
  {
    for (;;) {
      const Triangle t{1 + below(12), 1 + below(12), 1 + below(12)};
      if (t.q() > 0)
        return t;
    }
  }

  // The same shape: the root is a multiple of that before.
  void enlarge(Triangle& t)
  {
    const int scale = std::array<int, 4>{1, 2, 4, 9}[std::size_t(below(4))];
    t = {t.s * scale, t.t * scale, t.u * scale, t.is_reflected};
  }

  // A nearly equal one, where one root has the other sign, or one length differs.
  void change_one(std::vector<Triangle>& triangles)
  {
    Triangle& t = triangles[std::size_t(below(int(triangles.size())))];
    if (below(2) == 0)
      t.is_reflected = true;
    else
      t = triangle();
  }

  void shuffle(std::vector<Triangle>& triangles) { std::shuffle(triangles.begin(), triangles.end(), random_); }

private:
  std::mt19937_64 random_;
};

struct Counts
{
  int zero = 0, other = 0;
};

// Both images have roots of their own for each number.
template <class Number>
void expect_agreement(const Number& number, const Prime_fields& fields, Counts& counts)
{
  Interruption none;
  Multiquadratic_field field(none, (std::numeric_limits<std::size_t>::max)());
  Residue_rings rings(fields, none);
  const bool is_zero = number.is_zero(Multiquadratic_image{field});
  EXPECT_EQ(number.is_zero(Residue_image{rings}), is_zero);
  EXPECT_TRUE(rings.is_defined());
  ++(is_zero ? counts.zero : counts.other);
}

template <class Number>
Counts compare(int number_of_cases, std::uint64_t seed)
{
  Random_triangles random(seed);
  Counts counts;
  Prime_fields fields;
  for (int i = 0; i < number_of_cases && !::testing::Test::HasFailure(); ++i) {
    if (i % 1000 == 0)
      fields = random_prime_fields(seed + std::uint64_t(i));
    Number number;
    number.first = number.second = random.triangles();
    for (Triangle& t : number.second)
      random.enlarge(t);
    if (std::is_same<Number, Two_fans>::value)
      random.shuffle(number.second);
    if (i % 2 == 0)
      random.change_one(number.second);
    expect_agreement(number, fields, counts);
  }
  return counts;
}

TEST(Residues_against_expansion, fifty_thousand_hinges_with_fans)
{
  const Counts counts = compare<Two_fans>(50000, 1);
  EXPECT_GE(counts.zero, 25000);
  EXPECT_GT(counts.other, 15000);
}

TEST(Residues_against_expansion, fifty_thousand_strips)
{
  const Counts counts = compare<Two_strips>(50000, 2);
  EXPECT_GE(counts.zero, 25000);
  EXPECT_GT(counts.other, 15000);
}

} // namespace
