// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The cover of a surface given by lengths: the surface itself, or two copies glued along the border.

#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A complex and a turned-over copy of it, glued along the border. Face f is copied as face f and, turned over, as f +
// n. Also fills the vertices below, and the lengths of the edges.
inline Delta_complex doubled(const Delta_complex& complex, const std::vector<double>& lengths,
                             std::vector<std::uint32_t>& vertex_of, std::vector<double>& doubled_lengths)
{
  using Index = std::uint32_t;
  const std::size_t n = complex.number_of_faces();
  check_size(12 * n);
  // Calls visit(h, s) for the halfedge of each side s.
  const auto for_each_side = [](const Delta_complex& of, const auto& visit) {
    for (Face_index f : of.faces()) {
      Halfedge_index h = of.halfedge(f);
      for (Index i = 0; i < 3; ++i, h = of.next(h))
        visit(h, 3 * f.idx() + i);
    }
  };
  const auto back_side = [n](Index s) { return Index(3 * (n + s / 3) + 2 - s % 3); };

  vertex_of.resize(complex.number_of_vertices());
  std::iota(vertex_of.begin(), vertex_of.end(), Index(0));
  std::vector<Index> back_vertex = vertex_of;
  for (Vertex_index v : complex.vertices())
    if (complex.halfedge(v).is_valid() && !complex.is_border(complex.halfedge(v))) {
      back_vertex[v.idx()] = Index(vertex_of.size());
      vertex_of.push_back(v.idx());
    }
  std::vector<Index> side_of(complex.number_of_halfedges());
  for_each_side(complex, [&](Halfedge_index h, Index s) { side_of[h.idx()] = s; });
  Large_vector<Index> corner_vertex(6 * n, default_init), glued_to(6 * n, default_init);
  std::vector<double> length_of_side(6 * n);
  for_each_side(complex, [&](Halfedge_index h, Index s) {
    const Index back = back_side(s);
    const Halfedge_index g = complex.opposite(h);
    corner_vertex[s] = complex.source(h).idx();
    corner_vertex[back] = back_vertex[complex.target(h).idx()];
    glued_to[s] = complex.is_border(g) ? back : side_of[g.idx()];
    glued_to[back] = complex.is_border(g) ? s : back_side(side_of[g.idx()]);
    length_of_side[s] = length_of_side[back] = lengths[complex.edge(h).idx()];
  });
  Delta_complex result =
    Delta_complex_builder::from_glued_sides(vertex_of.size(), std::move(corner_vertex), std::move(glued_to));
  doubled_lengths.resize(result.number_of_edges());
  for_each_side(result, [&](Halfedge_index h, Index s) { doubled_lengths[result.edge(h).idx()] = length_of_side[s]; });
  return result;
}

Tufted_cover build_cover_of_complex(const Delta_complex& complex, const std::vector<double>& lengths,
                                    const Cover_options& options)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;
  Tufted_cover_report report;
  report.number_of_vertices = complex.number_of_vertices();
  report.number_of_faces = complex.number_of_faces();
  for (Edge_index e : complex.edges())
    report.border_edges += complex.is_border(e);
  for (Vertex_index v : complex.vertices())
    report.unreferenced_vertices += !complex.halfedge(v).is_valid();

  const std::size_t n = complex.number_of_faces();
  const bool is_doubled = options.cover == Surface_cover::TUFTED && report.border_edges > 0;
  std::vector<std::uint32_t> representative(complex.number_of_vertices()), face_of(n), vertex_of;
  std::iota(representative.begin(), representative.end(), std::uint32_t(0));
  std::iota(face_of.begin(), face_of.end(), std::uint32_t(0));
  std::vector<bool> is_back(n, false);
  Delta_complex cover = complex;
  std::vector<double> cover_lengths = lengths;
  vertex_of = representative;
  if (is_doubled) {
    cover = doubled(complex, lengths, vertex_of, cover_lengths);
    face_of.resize(2 * n);
    std::iota(face_of.begin() + std::ptrdiff_t(n), face_of.end(), std::uint32_t(0));
    is_back.resize(2 * n, true);
  }
  if (options.mollification > 0)
    report.mollification = mollify_lengths(cover, cover_lengths, options.mollification);
  return {Triangulation::from_lengths(std::move(cover), std::move(cover_lengths)),
          std::move(vertex_of),
          std::move(face_of),
          std::move(is_back),
          std::vector<bool>(is_doubled ? 2 * n : n, is_doubled),
          std::move(representative),
          report,
          false,
          {}};
}

} // namespace CGAL::Intrinsic_triangulations::internal
