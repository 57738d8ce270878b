// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces of a surface, divided where a path crosses them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H

#include "Divided_face.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Points of the path on edges and inside faces are new vertices, after those of the input.
class Cut_faces
{
  using Coordinates = std::array<double, 3>;
  using Node = std::uint32_t; // a vertex
  struct Is_before            // of points inside of one face, by the ratios of their coordinates
  {
    bool operator()(const Coordinates& p, const Coordinates& q) const
    {
      const Sign sign = compare_products(p[1], q[0], q[1], p[0]);
      return sign == NEGATIVE || (sign == ZERO && compare_products(p[2], q[0], q[2], p[0]) == NEGATIVE);
    }
  };

public:
  // \exception Invalid_point_error if a point does not lie on the surface, two consecutive ones do not lie in the face
  //   of the first, or segments cross elsewhere than at a point that one of them has
  // \exception Invalid_surface_error if two edges have the same ends
  Cut_faces(const Delta_complex& complex, const std::vector<std::vector<Surface_point>>& paths) : complex_(complex)
  {
    for (std::size_t k = 0; k < paths.size(); ++k)
      add_path(paths[k], k);
    for (Face_index f : complex.faces())
      divide(f);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (!sides_.insert({key(triangles_[t][i], triangles_[t][(i + 1) % 3]), 3 * t + i}).second)
          throw_same_ends(triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }

  const std::vector<std::array<std::uint32_t, 3>>& triangles() const { return triangles_; }
  const std::vector<std::uint32_t>& input_faces() const { return input_faces_; }
  // The vertex at a point of dimension 0.
  static Vertex_index vertex_at(const Delta_complex& complex, const Surface_point& p)
  {
    const auto corner = std::max_element(p.coordinates.begin(), p.coordinates.end()) - p.coordinates.begin();
    return complex.source(sides_from(complex, p.halfedge)[std::size_t(corner)]);
  }

  static std::uint64_t key(Node from, Node to) { return (std::uint64_t(from) << 32) | to; }
  // The sides of the triangles by their keys: three times the triangle plus the number of the side.
  const std::unordered_map<std::uint64_t, std::uint32_t>& sides() const { return sides_; }
  // An edge of a triangle on a path.
  struct Seam_edge
  {
    Node from, to;
    std::size_t path;
  };
  const std::vector<Seam_edge>& seam() const { return seam_; }
  std::size_t number_of_vertices() const { return complex_.number_of_vertices() + new_points_.size(); }
  Surface_point location(Node v) const
  {
    if (v >= complex_.number_of_vertices())
      return new_points_[v - complex_.number_of_vertices()];
    return {complex_.opposite(complex_.halfedge(Vertex_index(v))), {1, 0, 0}}; // its halfedge may be one of the border
  }
  // The coordinates of a vertex in the face of a halfedge, relative to that halfedge.
  Coordinates coordinates(Halfedge_index first, Node v) const
  {
    Coordinates result;
    find_coordinates(complex_, first, location(v), result);
    return result;
  }

private:
  void add_path(std::vector<Surface_point> path, std::size_t number)
  {
    for (std::size_t i = 0; i < path.size(); ++i)
      path[i] = checked(path[i], i);
    // Of consecutive points that are one, the last stays: it lies in a face with the next point.
    const auto are_one = [this](const Surface_point& p, const Surface_point& q) { return are_near(p, q); };
    path.erase(path.begin(), std::unique(path.rbegin(), path.rend(), are_one).base());
    if (path.size() == 2)
      path.insert(path.begin() + 1, middle(path[0], path[1]));
    std::vector<Node> nodes;
    for (const Surface_point& p : path)
      nodes.push_back(node(p));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      if (nodes[i] != nodes[i + 1])
        add_segment(path[i].halfedge, {nodes[i], nodes[i + 1], number}, i);
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
    p.coordinates = on_near_edges(p.coordinates);
    return p;
  }

  // A curve would cross itself where rounding moves its points apart.
  bool are_near(const Surface_point& p, const Surface_point& q) const
  {
    Coordinates there;
    return find_coordinates(complex_, p.halfedge, q, there) &&
           std::equal(there.begin(), there.end(), p.coordinates.begin(),
                      [](double a, double b) { return std::abs(a - b) < 0x1p-40; });
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
    if (dimension == 2) { // the path may end where it begins
      const Face_index f = complex_.face(p.halfedge);
      const auto [place, is_new] =
        inner_nodes_[f.idx()].insert({coordinates_from(complex_, p, complex_.halfedge(f)), next});
      if (is_new)
        new_points_.push_back(p);
      return place->second;
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

  void add_segment(Halfedge_index h, const Seam_edge& segment, std::size_t i)
  {
    Coordinates a, b;
    if (!find_coordinates(complex_, h, location(segment.from), a) ||
        !find_coordinates(complex_, h, location(segment.to), b))
      throw_apart(i);
    segments_[complex_.face(h).idx()].push_back(segment);
  }

  [[noreturn]] static void throw_same_ends(Node a, Node b)
  {
    throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, a, 1,
                                "two edges join vertex " + std::to_string(a) + " and vertex " + std::to_string(b) +
                                  ": the corners of triangles do not tell them apart");
  }

  void divide(Face_index f)
  {
    const Halfedge_index first = complex_.halfedge(f);
    const std::array<Halfedge_index, 3> sides = sides_from(complex_, first);
    std::array<Node, 3> corners;
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = Node(complex_.source(sides[i]).idx());
      const auto on_edge = edge_nodes_.find(complex_.edge(sides[i]).idx());
      if (on_edge != edge_nodes_.end())
        for (const auto& place : on_edge->second)
          nodes.push_back(place.second);
    }
    const auto inner = inner_nodes_.find(f.idx());
    if (inner != inner_nodes_.end())
      for (const auto& place : inner->second)
        nodes.push_back(place.second);
    std::sort(nodes.begin(), nodes.end()); // along the paths: each one is near the one before
    const auto segments = segments_.find(f.idx());
    if (nodes.empty() && segments == segments_.end()) {
      add_triangle(f, corners);
      return;
    }
    for (std::size_t i = 0; i < 3; ++i)
      if (corners[i] == corners[(i + 1) % 3])
        throw_same_ends(corners[i], corners[i]);
    Divided_face divided(corners);
    for (Node v : nodes)
      divided.insert(v, coordinates(first, v));
    if (segments != segments_.end())
      for (const Seam_edge& s : segments->second)
        if (divided.insert_segment(s.from, s.to, [&](Node a, Node b) { seam_.push_back({a, b, s.path}); }))
          throw Invalid_point_error("segments cross inside face " + std::to_string(f.idx()) +
                                    ": let both have the point where they cross");
    divided.improve();
    divided.for_each_triangle([&](const std::array<Node, 3>& t) { add_triangle(f, t); });
  }

  void add_triangle(Face_index f, const std::array<Node, 3>& triangle)
  {
    triangles_.push_back(triangle);
    input_faces_.push_back(std::uint32_t(f.idx()));
  }

  const Delta_complex& complex_;
  std::vector<Surface_point> new_points_;
  std::unordered_map<std::size_t, std::map<double, Node>> edge_nodes_; // of an edge, from the source of its halfedge
  std::unordered_map<std::size_t, std::map<Coordinates, Node, Is_before>> inner_nodes_; // of a face
  std::unordered_map<std::size_t, std::vector<Seam_edge>> segments_;                    // through a face
  std::vector<Seam_edge> seam_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::unordered_map<std::uint64_t, std::uint32_t> sides_;
  std::vector<std::uint32_t> input_faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_CUT_FACES_H
