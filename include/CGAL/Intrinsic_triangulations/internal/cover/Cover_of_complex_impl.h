// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The cover of a surface that is given by lengths.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A complex and a copy of it that is turned over, glued along the border. Face f is copied as face f and, turned over,
// as f + n.
class Complex_doubler
{
  using Index = std::uint32_t;

public:
  Complex_doubler(const Delta_complex& complex, const std::vector<double>& lengths)
    : complex_(complex), lengths_(lengths), n_(complex.number_of_faces()), side_of_(complex.number_of_halfedges())
  {
    for (Face_index f : complex.faces()) {
      Halfedge_index h = complex.halfedge(f);
      for (Index i = 0; i < 3; ++i, h = complex.next(h))
        side_of_[h.idx()] = 3 * f.idx() + i;
    }
  }

  // Also fills the vertices below, and the lengths of the edges.
  Delta_complex make(std::vector<Index>& vertex_of, std::vector<double>& doubled_lengths) const
  {
    check_size(12 * n_);
    Large_vector<Index> corner_vertex(6 * n_, default_init), glued_to(6 * n_, default_init);
    vertex_of.resize(complex_.number_of_vertices());
    std::iota(vertex_of.begin(), vertex_of.end(), Index(0));
    std::vector<Index> back_vertex = vertex_of;
    for (Vertex_index v : complex_.vertices())
      if (complex_.halfedge(v).is_valid() && !complex_.is_border(complex_.halfedge(v))) {
        back_vertex[v.idx()] = Index(vertex_of.size());
        vertex_of.push_back(v.idx());
      }
    std::vector<double> length_of_side(6 * n_);
    for (Halfedge_index h : complex_.halfedges()) {
      if (complex_.is_border(h))
        continue;
      const Index s = side_of_[h.idx()], back = back_side(s);
      const Halfedge_index g = complex_.opposite(h);
      corner_vertex[s] = complex_.source(h).idx();
      corner_vertex[back] = back_vertex[complex_.target(h).idx()];
      glued_to[s] = complex_.is_border(g) ? back : side_of_[g.idx()];
      glued_to[back] = complex_.is_border(g) ? s : back_side(side_of_[g.idx()]);
      length_of_side[s] = length_of_side[back] = lengths_[complex_.edge(h).idx()];
    }
    Delta_complex doubled =
      Delta_complex_builder::from_glued_sides(vertex_of.size(), std::move(corner_vertex), std::move(glued_to));
    doubled_lengths.resize(doubled.number_of_edges());
    for (Face_index f : doubled.faces()) {
      Halfedge_index h = doubled.halfedge(f);
      for (Index i = 0; i < 3; ++i, h = doubled.next(h))
        doubled_lengths[doubled.edge(h).idx()] = length_of_side[3 * f.idx() + i];
    }
    return doubled;
  }

private:
  Index back_side(Index s) const { return Index(3 * (n_ + s / 3) + 2 - s % 3); }

  const Delta_complex& complex_;
  const std::vector<double>& lengths_;
  const std::size_t n_;
  std::vector<Index> side_of_; // of each halfedge
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
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
    cover = Complex_doubler(complex, lengths).make(vertex_of, cover_lengths);
    face_of.resize(2 * n);
    std::iota(face_of.begin() + std::ptrdiff_t(n), face_of.end(), std::uint32_t(0));
    is_back.resize(2 * n, true);
  }
  if (options.mollification > 0)
    report.mollification = mollify_lengths(cover, cover_lengths, options.mollification, false);
  return {Triangulation::from_lengths(std::move(cover), std::move(cover_lengths)),
          std::move(vertex_of),
          std::move(face_of),
          std::move(is_back),
          std::vector<bool>(is_doubled ? 2 * n : n, is_doubled),
          std::move(representative),
          report};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_IMPL_H
