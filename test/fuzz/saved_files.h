// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small triangulations as files.

#ifndef IDT_TEST_FUZZ_SAVED_FILES_H
#define IDT_TEST_FUZZ_SAVED_FILES_H

#include <string>
#include <vector>

namespace fuzz {

// Of all kinds of metrics, with and without a border, flips, inserted vertices and constraints.
std::vector<std::string> saved_files();

} // namespace fuzz

#endif // IDT_TEST_FUZZ_SAVED_FILES_H
