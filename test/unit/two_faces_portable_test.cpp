// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// As on a processor without operations on two numbers at once. The library was compiled for another processor, so its
// sources are compiled here, too.

#include <CGAL/FPU.h>
#include <boost/config.hpp>
#include <gtest/gtest.h>
#undef __SSE2__

#include "library/all.cpp"
#include "two_faces_tests.h"
