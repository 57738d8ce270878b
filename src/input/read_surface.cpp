// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/read_surface.h"

#include "input/formats/Watched_file.h"
#include "input/formats/checks.h"
#include "input/formats/polygon_soup.h"
#include "input/formats/text_file.h"
#ifdef IDT_READS_VTP
#include "input/formats/vtp.h"
#endif

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <exception>
#include <istream>
#include <stdexcept>

namespace idt {
namespace {

std::string lower_case(std::string text)
{
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool read_soup(std::istream& in, const std::string& extension, Points& points, Polygons& polygons)
{
  const auto quiet = CGAL::parameters::verbose(false);
  CGAL::IO::set_mode(in, extension == "ply" || extension == "stl" ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  if (extension == "off")
    return CGAL::IO::read_OFF(in, points, polygons, quiet);
  if (extension == "obj")
    return CGAL::IO::read_OBJ(in, points, polygons, quiet);
  if (extension == "ply")
    return CGAL::IO::read_PLY(in, points, polygons, quiet);
  if (extension == "stl")
    return CGAL::IO::read_STL(in, points, polygons, quiet);
  return CGAL::IO::read_GOCAD(in, points, polygons, quiet);
}

Prepared_text prepare(const std::string& path, const std::string& extension, std::uintmax_t size)
{
  if (extension == "off" || extension == "obj" || extension == "ply" || extension == "ts")
    check_encoding(path);
  if (extension == "off")
    return check_off(path, size);
  if (extension == "obj")
    return check_obj(path);
  if (extension == "ply")
    return check_ply(path, size);
  if (extension == "stl")
    return check_stl(path, size);
  if (extension == "ts")
    return check_ts(path);
  return {};
}

// Lets CGAL's reader at a file or a text. What the check says goes before what comes of it.
template <class Watched_buffer>
bool read_soup(Watched_buffer& buffer, Text_check* const check, const std::string& path, const std::string& extension,
               Points& points, Polygons& polygons)
{
  std::istream in(&buffer);
  bool is_read = false;
  try {
    is_read = read_soup(in, extension, points, polygons);
  } catch (const std::length_error&) {
    buffer.throw_what_was_found();
    throw;
  }
  if (buffer.is_cancelled())
    throw CGAL::Intrinsic_triangulations::Cancelled_error(path + ": cancelled while it was read");
  buffer.throw_what_was_found();
  if (check != nullptr && (is_read || in.eof()))
    check->finish();
  return is_read;
}

bool read_soup(const std::string& path, const std::string& extension, std::uintmax_t size,
               Prepared_text& prepared,
               const CGAL::Intrinsic_triangulations::Progress_function& progress, Points& points,
               Polygons& polygons)
{
  if (prepared.text) {
    Watched_text text(*prepared.text, progress);
    return read_soup(text, nullptr, path, extension, points, polygons);
  }
#ifdef IDT_READS_VTP
  if (extension == "vtp") {
    read_vtp(path, points, polygons);
    return true;
  }
#endif
  Watched_file file(path, size, progress);
  if (extension == "obj")
    file.filter_obj();
  file.look_with(prepared.check.get());
  return read_soup(file, prepared.check.get(), path, extension, points, polygons);
}

// The extension in lower case, once it is clear that the file can be opened.
std::string check_name(const std::string& path, const std::uintmax_t size)
{
  static const std::string known = "known are .off, .obj, .ply, .stl, .ts, .gluing"
#ifdef IDT_READS_VTP
                                   ", .vtp"
#endif
    ;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos)
    refuse(path, "the name has no extension that tells the format (" + known + ")");
  const std::string extension = lower_case(name.substr(dot + 1));
#ifndef IDT_READS_VTP
  if (extension == "vtp")
    refuse(path, "VTP files can be read only if the command is built with VTK (" + known + ")");
#else
  if (extension != "vtp")
#endif
  if (extension != "off" && extension != "obj" && extension != "ply" && extension != "stl" && extension != "ts")
    refuse(path, "the extension " + quote("." + extension) + " is not known (" + known + ")");
  if (size == 0)
    refuse(path, "the file is empty");
  return extension;
}

} // namespace

Surface_input read_surface(const std::string& path,
                           const CGAL::Intrinsic_triangulations::Progress_function& progress)
{
  const std::uintmax_t size = check_file(path);
  const std::string extension = check_name(path, size);
  Points points;
  Polygons polygons;
  try {
    Prepared_text prepared = prepare(path, extension, size);

    bool is_read = false;
    std::string reason;
    try {
      is_read = read_soup(path, extension, size, prepared, progress, points, polygons);
    } catch (const std::length_error& error) {
      reason = std::string(": ") + error.what();
    }
    if (!is_read) {
      const std::size_t vertices = points.size(), faces = polygons.size();
      Points().swap(points);
      Polygons().swap(polygons);
      if (extension == "off")
        diagnose_off(path, load(path));
      else if (extension == "stl")
        diagnose_stl(path, load(path));
      else if (extension != "ts" && reason.empty())
        diagnose_by_position(path, extension);
      refuse(path, "the file cannot be read" + reason +
                     (extension == "off" ? std::string()
                                         : " (stopped after " + std::to_string(vertices) + " vertices and " +
                                             std::to_string(faces) + " faces)"));
    }
  } catch (const CGAL::Intrinsic_triangulations::Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse(path, "there is not enough memory for this file");
  } catch (const std::exception& error) {
    refuse(path, std::string("the file cannot be read: ") + error.what());
  }

  Surface_input input;
  input.path = path;
  input.points.reserve(points.size());
  for (const auto& p : points)
    input.points.push_back({{p.x(), p.y(), p.z()}});
  Points().swap(points);
  const bool is_triangulated = std::all_of(polygons.begin(), polygons.end(),
                                           [](const Corners& c) { return c.size() == 3; });
  if (is_triangulated) {
    input.triangles.reserve(polygons.size());
    for (const Corners& c : polygons)
      input.triangles.push_back({{c[0], c[1], c[2]}});
    return input;
  }
  input.first_corner.reserve(polygons.size() + 1);
  input.first_corner.push_back(0);
  for (const Corners& c : polygons) {
    input.corners.insert(input.corners.end(), c.begin(), c.end());
    input.first_corner.push_back(input.corners.size());
  }
  return input;
}

std::vector<Surface_input::Polygon> Surface_input::polygons() const
{
  std::vector<Polygon> result;
  result.reserve(number_of_faces());
  for (std::size_t f = 0; f < number_of_faces(); ++f)
    result.push_back(polygon(f));
  return result;
}

CGAL::Intrinsic_triangulations::Surface_report examine(const Surface_input& input)
{
  if (input.is_triangulated())
    return CGAL::Intrinsic_triangulations::examine_polygons(input.points, input.triangles);
  return CGAL::Intrinsic_triangulations::examine_polygons(input.points, input.polygons());
}

} // namespace idt
