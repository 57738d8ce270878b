// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the evaluation meshes are, which the project neither contains nor needs.

#ifndef IDT_TEST_EVALUATION_DATA_H
#define IDT_TEST_EVALUATION_DATA_H

#include <cstdlib>
#include <filesystem>

// The folder that the environment variable IDT_DATA_DIR names, or shared/data beside the
// checkout; an empty path if neither is there.
inline std::filesystem::path evaluation_data()
{
  const char* const variable = std::getenv("IDT_DATA_DIR");
  const std::filesystem::path folder =
    variable != nullptr ? std::filesystem::path(variable)
                        : std::filesystem::path(__FILE__).parent_path() / ".." / ".." / "shared" / "data";
  return std::filesystem::is_directory(folder) ? folder : std::filesystem::path();
}

#endif // IDT_TEST_EVALUATION_DATA_H
