// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Textured_mesh.h"

#include "output/Output_file.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <Eigen/Core>

#include <boost/crc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

std::string big_endian(std::uint32_t x) { return {char(x >> 24), char(x >> 16), char(x >> 8), char(x)}; }

std::string png_chunk(const std::string& type_and_data)
{
  boost::crc_32_type crc;
  crc.process_bytes(type_and_data.data(), type_and_data.size());
  return big_endian(std::uint32_t(type_and_data.size() - 4)) + type_and_data + big_endian(crc.checksum());
}

// One bit for each pixel, not compressed, which needs no PNG library. `squares` in each direction, of 16 pixels.
std::string checkerboard_png(std::uint32_t squares)
{
  const std::uint32_t size = 16 * squares;
  std::string rows;
  for (std::uint32_t y = 0; y < size; ++y) {
    rows += '\0'; // no filter
    for (std::uint32_t x = 0; x < squares; ++x)
      rows += (x + y / 16) % 2 == 0 ? std::string(2, '\xff') : std::string(2, '\0');
  }
  std::uint32_t a = 1, b = 0; // Adler-32
  for (unsigned char c : rows) {
    a = (a + c) % 65521;
    b = (b + a) % 65521;
  }
  const auto length = std::uint16_t(rows.size());
  const std::string stored = {
    '\x78', '\x01', '\x01', char(length), char(length >> 8), char(~length), char(std::uint16_t(~length) >> 8)};
  const std::string header =
    "IHDR" + big_endian(size) + big_endian(size) + std::string({1, 0, 0, 0, 0}); // one bit, grey
  return "\x89PNG\r\n\x1a\n" + png_chunk(header) + png_chunk("IDAT" + stored + rows + big_endian(b << 16 | a)) +
         png_chunk("IEND");
}

} // namespace

Textured_mesh make_map_over_input(const Surface& surface, const IT::Planar_points& uv)
{
  Textured_mesh mesh{surface.points, uv, {}, {}, false};
  const IT::Delta_complex& complex = surface.connectivity;
  mesh.faces.reserve(complex.number_of_faces());
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    mesh.faces.push_back({complex.source(h).idx(), complex.target(h).idx(), complex.target(complex.next(h)).idx()});
  }
  return mesh;
}

Textured_mesh make_map_over_intrinsic(const Surface& surface, const IT::Common_subdivision& subdivision,
                                      const IT::Planar_points& uv)
{
  const IT::Overlay& graph = subdivision.overlay();
  Textured_mesh mesh;
  mesh.points.reserve(graph.number_of_vertices());
  for (IT::Overlay::Vertex v : graph.vertices())
    mesh.points.push_back(subdivision.point(v, surface.points));

  std::vector<Eigen::Vector2d> images;
  images.reserve(uv.size());
  for (const auto& [u, v] : uv)
    images.emplace_back(u, v);
  mesh.uv.reserve(graph.number_of_vertices());
  for (const Eigen::Vector2d& p : IT::interpolate_intrinsic_values(subdivision, images))
    mesh.uv.push_back({p.x(), p.y()});

  mesh.faces.reserve(graph.number_of_faces());
  for (IT::Overlay::Face f : graph.faces()) {
    std::vector<std::size_t>& corners = mesh.faces.emplace_back();
    const IT::Overlay::Halfedge first = graph.halfedge(f);
    IT::Overlay::Halfedge h = first;
    do {
      corners.push_back(graph.target(h).idx());
      h = graph.next(h);
    } while (h != first);
  }
  return mesh;
}

std::vector<std::string> textured_mesh_paths(const std::string& obj_path)
{
  const std::filesystem::path path(obj_path);
  return {obj_path, std::filesystem::path(path).replace_extension(".mtl").string(),
          std::filesystem::path(path).replace_extension(".png").string()};
}

void write_textured_mesh(const std::string& obj_path, const Textured_mesh& mesh)
{
  std::array<double, 2> low = mesh.uv.front(), high = mesh.uv.front();
  for (const std::array<double, 2>& p : mesh.uv)
    for (int i = 0; i < 2; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  double size = (std::max)(high[0] - low[0], high[1] - low[1]);
  if (mesh.is_exact) {
    low = {0, 0};
    size = std::ldexp(1., std::ilogb(size) + 1);
  }
  const std::vector<std::string> paths = textured_mesh_paths(obj_path);

  Output_file obj(paths[0]), material(paths[1]), image(paths[2]);
  image.stream() << checkerboard_png(32);
  material.stream() << "newmtl checkerboard\nKd 1 1 1\nmap_Kd " << std::filesystem::path(paths[2]).filename().string()
                    << '\n';
  std::ostream& os = obj.stream();
  os << "mtllib " << std::filesystem::path(paths[1]).filename().string() << '\n';
  for (const std::array<double, 3>& p : mesh.points)
    os << "v " << in_full(p[0]) << ' ' << in_full(p[1]) << ' ' << in_full(p[2]) << '\n';
  for (const std::array<double, 2>& p : mesh.uv)
    os << "vt " << in_full((p[0] - low[0]) / size) << ' ' << in_full((p[1] - low[1]) / size) << '\n';
  os << "usemtl checkerboard\n";
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<std::size_t>& uv = mesh.uv_of_faces.empty() ? mesh.faces[f] : mesh.uv_of_faces[f];
    os << 'f';
    for (std::size_t i = 0; i < uv.size(); ++i)
      os << ' ' << mesh.faces[f][i] + 1 << '/' << uv[i] + 1;
    os << '\n';
  }
  image.commit();
  material.commit();
  obj.commit();
}

} // namespace idt
