// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A conformal metric laid out, overlaid with the input, and checked.

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/convex_polygon_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/planar_orientation.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include "Conformal_layout.h"
#include "Triple_overlay.h"

#include <boost/geometry/algorithms/intersects.hpp> // the tree needs it with Boost 1.83
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Planar_point = Conformal_map::Point;
using Planar_segment = std::array<Planar_point, 2>;

// Whether segments have a common point other than a common end.
bool have_common_point(Planar_segment first, Planar_segment second)
{
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  const auto& [p, q] = first;
  const auto& [r, s] = second;
  const auto a = planar_orientation(p, q, r), b = planar_orientation(p, q, s), c = planar_orientation(r, s, p),
             d = planar_orientation(r, s, q);
  const bool share_end = p == r || p == s || q == r || q == s;
  if (a != CGAL::COLLINEAR || b != CGAL::COLLINEAR)
    return !share_end && a * b <= 0 && c * d <= 0;
  const Planar_point from = (std::max)(p, r), to = (std::min)(q, s);
  return from < to || (from == to && !share_end);
}

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

Planar_point between(const Planar_point& p, const Planar_point& q, double t)
{
  return {(1 - t) * p[0] + t * q[0], (1 - t) * p[1] + t * q[1]};
}

// The overlay of the Delaunay triangulation of a surface and the triangulation that flips make of it.
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
    : surface_(surface), doubled_(doubled), progress_(progress), unit_(doubled.unit),
      input_(doubled.triangulation.input()), given_halfedge_(input_.number_of_halfedges())
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
    // In a double, only the overlay tells where the given half is.
    std::vector<bool> is_inside(metric.triangulation.number_of_halfedges(), !doubled_.is_doubled);
    const Common_subdivision subdivision(doubled_.triangulation,
                                         parameters::visitor(part_of_progress(progress_, 0, 0.2)));
    std::vector<double> u;
    for (Vertex_index v : doubled_.vertices)
      u.push_back(metric.u[v.idx()]);
    Triple_overlay overlay(
      subdivision, metric.triangulation,
      overlay_of_flips(doubled_.triangulation.connectivity(), metric.flips, part_of_progress(progress_, 0.2, 0.4)),
      doubled_.lengths, u, part_of_progress(progress_, 0.4, 0.5));
    if (doubled_.is_doubled)
      overlay.for_each_piece(
        [&](const Triple_overlay::Piece& piece) {
          if (doubled_.is_given(piece.input))
            for (const Triple_overlay::Corner& corner : piece.corners)
              if (corner.ideal.is_valid())
                is_inside[corner.ideal.idx()] = true;
        },
        part_of_progress(progress_, 0.5, 0.6));
    std::vector<double> lengths;
    for (double l : metric.lengths)
      lengths.push_back(std::ldexp(l, -unit_));
    const Conformal_layout layout(metric.triangulation, lengths, unit_, is_inside, ends_of_cuts());
    map_.is_certified = layout.is_certified();
    map_.seam = std::ldexp(layout.seam(), unit_);
    if (only_if_certified && !map_.is_certified)
      return std::move(map_);
    add_triangles(overlay, layout);
    map_.overlaps = have_common_points(border_);
    find_stretch();
    finish_input(layout);
    for (std::array<Planar_point, 3>& corners : map_.uv)
      for (Planar_point& p : corners)
        scale_to_input(p);
    for (Planar_point& p : map_.input_uv)
      scale_to_input(p);
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

  // Inside the image, or on a cut along a side of the input triangle, or through it.
  enum class Side : char {
    UNCUT,
    CUT_ALONG,
    CUT_THROUGH
  };

  struct Triangle
  {
    std::uint32_t face;
    std::array<std::uint32_t, 3> nodes;
    std::array<Planar_point, 3> uv;
    std::array<Side, 3> sides; // to the next corners
  };

  void add_triangles(Triple_overlay& overlay, const Conformal_layout& layout)
  {
    map_.input_uv.assign(map_.input.number_of_halfedges(), {0, 0});
    is_divided_.assign(map_.input.number_of_faces(), false);
    has_image_.assign(map_.input.number_of_halfedges(), false);
    std::vector<Triangle> triangles;
    overlay.for_each_piece(
      [&](const Triple_overlay::Piece& piece) {
        if (doubled_.is_given(piece.input))
          add_piece(piece, layout, triangles);
      },
      part_of_progress(progress_, 0.6, 1));
    // Where edges of the three triangulations meet in one point, or nearly, nodes have the same image: they are one.
    Disjoint_sets nodes(overlay.nodes().size());
    for (const auto& [a, b] : same_)
      nodes.unite(a, b);
    // Between a side of the input and a cut along it, a triangle may have collapsed: both sides of the cut are there.
    std::set<std::array<std::uint32_t, 2>> collapsed;
    std::vector<bool> is_at_collapsed(overlay.nodes().size(), false);
    for (auto [a, b] : collapsed_) {
      a = nodes.find(a), b = nodes.find(b);
      is_at_collapsed[a] = is_at_collapsed[b] = true;
      collapsed.insert({(std::min)(a, b), (std::max)(a, b)});
    }
    std::vector<std::uint32_t> number(overlay.nodes().size(), none);
    for (Vertex_index v : surface_.connectivity().vertices()) {
      const Vertex_index image = doubled_.images[v.idx()];
      if (image.is_valid()) // it has a face, or the surface is closed
        number[image.idx()] = v.idx();
      map_.places.push_back(place_of_vertex(v));
      map_.weights.push_back(image.is_valid() ? overlay.weights()[image.idx()] : 1);
    }
    // Sorts the pieces by input face.
    std::vector<std::size_t>& first = map_.first_of_face;
    first.assign(map_.input.number_of_faces() + 1, 0);
    std::vector<std::size_t> order(triangles.size()), next = first;
    for (const Triangle& t : triangles)
      ++next[t.face + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (std::size_t i = 0; i < triangles.size(); ++i)
      order[next[triangles[i].face]++] = i;
    for (std::size_t i : order) {
      Triangle& t = triangles[i];
      for (std::uint32_t& node : t.nodes)
        node = nodes.find(node);
      const auto& [a, b, c] = t.nodes;
      if (a == b || b == c || c == a)
        continue;
      std::array<bool, 3>& is_cut = map_.is_cut.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [from, to] = std::minmax(t.nodes[k], t.nodes[(k + 1) % 3]);
        const bool is_beside = is_at_collapsed[from] && is_at_collapsed[to] && collapsed.count({from, to}) > 0;
        is_cut[k] = is_beside || t.sides[k] != Side::UNCUT;
        if (!is_beside && t.sides[k] == Side::CUT_THROUGH)
          is_divided_[t.face] = true;
      }
      for (std::uint32_t& node : t.nodes) {
        if (number[node] == none) {
          number[node] = std::uint32_t(map_.places.size());
          map_.places.push_back(given_place(overlay.nodes()[node]));
          map_.weights.push_back(overlay.weights()[node]);
        }
        node = number[node];
      }
      if (planar_orientation(t.uv[0], t.uv[1], t.uv[2]) != LEFT_TURN)
        map_.turned.push_back(map_.triangles.size());
      map_.triangles.push_back(t.nodes);
      map_.uv.push_back(t.uv);
      map_.input_faces.emplace_back(t.face);
      first[t.face + 1] = map_.triangles.size();
    }
    std::partial_sum(first.begin(), first.end(), first.begin(), [](auto a, auto b) { return (std::max)(a, b); });
  }

  void add_piece(const Triple_overlay::Piece& piece, const Conformal_layout& layout, std::vector<Triangle>& triangles)
  {
    const auto at = [&](const Triple_overlay::Ideal_point& p) {
      const Halfedge_index h = p.side, next = map_.metric.triangulation.next(h);
      return (h.idx() & 1) ? between(layout.corner(next), layout.corner(h), p.t)
                           : between(layout.corner(h), layout.corner(next), p.t);
    };
    const std::vector<Triple_overlay::Corner>& corners = piece.corners;
    images_.clear();
    for (const Triple_overlay::Corner& c : corners)
      images_.push_back(layout.rounded(c.t == 0 ? at(c.from) : between(at(c.from), at(c.to), c.t)));
    const Face_index face = given_face(piece.input);
    std::vector<std::size_t> kept;
    std::vector<Side> sides; // to the next corners
    in_space_.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t next = k + 1 == corners.size() ? 0 : k + 1;
      const std::uint32_t a = corners[k].node, b = corners[next].node;
      const Halfedge_index ideal = corners[k].ideal, input = corners[k].input;
      if ((std::max)(a, b) >= doubled_.vertices.size() && images_[k] == images_[next]) {
        same_.push_back({a, b});
        continue;
      }
      kept.push_back(k);
      in_space_.push_back({images_[k][0], images_[k][1], 0});
      const bool is_cut = ideal.is_valid() && layout.is_cut(ideal);
      sides.push_back(!is_cut ? Side::UNCUT : input.is_valid() ? Side::CUT_ALONG : Side::CUT_THROUGH);
      const bool is_on_border = input.is_valid() && !doubled_.is_given(input_.face(input_.opposite(input)));
      if (is_on_border || is_cut)
        border_.push_back({images_[k], images_[next]});
    }
    const bool has_collapsed = kept.size() < 3; // so it may be on the other side of a cut along the input
    const Halfedge_index h = map_.input.halfedge(face);
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (corners[k].node < doubled_.vertices.size())
        for (Halfedge_index side : {h, map_.input.next(h), map_.input.prev(h)})
          if (map_.input.source(side) == doubled_.vertices[corners[k].node] &&
              !(has_collapsed && has_image_[side.idx()])) {
            map_.input_uv[side.idx()] = images_[k];
            has_image_[side.idx()] = !has_collapsed;
          }
    if (kept.size() == 2 && (sides[0] != Side::UNCUT || sides[1] != Side::UNCUT))
      collapsed_.push_back({corners[kept[0]].node, corners[kept[1]].node});
    if (has_collapsed)
      return;
    Convex_polygon_triangulation(in_space_).for_each_triangle([&](std::size_t a, std::size_t b, std::size_t c) {
      const std::size_t i = kept[a], j = kept[b], k = kept[c];
      triangles.push_back({face.idx(),
                           {corners[i].node, corners[j].node, corners[k].node},
                           {images_[i], images_[j], images_[k]},
                           {b == a + 1 ? sides[a] : Side::UNCUT, c == b + 1 ? sides[b] : Side::UNCUT,
                            c == a + kept.size() - 1 ? sides[c] : Side::UNCUT}});
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

  // The point of the given surface for a point of the double's input that lies in a face of the first copy.
  Surface_point given_place(const Surface_point& p) const
  {
    if (given_halfedge_[p.halfedge.idx()].is_valid())
      return {given_halfedge_[p.halfedge.idx()], p.coordinates};
    return // on an edge
      {given_halfedge_[input_.opposite(p.halfedge).idx()], {p.coordinates[1], p.coordinates[0], 0}};
  }

  void find_stretch()
  {
    using Complex = std::complex<double>;
    const double scale = std::ldexp(1., unit_ - surface_.unit_exponent()); // to that of the input metric
    for (Face_index f : map_.input.faces()) {
      const Halfedge_index h = map_.input.halfedge(f);
      const auto squared = [&](Halfedge_index side) {
        return surface_.input_metric().squared_length_double_double(map_.input, map_.input.edge(side)).hi();
      };
      // The face, with its first side on the real axis.
      const double s = squared(h), third = squared(map_.input.prev(h)), width = std::sqrt(s),
                   x = (s + third - squared(map_.input.next(h))) / (2 * width);
      const Complex apex(x, std::sqrt((std::max)(0., third - x * x)));
      for (std::size_t i = map_.first_of_face[f.idx()]; i < map_.first_of_face[f.idx() + 1]; ++i) {
        const auto b = map_.in_face(i);
        const auto side = [&](std::size_t k) { return (b[k][0] - b[0][0]) * width + (b[k][1] - b[0][1]) * apex; };
        const auto image = [&](std::size_t k) {
          return scale * Complex(map_.uv[i][k][0] - map_.uv[i][0][0], map_.uv[i][k][1] - map_.uv[i][0][1]);
        };
        // The linear map is z -> a z + b conj(z).
        const Complex p = side(1), q = side(2), u = image(1), v = image(2);
        const double area = 2 * std::abs((std::conj(p) * q).imag()),
                     rotating = std::abs(u * std::conj(q) - v * std::conj(p)) / area,
                     mirroring = std::abs(v * p - u * q) / area;
        map_.stretch.push_back({rotating + mirroring, std::abs(rotating - mirroring)});
      }
    }
  }

  void scale_to_input(Planar_point& p) const { p = {std::ldexp(p[0], unit_), std::ldexp(p[1], unit_)}; }

  void finish_input(const Conformal_layout& layout)
  {
    for (Face_index f : map_.input.faces()) {
      const Halfedge_index h = map_.input.halfedge(f);
      if (is_divided_[f.idx()]) {
        map_.divided_input.push_back(f);
        extend_largest_part(f, layout);
      }
      const auto uv = [&](Halfedge_index side) { return map_.input_uv[side.idx()]; };
      if (planar_orientation(uv(h), uv(map_.input.next(h)), uv(map_.input.prev(h))) != LEFT_TURN)
        map_.turned_input.push_back(f);
    }
  }

  // Extends the largest of the parts into which cuts divide an input triangle.
  void extend_largest_part(Face_index f, const Conformal_layout& layout)
  {
    const std::size_t first = map_.first_of_face[f.idx()], n = map_.first_of_face[f.idx() + 1] - first;
    Disjoint_sets parts(n);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> open; // sides
    std::vector<double> areas(n), sums(n, 0.);
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto& t = map_.triangles[first + i];
      for (std::size_t k = 0; k < 3; ++k)
        if (!map_.is_cut[first + i][k]) {
          const auto [other, is_new] = open.insert({std::minmax(t[k], t[(k + 1) % 3]), i});
          if (!is_new)
            parts.unite(i, other->second);
        }
      const auto [p, q, r] = map_.in_face(first + i);
      areas[i] = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    }
    for (std::uint32_t i = 0; i < n; ++i)
      sums[parts.find(i)] += areas[i];
    const auto part = std::uint32_t(std::max_element(sums.begin(), sums.end()) - sums.begin());
    std::size_t largest = part;
    for (std::uint32_t i = 0; i < n; ++i)
      if (parts.find(i) == part && areas[i] > areas[largest])
        largest = i;
    Halfedge_index h = map_.input.halfedge(f);
    for (int c = 0; c < 3; ++c, h = map_.input.next(h)) {
      map_.input_uv[h.idx()] = layout.rounded(map_.extended(first + largest, {double(c == 1), double(c == 2)}));
      for (std::uint32_t i = 0; i < n; ++i) // a corner of the part itself
        for (std::size_t k = 0; k < 3; ++k)
          if (parts.find(i) == part && map_.triangles[first + i][k] == map_.input.source(h).idx())
            map_.input_uv[h.idx()] = map_.uv[first + i][k];
    }
  }

  static constexpr std::uint32_t none = std::uint32_t(-1);

  const Doubled_surface::Triangulation& surface_;
  const Doubled_surface& doubled_;
  const Progress_function& progress_;
  int unit_; // the map is in the unit of `doubled_` until it is complete
  const Delta_complex& input_;
  std::vector<Halfedge_index> given_halfedge_; // of the surface's input, for each halfedge of the first copy
  std::vector<bool> is_divided_, has_image_;   // input faces; corners of them
  std::vector<Planar_segment> border_;         // of the image
  std::vector<std::array<std::uint32_t, 2>> same_, collapsed_; // nodes; ends of pieces that have collapsed to one side
  std::vector<Planar_point> images_;                           // of a piece's corners
  std::vector<std::array<double, 3>> in_space_;
  Conformal_map map_;
};

} // namespace

Conformal_map find_conformal_map(const Doubled_surface::Triangulation& surface, Conformal_options options,
                                 const Factorize& factorize)
{
  const Progress_function whole = options.progress, progress = part_of_progress(whole, 0.6, 1);
  options.progress = part_of_progress(whole, 0, 0.6);
  const Doubled_surface doubled(surface, options.progress);
  constexpr int maximum_number_of_attempts = 6;
  for (int attempt = 1;; ++attempt) {
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
          (map.metric.range_of_u > 10
             ? ", since u has a range of " + std::to_string(map.metric.range_of_u) + ": allow more cones"
             : ", since they are too thin for the spacing of doubles: repair them, or map a part of the surface"));
    } catch (const Numerical_error&) {
      if (!can_choose)
        throw;
    }
    options.largest_range *= 0.6;
    options.largest_range_with_border *= 0.6;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
