// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Conformal_map.h.

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include "Conformal_layout.h"
#include "Triple_overlay.h"
#include "planar_predicates.h"

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp> // the tree needs them with Boost 1.83

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

using Planar_point = Conformal_map::Point;

// Other than a common end.
bool have_common_point(Planar_segment first, Planar_segment second)
{
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  const auto& [p, q] = first;
  const auto& [r, s] = second;
  const auto a = orientation_in_plane(p, q, r), b = orientation_in_plane(p, q, s), c = orientation_in_plane(r, s, p),
             d = orientation_in_plane(r, s, q);
  const bool share_end = p == r || p == s || q == r || q == s;
  if (a != CGAL::COLLINEAR || b != CGAL::COLLINEAR)
    return !share_end && a * b <= 0 && c * d <= 0;
  const Planar_point from = (std::max)(p, r), to = (std::min)(q, s);
  return from < to || (from == to && !share_end);
}

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

  // \param only_if_certified whether a map that is not certified stays without triangles
  Conformal_map run(bool only_if_certified)
  {
    const Discrete_conformal_metric& metric = map_.metric;
    // Of a double, only the overlay tells where the given half is.
    std::vector<bool> is_inside(metric.triangulation.number_of_halfedges(), !doubled_.is_doubled);
    std::optional<Common_subdivision> subdivision;
    std::optional<Triple_overlay> overlay;
    const auto make_overlay = [&] {
      subdivision.emplace(doubled_.triangulation, parameters::visitor(part_of_progress(progress_, 0, 0.2)));
      std::vector<double> u;
      for (Vertex_index v : doubled_.vertices)
        u.push_back(metric.u[v.idx()]);
      overlay.emplace(
        *subdivision, metric.triangulation,
        overlay_of_flips(doubled_.triangulation.connectivity(), metric.flips, part_of_progress(progress_, 0.2, 0.4)),
        doubled_.lengths, u, part_of_progress(progress_, 0.4, 0.9));
    };
    if (doubled_.is_doubled) {
      make_overlay();
      for (const Triple_overlay::Piece& piece : overlay->pieces())
        if (doubled_.is_given(piece.input))
          for (const Triple_overlay::Corner& corner : piece.corners)
            if (corner.ideal.is_valid())
              is_inside[corner.ideal.idx()] = true;
    }
    const Conformal_layout layout(metric.triangulation, metric.lengths, is_inside, ends_of_cuts());
    map_.is_certified = layout.is_certified();
    map_.seam = layout.seam();
    if (only_if_certified && !map_.is_certified)
      return std::move(map_);
    if (!overlay)
      make_overlay();
    add_triangles(*overlay, layout);
    map_.overlaps = have_common_points(mark_cuts());
    find_stretch();
    finish_input();
    return std::move(map_);
  }

private:
  // Cones, and the border.
  std::vector<bool> ends_of_cuts() const
  {
    std::vector<bool> result, is_cone(map_.metric.u.size(), false);
    for (Vertex_index v : map_.metric.cones)
      is_cone[v.idx()] = true;
    for (Vertex_index v : map_.metric.triangulation.vertices()) {
      const Vertex_index w = doubled_.vertices[v.idx()];
      const Halfedge_index h = surface_.connectivity().halfedge(w);
      result.push_back(is_cone[w.idx()] || (h.is_valid() && surface_.connectivity().is_border(h)));
    }
    return result;
  }

  // In the order of the input faces.
  void add_triangles(const Triple_overlay& overlay, const Conformal_layout& layout)
  {
    std::vector<std::uint32_t> number(overlay.nodes().size(), none);
    for (Vertex_index v : surface_.connectivity().vertices()) {
      const Vertex_index image = doubled_.images[v.idx()];
      if (image.is_valid()) // it has a face, or the surface is closed
        number[image.idx()] = v.idx();
      map_.places.push_back(place_of_vertex(v));
      map_.weights.push_back(image.is_valid() ? overlay.weights()[image.idx()] : 1);
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < overlay.pieces().size(); ++i)
      if (doubled_.is_given(overlay.pieces()[i].input))
        order.push_back(i);
    const auto face = [&](std::size_t i) { return given_face(overlay.pieces()[i].input).idx(); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return face(i) < face(j); });
    map_.first_of_face.assign(map_.input.number_of_faces() + 1, 0);
    map_.input_uv.assign(map_.input.number_of_halfedges(), {0, 0});
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
          map_.weights.push_back(overlay.weights()[node]);
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

  // The sides without another triangle at the same side of the image: the border of the image. If the surface continues
  // there, they are cuts. Where both images of a cut are the same up to rounding, as those of a slit into a flat surface, the
  // image has no border.
  std::vector<Planar_segment> mark_cuts()
  {
    struct Side
    {
      std::uint32_t low, high;
      std::size_t number;
      bool operator<(const Side& o) const { return std::tie(low, high, number) < std::tie(o.low, o.high, o.number); }
    };
    std::vector<Side> sides;
    sides.reserve(3 * map_.triangles.size());
    for (std::size_t s = 0; s < 3 * map_.triangles.size(); ++s) {
      const auto [low, high] = std::minmax(map_.triangles[s / 3][s % 3], map_.triangles[s / 3][(s + 1) % 3]);
      sides.push_back({low, high, s});
    }
    std::sort(sides.begin(), sides.end());
    const auto source = [&](const Side& s) { return map_.triangles[s.number / 3][s.number % 3]; };
    const auto image = [&](const Side& s, std::size_t i) { return map_.uv[s.number / 3][(s.number % 3 + i) % 3]; };
    double largest = 0;
    for (const auto& corners : map_.uv)
      for (const Planar_point& p : corners)
        largest = (std::max)({largest, std::abs(p[0]), std::abs(p[1])});
    const auto are_near = [largest](const Planar_point& p, const Planar_point& q) {
      return std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) <= 1e-12 * largest;
    };
    map_.is_cut.assign(map_.triangles.size(), {false, false, false});
    std::vector<Planar_segment> border;
    for (auto first = sides.begin(), end = first; first != sides.end(); first = end) {
      while (end != sides.end() && end->low == first->low && end->high == first->high)
        ++end;
      for (auto s = first; s != end; ++s) {
        bool has_other = false, fits = false, nearly_fits = false;
        for (auto o = first; o != end; ++o)
          if (source(*o) != source(*s)) {
            has_other = true;
            fits = fits || (image(*s, 0) == image(*o, 1) && image(*s, 1) == image(*o, 0));
            nearly_fits = nearly_fits || (are_near(image(*s, 0), image(*o, 1)) && are_near(image(*s, 1), image(*o, 0)));
          }
        map_.is_cut[s->number / 3][s->number % 3] = has_other && !fits;
        if (!nearly_fits)
          border.push_back({image(*s, 0), image(*s, 1)});
      }
    }
    return border;
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
          map_.input_uv[h.idx()] = uv[i];
  }

  // The corners of a triangle, as parts of its face.
  std::array<std::array<double, 3>, 3> corners_in_face(std::size_t i) const
  {
    std::array<std::array<double, 3>, 3> result;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = map_.coordinates_in_face(map_.places[map_.triangles[i][k]], map_.input_faces[i]);
    return result;
  }

  void find_stretch()
  {
    for (std::size_t i = 0; i < map_.triangles.size(); ++i) {
      const Halfedge_index h = map_.input.halfedge(map_.input_faces[i]);
      const auto squared = [&](Halfedge_index side) {
        return surface_.input_metric().squared_length_double_double(map_.input, map_.input.edge(side)).hi();
      };
      // The face, with its first side on the x-axis.
      const double s = squared(h), width = std::sqrt(s),
                   x = (s + squared(map_.input.prev(h)) - squared(map_.input.next(h))) / (2 * width),
                   y = std::sqrt((std::max)(0., squared(map_.input.prev(h)) - x * x));
      const auto b = corners_in_face(i);
      const auto side = [&](std::size_t k) {
        return Planar_point{(b[k][1] - b[0][1]) * width + (b[k][2] - b[0][2]) * x, (b[k][2] - b[0][2]) * y};
      };
      const auto image = [&](std::size_t k) {
        return Planar_point{map_.uv[i][k][0] - map_.uv[i][0][0], map_.uv[i][k][1] - map_.uv[i][0][1]};
      };
      const Planar_point p = side(1), q = side(2), u = image(1), v = image(2);
      const double area = p[0] * q[1] - p[1] * q[0];
      const double a = (u[0] * q[1] - v[0] * p[1]) / area, c = (u[1] * q[1] - v[1] * p[1]) / area,
                   d = (v[1] * p[0] - u[1] * q[0]) / area, e = (v[0] * p[0] - u[0] * q[0]) / area;
      const double half_sum = std::hypot(a + d, c - e) / 2, half_difference = std::hypot(a - d, e + c) / 2;
      map_.stretch.push_back({half_sum + half_difference, std::abs(half_sum - half_difference)});
    }
  }

  void finish_input()
  {
    for (Face_index f : map_.input.faces()) {
      const Halfedge_index h = map_.input.halfedge(f);
      if (is_divided_[f.idx()]) {
        map_.divided_input.push_back(f);
        extend_largest_part(f);
      }
      if (!turns_left(map_.input_uv[h.idx()], map_.input_uv[map_.input.next(h).idx()],
                      map_.input_uv[map_.input.prev(h).idx()]))
        map_.turned_input.push_back(f);
    }
  }

  // Of the parts into which cuts divide an input triangle.
  void extend_largest_part(Face_index f)
  {
    const std::size_t first = map_.first_of_face[f.idx()], n = map_.first_of_face[f.idx() + 1] - first;
    Disjoint_sets parts(n);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> open; // sides
    std::vector<double> areas(n), sums(n, 0.);
    for (std::size_t i = 0; i < n; ++i) {
      const auto& t = map_.triangles[first + i];
      for (std::size_t k = 0; k < 3; ++k)
        if (!map_.is_cut[first + i][k]) {
          const auto [other, is_new] = open.insert({std::minmax(t[k], t[(k + 1) % 3]), i});
          if (!is_new)
            parts.unite(std::uint32_t(i), std::uint32_t(other->second));
        }
      const auto b = corners_in_face(first + i);
      areas[i] = (b[1][1] - b[0][1]) * (b[2][2] - b[0][2]) - (b[1][2] - b[0][2]) * (b[2][1] - b[0][1]);
    }
    for (std::size_t i = 0; i < n; ++i)
      sums[parts.find(std::uint32_t(i))] += areas[i];
    if (n == 0)
      return;
    const auto part = std::uint32_t(std::max_element(sums.begin(), sums.end()) - sums.begin());
    std::size_t largest = part;
    for (std::size_t i = 0; i < n; ++i)
      if (parts.find(std::uint32_t(i)) == part && areas[i] > areas[largest])
        largest = i;
    const auto b = corners_in_face(first + largest);
    const auto& uv = map_.uv[first + largest];
    Halfedge_index h = map_.input.halfedge(f);
    for (std::size_t c = 0; c < 3; ++c, h = map_.input.next(h)) {
      // Its coordinates with respect to the largest triangle of the part.
      const double x = (c == 1) - b[0][1], y = (c == 2) - b[0][2];
      const double s = (x * (b[2][2] - b[0][2]) - y * (b[2][1] - b[0][1])) / areas[largest],
                   t = (y * (b[1][1] - b[0][1]) - x * (b[1][2] - b[0][2])) / areas[largest];
      for (std::size_t k = 0; k < 2; ++k)
        map_.input_uv[h.idx()][k] = uv[0][k] + s * (uv[1][k] - uv[0][k]) + t * (uv[2][k] - uv[0][k]);
      for (std::size_t i = 0; i < n; ++i) // a corner of the part itself
        for (std::size_t k = 0; k < 3; ++k)
          if (parts.find(std::uint32_t(i)) == part && map_.triangles[first + i][k] == map_.input.source(h).idx())
            map_.input_uv[h.idx()] = map_.uv[first + i][k];
    }
  }

  static constexpr std::uint32_t none = std::uint32_t(-1);

  const Doubled_surface::Triangulation& surface_;
  const Doubled_surface& doubled_;
  const Progress_function& progress_;
  const Delta_complex& input_;
  std::vector<Halfedge_index> given_halfedge_; // of the surface's input, for each halfedge of the first copy
  std::vector<bool> is_divided_;
  Conformal_map map_;
};

} // namespace

bool have_common_points(const std::vector<Planar_segment>& segments)
{
  namespace bg = boost::geometry;
  using Point = bg::model::point<double, 2, bg::cs::cartesian>;
  using Box = bg::model::box<Point>;
  std::vector<std::pair<Box, std::size_t>> boxes;
  for (const Planar_segment& s : segments) {
    const auto [left, right] = std::minmax(s[0][0], s[1][0]);
    const auto [low, high] = std::minmax(s[0][1], s[1][1]);
    boxes.emplace_back(Box(Point(left, low), Point(right, high)), boxes.size());
  }
  const bg::index::rtree<std::pair<Box, std::size_t>, bg::index::quadratic<16>> tree(boxes);
  for (const auto& [box, i] : boxes)
    for (auto other = tree.qbegin(bg::index::intersects(box)); other != tree.qend(); ++other)
      if (other->second > i && have_common_point(segments[i], segments[other->second]))
        return true;
  return false;
}

Conformal_map find_conformal_map(const Doubled_surface::Triangulation& surface, Conformal_options options,
                                 const Factorize& factorize)
{
  const Progress_function whole = options.progress, progress = part_of_progress(whole, 0.6, 1);
  options.progress = part_of_progress(whole, 0, 0.6);
  const Doubled_surface doubled(surface, options.progress);
  constexpr int maximum_number_of_attempts = 6;
  for (int attempt = 1;; ++attempt, options.largest_range *= 0.6) {
    const bool can_choose =
      !options.number_of_cones && options.cone_angles.empty() && attempt < maximum_number_of_attempts;
    try {
      Conformal_map map =
        Conformal_map_builder(surface, doubled, find_conformal_metric(surface, doubled, options, factorize), progress)
          .run(can_choose);
      if (map.is_certified)
        return map;
      if (!can_choose)
        throw Numerical_error(
          "triangles of the conformal map turn over" +
          (map.turned.empty() ? std::string()
                              : ", first in face " + std::to_string(map.input_faces[map.turned.front()].idx())) +
          ", since u has a range of " + std::to_string(map.metric.range_of_u) + ": allow more cones");
    } catch (const Numerical_error&) {
      if (!can_choose)
        throw;
    }
  }
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
