// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Ptolemy_length.h.

#include <CGAL/Intrinsic_triangulations/internal/measures/Ptolemy_length.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

struct Exact_length
{
  Lazy_exact_nt<Gmpq> value;
};

namespace {

using Lazy = Lazy_exact_nt<Gmpq>;

struct Exact_hinge
{
  Lazy ij, jk, ki, il, lj;
};

Exact_hinge exact(const Ptolemy_hinge& h)
{
  const auto value = [](const Ptolemy_length& l) { return l.exact ? l.exact->value : Lazy(l.value); };
  return {value(h.ij), value(h.jk), value(h.ki), value(h.il), value(h.lj)};
}

// More would make chains of lengths that depend on each other too long for the stack, on which they are evaluated.
constexpr double largest_error = 0x1p-38;

} // namespace

Ptolemy_length flipped_length(const Ptolemy_hinge& h)
{
  // Nothing cancels: relative errors add up, and the four operations add at most 3 units.
  Ptolemy_length kl;
  kl.value = (h.jk.value * h.il.value + h.ki.value * h.lj.value) / h.ij.value;
  kl.relative_error =
    1.01 * ((std::max)(h.jk.relative_error + h.il.relative_error, h.ki.relative_error + h.lj.relative_error) +
            h.ij.relative_error) +
    0x1p-51;
  const auto value = std::make_shared<Exact_length>(Exact_length{Ptolemy_numbers<Lazy>::flipped(exact(h))});
  kl.exact = value;
  if (!(kl.relative_error < largest_error)) {
    kl.value = to_double(value->value.exact());
    kl.relative_error = 0x1p-52;
  }
  return kl;
}

bool is_Delaunay_exactly(const Ptolemy_hinge& h)
{
  const auto is_simple = [](const Ptolemy_length& l) { return !l.exact && l.value > 0x1p-200 && l.value < 0x1p200; };
  if (is_simple(h.ij) && is_simple(h.jk) && is_simple(h.ki) && is_simple(h.il) && is_simple(h.lj)) {
    const Double_double ij{h.ij.value}, jk{h.jk.value}, ki{h.ki.value}, il{h.il.value}, lj{h.lj.value};
    const Double_double left = ij * ij * (jk * ki + il * lj), right = (jk * il + ki * lj) * (ki * il + jk * lj);
    if (const double difference = (right - left).hi; std::abs(difference) > 0x1p-98 * (left.hi + right.hi))
      return difference > 0;
  }
  return Ptolemy_numbers<Lazy>::is_Delaunay(exact(h));
}

} // namespace CGAL::Intrinsic_triangulations::internal
