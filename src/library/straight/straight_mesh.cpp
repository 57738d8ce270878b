// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of straight_mesh.h.

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations {
namespace internal {
namespace {

using Point = std::array<double, 3>;

double length(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// In units of a size, so that products neither overflow nor vanish.
Point difference(const Point& p, const Point& q, double size)
{
  return {(p[0] - q[0]) / size, (p[1] - q[1]) / size, (p[2] - q[2]) / size};
}

Point cross_product(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// In degrees; 0 between points that coincide.
double angle(const Point& p, const Point& q, const Point& r)
{
  double size = (std::numeric_limits<double>::min)();
  for (std::size_t i = 0; i < 3; ++i)
    size = (std::max)({size, std::abs(q[i] - p[i]), std::abs(r[i] - p[i])});
  const Point a = difference(q, p, size), b = difference(r, p, size);
  return std::atan2(length(cross_product(a, b)), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * (180 / CGAL_PI);
}

class Straight_mesh_maker
{
public:
  Straight_mesh_maker(const Common_subdivision& subdivision, const std::vector<Point>& points)
    : subdivision_(subdivision), overlay_(subdivision.overlay()), complex_(subdivision.intrinsic()), points_(points)
  {
    for (Vertex_index v : complex_.vertices()) // which the overlay begins with
      mesh_.points.push_back(subdivision_.point(Overlay::Vertex(v.idx()), points_));
  }

  Straight_mesh make(const std::vector<bool>& is_marked, double thin_angle)
  {
    add_triangles();
    find_regions(is_marked);
    find_lines();
    measure_deviation();
    measure_angles(thin_angle);
    find_multiple_edges();
    mesh_.surface = examine_polygons(mesh_.points, mesh_.triangles);
    return std::move(mesh_);
  }

private:
  bool is_loop(Halfedge_index h) const { return complex_.source(h) == complex_.target(h); }

  void add_triangles()
  {
    const std::vector<Face_index> input_faces = largest_input_faces();
    for (Face_index f : complex_.faces()) {
      const Halfedge_index h = complex_.halfedge(f), i = complex_.next(h), j = complex_.prev(h);
      if (is_loop(h) || is_loop(i) || is_loop(j))
        continue;
      mesh_.triangles.push_back({complex_.source(h).idx(), complex_.source(i).idx(), complex_.source(j).idx()});
      mesh_.faces.push_back(f);
      mesh_.input_faces.push_back(input_faces[f.idx()]);
    }
  }

  // For each intrinsic face.
  std::vector<Face_index> largest_input_faces() const
  {
    std::vector<Face_index> result(complex_.number_of_faces());
    std::vector<double> largest(result.size(), -1);
    for (Overlay::Face f : overlay_.faces()) {
      const Overlay::Halfedge first = overlay_.halfedge(f);
      const Point p = subdivision_.point(overlay_.target(first), points_);
      Point q = p, sum{};
      for (Overlay::Halfedge h = overlay_.next(first); h != first; h = overlay_.next(h)) {
        const Point r = subdivision_.point(overlay_.target(h), points_);
        const Point part = cross_product(difference(q, p, 1), difference(r, p, 1));
        for (std::size_t i = 0; i < 3; ++i)
          sum[i] += part[i];
        q = r;
      }
      const std::size_t face = overlay_.intrinsic_face(f).idx();
      if (length(sum) > largest[face]) {
        largest[face] = length(sum);
        result[face] = overlay_.input_face(f);
      } else if (!result[face].is_valid()) { // of a sum that is not a number
        result[face] = overlay_.input_face(f);
      }
    }
    return result;
  }

  // Which intrinsic edges are marked.
  std::vector<bool> marked(const std::vector<bool>& is_marked) const
  {
    std::vector<bool> result(complex_.number_of_edges());
    if (!is_marked.empty())
      for (Edge_index e : complex_.edges()) {
        const auto segments = overlay_.intrinsic_segments(e);
        const Halfedge_index side = overlay_.input_halfedge(overlay_.halfedge(*segments.begin()));
        result[e.idx()] = segments.size() == 1 && side.is_valid() && is_marked[side.idx() >> 1];
      }
    return result;
  }

  void find_regions(const std::vector<bool>& is_marked)
  {
    is_marked_ = marked(is_marked);
    Disjoint_sets sets(complex_.number_of_faces());
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      if (complex_.is_border(e))
        is_marked_[e.idx()] = true;
      else if (!is_marked_[e.idx()])
        sets.unite(complex_.face(h).idx(), complex_.face(complex_.opposite(h)).idx());
    }
    mesh_.number_of_regions = std::uint32_t(sets.number(region_of_face_));
    for (Face_index f : mesh_.faces)
      mesh_.regions.push_back(std::uint32_t(region_of_face_[f.idx()]));
  }

  void find_lines()
  {
    constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
    using Regions = std::pair<std::size_t, std::size_t>;
    std::vector<Regions> regions;
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      if (!is_marked_[e.idx()] || is_loop(h))
        continue;
      const auto region_at = [&](Halfedge_index side) {
        return complex_.is_border(side) ? none : region_of_face_[complex_.face(side).idx()];
      };
      mesh_.marked_edges.push_back({complex_.source(h).idx(), complex_.target(h).idx()});
      regions.push_back(std::minmax(region_at(h), region_at(complex_.opposite(h))));
    }
    Disjoint_sets sets(regions.size());
    std::map<std::pair<std::uint32_t, Regions>, std::uint32_t> edge_at; // a marked edge at each end, by its regions
    for (std::uint32_t i = 0; i < regions.size(); ++i)
      for (std::uint32_t v : mesh_.marked_edges[i])
        sets.unite(edge_at.try_emplace({v, regions[i]}, i).first->second, i);
    std::vector<std::size_t> lines;
    mesh_.number_of_lines = std::uint32_t(sets.number(lines));
    mesh_.lines.assign(lines.begin(), lines.end());
  }

  // At the crossings, as a vertex of the triangulation is a vertex of its triangles but for rounding.
  //
  // In units of u = 2^-53 and of the largest coordinate: both positions have relative errors of 2u, so (1 - t) p + t q
  // has an error of 8u at most in each coordinate, and an inserted vertex as well. Their difference has one of 18u, and
  // its norm one of 32u < 2^-48. The last factor covers the rounding of the norm.
  void measure_deviation()
  {
    double largest = 0, farthest = 0;
    for (const std::vector<Point>& points : {points_, mesh_.points})
      for (const Point& p : points)
        for (double x : p)
          largest = (std::max)(largest, std::abs(x));
    if (overlay_.number_of_vertices() > overlay_.number_of_input_vertices())
      mesh_.deviation = 0x1p-48 * largest;
    for (Overlay::Vertex v : overlay_.crossings()) {
      const Halfedge_index h = complex_.halfedge(overlay_.intrinsic_edge(v));
      const Point &p = mesh_.points[complex_.source(h).idx()], &q = mesh_.points[complex_.target(h).idx()];
      const Point place = subdivision_.point(v, points_);
      const double t = subdivision_.positions().on_intrinsic_edge(v);
      const double distance = std::hypot(place[0] - ((1 - t) * p[0] + t * q[0]), place[1] - ((1 - t) * p[1] + t * q[1]),
                                         place[2] - ((1 - t) * p[2] + t * q[2]));
      if (distance > farthest) {
        farthest = distance;
        mesh_.deviation_place = place;
      }
    }
    mesh_.deviation += farthest * (1 + 0x1p-50);
  }

  void measure_angles(double thin_angle)
  {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      Halfedge_index h = complex_.halfedge(mesh_.faces[t]), smallest = h; // from the corner
      double of_triangle = 180;
      for (std::size_t i = 0; i < 3; ++i, h = complex_.next(h)) {
        const auto point = [&](std::size_t corner) { return mesh_.points[mesh_.triangles[t][corner % 3]]; };
        const double at_corner = angle(point(i), point(i + 1), point(i + 2));
        if (at_corner < of_triangle) {
          of_triangle = at_corner;
          smallest = h;
        }
      }
      mesh_.minimum_angle = (std::min)(mesh_.minimum_angle, of_triangle);
      if (of_triangle < thin_angle) {
        mesh_.thin_triangles.push_back(t);
        mesh_.number_of_sharp_corners +=
          is_marked_[complex_.edge(smallest).idx()] && is_marked_[complex_.edge(complex_.prev(smallest)).idx()];
      }
    }
  }

  void find_multiple_edges()
  {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, Edge_index>> ends;
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      if (is_loop(h)) {
        mesh_.loops.push_back(e);
      } else {
        const auto [a, b] = std::minmax({complex_.source(h).idx(), complex_.target(h).idx()});
        ends.emplace_back(a, b, e);
      }
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (std::get<0>(ends[i]) == std::get<0>(ends[i - 1]) && std::get<1>(ends[i]) == std::get<1>(ends[i - 1]))
        mesh_.multiple_edges.push_back(std::get<2>(ends[i]));
    std::sort(mesh_.multiple_edges.begin(), mesh_.multiple_edges.end());
  }

  const Common_subdivision& subdivision_;
  const Overlay& overlay_;
  const Delta_complex& complex_;
  const std::vector<Point>& points_;
  std::vector<bool> is_marked_;
  std::vector<std::size_t> region_of_face_;
  Straight_mesh mesh_;
};

} // namespace
} // namespace internal

Straight_mesh straight_mesh(const Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points,
                            const std::vector<bool>& is_marked, double thin_angle)
{
  const auto check = [](std::size_t given, const char* what, std::size_t needed, const char* of_what) {
    if (given != needed)
      throw Invalid_argument_error("straight_mesh(): there are " + std::to_string(given) + ' ' + what + " for " +
                                   std::to_string(needed) + ' ' + of_what + " of the input");
  };
  check(points.size(), "points", subdivision.input().number_of_vertices(), "vertices");
  if (!is_marked.empty())
    check(is_marked.size(), "marks", subdivision.input().number_of_edges(), "edges");
  return internal::Straight_mesh_maker(subdivision, points).make(is_marked, thin_angle);
}

std::string message(const Straight_mesh& mesh)
{
  std::ostringstream text;
  const auto begin = [&text] { return text.tellp() == 0 ? "" : "; "; };
  const auto edges = [&](const std::vector<Edge_index>& list, const char* one, const char* several) {
    if (!list.empty())
      text << begin() << list.size() << ' ' << (list.size() == 1 ? one : several) << ", the first is edge "
           << list.front().idx();
  };
  edges(mesh.loops, "edge ends where it begins, so its faces are left out",
        "edges end where they begin, so their faces are left out");
  edges(mesh.multiple_edges, "edge joins the same vertices as another one", "edges join the same vertices as others");
  for (const Finding& finding : mesh.surface.findings)
    if (finding.is_fatal || finding.defect == Invalid_surface_error::Defect::DUPLICATE_FACE) {
      text << begin() << message(finding, "");
      if (finding.elements.empty())
        continue;
      const bool is_vertex = finding.defect == Invalid_surface_error::Defect::NON_MANIFOLD_VERTEX ||
                             finding.defect == Invalid_surface_error::Defect::NOT_FINITE;
      const auto& p = mesh.points[!finding.edges.empty() ? finding.edges.front()[0]
                                  : is_vertex            ? finding.elements.front()
                                                         : mesh.triangles[finding.elements.front()][0]];
      text << " (at " << p[0] << ", " << p[1] << ", " << p[2] << ')';
    }
  return text.str();
}

} // namespace CGAL::Intrinsic_triangulations
