// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeds of the core target: gluings of every size, with numbers of every kind.

#include "fuzz_target.h"

#include <random>
#include <string>
#include <vector>

namespace fuzz {
namespace {

// The bytes of a gluing, as Metric_gluing.h reads them, up to the choice of the metric.
const std::vector<std::string>& gluings()
{
  static const std::vector<std::string> result = {
    std::string("\0\0\0", 3),                    // a triangle
    std::string("\0\1", 2),                      // a triangle whose legs are glued
    std::string("\1\3\2\1", 4),                  // a one-vertex torus
    std::string("\1\5\3\1", 4),                  // two triangles back to back
    std::string("\1\1\2\1", 4),                  // two cones, base to base
    std::string("\1\0\0\1\0\0", 6),              // a hinge
    std::string("\3\3\4\3\2\1\1", 7),            // closed, of four
    std::string("\3\0\2\0\3\0\2\0\1\0\0", 11),   // a strip of four
    std::string("\5\11\7\3\0\2\0\3\2\1\1\0", 12) // six
  };
  return result;
}

} // namespace

std::vector<std::string> seed_inputs()
{
  std::vector<std::string> seeds;
  std::mt19937 random(7);
  for (const std::string& gluing : gluings())
    for (int metric = 6; metric < 12; ++metric) {
      std::string seed = gluing + char(metric);
      for (int i = 0; i < 36; ++i)
        seed += char(random());
      seeds.push_back(seed);
      // Lengths in [1, 2), with which every gluing is a surface.
      seed.resize(gluing.size() + 1);
      for (int i = 0; i < 18; ++i)
        seed += {char(0), char(random())};
      seeds.push_back(seed);
    }
  // A tie across a root of a multiple of 2^31 - 1, one of the primes that prove independence.
  seeds.push_back(std::string("\307\227\023\176\001\005\003\037\000\000\000\000\000\000\000\375"
                              "\375\375\375\375\375\375\375\053\375\151\375\375\375\075\375",
                              31));
  return seeds;
}

} // namespace fuzz
