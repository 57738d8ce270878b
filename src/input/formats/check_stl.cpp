// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Text_check.h"
#include "input/formats/text_file.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace idt {
namespace {

bool is_text_stl(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\n\v\f\r");
  return begin != std::string::npos && text.compare(begin, 5, "solid") == 0 && begin + 5 < text.size() &&
         (text[begin + 5] == ' ' || text[begin + 5] == '\n' || text[begin + 5] == '\r');
}

} // namespace

// Goes through a text word by word and refuses the first facet that is not as
// it should be; returns if there is none, or if the file is not text.
void diagnose_stl(const std::string& path, const std::string& text)
{
  if (!is_text_stl(text))
    return;
  Scanner scanner(text);
  std::size_t facet = 0, corners = 0;
  bool is_in_facet = false, is_ended = false;
  for (std::string word = scanner.word(); !word.empty(); word = scanner.word()) {
    is_ended = is_ended || word == "endsolid";
    if (word == "facet") {
      is_in_facet = true;
      corners = 0;
    } else if (word == "endfacet" || (word == "vertex" && corners == 3)) {
      if (word == "vertex" || corners != 3)
        refuse(path, place(scanner, "facet", facet) + ": the facet does not have three vertices",
               Defect::NOT_A_TRIANGLE, facet);
      is_in_facet = false;
      ++facet;
    } else if (word == "vertex" && is_in_facet) {
      ++corners;
      for (int i = 0; i < 3; ++i) {
        const std::string coordinate = scanner.word_on_line();
        if (coordinate.empty())
          refuse(path,
                 place(scanner, "facet", facet) + ": a vertex has " + std::to_string(i) +
                   " numbers where 3 are needed",
                 Defect::UNREADABLE, facet);
        check_coordinate(path, coordinate, place(scanner, "facet", facet), facet);
      }
    }
  }
  if (is_in_facet || !is_ended)
    refuse(path,
           "the file ends " + std::string(is_in_facet ? "within" : "after") + " facet " +
             std::to_string(facet - (is_in_facet || facet == 0 ? 0 : 1)) + ", without a line endsolid",
           Defect::UNREADABLE, facet);
}

namespace {

// CGAL's reader takes the third coordinate up to what is no number: "0 0 1,5" is another vertex then.
class Stl_text_check : public Word_check
{
public:
  explicit Stl_text_check(const std::string& path) : path_(path) {}

  void restart() override
  {
    Word_check::restart();
    coordinates_ = facets_ = 0;
    is_in_facet_ = false;
  }

private:
  void word(const char* const first, const char* const last) override
  {
    if (coordinates_ > 0) {
      --coordinates_;
      if (skip_plain_number(first, last) == last)
        return;
      const std::string coordinate(first, last);
      if (is_coordinate(coordinate))
        return;
      // To say what is wrong takes longer than to see it.
      diagnose_stl(path_, load(path_));
      check_coordinate(path_, coordinate,
                       "line " + std::to_string(number()) + " (facet " + std::to_string(facets_) + ")", facets_);
    }
    const auto is = [&](const char* const name, const std::size_t size) {
      return static_cast<std::size_t>(last - first) == size && std::memcmp(first, name, size) == 0;
    };
    if (is("vertex", 6))
      coordinates_ = is_in_facet_ ? 3 : 0;
    else if (is("facet", 5))
      is_in_facet_ = true;
    else if (is("endfacet", 8)) {
      is_in_facet_ = false;
      ++facets_;
    }
  }

  std::string path_;
  std::size_t coordinates_ = 0; // how many are still to come
  std::size_t facets_ = 0;
  bool is_in_facet_ = false;
};

// Binary files may begin with the word of a text, for which CGAL's reader takes them then.
bool is_binary_stl(const std::string& head, const std::uint32_t facets, const std::uintmax_t file_size)
{
  const std::uintmax_t size = 84 + std::uintmax_t(50) * facets;
  if (head.size() < 84 || file_size < size)
    return false;
  return !is_text_stl(head) || file_size == size ||
         std::any_of(head.begin() + 80, head.begin() + 84, [](char c) { return (c < ' ' && !is_white(c)) || c > '~'; });
}

[[noreturn]] void refuse_neither(const std::string& path, const std::string& head, const std::uint32_t facets,
                                 const std::uintmax_t file_size)
{
  std::string begin = head.substr((std::min)(head.find_first_not_of(" \t\n\v\f\r"), head.size()), 6);
  std::transform(begin.begin(), begin.end(), begin.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (begin.compare(0, 3, "\xef\xbb\xbf") == 0)
    refuse(path, "the file begins with a byte order mark: save it as UTF-8 without one");
  if (begin.compare(0, 5, "solid") == 0)
    refuse(path, "the file begins with " + quote(head.substr(head.find_first_not_of(" \t\n\v\f\r"), 6)) +
                   ": text STL begins with solid, in small letters and with a blank or the end of the line behind it");
  refuse(path, "neither text STL (the first word is not solid) nor binary STL (" +
                 (head.size() < 84 ? std::string("shorter than the header of 84 bytes")
                                   : "the header announces " + std::to_string(facets) + " facets, the file has room for " +
                                       std::to_string((file_size - 84) / 50)) +
                 ")");
}

} // namespace

// What CGAL's reader would trust: that the first word tells text from binary,
// that the number of facets is right, and that the coordinates can be compared.
Prepared_text check_stl(const std::string& path, const std::uintmax_t file_size)
{
  const std::string head = load(path, 4096);
  std::uint32_t facets = 0;
  if (head.size() >= 84)
    std::memcpy(&facets, &head[80], 4);
  if (!is_binary_stl(head, facets, file_size)) {
    if (!is_text_stl(head))
      refuse_neither(path, head, facets, file_size);
    // The reader takes any file as empty that is shorter than a binary header.
    if (head.size() < 84)
      diagnose_stl(path, head);
    return {std::make_unique<Stl_text_check>(path), std::nullopt};
  }
  std::string text = load(path);
  for (std::size_t f = 0; f < facets; ++f) {
    float corner[9];
    std::memcpy(corner, &text[84 + 50 * f + 12], sizeof(corner));
    for (const float c : corner)
      if (!std::isfinite(c))
        refuse(path, "facet " + std::to_string(f) + ": a coordinate is not finite", Defect::NOT_FINITE, f);
  }
  if (!is_text_stl(head))
    return {};
  // Nothing that looks like the beginning of a text.
  text.replace(0, 80, 80, '-');
  return {nullptr, std::move(text)};
}

} // namespace idt
