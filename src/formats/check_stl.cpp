// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include "text_file.h"

#include <cmath>
#include <cstddef>
#include <cstring>

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

// What CGAL's reader would trust: that the first word tells text from binary,
// that the number of facets is right, and that the coordinates can be compared.
void check_stl(const std::string& path, const std::uintmax_t file_size)
{
  const std::string head = load(path, 4096);
  std::uint32_t facets = 0;
  if (head.size() >= 84)
    std::memcpy(&facets, &head[80], 4);
  const bool may_be_text = is_text_stl(head);
  if (head.size() < 84 || file_size < 84 + std::uintmax_t(50) * facets) {
    if (may_be_text) {
      // The reader takes any file as empty that is shorter than a binary header.
      if (head.size() < 84)
        diagnose_stl(path, head);
      return;
    }
    refuse(path, "neither text STL (the first word is not solid) nor binary STL (" +
                   (head.size() < 84
                      ? std::string("shorter than the header of 84 bytes")
                      : "the header announces " + std::to_string(facets) + " facets, the file has room for " +
                          std::to_string((file_size - 84) / 50)) +
                   ")");
  }
  const std::string text = load(path);
  for (std::size_t f = 0; f < facets; ++f) {
    float corner[9];
    std::memcpy(corner, &text[84 + 50 * f + 12], sizeof(corner));
    for (const float c : corner)
      if (!std::isfinite(c))
        refuse(path, "facet " + std::to_string(f) + ": a coordinate is not finite", Defect::NOT_FINITE, f);
  }
}

} // namespace idt
