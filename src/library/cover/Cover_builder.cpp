// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From triangles to the surface that covers them.

#include "Flat_face_remover.h"
#include "Triangle_cleaner.h"

#include "../gluing/Faces_around_edge.h"
#include "../gluing/Sides_by_edge.h"

#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Triangles in space with glued sides. Side 3f + i runs from corner i of face f to corner i + 1.
struct Glued_faces
{
  std::vector<std::uint32_t> face_of; // for each face, the triangle of which it is a copy
  std::vector<bool> is_back;
  Large_vector<std::uint32_t> corners;  // for each side the vertex where it begins
  Large_vector<std::uint32_t> glued_to; // for each side its partner, or the largest index

  void glue(std::uint32_t s, std::uint32_t t)
  {
    glued_to[s] = t;
    glued_to[t] = s;
  }
};

class Cover_builder
{
  using Index = std::uint32_t;
  using Index_vector = Large_vector<Index>;
  using Side = Sides_by_edge::Side;
  static constexpr Index null = (std::numeric_limits<Index>::max)();

public:
  Cover_builder(const Points& points, Cleaned_triangles&& cleaned, const Cover_options& options)
    : points_(points), cleaned_(std::move(cleaned)), options_(options), interruption_(options.go_further),
      sides_(points.size(), cleaned_.triangles)
  {}

  // \param coincident set to the pairs of vertices that faces without area unite; if it is not empty, they have to be
  //   merged first, and no cover is built
  std::optional<Tufted_cover> run(std::vector<Vertex_number_pair>& coincident)
  {
    check_size(12 * cleaned_.triangles.size());
    coincident.clear();
    // Each takes some tenths of a second for a million triangles.
    for (const auto step :
         {&Cover_builder::count_edges, &Cover_builder::count_nonmanifold_vertices, &Cover_builder::remove_flat_faces,
          &Cover_builder::find_pieces, &Cover_builder::make_copies, &Cover_builder::glue}) {
      interruption_.check();
      (this->*step)();
      coincident = coincident_;
      if (!coincident.empty())
        return std::nullopt;
    }
    interruption_.check();
    return assemble();
  }

private:
  using Triangles = std::vector<Index_triangle>;
  Tufted_cover_report& report() { return cleaned_.report; }
  const Triangles& triangles() const { return cleaned_.triangles; }

  [[noreturn]] void throw_at_edge(Invalid_surface_error::Defect defect, const Side& side, const char* what) const
  {
    const Index s = side.side(), f = cleaned_.input_face[s / 3];
    throw Invalid_surface_error(defect, f, 1,
                                "edge " + std::to_string(triangles()[s / 3][s % 3]) + "-" +
                                  std::to_string(triangles()[s / 3][next_side(s) % 3]) + " of face " +
                                  std::to_string(f) + " " + what +
                                  "; the tufted cover (Surface_cover::TUFTED, --cover tufted) takes it");
  }

  void count_edges()
  {
    sides_.for_each_edge([&](Index, const Side* begin, const Side* end) {
      if (end - begin == 1)
        ++report().border_edges;
      if (end - begin <= 2)
        return;
      ++report().nonmanifold_edges;
      refuse_without_cover(*begin);
    });
  }
  void refuse_without_cover(const Side& side) const
  {
    if (options_.cover == Surface_cover::NONE)
      throw_at_edge(Invalid_surface_error::Defect::NON_MANIFOLD_EDGE, side, "has more than two faces");
  }

  // Turns the faces of each piece so that they agree with its first one, or finds that it needs two copies.
  void find_pieces()
  {
    Triangle_pieces all(sides_, triangles().size());
    is_turned_ = std::move(all.is_turned);
    is_doubled_.assign(triangles().size(), false);
    for (const Triangle_pieces::Piece& piece : all.pieces) {
      report().is_orientable = report().is_orientable && piece.is_orientable();
      if (options_.cover == Surface_cover::NONE && !piece.is_orientable())
        throw_at_edge(Invalid_surface_error::Defect::INCONSISTENT_ORIENTATION, Side{0, 2 * piece.conflict},
                      "joins a face to itself turned over: the surface is not orientable");
    }
    if (options_.cover != Surface_cover::TUFTED)
      return;
    for (Index f = 0; f < triangles().size(); ++f)
      if (const auto& piece = all.pieces[all.piece_of[f]]; !piece.is_closed || !piece.is_orientable()) {
        is_doubled_[f] = true;
        is_turned_[f] = false;
      }
  }

  // The faces at a vertex form one fan if each can be reached from each other across edges.
  void count_nonmanifold_vertices()
  {
    Disjoint_sets fans(3 * triangles().size());
    sides_.for_each_edge([&](Index, const Side* begin, const Side* end) {
      const auto corner_at_smaller = [](const Side& s) {
        return s.runs_to_smaller_end() ? next_side(s.side()) : s.side();
      };
      const auto corner_at_larger = [](const Side& s) {
        return s.runs_to_smaller_end() ? s.side() : next_side(s.side());
      };
      for (const Side* s = begin + 1; s < end; ++s) {
        fans.unite(corner_at_smaller(*begin), corner_at_smaller(*s));
        fans.unite(corner_at_larger(*begin), corner_at_larger(*s));
      }
    });
    std::vector<unsigned char> fans_at(points_.size(), 0);
    for (Index c = 0; c < 3 * triangles().size(); ++c)
      if (fans.find(c) == c)
        if (unsigned char& n = fans_at[triangles()[c / 3][c % 3]]; n < 2 && ++n == 2)
          ++report().nonmanifold_vertices;
  }

  void make_copies()
  {
    const std::size_t n = triangles().size() + std::size_t(std::count(is_doubled_.begin(), is_doubled_.end(), true));
    first_copy_ = Index_vector(triangles().size(), default_init);
    cover_.corners = Index_vector(3 * n, default_init);
    cover_.face_of.resize(n);
    cover_.is_back.resize(n);
    Index copy = 0;
    for (Index f = 0; f < triangles().size(); ++f) {
      first_copy_[f] = copy;
      const auto& [a, b, c] = triangles()[f];
      if (is_doubled_[f] || !is_turned_[f])
        make_copy(copy++, f, a, b, c, false);
      if (is_doubled_[f] || is_turned_[f])
        make_copy(copy++, f, a, c, b, true);
    }
  }
  void make_copy(Index copy, Index f, Index a, Index b, Index c, bool is_back)
  {
    cover_.face_of[copy] = f;
    cover_.is_back[copy] = is_back;
    cover_.corners[3 * copy] = a;
    cover_.corners[3 * copy + 1] = b;
    cover_.corners[3 * copy + 2] = c;
  }

  // The side of the copy that runs to the smaller end, or of the other copy.
  Index side_of_copy(const Side& side, bool runs_to_smaller_end) const
  {
    const Index s = side.side(), f = s / 3;
    const bool is_back = is_doubled_[f] ? side.runs_to_smaller_end() != runs_to_smaller_end : bool(is_turned_[f]);
    return 3 * (first_copy_[f] + (is_doubled_[f] && is_back ? 1 : 0)) + (is_back ? 2 - s % 3 : s % 3);
  }

  // A copy that runs along an edge with the face on its left sees the next face, counterclockwise.
  void glue()
  {
    cover_.glued_to = Index_vector(cover_.corners.size(), null);
    std::vector<Faces_around_edge::Face> around;
    std::vector<const Side*> sorted;
    sides_.for_each_edge([&](Index v, const Side* begin, const Side* end) {
      const std::ptrdiff_t n = end - begin;
      if (!is_doubled_[begin->face()]) {
        if (n == 2 && runs_to_smaller_end(begin[0]) != runs_to_smaller_end(begin[1]))
          cover_.glue(side_of_copy(begin[0], false), side_of_copy(begin[1], true));
        else if (n > 1) {
          refuse_without_cover(*begin);
          is_cut_ = true;
        }
        return;
      }
      if (n <= 2) {
        for (std::ptrdiff_t i = 0; i < n; ++i)
          cover_.glue(side_of_copy(begin[i], false), side_of_copy(begin[n - 1 - i], true));
        return;
      }
      around.clear();
      for (const Side* s = begin; s < end; ++s)
        around.push_back({third_vertex(s->side()), Index(s - begin)});
      interruption_.check();
      if (!scaled_points_)
        scale_points();
      Faces_around_edge(*scaled_points_, v, begin->larger_end).sort(around);
      for (std::ptrdiff_t i = 0; i < n; ++i)
        cover_.glue(side_of_copy(begin[around[i].side], false), side_of_copy(begin[around[(i + 1) % n].side], true));
    });
  }
  // Scales into a range in which products neither over- nor underflow.
  void scale_points()
  {
    const std::vector<bool> is_used = have_faces(points_.size(), triangles());
    scaled_points_ = points_;
    normalize_points(*scaled_points_, [&](std::size_t v) { return bool(is_used[v]); });
  }
  // Whether a side of a face with one copy runs to the smaller end, after turning.
  bool runs_to_smaller_end(const Side& side) const { return side.runs_to_smaller_end() != is_turned_[side.face()]; }
  Index third_vertex(Index s) const { return triangles()[s / 3][(s + 2) % 3]; }

  void remove_flat_faces()
  {
    std::vector<bool> is_flat(triangles().size());
    bool is_any_flat = false;
    for (Index f = 0; f < triangles().size(); ++f) {
      if (f % 1024 == 0)
        interruption_.check();
      const auto& [a, b, c] = triangles()[f];
      is_flat[f] = are_collinear(points_[a], points_[b], points_[c]);
      is_any_flat = is_any_flat || is_flat[f];
    }
    if (!is_any_flat && cleaned_.wires.empty())
      return;
    Flat_face_remover others(points_, triangles(), cleaned_.input_face, is_flat, cleaned_.wires);
    coincident_ = std::move(others.coincident);
    if (!coincident_.empty())
      return;
    report().faces_without_area = others.lonely_faces;
    const std::vector<bool> had_faces = have_faces(points_.size(), triangles()),
                            has_faces = have_faces(points_.size(), others.triangles);
    for (Index v : cleaned_.representative)
      report().unreferenced_vertices += had_faces[v] && !has_faces[v];
    for (const auto& [ends, face] : others.flat_edges) {
      const auto &p = points_[ends.first], &q = points_[ends.second];
      flat_edges_.push_back({ends.first, ends.second, std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]), face});
    }
    cleaned_.input_face = std::move(others.names_of_triangles);
    cleaned_.triangles = std::move(others.triangles);
    check_size(12 * triangles().size());
    sides_ = Sides_by_edge(points_.size(), triangles(), others.cuts);
  }

  Tufted_cover assemble()
  {
    auto [vertex_of, corner_vertex] = separate_fans(points_.size(), cover_.corners, cover_.glued_to);
    // The halfedge of a face is that of a Surface_mesh, so numbers are rounded in the same way.
    Delta_complex complex = Delta_complex_builder::from_glued_sides(vertex_of.size(), std::move(corner_vertex),
                                                                    std::move(cover_.glued_to), 2);
    using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;
    Points points;
    points.reserve(vertex_of.size());
    for (Index v : vertex_of)
      points.push_back(points_[v]);
    for (Vertex_index v : complex.vertices())
      if (!complex.halfedge(v).is_valid())
        points[v.idx()] = {0, 0, 0}; // it may have been overwritten
    interruption_.check();
    std::vector<bool> is_half;
    is_half.reserve(cover_.face_of.size());
    for (Index& f : cover_.face_of) {
      is_half.push_back(is_doubled_[f]);
      f = cleaned_.input_face[f];
    }
    return {options_.mollification > 0 ? mollified(std::move(complex), points)
                                       : Triangulation(std::move(complex), std::move(points)),
            std::move(vertex_of),
            std::move(cover_.face_of),
            std::move(cover_.is_back),
            std::move(is_half),
            std::move(cleaned_.representative),
            cleaned_.report,
            is_cut_,
            std::move(flat_edges_)};
  }

  Intrinsic_triangulation<Filtered_edge_length_traits> mollified(Delta_complex complex, const Points& points)
  {
    std::vector<double> lengths;
    for (Edge_index e : complex.edges()) {
      const auto& p = points[complex.source(complex.halfedge(e)).idx()];
      const auto& q = points[complex.target(complex.halfedge(e)).idx()];
      lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
    }
    report().mollification = mollify_lengths(complex, lengths, options_.mollification);
    return Intrinsic_triangulation<Filtered_edge_length_traits>::from_lengths(std::move(complex), std::move(lengths));
  }

  const Points& points_;
  Cleaned_triangles cleaned_;
  const Cover_options& options_;
  const Interruption interruption_;
  Sides_by_edge sides_;
  std::vector<bool> is_doubled_, is_turned_; // of each triangle
  bool is_cut_ = false;
  Index_vector first_copy_;
  Glued_faces cover_;                          // faces are copies of triangles
  std::vector<Vertex_number_pair> coincident_; // that faces without area unite
  std::vector<Tufted_cover::Flat_edge> flat_edges_;
  std::optional<Points> scaled_points_; // if faces have to be ordered around some edge
};

Tufted_cover build_cover(const Points& points, const std::vector<Index_triangle>& triangles,
                         const Cover_options& options)
{
  std::vector<Vertex_number_pair> merged, coincident;
  for (;;) {
    Cover_builder builder(points, Triangle_cleaner(points, triangles, options).run(merged), options);
    if (std::optional<Tufted_cover> cover = builder.run(coincident))
      return std::move(*cover);
    if (options.coincident_vertices != Coincident_vertices::MERGE) {
      const auto& [v, w] = coincident[0];
      throw Invalid_surface_error(Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, v, coincident.size(),
                                  "vertices " + std::to_string(v) + " and " + std::to_string(w) +
                                    " are at the same place, and faces without area join them; merge them "
                                    "(Coincident_vertices::MERGE, --coincident-vertices merge)");
    }
    merged.insert(merged.end(), coincident.begin(), coincident.end());
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
