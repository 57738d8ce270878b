// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A view as a page: one file, which needs no other and no network.

#include "view/View.h"

#include "output/Output_file.h"
#include "view/page_parts.h"

#include <nlohmann/json.hpp>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

// The bytes of a number, the lowest first, whatever this machine does. Numbers are floats in a page.
void append(std::string& bytes, std::uint8_t number) { bytes.push_back(char(number)); }
void append(std::string& bytes, std::uint32_t number)
{
  boost::endian::native_to_little_inplace(number);
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
void append(std::string& bytes, float number)
{
  std::uint32_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  append(bytes, bits);
}
void append(std::string& bytes, double number) { append(bytes, float(number)); }

// In base64, whose last group is filled up.
template <class Number>
void write_array(std::ostream& os, const std::string& name, const std::vector<Number>& numbers)
{
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string bytes;
  for (Number x : numbers)
    append(bytes, x);
  os << "<script type=\"text/plain\" id=\"array-" << name << "\">";
  std::copy(Letters(bytes.cbegin()), Letters(bytes.cend()), std::ostreambuf_iterator<char>(os));
  os << std::string((3 - bytes.size() % 3) % 3, '=') << "</script>\n";
}

// The box of the points: its middle, half of its longest side, and how far points are from the middle.
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
  Json json = {{"title", view.title},  {"result", view.result},     {"center", box.center},   {"scale", box.scale},
               {"radius", box.radius}, {"vertices", Json::array()}, {"fields", Json::array()}};
  for (const View_triangulation& t : view.triangulations)
    json["vertices"].push_back(t.number_of_vertices);
  for (const View_field& field : view.fields)
    json["fields"].push_back(
      {{"name", field.name},
       {"unit", field.unit},
       {"of", std::vector<std::string>(field.numbers.size(), field.is_of_faces ? "faces" : "vertices")}});
  return json;
}

// No name ends the script.
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
  os << page_html << "<script type=\"application/json\" id=\"page\">" << script_text(description(view, box))
     << "</script>\n";
  write_array(os, "places", box.inside(view.points));
  write_array(os, "corners", view.corners);
  write_array(os, "sides", view.sides);
  write_array(os, "path", box.inside(view.path));
  for (std::size_t t = 0; t < view.triangulations.size(); ++t) {
    const View_triangulation& triangulation = view.triangulations[t];
    const std::string number = "-" + std::to_string(t);
    write_array(os, "faces" + number, view.faces[t]);
    write_array(os, "corners" + number, triangulation.corners);
    write_array(os, "sides" + number, triangulation.sides);
    write_array(os, "cotangents" + number, triangulation.cotangents);
    write_array(os, "weights" + number, triangulation.weights);
    write_array(os, "lengths" + number, triangulation.lengths);
  }
  for (std::size_t f = 0; f < view.fields.size(); ++f)
    for (std::size_t t = 0; t < view.fields[f].numbers.size(); ++t)
      write_array(os, "field-" + std::to_string(f) + "-" + std::to_string(t), view.fields[f].numbers[t]);
  os << "<script>" << page_three << "</script>\n<script>\n" << page_script << "</script>\n</html>\n";
}

} // namespace

void write_view(const std::string& path, const View& view)
{
  write_file(path, [&view](std::ostream& os) { write_page(os, view); });
}

} // namespace idt
