// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gluing format: written text can be read back, and damage is reported, never accepted.

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;
using Defect = IT::Invalid_surface_error::Defect;
using Triangles = std::vector<std::array<int, 3>>;
using Side_pairs = std::vector<std::array<int, 2>>;

namespace {

std::vector<Delta_complex> all_surfaces()
{
  return {Delta_complex(),
          IT::make_Delta_complex_from_triangles(7, Triangles{}),
          IT::make_Delta_complex_from_triangles(4, Triangles{{2, 0, 3}}),
          IT::make_Delta_complex_from_gluing(1, Side_pairs{{0, 1}}),
          IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 4}, {2, 5}}),
          IT::make_Delta_complex_from_gluing(2, Side_pairs{{0, 3}, {1, 5}, {2, 4}}),
          IT::make_Delta_complex_from_gluing(3, Side_pairs{{0, 1}, {2, 5}, {3, 8}, {6, 7}}),
          IT::make_Delta_complex_from_triangles(4, Triangles{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}),
          IT::make_Delta_complex_from_triangles(
            9, Triangles{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}})};
}

std::vector<double> some_lengths(const Delta_complex& c, std::mt19937& random)
{
  std::uniform_real_distribution<double> exponent(-300, 300);
  std::vector<double> lengths;
  for (std::size_t e = 0; e < c.number_of_edges(); ++e)
    lengths.push_back(std::pow(10., exponent(random)));
  return lengths;
}

std::string written(const Delta_complex& c, const std::vector<double>& lengths)
{
  std::ostringstream os;
  IT::write_gluing(os, c, lengths);
  return os.str();
}

IT::Gluing read(const std::string& text)
{
  std::istringstream is(text);
  return IT::read_gluing(is);
}

void expect_round_trip(const Delta_complex& c, const std::vector<double>& lengths)
{
  const std::string text = written(c, lengths);
  const IT::Gluing g = read(text);
  EXPECT_TRUE(g.complex.is_valid(true));
  EXPECT_EQ(g.complex, c) << text;
  EXPECT_EQ(g.lengths, lengths);
  EXPECT_EQ(written(g.complex, g.lengths), text);
}

void expect_refused(const std::string& text, Defect defect, std::size_t line, const std::string& word)
{
  try {
    read(text);
    FAIL() << "was accepted:\n" << text;
  } catch (const IT::Invalid_surface_error& e) {
    EXPECT_EQ(e.defect(), defect) << e.what();
    EXPECT_EQ(e.element(), line) << e.what();
    EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
}

const char* const square = "INTRINSIC_GLUING 1\n"
                           "4 5 2\n"
                           "0 1 2\n"
                           "0 2 3\n"
                           "0 -1 1\n"
                           "1 -1 1\n"
                           "2 3 1.5\n"
                           "4 -1 1\n"
                           "5 -1 1\n";

std::string with_line(int number, const std::string& replacement)
{
  std::istringstream is(square);
  std::string result, line;
  for (int i = 1; std::getline(is, line); ++i)
    result += (i == number ? replacement : line) + "\n";
  return result;
}

struct Comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

} // namespace

TEST(Delta_complex_io, every_surface_returns_also_after_flips)
{
  std::mt19937 random(1);
  for (Delta_complex c : all_surfaces()) {
    expect_round_trip(c, some_lengths(c, random));
    if (c.number_of_edges() == 0)
      continue;
    std::uniform_int_distribution<std::uint32_t> any_edge(0, c.number_of_edges() - 1);
    for (int i = 0; i < 50; ++i) {
      const Edge_index e(any_edge(random));
      if (c.is_flippable(e))
        c.flip(e);
      expect_round_trip(c, some_lengths(c, random));
    }
  }
}

TEST(Delta_complex_io, a_border_halfedge_may_come_first)
{
  const IT::Gluing g = read(with_line(5, "-1 0 1"));
  EXPECT_TRUE(g.complex.is_valid(true));
  EXPECT_TRUE(g.complex.is_border(Halfedge_index(0)));
  EXPECT_EQ(g.complex.face(Halfedge_index(1)), Face_index(0));
  EXPECT_EQ(g.complex.source(Halfedge_index(1)), Vertex_index(0));
  expect_round_trip(g.complex, g.lengths);
}

TEST(Delta_complex_io, lengths_return_to_the_last_bit)
{
  const Delta_complex c = IT::make_Delta_complex_from_triangles(3, Triangles{{0, 1, 2}});
  const double smallest = 0x1p-1074;
  expect_round_trip(c, {0.1, 1. / 3., smallest});
  expect_round_trip(c, {(std::numeric_limits<double>::max)(), std::nextafter(1., 2.), 1e22});
}

TEST(Delta_complex_io, the_text_is_as_documented)
{
  EXPECT_EQ(written(read(square).complex, {1, 1, 1.5, 1, 1}), square);
}

TEST(Delta_complex_io, locale_and_format_of_the_stream_do_not_matter)
{
  const std::locale comma(std::locale::classic(), new Comma);
  const IT::Gluing g = read(square);
  std::ostringstream os;
  os.imbue(comma);
  os << std::setprecision(3) << std::hex << std::showbase;
  IT::write_gluing(os, g.complex, g.lengths);
  EXPECT_EQ(os.str(), square);
  std::istringstream is(square);
  is.imbue(comma);
  EXPECT_EQ(IT::read_gluing(is).lengths, g.lengths);
}

TEST(Delta_complex_io, comments_blanks_and_foreign_line_ends_are_skipped)
{
  const std::string text = "# a square\n\nINTRINSIC_GLUING 1 # version\r\n4 5 2\r\n  0 1\t2\r\n"
                           "0 2 3#\n0 -1 1\n1 -1 1\n\n # diagonal\n2 3 15e-1\n4 -1 1\n5 -1 1";
  const IT::Gluing g = read(text);
  EXPECT_EQ(g.complex, read(square).complex);
  EXPECT_EQ(g.lengths, read(square).lengths);
}

TEST(Delta_complex_io, defects_are_named_with_their_line)
{
  expect_refused("", Defect::UNREADABLE, 0, "ends");
  expect_refused("OFF\n", Defect::UNREADABLE, 1, "1 field instead of 2");
  expect_refused("OFF 1\n", Defect::UNREADABLE, 1, "INTRINSIC_GLUING");
  expect_refused(with_line(1, "INTRINSIC_GLUING 2"), Defect::UNREADABLE, 1, "version 2");
  expect_refused(with_line(2, "4 5"), Defect::UNREADABLE, 2, "2 fields instead of");
  expect_refused(with_line(2, "4 5 two"), Defect::UNREADABLE, 2, "'two'");
  expect_refused(with_line(2, "-4 5 2"), Defect::UNREADABLE, 2, "negative");
  expect_refused(with_line(2, "4 7 2"), Defect::INVALID_GLUING, 2, "7 edges");
  expect_refused(with_line(2, "4 2 2"), Defect::INVALID_GLUING, 2, "2 edges");
  expect_refused(with_line(2, "4294967295 5 2"), Defect::OUT_OF_RANGE, 2, "4294967295");
  expect_refused(with_line(2, "99999999999999999999 5 2"), Defect::UNREADABLE, 2, "integer");
  expect_refused(with_line(2, "2000000000 5 2"), Defect::OUT_OF_RANGE, 2, "isolated");
  expect_refused(with_line(4, "0 2 4"), Defect::BAD_INDEX, 4, "vertex 4");
  expect_refused(with_line(4, "0 2 -1"), Defect::BAD_INDEX, 4, "vertex -1");
  expect_refused(with_line(4, "0 2 3.0"), Defect::UNREADABLE, 4, "'3.0'");
  expect_refused(with_line(7, "2 6 1.5"), Defect::INVALID_GLUING, 7, "side 6");
  expect_refused(with_line(7, "2 -2 1.5"), Defect::INVALID_GLUING, 7, "side -2");
  expect_refused(with_line(7, "2 2 1.5"), Defect::INVALID_GLUING, 7, "side 2");
  expect_refused(with_line(7, "2 1 1.5"), Defect::INVALID_GLUING, 7, "side 1");
  expect_refused(with_line(7, "-1 -1 1.5"), Defect::INVALID_GLUING, 7, "without a face");
  expect_refused(with_line(7, "2 4 1.5"), Defect::INVALID_GLUING, 7, "same vertices");
  expect_refused(with_line(7, "2 -1 1.5"), Defect::INVALID_GLUING, 9, "side 3");
  for (const char* length : {"0", "-1", "nan", "inf", "1e999", "0x1p3", "1,5", "1.5x", "--"}) {
    const std::string line = std::string("2 3 ") + length;
    const bool is_number = length == std::string("0") || length == std::string("-1");
    expect_refused(with_line(7, line), is_number ? Defect::NOT_FINITE : Defect::UNREADABLE, 7, length);
  }
  expect_refused(with_line(9, ""), Defect::UNREADABLE, 9, "ends");
  expect_refused(std::string(square) + "0 -1 1\n", Defect::UNREADABLE, 10, "follows");
}

TEST(Delta_complex_io, two_fans_at_a_vertex_are_refused)
{
  expect_refused("INTRINSIC_GLUING 1\n5 6 2\n0 1 2\n2 3 4\n0 -1 1\n1 -1 1\n2 -1 1\n3 -1 1\n4 -1 1\n5 -1 1\n",
                 Defect::NON_MANIFOLD_VERTEX, 2, "vertex 2");
}

TEST(Delta_complex_io, nothing_is_written_for_unusable_lengths)
{
  const Delta_complex c = read(square).complex;
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : {0., -1., infinity, std::numeric_limits<double>::quiet_NaN()}) {
    std::ostringstream os;
    try {
      IT::write_gluing(os, c, {1, 1, 1, bad, 1});
      FAIL();
    } catch (const IT::Invalid_surface_error& e) {
      EXPECT_EQ(e.defect(), Defect::NOT_FINITE);
      EXPECT_EQ(e.element(), 3u);
    }
    EXPECT_EQ(os.str(), "");
  }
}

// Damaged texts are refused or describe another valid complex.
TEST(Delta_complex_io, random_mutations_do_no_harm)
{
  std::mt19937 random(7);
  std::vector<std::string> texts{square};
  for (const Delta_complex& c : all_surfaces())
    texts.push_back(written(c, std::vector<double>(c.number_of_edges(), 1.25)));
  const std::string alphabet = std::string("0123456789-+.eE# \n\t\rxINTRINSIC_GLUING\xff") + '\0';
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  int accepted = 0, refused = 0;
  for (int i = 0; i < 60000; ++i) {
    std::string text = texts[below(texts.size())];
    for (std::size_t n = 1 + below(4); n > 0; --n) {
      const std::size_t at = below(text.size() + 1);
      const char c = alphabet[below(alphabet.size())];
      switch (below(6)) {
      case 0:
        text.insert(at, 1, c);
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.resize(std::max<std::size_t>(at, 1));
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), 1 + below(12)));
        break;
      default:
        text[at < text.size() ? at : 0] = c;
        break;
      }
      if (text.empty())
        text = " ";
    }
    try {
      const IT::Gluing g = read(text);
      ++accepted;
      ASSERT_TRUE(g.complex.is_valid(true)) << text;
      ASSERT_EQ(g.lengths.size(), g.complex.number_of_edges());
      expect_round_trip(g.complex, g.lengths);
    } catch (const IT::Invalid_surface_error&) {
      ++refused;
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 20000);
}

TEST(Exact_gluing_io, squared_lengths_return_whatever_their_size)
{
  using IT::internal::Integer;
  using IT::internal::Rational;
  std::mt19937 random(1);
  for (const Delta_complex& c : all_surfaces()) {
    std::vector<Rational> squared_lengths;
    for (std::size_t e = 0; e < c.number_of_edges(); ++e)
      squared_lengths.push_back(
        Rational(pow(Integer(3), random() % 5000) + random(), pow(Integer(2), random() % 5000)));
    std::stringstream text;
    IT::write_exact_gluing(text, c, squared_lengths);
    EXPECT_EQ(text.str().compare(0, 18, "INTRINSIC_GLUING 2"), 0);
    const IT::Exact_gluing gluing = IT::read_exact_gluing(text);
    EXPECT_EQ(gluing.complex, c);
    EXPECT_EQ(gluing.squared_lengths, squared_lengths);
    EXPECT_TRUE(gluing.lengths.empty());
  }
  std::istringstream first_version(square);
  const IT::Exact_gluing gluing = IT::read_exact_gluing(first_version);
  EXPECT_EQ(gluing.lengths, read(square).lengths);
  EXPECT_TRUE(gluing.squared_lengths.empty());
}

TEST(Exact_gluing_io, defects_are_named_with_their_line)
{
  const auto message = [](const std::string& version, const std::string& field) -> std::string {
    std::istringstream is("INTRINSIC_GLUING " + version + "\n3 3 1\n0 1 2\n0 -1 25/4\n1 -1 10\n2 -1 " + field + "\n");
    try {
      const IT::Exact_gluing gluing = IT::read_exact_gluing(is);
      return gluing.squared_lengths[2].str();
    } catch (const IT::Invalid_surface_error& e) {
      return e.what();
    }
  };
  EXPECT_EQ(message("2", "010"), "10");
  EXPECT_EQ(message("2", "6/4"), "3/2");
  for (const char* field : {"-1", "1.5", "1e3", "0x10", "1/", "/2", "1/2/3", "1/0", "+1", "1/-2", "nan", "\x1b"})
    EXPECT_EQ(message("2", field).compare(0, 10, "line 6 has"), 0) << message("2", field);
  for (const char* field : {"0", "0/5"})
    EXPECT_NE(message("2", field).find("not positive"), std::string::npos);
  EXPECT_NE(message("2", std::string(1000001, '9')).find("more than a million digits"), std::string::npos);
  EXPECT_EQ(message("2", std::string(1000000, '9')), std::string(1000000, '9'));
  EXPECT_NE(message("3", "1").find("line 1 asks for version 3"), std::string::npos);
  EXPECT_NE(message("1", "1").find("line 4 has '25/4' where a length is expected"), std::string::npos);
  std::ostringstream os;
  EXPECT_THROW(IT::write_exact_gluing(os, read(square).complex, std::vector<IT::internal::Rational>{1, 1, 1, 1, 0}),
               IT::Invalid_surface_error);
  EXPECT_EQ(os.str(), "");
}
