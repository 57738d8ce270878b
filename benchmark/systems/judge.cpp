// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Judges one result (judge.h says how), and prints a line of JSON.
//
//   judge_system_results triangulation|overlay|Laplacian SURFACE RESULT

#include "judge.h"

#include <exception>
#include <iostream>

namespace {

// JSON has no infinity.
double finite_number(double number) { return std::isfinite(number) ? number : 1e308; }

} // namespace

int main(int argc, char** argv)
{
  using namespace systems;
  if (argc != 4) {
    std::cerr << "expected: triangulation|overlay|Laplacian SURFACE RESULT\n";
    return 2;
  }
  try {
    const Result result = read_result(argv[3]);
    const Judgement judgement = judge(argv[1], read_surface(argv[2]), result);
    const char* const names[] = {"right", "close", "wrong"};
    std::cout << "{\"verdict\": \"" << names[int(judgement.verdict)] << "\", \"why\": \"" << judgement.why
              << "\", \"largest_error\": " << finite_number(judgement.largest_error)
              << ", \"wrong_faces\": " << judgement.wrong_faces << ", \"wrong_edges\": " << judgement.wrong_edges
              << ", \"triangulation_seconds\": " << result.triangulation_seconds
              << ", \"task_seconds\": " << result.task_seconds << "}\n";
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
