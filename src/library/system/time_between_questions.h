// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How often the function of an interruption is called.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_TIME_BETWEEN_QUESTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_TIME_BETWEEN_QUESTIONS_H

#include <chrono>

namespace CGAL::Intrinsic_triangulations::internal {

inline std::chrono::steady_clock::duration time_between_questions =
  std::chrono::milliseconds(10); // tests ask more often

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_TIME_BETWEEN_QUESTIONS_H
