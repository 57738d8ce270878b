// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Below which size `idt refine` inserts no vertex if nobody says so, and what it says when a budget will not suffice.

#ifndef IDT_SMALLEST_SIZE_H
#define IDT_SMALLEST_SIZE_H

#include "input/Surface.h"
#include "number_types/run.h"

#include <cstdint>
#include <functional>
#include <string>

namespace idt {

// Begins with 0. Sides below 2^-14 of the longest side of the box are what CAD programs leave by mistake if they need
// many vertices: then refinement begins anew with 2^-20 of the box, 2^-17 and 2^-14 in turn. Places that need few
// vertices are refined, whatever their size.
class Smallest_size
{
public:
  explicit Smallest_size(const Surface& surface);

  double size() const { return size_; }
  // Whether too many vertices have been inserted for small sides.
  bool is_exceeded(const CGAL::Intrinsic_triangulations::Refinement_progress& progress);
  // Whether sides as short as that are below a larger size that may still be chosen.
  bool covers(double side) const { return side < largest() && size_ < largest(); }
  // Chooses the next size.
  void increase();
  // For the report.
  std::string text() const;

private:
  double largest() const;

  double extent_ = 0; // of the box, or the longest edge of a surface that has no points
  std::uint64_t maximum_, number_ = 0;
  double size_ = 0;
};

// Writes once to the standard error that the budget will not suffice, as soon as two estimates in a row say so: the
// first one takes the thin faces around a vertex for a strip that has to be filled evenly.
class Budget_warning
{
public:
  Budget_warning(std::string path, std::uint64_t budget) : path_(std::move(path)), budget_(budget) {}
  void look(const CGAL::Intrinsic_triangulations::Refinement_progress& progress,
            const std::function<Short_side()>& where);

private:
  std::string path_;
  std::uint64_t budget_, estimate_ = 0;
  bool was_exceeded_ = false, is_written_ = false;
};

} // namespace idt

#endif // IDT_SMALLEST_SIZE_H
