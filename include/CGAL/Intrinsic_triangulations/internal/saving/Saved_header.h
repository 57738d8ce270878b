// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The header of a triangulation in a file.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_HEADER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_HEADER_H

#include <CGAL/Intrinsic_triangulations/reports.h>
#include <CGAL/Intrinsic_triangulations/internal/saving/Byte_stream.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// What the metric of the input is given by.
enum class Metric_kind {
  POINTS,
  LENGTHS,
  SQUARED_LENGTHS
};

// What the header of a file tells. It is text that follows from these numbers, so that a header is right if it is that text.
struct Saved_header
{
  Metric_kind metric = Metric_kind::POINTS;
  Tie_proof tie_proof = Tie_proof::PROBABLE_IF_COSTLY;
  bool has_constraints = false;
  std::size_t vertices = 0, edges = 0, faces = 0; // of the input
  std::size_t inserted_vertices = 0, intrinsic_vertices = 0, intrinsic_edges = 0, intrinsic_faces = 0;

  static constexpr std::size_t number_of_counts = number_of_stages + 1; // the last one is that of ties

  std::string text() const
  {
    std::ostringstream os;
    os.imbue(std::locale::classic());
    const auto element = [&](const char* name, std::size_t number, std::initializer_list<const char*> properties) {
      os << "element " << name << ' ' << number << '\n';
      for (const char* property : properties)
        os << "property " << property << '\n';
    };
    os << "ply\nformat binary_little_endian 1.0\n"
       << "comment intrinsic triangulation, version 1\n"
       << "comment traits Filtered_edge_length_traits\n"
       << "comment ties " << (tie_proof == Tie_proof::PROVEN ? "proven" : "probable") << '\n';
    if (metric == Metric_kind::POINTS) {
      element("vertex", vertices, {"double x", "double y", "double z", "uint halfedge"});
    } else {
      element("vertex", vertices, {"uint halfedge"});
    }
    element("face", faces, {"list uchar uint vertex_indices", "uint halfedge_0", "uint halfedge_1", "uint halfedge_2"});
    if (metric == Metric_kind::LENGTHS)
      element("input_edge", edges, {"double length"});
    else if (metric == Metric_kind::SQUARED_LENGTHS)
      element("input_edge", edges, {"list uint uchar squared_length"});
    else
      os << "comment input edges " << edges << '\n';
    element("intrinsic_vertex", intrinsic_vertices, {"uint halfedge"});
    element("inserted_vertex", inserted_vertices, {"uint halfedge", "double a", "double b", "double c"});
    element("intrinsic_face", intrinsic_faces,
            {"uint halfedge_0", "uint halfedge_1", "uint halfedge_2", "double four_areas", "double error",
             "uchar is_straight"});
    element("intrinsic_edge", intrinsic_edges,
            {"double squared_length", "int crossings", "uint input_halfedge_0", "uint input_halfedge_1"});
    if (has_constraints)
      os << "property uchar is_constrained\n";
    element("count", number_of_counts, {"uint low", "uint high"});
    os << "end_header\n";
    return os.str();
  }

  // \exception Invalid_surface_error
  static Saved_header read(Byte_reader& bytes)
  {
    constexpr std::size_t largest_number_of_lines = 40;
    Saved_header result;
    std::vector<std::string> lines;
    do {
      lines.push_back(bytes.line());
      result.note(lines.back());
    } while (lines.back() != "end_header" && lines.size() < largest_number_of_lines && lines[0] == "ply");
    std::istringstream expected(result.text());
    std::string line;
    for (std::size_t i = 0; std::getline(expected, line); ++i)
      if (i >= lines.size() || lines[i] != line)
        bytes.fail(0, "line " + std::to_string(i + 1) + " of the header is not \"" + line +
                        "\": this is no intrinsic triangulation, or was written by another version");
    return result;
  }

private:
  // Takes over what varies.
  void note(const std::string& line)
  {
    const auto number = [&](const char* before, std::size_t& n) {
      const std::string begin = before;
      std::uint32_t x = 0;
      if (line.compare(0, begin.size(), begin) == 0 && line.size() < begin.size() + 11) {
        for (std::size_t i = begin.size(); i < line.size(); ++i)
          if (line[i] < '0' || line[i] > '9')
            return;
        std::istringstream(line.substr(begin.size())) >> x;
        n = x;
      }
    };
    number("element vertex ", vertices);
    number("element face ", faces);
    number("element input_edge ", edges);
    number("comment input edges ", edges);
    number("element intrinsic_vertex ", intrinsic_vertices);
    number("element inserted_vertex ", inserted_vertices);
    number("element intrinsic_face ", intrinsic_faces);
    number("element intrinsic_edge ", intrinsic_edges);
    if (line == "property double length")
      metric = Metric_kind::LENGTHS;
    if (line == "property list uint uchar squared_length")
      metric = Metric_kind::SQUARED_LENGTHS;
    if (line == "comment ties proven")
      tie_proof = Tie_proof::PROVEN;
    if (line == "property uchar is_constrained")
      has_constraints = true;
  }
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_HEADER_H
