// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Ptolemy_length.h.

#include <CGAL/Intrinsic_triangulations/internal/measures/Ptolemy_length.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The lengths before a flip, and the exact length after it, once it was needed. Flips depend on each other in chains of
// any length, so nothing here is recursive.
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
  std::optional<Rational> exact;        // guarded by the mutex
};

namespace {

// Threads may decide about copies of a triangulation at once.
std::mutex& mutex()
{
  static std::mutex result;
  return result;
}

Rational known(const Ptolemy_length& length) { return length.flip ? *length.flip->exact : Rational(length.value); }

// \pre the mutex is locked
Rational exact(const Ptolemy_length& length)
{
  std::vector<Ptolemy_flip*> open;
  const auto add = [&](const Ptolemy_length& l) {
    if (l.flip && !l.flip->exact)
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
    const auto& [jk, ki, il, lj] = flip.around;
    flip.exact = (known(jk) * known(il) + known(ki) * known(lj)) / known(flip.ij);
  }
  return known(length);
}

constexpr double unit = 0x1p-53;
constexpr double largest_error = 0x1p-30; // most tests are far from a tie

} // namespace

Ptolemy_length rounded_once(const Ptolemy_length& length)
{
  if (!length.flip || length.relative_error <= 2 * unit)
    return length;
  const std::lock_guard<std::mutex> lock(mutex());
  return {exact(length).convert_to<double>(), 2 * unit, length.flip};
}

Ptolemy_length flipped_length(const Ptolemy_hinge& h)
{
  // Nothing cancels: relative errors add up, and the four operations add at most 3 units.
  Ptolemy_length kl;
  kl.value = (h.jk.value * h.il.value + h.ki.value * h.lj.value) / h.ij.value;
  kl.relative_error =
    1.01 * ((std::max)(h.jk.relative_error + h.il.relative_error, h.ki.relative_error + h.lj.relative_error) +
            h.ij.relative_error) +
    4 * unit;
  kl.flip = std::make_shared<Ptolemy_flip>(h);
  return kl.relative_error < largest_error ? kl : rounded_once(kl);
}

Sign exact_sign_of_Ptolemy_test(const Ptolemy_hinge& h)
{
  const std::lock_guard<std::mutex> lock(mutex());
  const Rational ij = exact(h.ij), jk = exact(h.jk), ki = exact(h.ki), il = exact(h.il), lj = exact(h.lj);
  return CGAL::Sign(Rational(ij * ij * (jk * ki + il * lj) - (jk * il + ki * lj) * (ki * il + jk * lj)).sign());
}

} // namespace CGAL::Intrinsic_triangulations::internal
