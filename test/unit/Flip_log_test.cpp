// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of the log of flips.

#include "library/engine/history/Flip_log.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Flip_log;

namespace {

IT::Hinge_halfedges flip(std::uint32_t number)
{
  IT::Hinge_halfedges result{};
  result.ij = IT::Halfedge_index(number);
  return result;
}

std::vector<std::uint32_t> numbers(std::uint32_t first, std::uint32_t last)
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t i = first; i < last; ++i)
    result.push_back(i);
  return result;
}

void note(Flip_log& log, std::uint32_t first, std::uint32_t last)
{
  for (std::uint32_t i = first; i < last; ++i)
    log.push_back(flip(i));
}

// From both ends; the results must agree.
std::vector<std::uint32_t> unread(const Flip_log& log, Flip_log::Reader reader)
{
  std::vector<std::uint32_t> result, backwards;
  log.for_each_unread(reader, [&](const IT::Hinge_halfedges& f) { result.push_back(f.ij.idx()); });
  log.for_each_unread_backwards(reader, [&](const IT::Hinge_halfedges& f) { backwards.push_back(f.ij.idx()); });
  EXPECT_EQ(std::vector<std::uint32_t>(backwards.rbegin(), backwards.rend()), result);
  EXPECT_EQ(log.number_of_unread(reader), result.size());
  return result;
}

} // namespace

TEST(Flip_log, has_what_one_reader_has_not_read)
{
  Flip_log log;
  note(log, 0, 5);
  EXPECT_FALSE(log.is_followed());
  log.follow(Flip_log::FACES);
  EXPECT_TRUE(log.is_followed_by(Flip_log::FACES));
  EXPECT_FALSE(log.is_followed_by(Flip_log::INTEGERS));
  note(log, 5, 7);
  EXPECT_EQ(unread(log, Flip_log::INTEGERS), numbers(0, 7));
  EXPECT_EQ(unread(log, Flip_log::FACES), numbers(0, 0));
  log.begin();
  EXPECT_FALSE(log.is_followed());
  note(log, 7, 10);
  Flip_log copy;
  copy = log;
  log.follow(Flip_log::INTEGERS);
  for (const Flip_log* each : {&log, &copy})
    EXPECT_EQ(unread(*each, Flip_log::FACES), numbers(7, 10));
  EXPECT_EQ(unread(copy, Flip_log::INTEGERS), numbers(0, 10));
}

TEST(Flip_log, has_all_flips_for_numbers_until_they_follow)
{
  Flip_log log;
  note(log, 0, 2500);
  log.follow(Flip_log::INTEGERS);
  log.follow(Flip_log::FACES);
  EXPECT_FALSE(log.is_followed_by_all());
  note(log, 2500, 2600);
  log.begin();
  note(log, 2600, 2700);
  EXPECT_EQ(unread(log, Flip_log::NUMBERS), numbers(0, 2700));
  EXPECT_EQ(unread(log, Flip_log::FACES), numbers(2600, 2700));
  log.follow(Flip_log::FACES);
  Flip_log copy;
  copy = log;
  EXPECT_EQ(unread(copy, Flip_log::NUMBERS), numbers(0, 2700));
  log.follow(Flip_log::NUMBERS);
  EXPECT_EQ(unread(log, Flip_log::INTEGERS), numbers(2600, 2700));
  log.follow(Flip_log::INTEGERS);
  EXPECT_TRUE(log.is_followed_by_all());
  EXPECT_EQ(log.size(), 0u);
}

TEST(Flip_log, is_empty_as_soon_as_all_readers_follow)
{
  Flip_log log;
  log.follow(Flip_log::NUMBERS);
  for (int i = 0; i < 2; ++i) {
    note(log, 0, 3000);
    log.follow(Flip_log::INTEGERS);
    EXPECT_EQ(log.size(), 3000u);
    log.follow(Flip_log::FACES);
    EXPECT_EQ(log.size(), 0u);
    log.begin();
    EXPECT_EQ(unread(log, Flip_log::FACES), numbers(0, 0));
  }
}

// In whichever way they were noted.
TEST(Flip_log, takes_flips_back)
{
  Flip_log log;
  log.make_room(2);
  log.append({flip(0), flip(1)});
  log.append({});
  note(log, 2, 5000);
  log.follow(Flip_log::FACES);
  for (std::uint32_t n = 5000; n-- > 1;) {
    log.pop_back();
    if (n % 700 == 1) {
      EXPECT_EQ(unread(log, Flip_log::INTEGERS), numbers(0, n));
    }
  }
  note(log, 1, 3000);
  EXPECT_EQ(unread(log, Flip_log::INTEGERS), numbers(0, 3000));
}
