// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Catches what the library throws, which may be a shared one.

#include "package.h"

#include <iostream>
#include <string>

std::string message_of_other();

int main()
{
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  try {
    CGAL::Intrinsic_triangulations::Input_metric::from_lengths({1, 1, -1});
  } catch (const Invalid_surface_error& error) {
    if (error.defect() == Invalid_surface_error::Defect::NOT_FINITE && message_of_other() == error.what())
      std::cout << "OK\n";
  }
}
