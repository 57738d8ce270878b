// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "package.h"

#include <iostream>

const char* name_of_other();

int main()
{
  try {
    throw CGAL::Intrinsic_triangulations::Undecided_error(name_of_other());
  } catch (const CGAL::Intrinsic_triangulations::Error& error) {
    std::cout << error.what() << '\n';
  }
}
