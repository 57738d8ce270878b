// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program around a system: reads the surface, does one task, writes the result.
//
//   system-NAME triangulation|overlay|Laplacian SURFACE RESULT
//   system-NAME version
//
// The exit status is 0 if there is a result, 3 if the system refuses the surface by an exception, and 4 if it has
// no interface for the task, or none for such a surface.

#ifndef IDT_BENCHMARK_SYSTEMS_RUN_SYSTEM_H
#define IDT_BENCHMARK_SYSTEMS_RUN_SYSTEM_H

#include "Interchange.h"

#include <ctime>
#include <exception>
#include <iostream>
#include <string>

namespace systems {

enum class Task {
  TRIANGULATION,
  OVERLAY,
  LAPLACIAN
};

// Thrown if a system does not offer something.
struct Not_offered
{
  const char* why;
};

// Runs while it lives; its processor time is added to the result, since the machine may be busy. All systems use one thread.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds) : seconds_(seconds), start_(std::clock()) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { seconds_ += double(std::clock() - start_) / CLOCKS_PER_SEC; }

private:
  double& seconds_;
  std::clock_t start_;
};

template <class Run>
int run_system(int argc, char** argv, const Run& run)
{
  if (argc == 2 && std::string(argv[1]) == "version") {
    std::cout << SYSTEM_VERSION << '\n';
    return 0;
  }
  const std::string task = argc == 4 ? argv[1] : "";
  if (task != "triangulation" && task != "overlay" && task != "Laplacian") {
    std::cerr << "expected: triangulation|overlay|Laplacian SURFACE RESULT\n";
    return 2;
  }
  try {
    write_result(argv[3], run(task == "triangulation" ? Task::TRIANGULATION
                              : task == "overlay"     ? Task::OVERLAY
                                                      : Task::LAPLACIAN,
                              read_surface(argv[2])));
    return 0;
  } catch (const Not_offered& error) {
    std::cerr << error.why << '\n';
    return 4;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_RUN_SYSTEM_H
