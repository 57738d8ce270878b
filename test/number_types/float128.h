// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifdef __SIZEOF_FLOAT128__
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/quadruple_precision.h>

using Number_type = __float128;
#else
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

using Number_type = boost::multiprecision::cpp_bin_float_quad;
#endif
