// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A view as a page: one file, which needs no other and no network.

#include "view/View.h"

#include "output/Output_file.h"
#include "view/page_parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

// Bytes as letters, four for three.
class Base64_writer
{
public:
  explicit Base64_writer(std::ostream& os) : os_(os) {}
  Base64_writer(const Base64_writer&) = delete;
  Base64_writer& operator=(const Base64_writer&) = delete;
  ~Base64_writer()
  {
    const std::size_t n = number_of_bytes_;
    if (n > 0) {
      while (number_of_bytes_ != 0)
        add(std::uint8_t(0));
      text_.replace(text_.size() - (3 - n), 3 - n, 3 - n, '=');
    }
    os_ << text_;
  }

  void add(std::uint8_t byte)
  {
    static constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    if (number_of_bytes_ == 0 && text_.size() >= 65536) {
      os_ << text_;
      text_.clear();
    }
    bits_ = bits_ << 8 | byte;
    if (++number_of_bytes_ < 3)
      return;
    for (int shift = 18; shift >= 0; shift -= 6)
      text_ += letters[bits_ >> shift & 63];
    number_of_bytes_ = 0;
  }
  // The lowest byte first, whatever this machine does.
  void add(std::uint32_t number)
  {
    for (int b = 0; b < 4; ++b)
      add(std::uint8_t(number >> 8 * b & 0xff));
  }
  void add(float number)
  {
    std::uint32_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    add(bits);
  }
  void add(double number) { add(float(number)); }

private:
  std::ostream& os_;
  std::string text_;
  std::uint32_t bits_ = 0;
  std::size_t number_of_bytes_ = 0; // of three
};

template <class Number>
void write_array(std::ostream& os, const std::string& name, const std::vector<Number>& numbers)
{
  os << "<script type=\"text/plain\" id=\"array-" << name << "\">";
  {
    Base64_writer writer(os);
    for (Number x : numbers)
      writer.add(x);
  }
  os << "</script>\n";
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
