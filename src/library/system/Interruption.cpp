// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Asking the function, and when to ask it next.

#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include "time_between_questions.h"
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <atomic>

namespace CGAL::Intrinsic_triangulations::internal {

void Interruption::ask() const
{
  if (!go_further_())
    throw Cancelled_error("the computation was cancelled");
  next_question_.store(now() + time_between_questions.count(), std::memory_order_relaxed);
}

} // namespace CGAL::Intrinsic_triangulations::internal
