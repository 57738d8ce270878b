// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A view as a page: a single file, which needs neither other files nor a network.

#include "view/View.h"

#include "output/Output_file.h"
#include "view/page_parts.h"

#include <nlohmann/json.hpp>

#ifdef IDT_HAS_ZLIB
#include <zlib.h>
#endif

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <new>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

using Words = std::vector<std::uint32_t>;

std::uint32_t bits_of(float x)
{
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

// Numbers are floats in a page.
template <class Number>
Words words_of(const std::vector<Number>& numbers)
{
  Words words;
  words.reserve(numbers.size());
  for (Number x : numbers)
    words.push_back(bits_of(float(x)));
  return words;
}

void exclude(Words& words, const Words& others)
{
  for (std::size_t i = 0; i < (std::min)(words.size(), others.size()); ++i)
    words[i] ^= others[i];
}

// A difference with its sign in the lowest bit.
std::uint32_t folded(std::uint32_t difference) { return difference << 1 ^ (difference >> 31 ? ~std::uint32_t(0) : 0); }

// The page computes the same estimates, so only the differences have to be stored. An estimate that is rounded
// differently, for instance by a fused product, changes only a last place.
Words cotangents_without_estimates(const View_triangulation& t)
{
  Words words;
  words.reserve(t.cotangents.size());
  for (std::size_t s = 0; s < t.cotangents.size(); ++s) {
    const std::size_t f = s - s % 3;
    const double c = t.lengths[t.sides[s]], a = t.lengths[t.sides[f + (s + 1) % 3]],
                 b = t.lengths[t.sides[f + (s + 2) % 3]];
    const float x = float((a * a + b * b - c * c) / std::sqrt((a + b + c) * (a + b - c) * (c + a - b) * (c + b - a)));
    words.push_back(folded(bits_of(t.cotangents[s]) - bits_of(std::isnan(x) ? 0 : x)));
  }
  return words;
}
Words weights_without_estimates(const View_triangulation& t)
{
  std::vector<float> sums(t.weights.size());
  for (std::size_t s = 0; s < t.sides.size(); ++s)
    sums[t.sides[s]] += t.cotangents[s];
  Words words;
  words.reserve(sums.size());
  for (std::size_t e = 0; e < sums.size(); ++e)
    words.push_back(folded(bits_of(float(t.weights[e])) - bits_of(std::isnan(sums[e]) ? 0 : sums[e])));
  return words;
}

// All arrays one after the other, in a form that compresses well.
struct Packed_arrays
{
  std::string bytes;
  Json places = Json::object(); // where each begins, and how many numbers it has

  void add(const std::string& name, const std::vector<std::uint8_t>& numbers)
  {
    places[name] = {bytes.size(), numbers.size()};
    bytes.append(numbers.begin(), numbers.end());
  }
  // First the lowest bytes of all words, then the next ones.
  void add_words(const std::string& name, const Words& words)
  {
    places[name] = {bytes.size(), words.size()};
    for (int shift = 0; shift < 32; shift += 8)
      for (std::uint32_t word : words)
        bytes.push_back(char(word >> shift & 255));
  }
  // Differences of consecutive numbers.
  void add_integers(const std::string& name, const Words& numbers)
  {
    Words words;
    words.reserve(numbers.size());
    std::uint32_t last = 0;
    for (std::uint32_t x : numbers)
      words.push_back(folded(x - std::exchange(last, x)));
    add_words(name, words);
  }
};

#ifdef IDT_HAS_ZLIB
std::string compressed(const std::string& bytes)
{
  uLongf size = compressBound(uLong(bytes.size()));
  std::string result(size, '\0');
  constexpr int level = 4; // higher ones take longer, and save little
  if (compress2(reinterpret_cast<Bytef*>(&result[0]), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                uLong(bytes.size()), level) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}
#endif

// In base64, whose last group is padded.
void write_base64(std::ostream& os, const std::string& bytes)
{
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::copy(Letters(bytes.cbegin()), Letters(bytes.cend()), std::ostreambuf_iterator<char>(os));
  os << std::string((3 - bytes.size() % 3) % 3, '=');
}

// The box of the points: its middle, half of its longest side, and the largest distance of a point from the middle.
struct Box
{
  explicit Box(const std::vector<std::array<double, 3>>& points)
  {
    std::array<double, 3> half{};
    for (std::size_t i = 0; i < 3 && !points.empty(); ++i) {
      const auto [low, high] =
        std::minmax_element(points.begin(), points.end(), [i](const auto& p, const auto& q) { return p[i] < q[i]; });
      center[i] = (*low)[i] / 2 + (*high)[i] / 2;
      half[i] = (*high)[i] / 2 - (*low)[i] / 2;
    }
    const double size = (std::max)({half[0], half[1], half[2]});
    if (size > 0)
      scale = size;
    for (const auto& p : points)
      radius = (std::max)(
        radius, std::hypot((p[0] - center[0]) / scale, (p[1] - center[1]) / scale, (p[2] - center[2]) / scale));
    if (radius == 0)
      radius = 1;
  }

  // Coordinates from -1 to 1.
  std::vector<float> inside(const std::vector<std::array<double, 3>>& points) const
  {
    std::vector<float> result;
    result.reserve(3 * points.size());
    for (const auto& p : points)
      for (std::size_t i = 0; i < 3; ++i)
        result.push_back(float((p[i] - center[i]) / scale));
    return result;
  }

  std::array<double, 3> center{};
  double scale = 1, radius = 0;
};

Json description(const View& view, const Box& box)
{
  Json json = {{"title", view.title},     {"result", view.result},  {"center", box.center},
               {"scale", box.scale},      {"radius", box.radius},   {"vertices", Json::array()},
               {"fields", Json::array()}, {"path", view.path_name}, {"path_unit", view.path_unit},
               {"marks", view.marks_name}};
  for (const View_triangulation& t : view.triangulations)
    json["vertices"].push_back(t.number_of_vertices);
  for (const View_field& field : view.fields)
    json["fields"].push_back(
      {{"name", field.name},
       {"unit", field.unit},
       {"of", std::vector<std::string>(field.numbers.size(), field.is_of_faces ? "faces" : "vertices")}});
  return json;
}

// No name may end the script.
std::string script_text(const Json& json)
{
  std::string result;
  for (char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    result += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return result;
}

void write_page(std::ostream& os, const View& view)
{
  const Box box(view.points);
  Packed_arrays arrays;
  arrays.add_words("places", words_of(box.inside(view.points)));
  arrays.add_integers("corners", view.corners);
  arrays.add("sides", view.sides);
  arrays.add_words("path", words_of(box.inside(view.path)));
  arrays.add_words("path-numbers", words_of(view.path_numbers));
  arrays.add_words("marks", words_of(box.inside(view.marks)));
  if (!view.plane.corners.empty()) {
    const Box plane(view.plane.corners);
    arrays.add_words("plane", words_of(plane.inside(view.plane.corners)));
    arrays.add_words("plane-path", words_of(plane.inside(view.plane.path)));
    arrays.add_words("plane-marks", words_of(plane.inside(view.plane.marks)));
  }
  Words input_lengths, input_cotangents;
  for (std::size_t t = 0; t < view.triangulations.size(); ++t) {
    const View_triangulation& triangulation = view.triangulations[t];
    const std::string number = "-" + std::to_string(t);
    arrays.add_integers("faces" + number, view.faces[t]);
    arrays.add_integers("corners" + number, triangulation.corners);
    arrays.add_integers("sides" + number, triangulation.sides);
    Words lengths = words_of(triangulation.lengths), cotangents = cotangents_without_estimates(triangulation);
    if (t == 0) {
      input_lengths = lengths;
      input_cotangents = cotangents;
    } else { // most faces are those of the input
      exclude(lengths, input_lengths);
      exclude(cotangents, input_cotangents);
    }
    arrays.add_words("lengths" + number, lengths);
    arrays.add_words("cotangents" + number, cotangents);
    arrays.add_words("weights" + number, weights_without_estimates(triangulation));
  }
  for (std::size_t f = 0; f < view.fields.size(); ++f)
    for (std::size_t t = 0; t < view.fields[f].numbers.size(); ++t)
      arrays.add_words("field-" + std::to_string(f) + "-" + std::to_string(t), words_of(view.fields[f].numbers[t]));
  Json json = description(view, box);
  json["arrays"] = arrays.places;
  json["has_plane"] = !view.plane.corners.empty();
#ifdef IDT_HAS_ZLIB
  json["is_compressed"] = true;
  arrays.bytes = compressed(arrays.bytes);
#endif
  os << page_html << "<script type=\"application/json\" id=\"page\">" << script_text(json)
     << "</script>\n<script type=\"text/plain\" id=\"arrays\">";
  write_base64(os, arrays.bytes);
  os << "</script>\n<script>" << page_three << "</script>\n<script>\n" << page_script << "</script>\n</html>\n";
}

} // namespace

void write_view(const std::string& path, const View& view)
{
  write_file(path, [&view](std::ostream& os) { write_page(os, view); });
}

} // namespace idt
