// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thousands of small damages to valid files of every format: each file is read with exactly its faces, as an
// independent reading finds them, or is refused with a message that says where.

#include "Surface_file_test.h"
#include "faces_of_file.h"
#include "input/gluing_file.h"
#include "valid_files.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <vector>

namespace {

typedef std::vector<std::string> Lines;

Lines split(const std::string& text)
{
  Lines lines(1);
  for (const char c : text)
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += c;
  return lines;
}
std::string join(const Lines& lines)
{
  std::string text = lines.front();
  for (std::size_t i = 1; i < lines.size(); ++i)
    text += '\n' + lines[i];
  return text;
}

class Mutator
{
public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(const std::string& text, bool is_binary)
  {
    std::string result = text;
    for (std::size_t n = below(4) == 0 ? 2 : 1; n > 0; --n)
      result = is_binary && below(4) != 0 ? change_bytes(result) : change_line(result);
    return result;
  }

private:
  std::size_t below(std::size_t n) { return random_() % n; }

  std::string change_line(const std::string& text)
  {
    Lines lines = split(text);
    const std::size_t l = below(lines.size());
    std::string& line = lines[l];
    switch (below(14)) {
    case 0:
      lines.erase(lines.begin() + std::ptrdiff_t(l));
      break;
    case 1:
      lines.insert(lines.begin() + std::ptrdiff_t(l), line);
      break;
    case 2:
      std::swap(line, lines[below(lines.size())]);
      break;
    case 3: // joined with the next
      if (l + 1 < lines.size()) {
        line += (below(2) == 0 ? " " : "") + lines[l + 1];
        lines.erase(lines.begin() + std::ptrdiff_t(l) + 1);
      }
      break;
    case 4: // misspelt
      if (!line.empty())
        line[below(line.size())] = char(below(3) == 0 ? ' ' : 'a' + below(26));
      break;
    case 5:
      if (!line.empty())
        line.erase(below((std::min<std::size_t>)(line.size(), 8)), 1);
      break;
    case 6:
      for (char& c : line)
        c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
      break;
    case 7: // a number changed by one
    case 8:
      change_number(line);
      break;
    case 9:
      line += below(2) == 0 ? " 1" : " 0 2";
      break;
    case 10: // without its last word
      line.resize((std::min)(line.find_last_of(" \t"), line.size()));
      break;
    case 11: // cut in two
      line.insert(below(line.size() + 1), "\n");
      break;
    case 12:
      line = below(2) == 0 ? "  \t" : "# " + line;
      break;
    default:
      return change_bytes(text);
    }
    return lines.empty() ? std::string() : join(lines);
  }

  void change_number(std::string& line)
  {
    const std::size_t at = line.find_first_of("0123456789", below(line.size() + 1));
    if (at == std::string::npos)
      return;
    char& digit = line[at];
    digit = char(below(2) == 0 ? (digit == '9' ? '8' : digit + 1) : (digit == '0' ? '1' : digit - 1));
  }

  std::string change_bytes(std::string text)
  {
    if (text.empty())
      return text;
    switch (below(5)) {
    case 0:
      text.resize(below(text.size()));
      break;
    case 1:
      text.append(1 + below(60), "\0\xffx\n3"[below(5)]);
      break;
    case 2:
      text.erase(below(text.size()), 1 + below(3));
      break;
    case 3:
      text.insert(below(text.size()), 1 + below(3), "\0\xffx \n"[below(5)]);
      break;
    default:
      text[below(text.size())] =
        char(below(4) == 0 ? below(256) : unsigned(text[below(text.size())]) + (below(2) == 0 ? 1 : 255));
    }
    return text;
  }

  std::mt19937 random_;
};

class Mutated_files : public Surface_file_test
{};

bool says_where(const std::string& message)
{
  for (const char* const part : {"line ", "facet ", "element ", "byte ", "the file ends", "there is no ", "header",
                                 "is empty", "nothing but", "begins with", "no vertex", "no face", "binary STL",
                                 "no line END", "has no element", "more than fit", "UTF-16", "the list "})
    if (contains(message, part))
      return true;
  return false;
}

TEST_F(Mutated_files, are_read_with_their_faces_or_refused)
{
  const char* const wish = std::getenv("IDT_FILE_MUTATIONS");
  const int rounds = wish == nullptr ? 100 : std::atoi(wish);
  std::size_t read = 0, refused = 0, losses = 0;
  const auto attempt = [&](const Valid_file& file, const std::string& content) {
    const std::string name = write("a." + file.extension, content);
    IT::Polygon_soup soup;
    try {
      soup = IT::read_polygon_soup(name);
    } catch (const IT::Invalid_surface_error& error) {
      ++refused;
      EXPECT_TRUE(says_where(error.what())) << error.what() << "\n" << content;
      return;
    }
    ++read;
    const std::string difference = faces_of_file::difference(file.extension, content, soup);
    losses += !difference.empty();
    if (!difference.empty() && losses < 20)
      ADD_FAILURE() << file.extension << ", " << file.name << ": " << difference << "\n" << content;
  };
  unsigned seed = 0;
  for (const Valid_file& file : valid_files()) {
    attempt(file, file.content);
    Mutator mutator(++seed);
    for (int i = 0; i < rounds; ++i)
      attempt(file, mutator.mutate(file.content, file.is_binary));
  }
  EXPECT_EQ(losses, 0u);
  EXPECT_GT(read, valid_files().size());
  EXPECT_GT(refused, read / 10);
  std::cout << read << " were read, " << refused << " refused, " << losses << " lost faces or gained some" << std::endl;
}

// The defect of a gluing that was read, or empty. Each row is a face or an edge.
std::string difference_of_gluing(std::string content, const IT::Exact_gluing& gluing)
{
  using namespace faces_of_file;
  std::replace(content.begin(), content.end(), '\r', '\n');
  const std::vector<Row> all = rows(content, '#');
  const IT::Delta_complex& complex = gluing.complex;
  if (all.size() < 2 || all.size() != 2 + complex.number_of_faces() + complex.number_of_edges())
    return std::to_string(all.size()) + " rows";
  std::size_t r = 2;
  const auto number = [&](std::size_t i) { return integer(all[r].at(i)); };
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      if (number(i) != (long long)(complex.source(h).idx()))
        return "face " + std::to_string(f.idx());
    ++r;
  }
  for (IT::Edge_index e : complex.edges()) {
    IT::Halfedge_index h = complex.halfedge(e);
    for (std::size_t i = 0; i < 2; ++i, h = complex.opposite(h)) {
      long long side = -1;
      if (!complex.is_border(h)) {
        const IT::Halfedge_index first = complex.halfedge(complex.face(h));
        side = 3 * (long long)(complex.face(h).idx()) + (h == first ? 0 : h == complex.next(first) ? 1 : 2);
      }
      if (number(i) != side)
        return "side " + std::to_string(i) + " of edge " + std::to_string(e.idx());
    }
    if (gluing.squared_lengths.empty() && real(all[r].at(2)) != gluing.lengths[e.idx()])
      return "the length of edge " + std::to_string(e.idx());
    ++r;
  }
  return std::string();
}

TEST_F(Mutated_files, gluings_are_read_with_their_sides_or_refused)
{
  const std::string plain =
    "INTRINSIC_GLUING 1\n4 5 2\n0 1 2\n3 2 1\n# edges\n0 -1 1.5\n4 1 2\n2 -1 1\n3 -1 2.5e0\n5 -1 2\n";
  std::string exact = plain;
  exact[17] = '2';
  exact.replace(exact.find("1.5"), 3, "9/4");
  exact.replace(exact.find("2.5e0"), 5, "25/4");
  std::size_t read = 0, refused = 0;
  const auto attempt = [&](const std::string& content) {
    IT::Exact_gluing gluing;
    try {
      gluing = idt::read_gluing_file(write("a.gluing", content));
    } catch (const IT::Invalid_surface_error& error) {
      ++refused;
      EXPECT_TRUE(says_where(error.what()) || contains(error.what(), "at vertex ")) << error.what() << "\n" << content;
      return;
    }
    ++read;
    EXPECT_EQ(difference_of_gluing(content, gluing), "") << content;
  };
  unsigned seed = 0;
  for (const std::string& file :
       {plain, "\xef\xbb\xbf" + plain, exact, with_line_ends(plain, "\r"), with_line_ends(plain, "\r\n")}) {
    const std::size_t before = read;
    attempt(file);
    EXPECT_EQ(read, before + 1);
    Mutator mutator(++seed);
    for (int i = 0; i < 300; ++i)
      attempt(mutator.mutate(file, false));
  }
  EXPECT_GT(refused, read / 10);
}

} // namespace
