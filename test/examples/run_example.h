// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Calls the function `main` of an example, which may take the arguments or not.

#ifndef INTRINSIC_TRIANGULATIONS_TEST_RUN_EXAMPLE_H
#define INTRINSIC_TRIANGULATIONS_TEST_RUN_EXAMPLE_H

inline int run_example(int (*main)(), int, char**) { return main(); }
inline int run_example(int (*main)(int, char**), int argc, char** argv) { return main(argc, argv); }

#endif // INTRINSIC_TRIANGULATIONS_TEST_RUN_EXAMPLE_H
