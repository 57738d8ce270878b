// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces of a surface, divided where a path crosses them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Points of the path on edges and inside faces are new vertices, after those of the input.
class Cut_faces
{
  using Coordinates = std::array<double, 3>;
  using Node = std::uint32_t; // a vertex

public:
  // \exception Invalid_point_error
  Cut_faces(const Delta_complex& complex, const std::vector<std::vector<Surface_point>>& paths) : complex_(complex)
  {
    for (const std::vector<Surface_point>& path : paths)
      add_path(path);
    for (Face_index f : complex.faces())
      divide(f);
  }

  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  const std::vector<std::uint32_t>& input_faces() const { return input_faces_; }
  // The coordinates of a point with respect to h and the two other sides of its face; whether it lies there.
  static bool find_coordinates(const Delta_complex& complex, Halfedge_index h, const Surface_point& p,
                               Coordinates& result)
  {
    if (complex.face(p.halfedge) == complex.face(h)) {
      result = coordinates_from(complex, p, h);
      return true;
    }
    result = {0, 0, 0};
    const std::array<Halfedge_index, 3> sides = sides_from(complex, h);
    for (std::size_t i = 0; i < 3; ++i)
      if (p.dimension() == 0 && complex.source(sides[i]) == vertex_at(complex, p)) {
        result[i] = 1;
        return true;
      } else if (p.dimension() == 1 && complex.edge(sides[i]) == complex.edge(side_of(complex, p))) {
        std::tie(result[i], result[(i + 1) % 3]) = coordinates_on_edge(complex, p, sides[i]);
        return true;
      }
    return false;
  }
  // The vertex at a point of dimension 0.
  static Vertex_index vertex_at(const Delta_complex& complex, const Surface_point& p)
  {
    const auto corner = std::max_element(p.coordinates.begin(), p.coordinates.end()) - p.coordinates.begin();
    return complex.source(sides_from(complex, p.halfedge)[std::size_t(corner)]);
  }

  // The segments of the paths.
  const std::vector<std::pair<Node, Node>>& seam() const { return seam_; }
  std::size_t number_of_vertices() const { return complex_.number_of_vertices() + new_points_.size(); }
  Surface_point location(Node v) const
  {
    if (v >= complex_.number_of_vertices())
      return new_points_[v - complex_.number_of_vertices()];
    return {complex_.opposite(complex_.halfedge(Vertex_index(v))), {1, 0, 0}}; // its halfedge may be one of the border
  }
  // Of a vertex in the face of a halfedge, relative to that.
  Coordinates coordinates(Halfedge_index first, Node v) const
  {
    Coordinates result;
    find_coordinates(complex_, first, location(v), result);
    return result;
  }

private:
  // A convex part of a face: its corners, counterclockwise.
  using Piece = std::vector<Node>;

  void add_path(std::vector<Surface_point> path)
  {
    for (std::size_t i = 0; i < path.size(); ++i)
      path[i] = checked(path[i], i);
    if (path.size() == 2)
      path.insert(path.begin() + 1, middle(path[0], path[1]));
    std::vector<Node> nodes;
    for (const Surface_point& p : path)
      nodes.push_back(node(p));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      if (nodes[i] != nodes[i + 1])
        add_segment(path[i].halfedge, nodes[i], nodes[i + 1], i);
  }

  Surface_point checked(Surface_point p, std::size_t i) const
  {
    double sum = 0;
    bool is_valid = p.halfedge.idx() < complex_.number_of_halfedges() && !complex_.is_border(p.halfedge);
    for (double x : p.coordinates) {
      is_valid = is_valid && x >= 0 && x <= 0x1p500;
      sum += x;
    }
    if (!is_valid || !(sum > 0x1p-500))
      throw Invalid_point_error("point " + std::to_string(i) + " of the path does not lie on the surface");
    for (double& x : p.coordinates)
      x /= sum;
    return p;
  }

  static std::array<Halfedge_index, 3> sides_from(const Delta_complex& complex, Halfedge_index h)
  {
    return {h, complex.next(h), complex.prev(h)};
  }

  // The vertex at a point. Points on an edge coincide if they are equal relative to one of its halfedges.
  Node node(const Surface_point& p)
  {
    const int dimension = p.dimension();
    if (dimension == 0)
      return Node(vertex_at(complex_, p).idx());
    const Node next = Node(number_of_vertices());
    if (dimension == 2) {
      std::vector<Node>& inner_nodes = inner_nodes_[complex_.face(p.halfedge).idx()];
      for (Node other : inner_nodes) // the path may end where it begins
        if (are_same_points(complex_, location(other), p))
          return other;
      new_points_.push_back(p);
      inner_nodes.push_back(next);
      return next;
    }
    const Edge_index e = complex_.edge(side_of(complex_, p));
    const auto [at_source, at_target] = coordinates_on_edge(complex_, p, complex_.halfedge(e));
    const auto [place, is_new] = edge_nodes_[e.idx()].insert({at_target / (at_source + at_target), next});
    if (is_new)
      new_points_.push_back(p);
    return place->second;
  }

  Surface_point middle(const Surface_point& p, const Surface_point& q) const
  {
    Coordinates a = p.coordinates, b;
    if (!find_coordinates(complex_, p.halfedge, q, b))
      throw_apart(0);
    for (std::size_t i = 0; i < 3; ++i)
      a[i] = (a[i] + b[i]) / 2;
    return {p.halfedge, a};
  }

  [[noreturn]] static void throw_apart(std::size_t i)
  {
    throw Invalid_point_error("points " + std::to_string(i) + " and " + std::to_string(i + 1) +
                              " of the path do not lie in the face of the first");
  }

  void add_segment(Halfedge_index h, Node from, Node to, std::size_t i)
  {
    Coordinates a, b;
    if (!find_coordinates(complex_, h, location(from), a) || !find_coordinates(complex_, h, location(to), b))
      throw_apart(i);
    seam_.emplace_back(from, to);
    for (std::size_t k = 0; k < 3; ++k)
      if (a[k] == 0 && b[k] == 0) // along a side
        return;
    segments_[complex_.face(h).idx()].emplace_back(from, to);
  }

  void divide(Face_index f)
  {
    const Halfedge_index first = complex_.halfedge(f);
    Piece face;
    for (Halfedge_index h : sides_from(complex_, first)) {
      face.push_back(Node(complex_.source(h).idx()));
      append_nodes(h, face);
    }
    std::vector<Piece> pieces{face};
    const auto segments = segments_.find(f.idx());
    if (segments != segments_.end())
      for (const auto& [from, to] : segments->second)
        split(pieces, from, to);
    const auto inner = inner_nodes_.find(f.idx());
    if (inner != inner_nodes_.end())
      for (Node v : inner->second)
        split_around(pieces, first, v);
    for (const Piece& piece : pieces)
      triangulate(piece, first);
  }

  // The new vertices on an edge, in the direction of h.
  void append_nodes(Halfedge_index h, Piece& piece) const
  {
    const auto found = edge_nodes_.find(complex_.edge(h).idx());
    if (found == edge_nodes_.end())
      return;
    const std::size_t n = piece.size();
    for (const auto& place : found->second)
      piece.push_back(place.second);
    if (h != complex_.halfedge(complex_.edge(h)))
      std::reverse(piece.begin() + std::ptrdiff_t(n), piece.end());
  }

  // Between two corners that are not neighbors.
  static void split(std::vector<Piece>& pieces, Node from, Node to)
  {
    for (Piece& piece : pieces) {
      const auto first = std::find(piece.begin(), piece.end(), from),
                 second = std::find(piece.begin(), piece.end(), to);
      if (first == piece.end() || second == piece.end())
        continue;
      const auto begin = (std::min)(first, second), end = (std::max)(first, second);
      if (end - begin == 1 || (begin == piece.begin() && end + 1 == piece.end()))
        return;
      Piece other(begin, end + 1);
      piece.erase(begin + 1, end);
      pieces.push_back(std::move(other));
      return;
    }
  }

  // Into triangles around a new vertex inside.
  void split_around(std::vector<Piece>& pieces, Halfedge_index first, Node v) const
  {
    std::size_t best = 0;
    double depth = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      double smallest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < pieces[i].size(); ++k)
        smallest = (std::min)(smallest, area(first, pieces[i][k], pieces[i][(k + 1) % pieces[i].size()], v));
      if (smallest > depth) {
        depth = smallest;
        best = i;
      }
    }
    const Piece around = pieces[best];
    pieces.erase(pieces.begin() + std::ptrdiff_t(best));
    for (std::size_t k = 0; k < around.size(); ++k)
      pieces.push_back({around[k], around[(k + 1) % around.size()], v});
  }

  // As a part of the face.
  double area(Halfedge_index first, Node a, Node b, Node c) const
  {
    const Coordinates p = coordinates(first, a), q = coordinates(first, b), r = coordinates(first, c);
    return (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]);
  }

  void triangulate(const Piece& piece, Halfedge_index first)
  {
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      triangles_.push_back({piece[a], piece[b], piece[c]});
      input_faces_.push_back(complex_.face(first).idx());
    };
    if (piece.size() == 3) {
      add(0, 1, 2);
      return;
    }
    std::vector<Coordinates> corners;
    for (Node v : piece)
      corners.push_back(coordinates(first, v));
    Convex_polygon_triangulation(corners).for_each_triangle(add);
  }

  const Delta_complex& complex_;
  std::vector<Surface_point> new_points_;
  std::unordered_map<std::size_t, std::map<double, Node>> edge_nodes_; // of an edge, from the source of its halfedge
  std::unordered_map<std::size_t, std::vector<Node>> inner_nodes_;     // of a face
  std::unordered_map<std::size_t, std::vector<std::pair<Node, Node>>> segments_; // through a face
  std::vector<std::pair<Node, Node>> seam_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> input_faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H
