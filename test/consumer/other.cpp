// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "package.h"

#include <string>

// The message of the same error, caught by its base.
std::string message_of_other()
{
  try {
    CGAL::Intrinsic_triangulations::Input_metric::from_lengths({2, 2, -2});
  } catch (const CGAL::Intrinsic_triangulations::Error& error) {
    return error.what();
  }
  return {};
}
