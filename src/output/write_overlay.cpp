// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_overlay.h"

#include "input/formats/vtp.h"
#include "system/Long_text.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

enum class Vertex_kind : std::uint8_t {
  INPUT,
  CROSSING,
  INSERTED
};

// The vertices of the file are the vertices of the overlay. Its faces are the faces of the overlay, or the triangles of
// its first face, then of the second, and so on; its edges are the segments.
class Overlay_writer
{
public:
  Overlay_writer(const IT::Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points,
                 bool are_triangles, const std::vector<Named_values>& values)
    : subdivision_(subdivision), overlay_(subdivision_.overlay()), points_(points), values_(values),
      are_triangles_(are_triangles), number_of_faces_(overlay_.number_of_faces()),
      number_of_edges_(overlay_.number_of_segments())
  {
    if (are_triangles_)
      for (IT::Overlay::Face f : overlay_.faces()) {
        const std::size_t corners = corners_of(f).size();
        number_of_faces_ += corners - 3;
        number_of_edges_ += corners - 3;
      }
  }

  // Programs that need triangles do not know edges, either.
  void write_ply(std::ostream& os) const
  {
    os << "ply\nformat binary_little_endian 1.0\n"
          "comment overlay of an input triangulation and an intrinsic one\n"
          "comment kind of a vertex: 0 vertex of the input, 1 crossing, 2 inserted vertex\n"
          "comment input_edge, intrinsic_edge of a vertex: those that meet in a crossing, or -1\n"
          "comment input_face, intrinsic_face of a face: those that contain it\n"
          "comment label of an edge: 0 input, 1 intrinsic, 2 both\n"
          "element vertex "
       << overlay_.number_of_vertices()
       << "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar kind\n"
          "property int input_edge\nproperty int intrinsic_edge\n";
    for (const std::string& name : coordinate_names(values_))
      os << "property double " << name << '\n';
    os << "element face " << number_of_faces_
       << "\nproperty list uchar int vertex_indices\nproperty uint input_face\nproperty uint intrinsic_face\n";
    if (!are_triangles_)
      os << "element edge " << overlay_.number_of_segments()
         << "\nproperty int vertex1\nproperty int vertex2\nproperty uchar label\n";
    os << "end_header\n";
    write_elements(os, overlay_.number_of_vertices(), [this](Long_text& text, std::size_t i) {
      const IT::Overlay::Vertex v(static_cast<std::uint32_t>(i));
      for (double x : subdivision_.point(v, points_))
        text.add_bytes(x);
      text.add_bytes(std::uint8_t(kind(v)))
        .add_bytes(std::uint32_t(input_edge(v)))
        .add_bytes(std::uint32_t(intrinsic_edge(v)));
      for_each_coordinate(values_, i, [&text](double x) { text.add_bytes(x); });
    });
    write_faces(os, [this](Long_text& text, IT::Overlay::Face f, const Corners& corners) {
      text.add_bytes(std::uint8_t(corners.size())); // a part of a pair of triangles has few
      for (std::uint32_t v : corners)
        text.add_bytes(v);
      text.add_bytes(overlay_.input_face(f).idx()).add_bytes(overlay_.intrinsic_face(f).idx());
    });
    if (are_triangles_)
      return;
    write_elements(os, overlay_.number_of_segments(), [this](Long_text& text, std::size_t i) {
      const IT::Overlay::Segment s(static_cast<std::uint32_t>(i));
      const IT::Overlay::Halfedge h = overlay_.halfedge(s);
      text.add_bytes(overlay_.target(h).idx())
        .add_bytes(overlay_.source(h).idx())
        .add_bytes(std::uint8_t(overlay_.label(s)));
    });
  }

  // In the form of CGAL::IO::write_OFF().
  void write_off(std::ostream& os) const
  {
    os << "OFF\n" << overlay_.number_of_vertices() << ' ' << number_of_faces_ << " 0\n\n";
    write_vertices(os, "");
    write_faces(os, [](Long_text& text, IT::Overlay::Face, const Corners& corners) {
      text << corners.size() << ' ';
      for (std::uint32_t v : corners)
        text << ' ' << v;
      text << '\n';
    });
    os << '\n';
  }

  // In the form of CGAL::IO::write_OBJ().
  void write_obj(std::ostream& os) const
  {
    const char* const line = "# ------------------------------------------\n\n";
    os << "# file written from a CGAL tool in Wavefront obj format\n# " << overlay_.number_of_vertices()
       << " vertices\n# " << 2 * number_of_edges_ << " halfedges\n# " << number_of_faces_ << " facets\n\n\n# "
       << overlay_.number_of_vertices() << " vertices\n"
       << line;
    write_vertices(os, "v ");
    os << "\n# " << number_of_faces_ << " facets\n" << line;
    write_faces(os, [](Long_text& text, IT::Overlay::Face, const Corners& corners) {
      text << "f ";
      for (std::uint32_t v : corners)
        text << ' ' << v + 1;
      text << '\n';
    });
    os << "\n# End of Wavefront obj format #\n";
  }

  // Segments are lines, before the faces.
  void write_vtp(std::ostream& os) const
  {
    Named_values kinds{"kind", {}, 1, "UInt8"}, input_edges{"input_edge", {}, 1, "Int32"},
      intrinsic_edges{"intrinsic_edge", {}, 1, "Int32"};
    for (IT::Overlay::Vertex v : overlay_.vertices()) {
      kinds.values.push_back(double(kind(v)));
      input_edges.values.push_back(input_edge(v));
      intrinsic_edges.values.push_back(intrinsic_edge(v));
    }
    Named_values labels{"label", {}, 1, "Int32"}, input_faces{"input_face", {}, 1, "Int32"},
      intrinsic_faces{"intrinsic_face", {}, 1, "Int32"};
    Flat_polygons lines, polygons;
    const auto add_cell = [&](double label, double input_face, double intrinsic_face) {
      labels.values.push_back(label);
      input_faces.values.push_back(input_face);
      intrinsic_faces.values.push_back(intrinsic_face);
    };
    for (IT::Overlay::Segment s : overlay_.segments()) {
      const IT::Overlay::Halfedge h = overlay_.halfedge(s);
      lines.add(std::array<std::uint32_t, 2>{overlay_.source(h).idx(), overlay_.target(h).idx()});
      add_cell(double(overlay_.label(s)), -1, -1);
    }
    for (IT::Overlay::Face f : overlay_.faces())
      for_each_piece(f, [&](const Corners& corners) {
        polygons.add(corners);
        add_cell(-1, overlay_.input_face(f).idx(), overlay_.intrinsic_face(f).idx());
      });
    std::vector<Named_values> at_points = values_;
    at_points.insert(at_points.end(), {kinds, input_edges, intrinsic_edges});
    idt::write_vtp(os, all_points(), polygons, at_points, lines, {input_faces, intrinsic_faces, labels});
  }

  // \pre the faces are triangles
  void write_triangles(std::ostream& os, Mesh_format format) const
  {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(number_of_faces_);
    for (IT::Overlay::Face f : overlay_.faces())
      for_each_piece(f, [&](const Corners& corners) { triangles.push_back({corners[0], corners[1], corners[2]}); });
    write_mesh(os, all_points(), triangles, format);
  }

private:
  using Corners = boost::container::small_vector<std::uint32_t, 8>;

  Corners corners_of(IT::Overlay::Face f) const
  {
    Corners corners;
    const IT::Overlay::Halfedge first = overlay_.halfedge(f);
    IT::Overlay::Halfedge h = first;
    do {
      corners.push_back(overlay_.target(h).idx());
      h = overlay_.next(h);
    } while (h != first);
    return corners;
  }

  std::array<double, 3> point(std::uint32_t v) const { return subdivision_.point(IT::Overlay::Vertex(v), points_); }

  std::vector<std::array<double, 3>> places(const Corners& corners) const
  {
    std::vector<std::array<double, 3>> result;
    for (std::uint32_t v : corners)
      result.push_back(point(v));
    return result;
  }

  std::vector<std::array<double, 3>> all_points() const
  {
    std::vector<std::array<double, 3>> result;
    result.reserve(overlay_.number_of_vertices());
    for (IT::Overlay::Vertex v : overlay_.vertices())
      result.push_back(point(v.idx()));
    return result;
  }

  Vertex_kind kind(IT::Overlay::Vertex v) const
  {
    return overlay_.is_crossing(v)   ? Vertex_kind::CROSSING
           : overlay_.is_inserted(v) ? Vertex_kind::INSERTED
                                     : Vertex_kind::INPUT;
  }
  // The numbers of edges are below 2^31.
  std::int32_t input_edge(IT::Overlay::Vertex v) const
  {
    return overlay_.is_crossing(v) ? std::int32_t(overlay_.input_edge(v).idx()) : -1;
  }
  std::int32_t intrinsic_edge(IT::Overlay::Vertex v) const
  {
    return overlay_.is_crossing(v) ? std::int32_t(overlay_.intrinsic_edge(v).idx()) : -1;
  }

  // Calls `visit(corners)` for a face, or for each of its triangles.
  template <class Visit>
  void for_each_piece(IT::Overlay::Face f, const Visit& visit) const
  {
    const Corners corners = corners_of(f);
    if (!are_triangles_ || corners.size() == 3)
      return visit(corners);
    for (const auto& [a, b, c] : IT::triangulate_convex_polygon(places(corners)))
      visit(Corners{corners[a], corners[b], corners[c]});
  }

  // Calls `write(text, f, corners)` for each face of the file, a part of face f of the overlay.
  template <class Write>
  void write_faces(std::ostream& os, const Write& write) const
  {
    write_elements(os, overlay_.number_of_faces(), [&](Long_text& text, std::size_t i) {
      const IT::Overlay::Face f(static_cast<std::uint32_t>(i));
      for_each_piece(f, [&](const Corners& corners) { write(text, f, corners); });
    });
  }

  void write_vertices(std::ostream& os, const char* const begin) const
  {
    write_elements(os, overlay_.number_of_vertices(), [this, begin](Long_text& text, std::size_t i) {
      const auto [x, y, z] = point(static_cast<std::uint32_t>(i));
      text << begin << x << ' ' << y << ' ' << z << '\n';
    });
  }

  const IT::Common_subdivision& subdivision_;
  const IT::Overlay& overlay_;
  const std::vector<std::array<double, 3>>& points_; // of the input
  const std::vector<Named_values>& values_;          // at the vertices of the overlay
  bool are_triangles_;
  std::size_t number_of_faces_, number_of_edges_; // of the file
};

} // namespace

void write_overlay(std::ostream& os, const IT::Common_subdivision& subdivision,
                   const std::vector<std::array<double, 3>>& points, Mesh_format format, bool are_triangles,
                   const std::vector<Named_values>& values)
{
  const Overlay_writer writer(subdivision, points, are_triangles, values);
  switch (format) {
  case Mesh_format::PLY:
    return writer.write_ply(os);
  case Mesh_format::OFF:
    return writer.write_off(os);
  case Mesh_format::OBJ:
    return writer.write_obj(os);
  case Mesh_format::VTP:
    return writer.write_vtp(os);
  case Mesh_format::STL:
  case Mesh_format::TS:
    return writer.write_triangles(os, format);
  }
}

} // namespace idt
