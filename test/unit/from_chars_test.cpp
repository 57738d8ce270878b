// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers are read in the same way with any standard library, bit for bit.

#include "library/files/text_file.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

TEST(From_chars, rounds_correctly)
{
  const auto value = [](const std::string& text) {
    double number = 7;
    IT::internal::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  EXPECT_EQ(value("9007199254740993"), 9007199254740992.); // a tie, to even
  EXPECT_EQ(value("9007199254740993.0000000000000000000000000000000000000000000000000000000000000000000000001"),
            9007199254740994.);
  EXPECT_EQ(value("2.4703282292062328e-324"), 4.9406564584124654e-324);
  EXPECT_EQ(value("1.7976931348623158e308"), 1.7976931348623157e308);
  EXPECT_EQ(value("-.5e1x"), -5);
}

#if defined(__cpp_lib_to_chars) && !defined(_WIN32)
template <class Real>
void expect_same(const std::string& text)
{
  Real expected = 7, found = 7;
  const char *const first = text.data(), *const last = first + text.size();
  const std::from_chars_result by_library = std::from_chars(first, last, expected),
                               by_us = IT::internal::from_chars_by_strtod(first, last, found);
  EXPECT_EQ(by_us.ptr - first, by_library.ptr - first) << text;
  EXPECT_TRUE(by_us.ec == by_library.ec) << text;
  EXPECT_TRUE(std::memcmp(&found, &expected, sizeof found) == 0 || (std::isnan(found) && std::isnan(expected))) << text;
}

TEST(From_chars, does_the_same_without_the_function_of_the_standard_library)
{
  for (const char* text :
       {"",
        "1",
        "-1",
        "+1",
        "--1",
        ".5",
        "5.",
        "-5.e3",
        "e5",
        ".",
        "-",
        ".e1",
        "1e",
        "1e+",
        "1e5x",
        " 1",
        "1,5",
        "0x10",
        "inf",
        "-INF",
        "infinit",
        "infinity",
        "nan",
        "-nan",
        "nan(",
        "nan(a_1)",
        "nan(a-b)",
        "1e400",
        "-1e400",
        "1e-400",
        "4.9e-324",
        "2e-324",
        "2.4703282292062328e-324",
        "1.7976931348623159e308",
        "0e99999999999999999999",
        "1e99999999999999999999",
        "-1e-99999999999999999999",
        "9007199254740993",
        "3.4028235677973366e38",
        "1e39",
        "7e-46",
        "0.00000000000000000000000000000000000000000000000000000000000000000000000000000000001e90"}) {
    expect_same<double>(text);
    expect_same<float>(text);
  }
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random();
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, i % 3 == 0 ? "%.17g" : i % 3 == 1 ? "%.25e" : "%.8g", number);
    expect_same<double>(buffer);
    expect_same<float>(buffer);
    std::string letters;
    for (std::uint64_t n = random() % 9; n > 0; --n)
      letters += "0123456789.eE+-nif"[random() % 18];
    expect_same<double>(letters);
  }
}
#endif

} // namespace
