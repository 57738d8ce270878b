// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Long texts put together by several threads: the same bytes as from a stream, in order.

#include "system/Long_text.h"
#include "system/text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <vector>

namespace {

TEST(Long_text, numbers_as_in_full)
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<double> numbers = {
    0, -0., 1, 0.1, 1e-5, 1e16, 1e17, 123456789, 5e-324, (std::numeric_limits<double>::max)(), HUGE_VAL};
  for (int i = 0; i < 1000; ++i)
    numbers.push_back(std::ldexp(unit(random), int(random() % 2000) - 1000));
  for (const double x : numbers) {
    idt::Long_text text;
    text << x;
    EXPECT_EQ(text.string(), idt::in_full(x));
  }
  idt::Long_text text;
  text << 'a' << -7 << ' ' << (std::numeric_limits<std::uint64_t>::max)() << "b c" << std::uint8_t(200);
  EXPECT_EQ(text.string(), "a-7 18446744073709551615b c200");
}

TEST(Long_text, bytes_begin_with_the_lowest)
{
  idt::Long_text text;
  text.add_bytes(std::uint8_t(255)).add_bytes(std::uint32_t(0x01020304)).add_bytes(1.);
  EXPECT_EQ(text.string(), std::string("\xff\4\3\2\1\0\0\0\0\0\0\xf0\x3f", 13));
}

TEST(Long_text, blocks_are_written_in_order)
{
  for (const std::size_t n : {std::size_t(0), std::size_t(1), idt::elements_of_block, 7 * idt::elements_of_block + 1}) {
    std::string expected;
    for (std::size_t i = 0; i < n; ++i)
      expected += std::to_string(i) + '\n';
    std::ostringstream os;
    idt::write_elements(os, n, [](idt::Long_text& text, std::size_t i) { text << i << '\n'; });
    EXPECT_TRUE(os.str() == expected) << n;
  }
}

// Takes some bytes and no more.
class Full_disk : public std::streambuf
{
public:
  explicit Full_disk(std::streamsize room) : room_(room) {}

private:
  std::streamsize xsputn(const char*, std::streamsize n) override
  {
    const std::streamsize taken = (std::min)(n, room_);
    room_ -= taken;
    return taken;
  }
  std::streamsize room_;
};

TEST(Long_text, ends_where_the_disk_is_full_or_an_element_fails)
{
  Full_disk disk(100);
  std::ostream os(&disk);
  std::atomic<std::size_t> elements{0};
  idt::write_elements(os, 1000 * idt::elements_of_block, [&](idt::Long_text& text, std::size_t) {
    ++elements;
    text << '.';
  });
  EXPECT_FALSE(os);
  EXPECT_LT(elements, 999 * idt::elements_of_block);
  std::ostringstream good;
  const auto fail = [](idt::Long_text&, std::size_t i) {
    if (i == 3 * idt::elements_of_block)
      throw std::runtime_error("as wanted");
  };
  EXPECT_THROW(idt::write_elements(good, 9 * idt::elements_of_block, fail), std::runtime_error);
}

} // namespace
