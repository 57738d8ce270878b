// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Headers that most tests include; with Clang, they are compiled once for all tests. (GCC would gain less: see
// idt_test_helpers.cmake.)

#ifndef INTRINSIC_TRIANGULATIONS_TEST_PRECOMPILED_H
#define INTRINSIC_TRIANGULATIONS_TEST_PRECOMPILED_H

#include <CGAL/Intrinsic_triangulations.h>
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <boost/multiprecision/mpfr.hpp>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#endif // INTRINSIC_TRIANGULATIONS_TEST_PRECOMPILED_H
