// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Conformal_map.h.

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include "Conformal_layout.h"
#include "Triple_overlay.h"
#include "planar_predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

using Planar_point = Conformal_map::Point;

Planar_point between(const Planar_point& p, const Planar_point& q, double t)
{
  return {(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]};
}

// The overlay of the Delaunay triangulation of a surface and what flips have made of it.
Overlay overlay_of_flips(const Delta_complex& complex, const std::vector<Edge_index>& flips,
                         const Progress_function& progress)
{
  using Lengths = Intrinsic_triangulation<Ptolemy_traits<float>>; // only the integers of the flips count
  Lengths t = Lengths::from_lengths(complex, std::vector<float>(complex.number_of_edges(), 1));
  t.keep_input(Input_metric());
  Whole_triangulation<Ptolemy_traits<float>> whole(t);
  const auto keeps_one = [](const auto&, auto& flipped) {
    flipped.kl = 1;
    return true;
  };
  for (Edge_index e : flips)
    whole.flip_convex(t.connectivity().hinge(e), keeps_one);
  return Overlay(t, parameters::visitor(progress));
}

class Conformal_map_builder
{
public:
  Conformal_map_builder(const Doubled_surface::Triangulation& surface, const Doubled_surface& doubled,
                        Discrete_conformal_metric metric, const Progress_function& progress)
    : surface_(surface), doubled_(doubled), progress_(progress), input_(doubled.triangulation.input()),
      given_halfedge_(input_.number_of_halfedges())
  {
    map_.metric = std::move(metric);
    map_.input = surface.input();
    for (Halfedge_index h : map_.input.halfedges())
      if (!map_.input.is_border(h))
        given_halfedge_[doubled.halfedges[h.idx()].idx()] = h;
  }

  Conformal_map run()
  {
    const Discrete_conformal_metric& metric = map_.metric;
    const Delta_complex& intrinsic = doubled_.triangulation.connectivity();
    std::vector<double> u;
    for (Vertex_index v : doubled_.vertices)
      u.push_back(metric.u[v.idx()]);
    const std::vector<double> lengths = exact_edge_lengths(doubled_.triangulation);
    const Common_subdivision subdivision(doubled_.triangulation,
                                         parameters::visitor(part_of_progress(progress_, 0, 0.2)));
    const Overlay ideal = overlay_of_flips(intrinsic, metric.flips, part_of_progress(progress_, 0.2, 0.4));
    const Triple_overlay overlay(subdivision, metric.triangulation, ideal, lengths, u,
                                 part_of_progress(progress_, 0.4, 0.9));

    std::vector<bool> is_inside(metric.triangulation.number_of_halfedges(), false);
    for (const Triple_overlay::Piece& piece : overlay.pieces())
      if (doubled_.is_given(piece.input))
        for (const Triple_overlay::Corner& corner : piece.corners)
          if (corner.ideal.is_valid())
            is_inside[corner.ideal.idx()] = true;
    std::vector<bool> is_end(metric.triangulation.number_of_vertices(), false), is_cone(metric.u.size(), false);
    for (Vertex_index v : metric.cones)
      is_cone[v.idx()] = true;
    for (Vertex_index v : metric.triangulation.vertices()) {
      const Vertex_index w = doubled_.vertices[v.idx()];
      const Halfedge_index h = surface_.connectivity().halfedge(w);
      is_end[v.idx()] = is_cone[w.idx()] || (h.is_valid() && surface_.connectivity().is_border(h));
    }
    const Conformal_layout layout(metric.triangulation, metric.lengths, is_inside, is_end);
    map_.is_certified = layout.is_certified();
    map_.seam = layout.seam();
    add_triangles(overlay, layout);
    mark_cuts();
    map_.overlaps = have_common_points(border_of_image());
    map_.input_uv = input_uv_;
    check_input();
    return std::move(map_);
  }

private:
  // In the order of the input faces.
  void add_triangles(const Triple_overlay& overlay, const Conformal_layout& layout)
  {
    std::vector<std::uint32_t> number(overlay.nodes().size(), none);
    for (Vertex_index v : surface_.connectivity().vertices()) {
      if (doubled_.images[v.idx()].is_valid()) // it has a face, or the surface is closed
        number[doubled_.images[v.idx()].idx()] = v.idx();
      map_.places.push_back(place_of_vertex(v));
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < overlay.pieces().size(); ++i)
      if (doubled_.is_given(overlay.pieces()[i].input))
        order.push_back(i);
    const auto face = [&](std::size_t i) { return given_face(overlay.pieces()[i].input).idx(); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return face(i) < face(j); });
    map_.first_of_face.assign(map_.input.number_of_faces() + 1, 0);
    input_uv_.assign(map_.input.number_of_halfedges(), {0, 0});
    is_divided_.assign(map_.input.number_of_faces(), false);
    const auto at = [&](const Triple_overlay::Ideal_point& p) {
      const Halfedge_index h = p.side, next = map_.metric.triangulation.next(h);
      return (h.idx() & 1) ? between(layout.corner(next), layout.corner(h), p.t)
                           : between(layout.corner(h), layout.corner(next), p.t);
    };
    const auto image = [&](const Triple_overlay::Corner& corner) {
      return corner.t == 0 ? at(corner.from) : between(at(corner.from), at(corner.to), corner.t);
    };
    // Where edges of the three triangulations meet in one point, or nearly, nodes have the same image: they are one.
    Disjoint_sets nodes(overlay.nodes().size());
    for (std::size_t i : order) {
      const std::vector<Triple_overlay::Corner>& corners = overlay.pieces()[i].corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Triple_overlay::Corner &a = corners[k], &b = corners[(k + 1) % corners.size()];
        if ((std::max)(a.node, b.node) >= doubled_.vertices.size() && image(a) == image(b))
          nodes.unite(a.node, b.node);
      }
    }
    for (std::size_t i : order) {
      const Triple_overlay::Piece& piece = overlay.pieces()[i];
      std::vector<Planar_point> uv;
      std::vector<std::array<double, 3>> in_space;
      std::vector<std::uint32_t> vertices;
      for (const Triple_overlay::Corner& corner : piece.corners) {
        uv.push_back(image(corner));
        in_space.push_back({uv.back()[0], uv.back()[1], 0});
        if (corner.ideal.is_valid() && !corner.is_input && layout.is_cut(map_.metric.triangulation.edge(corner.ideal)))
          is_divided_[face(i)] = true;
        const std::uint32_t node = nodes.find(corner.node);
        if (number[node] == none) {
          number[node] = std::uint32_t(map_.places.size());
          map_.places.push_back(given_place(overlay.nodes()[node]));
        }
        vertices.push_back(number[node]);
      }
      note_corners_of_input(piece, uv, vertices);
      Convex_polygon_triangulation(in_space).for_each_triangle([&](std::size_t a, std::size_t b, std::size_t c) {
        if (vertices[a] == vertices[b] || vertices[b] == vertices[c] || vertices[c] == vertices[a])
          return;
        if (!turns_left(uv[a], uv[b], uv[c]))
          map_.turned.push_back(map_.triangles.size());
        map_.triangles.push_back({vertices[a], vertices[b], vertices[c]});
        map_.uv.push_back({uv[a], uv[b], uv[c]});
        map_.input_faces.push_back(given_face(piece.input));
      });
      map_.first_of_face[face(i) + 1] = map_.triangles.size();
    }
    for (std::size_t f = 0; f + 1 < map_.first_of_face.size(); ++f)
      map_.first_of_face[f + 1] = (std::max)(map_.first_of_face[f + 1], map_.first_of_face[f]);
  }

  // The sides whose two images differ. With several edges between the same vertices, the first two sides that fit count.
  void mark_cuts()
  {
    map_.is_cut.assign(map_.triangles.size(), {false, false, false});
    std::map<std::array<std::uint32_t, 2>, std::vector<std::size_t>> sides;
    for (std::size_t s = 0; s < 3 * map_.triangles.size(); ++s) {
      const auto& t = map_.triangles[s / 3];
      sides[{t[s % 3], t[(s + 1) % 3]}].push_back(s);
    }
    const auto end = [&](std::size_t s, std::size_t i) { return map_.uv[s / 3][(s % 3 + i) % 3]; };
    for (const auto& [vertices, found] : sides)
      if (const auto others = sides.find({vertices[1], vertices[0]}); others != sides.end())
        for (std::size_t s : found)
          map_.is_cut[s / 3][s % 3] = std::none_of(others->second.begin(), others->second.end(), [&](std::size_t o) {
            return end(s, 0) == end(o, 1) && end(s, 1) == end(o, 0);
          });
  }

  Face_index given_face(Face_index f) const { return map_.input.face(given_halfedge_[input_.halfedge(f).idx()]); }

  Surface_point place_of_vertex(Vertex_index v) const
  {
    if (v.idx() >= map_.input.number_of_vertices())
      return surface_.location(v);
    const Halfedge_index h = map_.input.halfedge(v);
    return {h.is_valid() ? map_.input.opposite(h) : h, {1, 0, 0}};
  }

  // A point of the double's input that lies in a face of the first copy.
  Surface_point given_place(const Surface_point& p) const
  {
    if (given_halfedge_[p.halfedge.idx()].is_valid())
      return {given_halfedge_[p.halfedge.idx()], p.coordinates};
    return // on an edge
      {given_halfedge_[input_.opposite(p.halfedge).idx()], {p.coordinates[1], p.coordinates[0], 0}};
  }

  // Which of the piece's corners are corners of its input face: those between two sides that are parts of input edges.
  void note_corners_of_input(const Triple_overlay::Piece& piece, const std::vector<Planar_point>& uv,
                             const std::vector<std::uint32_t>& vertices)
  {
    const Halfedge_index first = map_.input.halfedge(given_face(piece.input));
    for (std::size_t i = 0; i < piece.corners.size(); ++i)
      for (Halfedge_index h : {first, map_.input.next(first), map_.input.prev(first)})
        if (map_.input.source(h).idx() == vertices[i])
          input_uv_[h.idx()] = uv[i];
  }

  void check_input()
  {
    for (Face_index f : map_.input.faces()) {
      const Halfedge_index h = map_.input.halfedge(f);
      if (is_divided_[f.idx()])
        map_.divided_input.push_back(f);
      else if (!turns_left(map_.input_uv[h.idx()], map_.input_uv[map_.input.next(h).idx()],
                           map_.input_uv[map_.input.prev(h).idx()]))
        map_.turned_input.push_back(f);
    }
  }

  // The sides of triangles without another triangle at the same side.
  std::vector<std::array<Planar_point, 2>> border_of_image() const
  {
    std::map<std::array<Planar_point, 2>, int> sides;
    for (const auto& t : map_.uv)
      for (std::size_t i = 0; i < 3; ++i) {
        const Planar_point &p = t[i], &q = t[(i + 1) % 3];
        if (const auto other = sides.find({q, p}); other != sides.end() && --other->second == 0)
          sides.erase(other);
        else if (other == sides.end())
          ++sides[{p, q}];
      }
    std::vector<std::array<Planar_point, 2>> result;
    for (const auto& [side, count] : sides)
      result.insert(result.end(), std::size_t(count), side);
    return result;
  }

  static constexpr std::uint32_t none = std::uint32_t(-1);

  const Doubled_surface::Triangulation& surface_;
  const Doubled_surface& doubled_;
  const Progress_function& progress_;
  const Delta_complex& input_;
  std::vector<Halfedge_index> given_halfedge_; // of the surface's input, for each halfedge of the first copy
  std::vector<Planar_point> input_uv_;
  std::vector<bool> is_divided_;
  Conformal_map map_;
};

} // namespace

// By increasing x, with those that are not passed yet.
bool have_common_points(std::vector<std::array<std::array<double, 2>, 2>> segments)
{
  std::vector<std::array<Planar_point, 2>> ordered = segments;
  for (auto& s : ordered)
    if (s[1] < s[0])
      std::swap(s[0], s[1]);
  std::sort(ordered.begin(), ordered.end());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const Planar_point &p = ordered[i][0], &q = ordered[i][1];
    open.erase(std::remove_if(open.begin(), open.end(), [&](std::size_t j) { return ordered[j][1][0] < p[0]; }),
               open.end());
    for (std::size_t j : open) {
      const auto& [r, s] = ordered[j];
      const auto [low, high] = std::minmax(p[1], q[1]);
      if ((r[1] < low && s[1] < low) || (r[1] > high && s[1] > high))
        continue;
      const auto a = orientation_in_plane(p, q, r), b = orientation_in_plane(p, q, s),
                 c = orientation_in_plane(r, s, p), d = orientation_in_plane(r, s, q);
      const bool share_end = p == r || p == s || q == r || q == s;
      if (a == CGAL::COLLINEAR && b == CGAL::COLLINEAR) {
        const Planar_point first = (std::max)(p, r), last = (std::min)(q, s);
        if (first < last || (first == last && !share_end))
          return true;
      } else if (!share_end && a * b <= 0 && c * d <= 0) {
        return true;
      }
    }
    open.push_back(i);
  }
  return false;
}

Conformal_map lay_out(const Doubled_surface::Triangulation& surface, const Doubled_surface& doubled,
                      Discrete_conformal_metric metric, const Progress_function& progress)
{
  return Conformal_map_builder(surface, doubled, std::move(metric), progress).run();
}

} // namespace internal

namespace {

// The barycentric coordinates of p in a triangle; the least is negative outside.
std::array<double, 3> planar_coordinates(const std::array<Conformal_map::Point, 3>& t, const Conformal_map::Point& p)
{
  std::array<double, 3> result;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &q = t[(i + 1) % 3], &r = t[(i + 2) % 3];
    sum += result[i] = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }
  for (double& x : result)
    x = sum > 0 ? x / sum : -std::numeric_limits<double>::infinity();
  return result;
}

// The triangle for which `coordinates` gives the largest least coordinate.
template <class Coordinates>
std::pair<std::size_t, std::array<double, 3>> best_triangle(std::size_t first, std::size_t end,
                                                            const Coordinates& coordinates)
{
  std::pair<std::size_t, std::array<double, 3>> best{first, {1, 0, 0}};
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < end; ++i) {
    const std::array<double, 3> x = coordinates(i);
    const double least = (std::min)({x[0], x[1], x[2]});
    if (least > largest) {
      largest = least;
      best = {i, x};
    }
  }
  for (double& x : best.second)
    x = (std::max)(x, 0.);
  best.second = internal::with_sum_one(best.second);
  return best;
}

} // namespace

Conformal_map::Point Conformal_map::to_plane(const Surface_point& point) const
{
  if (!(point.halfedge.idx() < input.number_of_halfedges()) || input.is_border(point.halfedge))
    throw Invalid_point_error("a point has to be given in a face of the input");
  for (double x : point.coordinates)
    if (!(x >= 0 && x <= (std::numeric_limits<double>::max)()))
      throw Invalid_point_error("a barycentric coordinate is negative or not finite");
  if (point.coordinates == std::array<double, 3>{0, 0, 0})
    throw Invalid_point_error("the barycentric coordinates of a point are all zero");
  const Face_index f = input.face(point.halfedge);
  if (first_of_face[f.idx()] == first_of_face[f.idx() + 1]) // all of it has one image, up to rounding
    return input_uv[input.halfedge(f).idx()];
  const auto in_face = [&](const Surface_point& p) {
    const std::array<double, 3> x = coordinates_in_face(p, f);
    return Point{x[1], x[2]};
  };
  const Point p = in_face({point.halfedge, internal::with_sum_one(point.coordinates)});
  const auto [i, x] = best_triangle(first_of_face[f.idx()], first_of_face[f.idx() + 1], [&](std::size_t j) {
    return planar_coordinates(
      {in_face(places[triangles[j][0]]), in_face(places[triangles[j][1]]), in_face(places[triangles[j][2]])}, p);
  });
  Point result{0, 0};
  for (std::size_t k = 0; k < 3; ++k)
    result = {result[0] + x[k] * uv[i][k][0], result[1] + x[k] * uv[i][k][1]};
  return result;
}

Surface_point Conformal_map::to_surface(const Point& point) const
{
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || triangles.empty())
    throw Invalid_point_error("a coordinate is not finite, or the map has no triangle");
  const auto [i, x] =
    best_triangle(0, triangles.size(), [&](std::size_t j) { return planar_coordinates(uv[j], point); });
  const Face_index f = input_faces[i];
  Surface_point result{input.halfedge(f), {0, 0, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 3> y = coordinates_in_face(places[triangles[i][k]], f);
    for (std::size_t c = 0; c < 3; ++c)
      result.coordinates[c] += x[k] * y[c];
  }
  return result;
}

// Of a point in a face or on its border, relative to `input.halfedge(f)`.
std::array<double, 3> Conformal_map::coordinates_in_face(const Surface_point& p, Face_index f) const
{
  const Halfedge_index first = input.halfedge(f);
  if (input.face(p.halfedge) == f)
    return coordinates_from(input, p, first);
  const std::array<Halfedge_index, 3> sides{first, input.next(first), input.prev(first)};
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<double, 3> result{0, 0, 0};
    if (p.dimension() == 1 && input.opposite(sides[i]) == internal::side_of(input, p)) {
      const auto [source, target] = internal::coordinates_on_edge(input, p, sides[i]);
      result[i] = source;
      result[(i + 1) % 3] = target;
      return result;
    }
    const Vertex_index v = p.coordinates[0] > 0   ? input.source(p.halfedge)
                           : p.coordinates[1] > 0 ? input.target(p.halfedge)
                                                  : input.target(input.next(p.halfedge));
    if (p.dimension() == 0 && input.source(sides[i]) == v) {
      result[i] = 1;
      return result;
    }
  }
  return {1, 0, 0}; // not in the face
}

} // namespace CGAL::Intrinsic_triangulations
