// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The triangles of one polygon; the steps of a repair, and the thread from each element back to the input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_REPAIR_POLYGONS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_REPAIR_POLYGONS_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/gluing/Surface_gluer.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Polygon_sides.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

inline std::vector<std::array<std::size_t, 3>> triangulate_polygon(const std::vector<std::array<double, 3>>& polygon)
{
  typedef Exact_predicates_inexact_constructions_kernel::Point_3 Point;
  // Moved and scaled to the size of 1, lest squares and products overflow. Quartered before, for
  // the difference of two coordinates can overflow as well.
  std::vector<std::array<double, 3>> places = polygon;
  double size = 0;
  for (std::array<double, 3>& p : places)
    for (int i = 0; i < 3; ++i) {
      p[i] = p[i] / 4 - polygon[0][i] / 4;
      size = (std::max)(size, std::abs(p[i]));
    }
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  std::vector<Point> points;
  for (const std::array<double, 3>& p : places)
    points.emplace_back(std::ldexp(p[0], -exponent), std::ldexp(p[1], -exponent), std::ldexp(p[2], -exponent));

  // Where the polygon is not nearly planar, memory is quadratic and time cubic: with a thousand
  // corners half a minute.
  const bool is_small = polygon.size() <= 200;
  std::vector<Triple<int, int, int>> triples;
  if (size > 0)
    Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triples),
                                                       parameters::use_2d_constrained_delaunay_triangulation(true)
                                                         .use_delaunay_triangulation(is_small)
                                                         .do_not_use_cubic_algorithm(!is_small));
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const Triple<int, int, int>& t : triples)
    triangles.push_back({std::size_t(t.first), std::size_t(t.second), std::size_t(t.third)});
  // A polygon that is all but a line, or a large one in space: a fan is as good as anything.
  if (triangles.size() != polygon.size() - 2) {
    triangles.clear();
    for (std::size_t i = 2; i < polygon.size(); ++i)
      triangles.push_back({0, i - 1, i});
  }
  return triangles;
}

namespace internal {

// Points and polygons carry the numbers that they have in the input through functions that copy,
// swap and renumber them.
struct Numbered_point : Simple_cartesian<double>::Point_3
{
  using Base = Simple_cartesian<double>::Point_3;
  Numbered_point() = default;
  Numbered_point(const std::array<double, 3>& p, std::size_t number) : Base(p[0], p[1], p[2]), input(number) {}

  std::size_t input = 0;
  std::size_t group = 0; // points at the same place are one if they have the same
};
// GCC 14 takes the copy of a polygon with fewer than two corners, in CGAL 6, for one of more.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Warray-bounds"
#pragma GCC diagnostic ignored "-Wstringop-overflow"
#endif
struct Numbered_polygon : std::vector<std::size_t>
{
  using std::vector<std::size_t>::vector;
  std::size_t input = 0;
};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

// Which points CGAL's functions take to be the same.
struct Numbered_point_traits
{
  struct Less_xyz_3
  {
    bool operator()(const Numbered_point& p, const Numbered_point& q) const
    {
      return std::make_tuple(p.x(), p.y(), p.z(), p.group) < std::make_tuple(q.x(), q.y(), q.z(), q.group);
    }
  };
  Less_xyz_3 less_xyz_3_object() const { return {}; }
};

class Polygon_repairer
{
  using Index = std::size_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  Polygon_repairer(std::vector<std::array<double, 3>> points, std::vector<std::vector<Index>> polygons)
    : input_points_(std::move(points)), input_polygons_(std::move(polygons)),
      is_reversed_(input_polygons_.size(), false), has_lost_part_(input_polygons_.size(), false)
  {
    for (Index v = 0; v < input_points_.size(); ++v)
      points_.emplace_back(input_points_[v], v);
    for (Index f = 0; f < input_polygons_.size(); ++f)
      add_polygon(polygons_, f, input_polygons_[f]);
  }

  Repaired_polygons run(const Progress_function& progress)
  {
    // Only the triangulation of polygons can take long: the other steps count for little.
    ask(progress, 0);
    merge_points();
    remove_repeated_corners();
    remove_duplicates();
    triangulate(progress);
    ask(progress, 0.9);
    glue();
    collect();
    report();
    ask(progress, 1);
    return std::move(result_);
  }

private:
  static void ask(const Progress_function& progress, double fraction)
  {
    report_progress(progress, fraction, "the repair");
  }

  static void add_polygon(std::vector<Numbered_polygon>& polygons, Index input, const std::vector<Index>& corners)
  {
    polygons.emplace_back(corners.begin(), corners.end());
    polygons.back().input = input;
  }

  // Inner vertices are no candidates: sheets that lie on each other would be glued together.
  void merge_points()
  {
    std::vector<std::array<Index, 2>> edges;
    std::vector<bool> may_merge(points_.size(), false);
    for (const Numbered_polygon& polygon : polygons_)
      for (Index i = 0; i < polygon.size(); ++i) {
        const Index v = polygon[i], w = polygon[(i + 1) % polygon.size()];
        if (input_points_[v] == input_points_[w])
          may_merge[v] = may_merge[w] = true;
        edges.push_back({(std::min)(v, w), (std::max)(v, w)});
      }
    std::sort(edges.begin(), edges.end());
    for (Index i = 0; i < edges.size(); ++i)
      if ((i == 0 || edges[i] != edges[i - 1]) && (i + 1 == edges.size() || edges[i] != edges[i + 1]))
        may_merge[edges[i][0]] = may_merge[edges[i][1]] = true;
    for (Index v = 0; v < points_.size(); ++v)
      points_[v].group = may_merge[v] ? 0 : v + 1;

    Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points_, polygons_,
                                                                    parameters::geom_traits(Numbered_point_traits()));
    representative_.assign(input_points_.size(), none);
    for (Index f = 0; f < polygons_.size(); ++f)
      for (Index i = 0; i < polygons_[f].size(); ++i)
        representative_[input_polygons_[f][i]] = points_[polygons_[f][i]].input;
    // From here on each point is itself.
    for (Numbered_point& p : points_)
      p.group = p.input + 1;
  }

  // Walks around each polygon; where it comes to a vertex for the second time it has gone around
  // a loop, which is cut off.
  void remove_repeated_corners()
  {
    std::vector<Numbered_polygon> polygons;
    std::vector<Index> path, place(points_.size(), none); // of each vertex in the path
    const auto cut_path = [&](Index begin, Index polygon) {
      if (path.size() - begin >= 3)
        add_polygon(polygons, polygon, std::vector<Index>(path.begin() + std::ptrdiff_t(begin), path.end()));
      for (; path.size() > begin; path.pop_back())
        place[path.back()] = none;
    };
    for (const Numbered_polygon& polygon : polygons_) {
      for (Index v : polygon) {
        if (place[v] != none)
          cut_path(place[v], polygon.input);
        place[v] = path.size();
        path.push_back(v);
      }
      cut_path(0, polygon.input);
    }
    polygons_ = std::move(polygons);
    is_kept_.assign(input_polygons_.size(), false);
    for (const Numbered_polygon& polygon : polygons_)
      is_kept_[polygon.input] = true;
    for (Index f = 0; f < is_kept_.size(); ++f)
      if (!is_kept_[f])
        collapsed_.add(f);
  }

  std::vector<Index> number_of_parts() const
  {
    std::vector<Index> result(input_polygons_.size(), 0);
    for (const Numbered_polygon& polygon : polygons_)
      ++result[polygon.input];
    return result;
  }

  void remove_duplicates()
  {
    const std::vector<Index> before = number_of_parts();
    Polygon_mesh_processing::merge_duplicate_polygons_in_polygon_soup(points_, polygons_,
                                                                      parameters::geom_traits(Numbered_point_traits()));
    std::stable_sort(polygons_.begin(), polygons_.end(),
                     [](const Numbered_polygon& a, const Numbered_polygon& b) { return a.input < b.input; });
    const std::vector<Index> after = number_of_parts();
    for (Index f = 0; f < before.size(); ++f)
      if (before[f] > 1 && after[f] < before[f])
        has_lost_part_[f] = true;
  }

  void triangulate(const Progress_function& progress)
  {
    Index number_of_corners = 0, done = 0;
    for (const Numbered_polygon& polygon : polygons_)
      number_of_corners += polygon.size();
    std::vector<Numbered_polygon> triangles;
    bool is_changed = false;
    for (const Numbered_polygon& polygon : polygons_) {
      if (polygon.size() == 3) {
        done += 3;
        triangles.push_back(polygon);
        continue;
      }
      is_changed = true;
      ask(progress, 0.1 + 0.7 * double(done) / double(number_of_corners));
      done += polygon.size();
      std::vector<std::array<double, 3>> corners;
      for (Index v : polygon)
        corners.push_back({points_[v].x(), points_[v].y(), points_[v].z()});
      for (const std::array<std::size_t, 3>& t : triangulate_polygon(corners))
        add_polygon(triangles, polygon.input, {polygon[t[0]], polygon[t[1]], polygon[t[2]]});
    }
    polygons_ = std::move(triangles);
    if (is_changed)
      remove_duplicates();
  }

  // Turns triangles, and copies vertices for the fans that are left.
  void glue()
  {
    Points points;
    std::vector<Index_triangle> triangles;
    for (const Numbered_point& p : points_)
      points.push_back({p.x(), p.y(), p.z()});
    for (const Numbered_polygon& polygon : polygons_)
      triangles.push_back({std::uint32_t(polygon[0]), std::uint32_t(polygon[1]), std::uint32_t(polygon[2])});
    const Surface_gluer gluer(points, triangles);

    for (Index f = 0; f < triangles.size(); ++f)
      if (gluer.is_turned(f)) {
        is_reversed_[polygons_[f].input] = true;
        std::swap(polygons_[f][0], polygons_[f][2]);
      }
    find_opened_edges(gluer);
    points_.reserve(gluer.vertices().size());
    for (Index v = points_.size(); v < gluer.vertices().size(); ++v)
      points_.push_back(Numbered_point(points_[gluer.vertices()[v]]));
    for (Index c = 0; c < 3 * triangles.size(); ++c)
      polygons_[c / 3][c % 3] = gluer.vertex(c);
  }

  // Border edges that had several faces in the input, or lay inside one.
  void find_opened_edges(const Surface_gluer& gluer)
  {
    using Edge = std::array<Index, 2>;
    const auto edge = [](Index v, Index w) { return Edge{(std::min)(v, w), (std::max)(v, w)}; };
    std::vector<std::pair<Edge, Index>> border; // with the face
    for (const Numbered_polygon& triangle : polygons_)
      for (Index i = 0; i < 3; ++i)
        if (gluer.is_border(3 * Index(&triangle - polygons_.data()) + i))
          border.emplace_back(edge(points_[triangle[i]].input, points_[triangle[(i + 1) % 3]].input), triangle.input);
    std::sort(border.begin(), border.end());
    std::vector<Index> number_of_faces(border.size(), 0);
    for (const std::vector<Index>& polygon : input_polygons_)
      for (Index i = 0; i < polygon.size() && !border.empty(); ++i) {
        const std::pair<Edge, Index> key(
          edge(representative_[polygon[i]], representative_[polygon[i + 1 < polygon.size() ? i + 1 : 0]]), 0);
        for (auto it = std::lower_bound(border.begin(), border.end(), key);
             it != border.end() && it->first == key.first; ++it)
          ++number_of_faces[Index(it - border.begin())];
      }
    for (Index i = 0; i < border.size(); ++i) {
      const auto& [ends, face] = border[i];
      if (number_of_faces[i] == 1)
        continue;
      if (opened_.count() == 0 || face < opened_.first())
        first_opened_edge_ = {ends[0], ends[1], number_of_faces[i]};
      opened_.add(face);
    }
  }

  // The vertices that are left, and for each the first vertex of the input that has become it.
  void collect()
  {
    std::vector<Index> input(points_.size(), none);
    for_each_corner([&](Index v, Index in_input) { input[v] = (std::min)(input[v], in_input); });
    std::vector<Index> number(points_.size(), none);
    for (Index v = 0; v < points_.size(); ++v)
      if (input[v] != none) {
        number[v] = result_.points.size();
        result_.points.push_back(input_points_[input[v]]);
        result_.input_vertices.push_back(input[v]);
      }
    for (const Numbered_polygon& triangle : polygons_) {
      result_.triangles.push_back({number[triangle[0]], number[triangle[1]], number[triangle[2]]});
      result_.input_faces.push_back(triangle.input);
    }
    merged_with_.assign(input_points_.size(), none);
    for_each_corner([&](Index v, Index in_input) {
      if (input[v] != in_input)
        merged_with_[in_input] = input[v];
    });
  }

  // Calls function(vertex, vertex of the input) for all that a corner of a triangle may have been
  // in its face of the input.
  template <class Function>
  void for_each_corner(const Function& function) const
  {
    std::vector<std::array<Index, 2>> corners; // of one face: representative, vertex
    Index face = none;
    for (const Numbered_polygon& triangle : polygons_) {
      if (triangle.input != face) {
        face = triangle.input;
        corners.clear();
        for (Index v : input_polygons_[face])
          corners.push_back({representative_[v], v});
        std::sort(corners.begin(), corners.end());
      }
      for (Index v : triangle)
        for (auto it = std::lower_bound(corners.begin(), corners.end(), std::array<Index, 2>{points_[v].input, 0});
             it != corners.end() && (*it)[0] == points_[v].input; ++it)
          function(v, (*it)[1]);
    }
  }

  void report()
  {
    std::vector<Index> vertex_count(input_points_.size(), 0), face_count(input_polygons_.size(), 0);
    for (Index v : result_.input_vertices)
      ++vertex_count[v];
    for (Index f : result_.input_faces)
      ++face_count[f];

    Element_collector merged, duplicates, lost_parts, triangulated, reversed, split, dropped;
    for (Index v = 0; v < vertex_count.size(); ++v) {
      if (vertex_count[v] > 1)
        split.add(v);
      else if (vertex_count[v] == 0)
        (merged_with_[v] != none ? merged : dropped).add(v);
    }
    for (Index f = 0; f < face_count.size(); ++f) {
      if (has_lost_part_[f])
        lost_parts.add(f);
      if (face_count[f] == 0 && is_kept_[f] && !has_lost_part_[f])
        duplicates.add(f);
      else if (face_count[f] > 0) {
        if (input_polygons_[f].size() > 3)
          triangulated.add(f);
        if (is_reversed_[f])
          reversed.add(f);
      }
    }

    const auto vertex = [](Index v) { return "vertex " + std::to_string(v); };
    const auto face = [](Index f) { return "face " + std::to_string(f); };
    add(Repair_kind::MERGED_VERTEX, merged,
        [&](Index v) { return vertex(v) + " was merged with " + vertex(merged_with_[v]) + " at the same place"; });
    add(Repair_kind::COLLAPSED_FACE, collapsed_,
        [&](Index f) { return face(f) + " was removed, as fewer than three of its corners differ"; });
    add(Repair_kind::DUPLICATE_FACE, duplicates,
        [&](Index f) { return face(f) + " was removed, as another face has the same corners"; });
    add(Repair_kind::DUPLICATE_PART, lost_parts, [&](Index f) {
      return face(f) + (face_count[f] == 0 ? " was removed" : " was removed in part") +
             " after it was cut, as other faces have the same corners";
    });
    add(Repair_kind::TRIANGULATED_FACE, triangulated, [&](Index f) {
      return face(f) + " (" + std::to_string(input_polygons_[f].size()) + " corners) was cut into triangles";
    });
    add(Repair_kind::REVERSED_FACE, reversed, [&](Index f) { return face(f) + " was turned over"; });
    add(Repair_kind::SPLIT_VERTEX, split, [&](Index v) {
      return vertex(v) + " became " + std::to_string(vertex_count[v]) + " vertices, one for each fan of its faces";
    });
    add(Repair_kind::OPENED_EDGE, opened_, [&](Index f) {
      const auto [v, w, n] = first_opened_edge_;
      return "edge " + std::to_string(v) + "-" + std::to_string(w) + " of " + face(f) +
             (n == 0   ? " became border: it was inside a face, of which a part was removed"
              : n == 2 ? " became border: its two faces do not fit, or one was removed"
                       : " became border: of its " + std::to_string(n) + " faces, no other one was left that fits");
    });
    add(Repair_kind::DROPPED_VERTEX, dropped, [&](Index v) {
      return vertex(v) + (representative_[v] == none ? " was dropped, as no face names it"
                                                     : " was dropped, as no triangle of the result has it");
    });
  }

  template <class Describe>
  void add(Repair_kind kind, const Element_collector& elements, const Describe& describe)
  {
    if (elements.count() > 0)
      result_.repairs.push_back({kind, elements.elements(), elements.count(), describe(elements.first())});
  }

  const std::vector<std::array<double, 3>> input_points_;
  const std::vector<std::vector<Index>> input_polygons_;
  std::vector<Numbered_point> points_;
  std::vector<Numbered_polygon> polygons_;
  std::vector<Index> representative_;       // of each input vertex that a face names, the one it was merged into
  std::vector<Index> merged_with_;          // of each input vertex, the one whose place it took, or none
  std::vector<bool> is_kept_, is_reversed_; // of each input face
  std::vector<bool> has_lost_part_;         // of each input face of which several parts were left
  Element_collector collapsed_;
  Element_collector opened_;
  std::array<Index, 3> first_opened_edge_ = {}; // ends, and how many faces it had
  Repaired_polygons result_;
};

inline Repaired_polygons repair(std::vector<std::array<double, 3>> points,
                                std::vector<std::vector<std::size_t>> polygons, const Progress_function& progress)
{
  return Polygon_repairer(std::move(points), std::move(polygons)).run(progress);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_REPAIR_POLYGONS_IMPL_H
