// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removes faces without area from triangles, without changing their metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Vertex_number_pair = std::pair<std::uint32_t, std::uint32_t>;

// An edge and a face beside it: the remains of a face that lost a corner.
struct Wire
{
  Vertex_number_pair ends;
  std::uint32_t face;
};

// A face without area is a segment: its longest side runs through its third corner and coincides with the two other
// sides. So all other faces at that side are cut at that corner, into triangles that together lie in space where they
// did, and the face is no longer needed. The vertices that such faces put between the ends of an edge are found for the
// longest edges first, since they lie on shorter ones, too. Edges between the same two vertices are one edge, as
// everywhere.
class Flat_face_remover
{
  using Index = std::uint32_t;
  using Ends = Vertex_number_pair; // of an edge, in the order of their points, which differ

public:
  // \param names of the faces, for the results
  // \param is_flat whether faces have no area
  // \pre the corners of each face are at different points, and so are the ends of each wire
  Flat_face_remover(const Points& points, const std::vector<Index_triangle>& faces, const std::vector<Index>& names,
                    const std::vector<bool>& is_flat, const std::vector<Wire>& wires)
    : points_(points), middles_(Contains{points}), faces_of_flat_edges_(Contains{points})
  {
    find_middles(faces, is_flat);
    if (!coincident.empty())
      return;
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (is_flat[f])
        add_flat_edges(longest_side(faces[f]), names[f]);
    for (const Wire& wire : wires)
      add_flat_edges(ends(wire.ends.first, wire.ends.second), wire.face);
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (!is_flat[f])
        split(faces[f], names[f]);
    for (const auto& [ends, face] : faces_of_flat_edges_)
      flat_edges.push_back({ends, face});
    for (auto edge = middles_.rbegin(); edge != middles_.rend(); ++edge) { // the parts of an edge come after it
      const auto [one, other] = halves(*edge);
      edge->second.is_flat = is_flat_edge(one) && is_flat_edge(other);
    }
    for (std::size_t f = 0; f < faces.size(); ++f)
      lonely_faces += is_flat[f] && is_flat_edge(longest_side(faces[f]));
  }

  // Pairs of different vertices that turned out to be at one point. If there are any, nothing else is known.
  std::vector<Vertex_number_pair> coincident;
  // The faces with area, cut, each with the name of the face that it is a part of.
  std::vector<Index_triangle> triangles;
  std::vector<Index> names_of_triangles;
  // Pairs of sides 3f + i where faces were cut. Other faces do not share these edges.
  std::vector<std::array<Index, 2>> cuts;
  // Edges that belong to faces without area only, each with one of these faces.
  std::vector<Wire> flat_edges;
  // The number of faces without area that have only such edges.
  std::size_t lonely_faces = 0;

private:
  // An order in which an edge comes before those that it contains.
  struct Contains
  {
    const Points& points;

    bool operator()(const Ends& a, const Ends& b) const
    {
      if (points[a.first] != points[b.first])
        return points[a.first] < points[b.first];
      if (points[a.second] != points[b.second])
        return points[b.second] < points[a.second];
      return a < b;
    }
  };

  // The vertices between the ends of an edge.
  struct Middles
  {
    std::vector<Index> vertices;
    bool is_flat = false; // whether all parts of the edge are considered flat
  };

  Ends ends(Index v, Index w) const { return points_[v] < points_[w] ? Ends{v, w} : Ends{w, v}; }

  // The corners of a face without area, the one between the two others first.
  Index_triangle middle_first(const Index_triangle& t) const
  {
    for (std::size_t i = 0; i < 2; ++i) { // on a line, points are in the order of their coordinates
      const Index v = t[i], w = t[i + 1], x = t[(i + 2) % 3];
      if ((points_[w] < points_[v]) != (points_[x] < points_[v]))
        return {v, w, x};
    }
    return {t[2], t[0], t[1]};
  }

  void find_middles(const std::vector<Index_triangle>& faces, const std::vector<bool>& is_flat)
  {
    for (Index f = 0; f < faces.size(); ++f)
      if (is_flat[f]) {
        const auto [v, w, x] = middle_first(faces[f]);
        middles_[ends(w, x)].vertices.push_back(v);
      }
    for (auto& [edge, between] : middles_) { // entries that are added come later in the order
      std::vector<Index>& middles = between.vertices;
      std::sort(middles.begin(), middles.end(),
                [this](Index v, Index w) { return points_[v] != points_[w] ? points_[v] < points_[w] : v < w; });
      std::size_t n = 0;
      for (std::size_t i = 1; i < middles.size(); ++i) {
        if (points_[middles[i]] != points_[middles[n]])
          middles[++n] = middles[i];
        else if (middles[i] != middles[n])
          coincident.push_back({middles[n], middles[i]});
      }
      middles.resize(n + 1);
      for (std::size_t i = 1; i < middles.size(); ++i) {
        middles_[ends(edge.first, middles[i])].vertices.push_back(middles[i - 1]);
        middles_[ends(middles[i - 1], edge.second)].vertices.push_back(middles[i]);
      }
    }
  }

  // v, and the vertices between v and w.
  std::vector<Index> path(Index v, Index w) const
  {
    std::vector<Index> result, next{w};
    while (!next.empty()) {
      const auto found = middles_.find(ends(v, next.back()));
      if (found != middles_.end()) {
        next.push_back(found->first.first == v ? found->second.vertices.front() : found->second.vertices.back());
        continue;
      }
      result.push_back(v);
      v = next.back();
      next.pop_back();
    }
    return result;
  }

  Ends longest_side(const Index_triangle& face) const
  {
    const Index_triangle t = middle_first(face);
    return ends(t[1], t[2]);
  }

  std::array<Ends, 2> halves(const std::pair<const Ends, Middles>& edge) const
  {
    const Index middle = edge.second.vertices.front();
    return {ends(edge.first.first, middle), ends(middle, edge.first.second)};
  }
  bool is_flat_edge(const Ends& edge) const
  {
    const auto found = middles_.find(edge);
    return found != middles_.end() ? found->second.is_flat : faces_of_flat_edges_.count(edge) > 0;
  }

  // Considers the parts of an edge flat until faces with area are found there. Each edge is divided once: many faces
  // may lie on each other.
  void add_flat_edges(const Ends& edge, Index face)
  {
    std::vector<Ends> next{edge};
    while (!next.empty()) {
      const Ends part = next.back();
      next.pop_back();
      const auto found = middles_.find(part);
      if (found == middles_.end())
        faces_of_flat_edges_.insert({part, face});
      else if (!std::exchange(found->second.is_flat, true))
        for (const Ends& half : halves(*found))
          next.push_back(half);
    }
  }

  void split(const Index_triangle& t, Index name)
  {
    std::array<std::vector<Index>, 3> sides{path(t[0], t[1]), path(t[1], t[2]), path(t[2], t[0])};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < sides[i].size(); ++k)
        faces_of_flat_edges_.erase(
          ends(sides[i][k], k + 1 < sides[i].size() ? sides[i][k + 1] : sides[(i + 1) % 3][0]));
    const auto first_cut = std::find_if(sides.begin(), sides.end(), [](const auto& side) { return side.size() > 1; });
    if (first_cut == sides.end()) {
      triangles.push_back(t);
      names_of_triangles.push_back(name);
      return;
    }
    // A strip of triangles: a fan around the first vertex on this side, from the beginning of the side to the third
    // corner; a fan around that corner, past the other vertices on the side; and a fan around the last of these, to the
    // end of the side.
    std::rotate(sides.begin(), first_cut, sides.end());
    const Index a = sides[0][0], c = sides[2][0];
    const std::size_t begin = triangles.size();
    const auto add_fan = [&](const std::vector<Index>& side, Index end, Index apex) {
      for (std::size_t i = side.size(); i-- > 0;)
        triangles.push_back({side[i], i + 1 < side.size() ? side[i + 1] : end, apex});
    };
    add_fan(sides[2], a, sides[0][1]);
    for (std::size_t i = 1; i + 1 < sides[0].size(); ++i)
      triangles.push_back({sides[0][i], sides[0][i + 1], c});
    add_fan(sides[1], c, sides[0].back());
    names_of_triangles.resize(triangles.size(), name);
    for (std::size_t f = begin; f + 1 < triangles.size(); ++f)
      join(f, f + 1);
  }

  // Notes the sides where one part meets the next.
  void join(std::size_t f, std::size_t g)
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (triangles[f][i] == triangles[g][(k + 1) % 3] && triangles[f][(i + 1) % 3] == triangles[g][k])
          cuts.push_back({Index(3 * f + i), Index(3 * g + k)});
  }

  const Points& points_;
  std::map<Ends, Middles, Contains> middles_; // of edges past vertices, in the order of their points
  std::map<Ends, Index, Contains> faces_of_flat_edges_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H
