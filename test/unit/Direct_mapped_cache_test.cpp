// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/internal/system/Direct_mapped_cache.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>

namespace {

using CGAL::Intrinsic_triangulations::internal::Direct_mapped_cache;

// Keys that share their place displace each other, and the places move when the cache grows.
TEST(Direct_mapped_cache, has_the_value_of_the_key_that_is_asked_for)
{
  constexpr std::uint32_t number_of_keys = 100000;
  Direct_mapped_cache<std::uint32_t, std::uint32_t> cache(number_of_keys);
  std::mt19937 random(1);
  for (int i = 0; i < 500000; ++i) {
    const std::uint32_t key = 1 + random() % number_of_keys;
    ASSERT_EQ(cache(key, key * 7, [&] { return 3 * key + 1; }), 3 * key + 1);
  }
}

// As many places as keys: after it has grown, nothing is computed twice.
TEST(Direct_mapped_cache, grows_to_the_number_of_its_keys)
{
  constexpr std::uint32_t number_of_keys = 16000;
  Direct_mapped_cache<std::uint32_t, std::uint32_t> cache(number_of_keys);
  std::size_t computed = 0;
  const auto ask_all = [&] {
    computed = 0;
    for (std::uint32_t key = 1; key < number_of_keys; ++key)
      cache(key, key, [&] {
        ++computed;
        return key;
      });
  };
  for (int i = 0; i < 10; ++i)
    ask_all();
  EXPECT_EQ(computed, 0u);
}

} // namespace
