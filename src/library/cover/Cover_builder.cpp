// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From triangles, or a surface given by lengths, to the surface that covers them.

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include "Flat_face_remover.h"
#include "../gluing/Faces_around_edge.h"
#include "../gluing/Sides_by_edge.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// For each vertex, whether it has a face.
inline std::vector<bool> have_faces(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
{
  std::vector<bool> result(number_of_vertices, false);
  for (const Index_triangle& t : triangles)
    for (std::uint32_t v : t)
      result[v] = true;
  return result;
}

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

// Triangles with corners at three different places; each corner is the vertex that represents the given one.
struct Cleaned_triangles
{
  std::vector<Index_triangle> triangles;
  std::vector<std::uint32_t> input_face;     // of each triangle
  std::vector<std::uint32_t> representative; // of each vertex
  std::vector<Wire> wires;                   // of faces that lost a corner
  Tufted_cover_report report;                // numbers of vertices and faces, dropped and merged ones
};

// \param merged pairs of vertices to unite, besides those that the options merge
// \exception Invalid_surface_error if the point of a vertex with a face is not finite, or by Coincident_vertices::ERROR
// \pre the vertices exist
class Triangle_cleaner
{
public:
  Triangle_cleaner(const Points& points, std::vector<Index_triangle> triangles, const Cover_options& options)
    : points_(points), options_(options)
  {
    result_.triangles = std::move(triangles);
    result_.report.number_of_vertices = points.size();
    result_.report.number_of_faces = result_.triangles.size();
  }

  Cleaned_triangles run(const std::vector<Vertex_number_pair>& merged)
  {
    check_points();
    result_.input_face.resize(result_.triangles.size());
    std::iota(result_.input_face.begin(), result_.input_face.end(), std::uint32_t(0));
    result_.report.repeated_corner_faces = remove_if([](const Index_triangle& t) { return repeats_a_corner(t); });
    Disjoint_sets sets(points_.size());
    for (const auto& [v, w] : merged)
      sets.unite(v, w);
    if (options_.is_welded)
      weld(sets);
    treat_short_edges(sets);
    name_representatives(sets);
    count_unreferenced();
    return std::move(result_);
  }

private:
  static bool repeats_a_corner(const Index_triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

  // Also vertices that no face names: the constructors of triangulations refuse them, too.
  void check_points() const
  {
    for (std::size_t v = 0; v < points_.size(); ++v)
      for (double x : points_[v])
        if (!std::isfinite(x))
          throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_FINITE, v, 1,
                                      "vertex " + std::to_string(v) + " has a coordinate that is not finite");
  }

  // Returns how many there were.
  template <class Condition>
  std::size_t remove_if(const Condition& condition)
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < result_.triangles.size(); ++i)
      if (!condition(result_.triangles[i])) {
        result_.triangles[n] = result_.triangles[i];
        result_.input_face[n++] = result_.input_face[i];
      }
    const std::size_t removed = result_.triangles.size() - n;
    result_.triangles.resize(n);
    result_.input_face.resize(n);
    return removed;
  }

  void weld(Disjoint_sets& sets) const
  {
    const std::vector<bool> has_face = have_faces(points_.size(), result_.triangles);
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      if (has_face[v])
        order.push_back(v);
    std::sort(order.begin(), order.end(), [this](std::uint32_t v, std::uint32_t w) { return points_[v] < points_[w]; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (points_[order[i - 1]] == points_[order[i]])
        sets.unite(order[i - 1], order[i]);
  }

  // The first corner of a side whose ends are at the same place but are different vertices, or 3.
  int find_short_side(const Index_triangle& t, Disjoint_sets& sets) const
  {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i], w = t[(i + 1) % 3];
      if (points_[v] == points_[w] && sets.find(v) != sets.find(w))
        return i;
    }
    return 3;
  }

  void treat_short_edges(Disjoint_sets& sets)
  {
    if (options_.coincident_vertices == Coincident_vertices::DROP) {
      result_.report.zero_length_faces =
        remove_if([&](const Index_triangle& t) { return find_short_side(t, sets) < 3; });
      return;
    }
    for (std::size_t f = 0; f < result_.triangles.size(); ++f) {
      const Index_triangle& t = result_.triangles[f];
      for (int i = find_short_side(t, sets); i < 3; i = find_short_side(t, sets)) {
        const std::uint32_t v = t[i], w = t[(i + 1) % 3];
        if (options_.coincident_vertices == Coincident_vertices::ERROR)
          throw Invalid_surface_error(Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, v, 1,
                                      "vertices " + std::to_string(v) + " and " + std::to_string(w) + " of face " +
                                        std::to_string(result_.input_face[f]) +
                                        " are at the same place; merge them, or drop the face");
        sets.unite(v, w);
      }
    }
  }

  void name_representatives(Disjoint_sets& sets)
  {
    result_.representative.resize(points_.size());
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      result_.representative[v] = sets.find(v);
      result_.report.merged_vertices += result_.representative[v] != v;
    }
    if (result_.report.merged_vertices == 0)
      return;
    for (Index_triangle& t : result_.triangles)
      for (std::uint32_t& v : t)
        v = result_.representative[v];
    for (std::size_t f = 0; f < result_.triangles.size(); ++f) {
      const auto& [a, b, c] = result_.triangles[f];
      if (const std::uint32_t other = a == b ? c : b; repeats_a_corner(result_.triangles[f]) && other != a)
        result_.wires.push_back({{a, other}, result_.input_face[f]});
    }
    result_.report.collapsed_faces = remove_if([](const Index_triangle& t) { return repeats_a_corner(t); });
  }

  void count_unreferenced()
  {
    const std::vector<bool> has_row = have_faces(points_.size(), result_.triangles);
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      result_.report.unreferenced_vertices += !has_row[result_.representative[v]];
  }

  const Points& points_;
  const Cover_options& options_;
  Cleaned_triangles result_;
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
  // Of a face with one copy.
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
