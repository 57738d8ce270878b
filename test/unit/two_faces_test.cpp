// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With the processor's operations on two numbers at once.

#include "two_faces_tests.h"
