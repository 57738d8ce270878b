// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of straight_mesh.h.

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include "Straight_map.h"
#include "Thin_part_merger.h"
#include "crossing_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations {
namespace internal {
namespace {

using Point = std::array<double, 3>;

class Straight_mesh_maker
{
public:
  Straight_mesh_maker(const Common_subdivision& subdivision, const std::vector<Point>& points,
                      const std::vector<bool>& is_fixed, const std::vector<bool>& must_not_cross,
                      const Progress_function& progress)
    : overlay_(subdivision.overlay()), complex_(subdivision.intrinsic()), map_(subdivision, points),
      is_fixed_(is_fixed), must_not_cross_(must_not_cross), progress_(progress)
  {}

  Straight_mesh make(const std::vector<bool>& is_marked, double thin_angle, double maximum_deviation)
  {
    find_regions(is_marked);
    find_triangles(thin_angle, maximum_deviation);
    measure_angles(thin_angle);
    find_lines();
    find_multiple_edges();
    mesh_.surface = examine_polygons(mesh_.points, mesh_.triangles);
    find_folded_edges();
    const auto edges = complex_.edges();
    const auto is_border = [this](Edge_index e) { return complex_.is_border(e); };
    const std::size_t number =
      std::size_t(std::count_if(edges.begin(), edges.end(), is_border)) + number_of_new_border_parts_;
    mesh_.number_of_new_border_edges = (std::max)(mesh_.surface.number_of_border_edges, number) - number;
    return std::move(mesh_);
  }

  // For each triangle, the faces that it stands for.
  const std::vector<std::vector<Face_index>>& stands_for() const { return stands_for_; }

private:
  using Triangle = std::array<std::uint32_t, 3>;

  bool is_loop(Halfedge_index h) const { return complex_.source(h) == complex_.target(h); }
  // Whether the smallest angle is one between two marked edges.
  bool is_sharp_corner(const Triangle& corners, Face_index f) const
  {
    Halfedge_index h = complex_.halfedge(f);
    for (std::size_t i = smallest_angle(map_.corners(corners)).second; i > 0; --i)
      h = complex_.next(h);
    return is_marked_[complex_.edge(h).idx()] && is_marked_[complex_.edge(complex_.prev(h)).idx()];
  }

  // A loop would be a point: two more points make a triangle of it.
  void divide_loops()
  {
    divisions_.resize(complex_.number_of_edges());
    for (Edge_index e : complex_.edges())
      if (is_loop(complex_.halfedge(e))) {
        mesh_.loops.push_back(e);
        for (std::size_t i = 0; i < 2; ++i)
          divisions_[e.idx()][i] = map_.add_vertex(map_.point_on(e, double(i + 1) / 3));
        if (complex_.is_border(e))
          number_of_new_border_parts_ += 2;
      }
  }
  // The points from the source of h to before its target.
  std::vector<std::uint32_t> points_along(Halfedge_index h) const
  {
    const Edge_index e = complex_.edge(h);
    const std::size_t first = h == complex_.halfedge(e) ? 0 : 1;
    if (is_loop(h))
      return {complex_.source(h).idx(), divisions_[e.idx()][first], divisions_[e.idx()][1 - first]};
    return {complex_.source(h).idx()};
  }
  // One triangle, or more if sides are loops.
  std::vector<Triangle> triangles_in(Face_index f) const
  {
    Halfedge_index h = complex_.halfedge(f);
    for (Halfedge_index side : {complex_.next(h), complex_.prev(h)})
      if (!is_loop(h) && is_loop(side)) // a face has one loop or three
        h = side;
    std::vector<std::uint32_t> p;
    for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
      for (std::uint32_t v : points_along(side))
        p.push_back(v);
    if (p.size() == 3)
      return {{p[0], p[1], p[2]}};
    if (p.size() == 5)
      return {{p[4], p[0], p[1]}, {p[4], p[1], p[2]}, {p[4], p[2], p[3]}};
    return {{p[8], p[0], p[1]}, {p[2], p[3], p[4]}, {p[5], p[6], p[7]}, {p[1], p[2], p[4]},
            {p[1], p[4], p[5]}, {p[1], p[5], p[7]}, {p[1], p[7], p[8]}};
  }

  void find_triangles(double thin_angle, double maximum_deviation)
  {
    Straight_triangles triangles;
    divide_loops();
    for (Face_index f : complex_.faces()) {
      const std::vector<Triangle> parts = triangles_in(f);
      triangles.triangles.insert(triangles.triangles.end(), parts.begin(), parts.end());
      triangles.faces.resize(triangles.triangles.size(), f);
      triangles.is_kept.resize(triangles.triangles.size(), parts.size() == 1 && is_sharp_corner(parts[0], f));
    }
    for (Edge_index e : complex_.edges())
      if (is_marked_[e.idx()]) {
        std::vector<std::uint32_t> points = points_along(complex_.halfedge(e));
        points.push_back(complex_.target(complex_.halfedge(e)).idx());
        for (std::size_t i = 1; i < points.size(); ++i)
          triangles.marked_edges.push_back({points[i - 1], points[i]});
      }
    triangles.is_fixed = is_fixed_;
    triangles.must_not_cross = must_not_cross_;
    Thin_part_merger merger(map_, triangles, thin_angle, maximum_deviation, progress_);
    const Straight_map::Distance distance = merger();
    mesh_.number_of_removed_pieces = merger.number_of_removed_pieces();
    mesh_.number_of_rods = merger.number_of_rods();
    mesh_.area_of_films = merger.area_of_films();
    mesh_.film_place = merger.place_of_film();
    if (maximum_deviation > 0)
      mesh_.number_of_new_components = merger.number_of_new_components();
    number_of_new_border_parts_ += merger.number_of_bent_border_edges();
    images_ = merger.images();
    mesh_.deviation = map_.bound(distance.value);
    mesh_.deviation_place = distance.place;
    const std::vector<Face_index> input_faces = largest_input_faces();
    for (std::size_t t = 0; t < triangles.triangles.size(); ++t)
      if (const Triangle& corners = triangles.triangles[t];
          corners[0] != corners[1] && !merger.is_left_out(std::uint32_t(t))) {
        const Face_index f = triangles.faces[t];
        mesh_.triangles.push_back(corners);
        mesh_.faces.push_back(f);
        stands_for_.push_back(merger.faces_of({std::uint32_t(t)}));
        mesh_.input_faces.push_back(input_faces[f.idx()]);
        mesh_.regions.push_back(std::uint32_t(region_of_face_[f.idx()]));
      }
    number_regions();
    find_points();
    find_marked_edges(triangles.marked_edges);
  }

  // Numbers the points: first vertices of the triangulation, then the copies that triangles have.
  void find_points()
  {
    std::vector<bool> is_used(map_.points().size());
    for (const Triangle& triangle : mesh_.triangles)
      for (std::uint32_t v : triangle)
        is_used[v] = true;
    for (Vertex_index v : complex_.vertices()) {
      is_used[v.idx()] = is_used[v.idx()] || images_[v.idx()] == v.idx();
      if (images_[v.idx()] != v.idx())
        mesh_.merged_vertices.push_back(v);
    }
    for (std::uint32_t v = 0; v < is_used.size(); ++v) {
      numbers_.push_back(std::uint32_t(mesh_.points.size()));
      if (is_used[v])
        mesh_.points.push_back(map_.points()[v]);
    }
    for (Vertex_index v : complex_.vertices())
      mesh_.points_of_vertices.push_back(numbers_[images_[v.idx()]]);
    for (Triangle& triangle : mesh_.triangles)
      for (std::uint32_t& v : triangle)
        v = numbers_[v];
  }

  // For each intrinsic face, the input face that has the largest part of it.
  std::vector<Face_index> largest_input_faces() const
  {
    std::vector<Face_index> result(complex_.number_of_faces());
    std::vector<double> largest(result.size(), -1);
    for (Overlay::Face f : overlay_.faces()) {
      const Overlay::Halfedge first = overlay_.halfedge(f);
      const Point p = map_.position(overlay_.target(first));
      Point q = p, sum{}; // the sum of the areas of the triangles at p, as a vector
      for (Overlay::Halfedge h = overlay_.next(first); h != first; h = overlay_.next(h)) {
        const Point& r = map_.position(overlay_.target(h));
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
          sum[i] += (q[j] - p[j]) * (r[k] - p[k]) - (q[k] - p[k]) * (r[j] - p[j]);
        }
        q = r;
      }
      const double area = std::hypot(sum[0], sum[1], sum[2]);
      const std::size_t face = overlay_.intrinsic_face(f).idx();
      if (area > largest[face]) {
        largest[face] = area;
        result[face] = overlay_.input_face(f);
      } else if (!result[face].is_valid()) { // the area is not a number
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
    sets.number(region_of_face_);
  }

  void find_marked_edges(const std::vector<std::array<std::uint32_t, 2>>& marked_edges)
  {
    for (const auto& [v, w] : marked_edges)
      mesh_.marked_edges.push_back({(std::min)(numbers_[v], numbers_[w]), (std::max)(numbers_[v], numbers_[w])});
    std::sort(mesh_.marked_edges.begin(), mesh_.marked_edges.end());
  }

  // Where the parts between two regions have vanished, these meet without a marked edge, but have a line, too.
  void find_lines()
  {
    std::vector<std::array<std::uint32_t, 3>> sides; // with the region
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [v, w] = std::minmax(mesh_.triangles[t][i], mesh_.triangles[t][(i + 1) % 3]);
        sides.push_back({v, w, mesh_.regions[t]});
      }
    std::sort(sides.begin(), sides.end());
    const std::vector<std::array<std::uint32_t, 2>> marked = std::move(mesh_.marked_edges);
    mesh_.marked_edges.clear();
    std::vector<std::vector<std::uint32_t>> regions; // beside each edge
    for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
      const std::array<std::uint32_t, 2> ends{(*begin)[0], (*begin)[1]};
      while (end != sides.end() && (*end)[0] == ends[0] && (*end)[1] == ends[1])
        ++end;
      if ((*begin)[2] == (*(end - 1))[2] && !std::binary_search(marked.begin(), marked.end(), ends))
        continue;
      mesh_.marked_edges.push_back(ends);
      regions.emplace_back();
      for (auto side = begin; side != end; ++side)
        regions.back().push_back((*side)[2]);
    }
    Disjoint_sets sets(mesh_.marked_edges.size());
    std::map<std::pair<std::uint32_t, std::vector<std::uint32_t>>, std::uint32_t> edge_at; // each end, by the regions
    for (std::uint32_t i = 0; i < mesh_.marked_edges.size(); ++i)
      for (std::uint32_t v : mesh_.marked_edges[i])
        sets.unite(edge_at.try_emplace({v, regions[i]}, i).first->second, i);
    std::vector<std::size_t> lines;
    mesh_.number_of_lines = std::uint32_t(sets.number(lines));
    mesh_.lines.assign(lines.begin(), lines.end());
  }

  // Regions that vanished have no number.
  void number_regions()
  {
    std::vector<std::uint32_t> used = mesh_.regions;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (std::uint32_t& region : mesh_.regions)
      region = std::uint32_t(std::lower_bound(used.begin(), used.end(), region) - used.begin());
    mesh_.number_of_regions = std::uint32_t(used.size());
  }

  void measure_angles(double thin_angle)
  {
    std::vector<std::uint32_t> sharp_corners;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const Triangle& corners = mesh_.triangles[t];
      const auto smallest =
        smallest_angle({mesh_.points[corners[0]], mesh_.points[corners[1]], mesh_.points[corners[2]]});
      const double angle = smallest.first;
      const std::size_t at = smallest.second;
      mesh_.minimum_angle = (std::min)(mesh_.minimum_angle, angle);
      if (angle >= thin_angle)
        continue;
      const auto is_marked = [&](std::size_t side) { // which are in order
        const auto [v, w] = std::minmax(corners[side % 3], corners[(side + 1) % 3]);
        return std::binary_search(mesh_.marked_edges.begin(), mesh_.marked_edges.end(),
                                  std::array<std::uint32_t, 2>{v, w});
      };
      (is_marked(at) && is_marked(at + 2) ? sharp_corners : mesh_.thin_triangles).push_back(t);
    }
    mesh_.number_of_sharp_corners = sharp_corners.size();
    mesh_.thin_triangles.insert(mesh_.thin_triangles.end(), sharp_corners.begin(), sharp_corners.end());
  }

  void find_folded_edges()
  {
    std::vector<std::array<std::uint32_t, 3>> sides; // with the third corner
    for (const Triangle& t : mesh_.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [v, w] = std::minmax(t[i], t[(i + 1) % 3]);
        sides.push_back({v, w, t[(i + 2) % 3]});
      }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const auto& [v, w, x] = sides[i];
      if (sides[i - 1][0] != v || sides[i - 1][1] != w)
        continue;
      const auto& p = mesh_.points;
      const double angle = dihedral_angle(p[v], p[w], p[x], p[sides[i - 1][2]]);
      mesh_.minimum_dihedral_angle = (std::min)(mesh_.minimum_dihedral_angle, angle);
      if (angle < Straight_mesh::smallest_dihedral_angle && mesh_.is_closed())
        mesh_.folded_edges.push_back({v, w});
    }
  }

  void find_multiple_edges()
  {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, Edge_index>> ends;
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      if (!is_loop(h)) {
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

  const Overlay& overlay_;
  const Delta_complex& complex_;
  Straight_map map_;
  std::vector<bool> is_marked_;
  std::vector<std::size_t> region_of_face_;
  const std::vector<bool>& is_fixed_;       // the vertices that must not be merged
  const std::vector<bool>& must_not_cross_; // whether steps at a face must not make triangles cross
  const Progress_function& progress_;
  std::vector<std::vector<Face_index>> stands_for_;
  std::vector<std::array<std::uint32_t, 2>> divisions_; // of loops
  std::size_t number_of_new_border_parts_ = 0;
  std::vector<std::uint32_t> images_;  // of vertices of the triangulation, among the vertices before they are numbered
  std::vector<std::uint32_t> numbers_; // of the points of vertices and their copies
  Straight_mesh mesh_;
};

// How many places are bad other than crossings. Where triangles are no surface, all are bad.
std::size_t number_of_bad(const Straight_mesh& mesh, double deviation)
{
  return mesh.is_surface() && mesh.deviation <= deviation
           ? mesh.thin_triangles.size() - mesh.number_of_sharp_corners + mesh.folded_edges.size()
           : mesh.triangles.size() + 1;
}

// As in `is_good()`, crossings of closed triangles count like what else is bad, and those of others after it.
std::pair<std::size_t, std::size_t> defects(const Straight_mesh& mesh, double deviation)
{
  const std::size_t bad = number_of_bad(mesh, deviation), crossings = mesh.number_of_new_crossings;
  return mesh.is_closed() ? std::pair(bad + crossings, bad) : std::pair(bad, crossings);
}

// Where triangles cross and the surface does not, they are made again without the steps that lead to that. Programs that
// fill volumes refuse a surface that crosses itself, whatever its triangles do.
class Crossing_free_maker
{
public:
  Crossing_free_maker(const Common_subdivision& subdivision, const std::vector<Point>& points,
                      const std::vector<bool>& is_fixed)
    : subdivision_(subdivision), points_(points), is_fixed_(is_fixed)
  {}

  Straight_mesh make(const std::vector<bool>& is_marked, double thin_angle, double deviation,
                     const Progress_function& progress)
  {
    constexpr int most_rounds = 4;
    Straight_mesh result;
    std::vector<bool> must_not_cross;
    for (int round = 0; round < most_rounds; ++round) {
      const Progress_function part =
        part_of_progress(progress, double(round) / most_rounds, double(round + 1) / most_rounds);
      Straight_mesh_maker maker(subdivision_, points_, is_fixed_, must_not_cross, part);
      Straight_mesh mesh = maker.make(is_marked, thin_angle, deviation);
      const std::vector<bool> before = must_not_cross;
      if (deviation > 0)
        find_crossings(mesh, maker.stands_for(), must_not_cross, part);
      const bool has_bad = number_of_bad(mesh, deviation) > 0;
      if (round == 0 || defects(mesh, deviation) < defects(result, deviation))
        result = std::move(mesh);
      if (must_not_cross == before || (round == 0 && has_bad))
        break;
    }
    return result;
  }

private:
  // \param must_not_cross gets the faces that crossing triangles stand for
  void find_crossings(Straight_mesh& mesh, const std::vector<std::vector<Face_index>>& stands_for,
                      std::vector<bool>& must_not_cross, const Progress_function& progress)
  {
    std::size_t calls = 0;
    const auto go_on = [&] {
      if (calls++ % 256 == 0)
        report_progress(progress, 1, "straight_mesh()");
    };
    auto& pairs = mesh.crossing_triangles;
    pairs = crossing_triangles(mesh.points, mesh.triangles, go_on);
    if (pairs.empty())
      return;
    if (!surface_crossings_)
      surface_crossings_.emplace(subdivision_, points_, go_on);
    const auto is_new = [&](const auto& pair) {
      return !surface_crossings_->has(stands_for[pair[0]], stands_for[pair[1]]);
    };
    const auto end = std::stable_partition(pairs.begin(), pairs.end(), is_new);
    mesh.number_of_new_crossings = std::size_t(end - pairs.begin());
    if (end != pairs.end())
      return;
    must_not_cross.resize(subdivision_.intrinsic().number_of_faces());
    for (const auto& [s, t] : pairs)
      for (std::uint32_t triangle : {s, t})
        for (Face_index f : stands_for[triangle])
          must_not_cross[f.idx()] = true;
  }

  const Common_subdivision& subdivision_;
  const std::vector<Point>& points_;
  const std::vector<bool>& is_fixed_;
  std::optional<Surface_crossings> surface_crossings_; // if triangles cross
};

} // namespace

bool keeps_most(const Straight_mesh& mesh, const Straight_mesh& before)
{
  const auto area = [](const Straight_mesh& triangles) {
    double sum = 0;
    for (const auto& [u, v, w] : triangles.triangles)
      sum += area_of({triangles.points[u], triangles.points[v], triangles.points[w]});
    return sum;
  };
  return 2 * area(mesh) > area(before);
}

Straight_mesh straight_mesh(const Common_subdivision& subdivision, const std::vector<Point>& points,
                            const std::vector<bool>& is_marked, double thin_angle, double maximum_deviation,
                            const std::vector<bool>& is_fixed, const Progress_function& progress,
                            bool tries_larger_deviations)
{
  const auto check = [](std::size_t given, const char* what, std::size_t needed, const char* of_what) {
    if (given != needed)
      throw Invalid_argument_error("straight_mesh(): there are " + std::to_string(given) + ' ' + what + " for " +
                                   std::to_string(needed) + ' ' + of_what + " of the input");
  };
  check(points.size(), "points", subdivision.input().number_of_vertices(), "vertices");
  if (!is_marked.empty())
    check(is_marked.size(), "marks", subdivision.input().number_of_edges(), "edges");
  for (const Point& p : points)
    if (!(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
      throw Invalid_argument_error("straight_mesh(): a coordinate of a point is not finite");
  if (!is_fixed.empty())
    check(is_fixed.size(), "marks of fixed vertices", subdivision.input().number_of_vertices(), "vertices");
  Crossing_free_maker maker(subdivision, points, is_fixed);
  Straight_mesh result = maker.make(is_marked, thin_angle, maximum_deviation, part_of_progress(progress, 0, 0.4));
  if (maximum_deviation == 0 || !tries_larger_deviations)
    return result;
  // Larger ones are tried as long as that leaves fewer bad triangles, and they are smaller than the surface.
  double extent = 0;
  for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [axis](const Point& p, const Point& q) { return p[axis] < q[axis]; });
    extent = (std::max)(extent, (*high)[axis] - (*low)[axis]);
  }
  double d = 2 * maximum_deviation, done = 0.4;
  for (std::size_t before = defects(result, maximum_deviation).first;
       before > 0 && d < (std::min)(100 * maximum_deviation, extent / 4); d *= 2, done += 0.1) {
    const Straight_mesh mesh = maker.make(is_marked, thin_angle, d, part_of_progress(progress, done, done + 0.1));
    const std::size_t number = defects(mesh, d).first;
    if (number == 0 && keeps_most(mesh, result))
      result.sufficient_deviation = d;
    before = number < before ? number : 0;
  }
  return result;
}

} // namespace internal

std::string message(const Straight_mesh& mesh)
{
  if (mesh.is_surface())
    return {};
  std::ostringstream text;
  const auto begin = [&text] { return text.tellp() == 0 ? "" : "; "; };
  const auto edges = [&](const std::vector<Edge_index>& list, const char* one, const char* several) {
    if (!list.empty())
      text << begin() << list.size() << ' ' << (list.size() == 1 ? one : several) << ", the first is edge "
           << list.front().idx();
  };
  edges(mesh.multiple_edges, "edge joins the same vertices as another one", "edges join the same vertices as others");
  if (mesh.number_of_new_border_edges > 0)
    text << begin() << mesh.number_of_new_border_edges
         << (mesh.number_of_new_border_edges == 1 ? " edge is" : " edges are")
         << " on the border, but not of the surface";
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
