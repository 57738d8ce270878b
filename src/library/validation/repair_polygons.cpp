// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The steps of a repair, and the thread from each element back to the input.

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>
#include "../gluing/Surface_gluer.h"
#include "../gluing/Sides_by_edge.h"
#include "Doubled_faces.h"
#include "Flat_spikes.h"
#include "Polygon_cutter.h"
#include "Hanging_vertices.h"
#include "Polygon_sides.h"
#include "Vertices_on_edges.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A kind of repair in files, and the elements that it counts.
struct Repair_words
{
  const char *name, *singular, *plural;
};
inline Repair_words words_of(Repair_kind kind)
{
  static constexpr Repair_words words[] = {
    {"merged vertices", "vertex", "vertices"}, {"collapsed faces", "face", "faces"},
    {"duplicate faces", "face", "faces"},      {"duplicate parts of faces", "face", "faces"},
    {"triangulated faces", "face", "faces"},   {"fanned faces", "face", "faces"},
    {"flat spikes", "vertex", "vertices"},     {"stitched edges", "edge", "edges"},
    {"reversed faces", "face", "faces"},       {"split vertices", "vertex", "vertices"},
    {"opened edges", "edge", "edges"},         {"dropped vertices", "vertex", "vertices"}};
  return words[static_cast<std::size_t>(kind)];
}

} // namespace internal

const char* name(Repair_kind kind) { return internal::words_of(kind).name; }

bool is_repairable(Invalid_surface_error::Defect defect)
{
  using Defect = Invalid_surface_error::Defect;
  return (defect > Defect::NOT_FINITE && defect < Defect::OUT_OF_RANGE) || defect == Defect::DEGENERATE_FACE ||
         defect == Defect::UNREFERENCED_VERTEX;
}

std::string message(const Repair& repair)
{
  const internal::Repair_words words = internal::words_of(repair.kind);
  std::string text = repair.description;
  if (repair.count > 1)
    text += ", and " + std::to_string(repair.count - 1) + " more " +
            (repair.count == 2 ? words.singular : words.plural) + " like it";
  return text;
}

Polygon_triangles triangulate_polygon(const std::vector<std::array<double, 3>>& points,
                                      const std::vector<std::size_t>& polygon, std::size_t face)
{
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (polygon[i] != polygon[i > 0 ? i - 1 : polygon.size() - 1])
      corners.push_back(polygon[i]);
  Polygon_triangles result;
  if (corners.size() < 3)
    return result;
  internal::Polygon_cutter cutter(points, corners, face);
  for (const auto& [i, j, k] : cutter.cut())
    result.triangles.push_back({corners[i], corners[j], corners[k]});
  result.warning = cutter.warning();
  return result;
}

namespace internal {

// A polygon of the input, or a part of one that was cut.
struct Polygon_part
{
  std::size_t input;
  std::vector<std::size_t> corners;
};

// As Hanging_vertices asks for them; sides are numbered three for each triangle.
class Edges_of_triangles
{
  using Index = std::uint32_t;

public:
  Edges_of_triangles(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
    : triangles_(triangles), sides_(number_of_vertices, triangles)
  {}

  template <class Function>
  void for_each_edge(const Function& function) const
  {
    std::vector<Index> sides;
    sides_.for_each_edge([&](Index v, const Side_at_edge* begin, const Side_at_edge* end) {
      sides.clear();
      for (const Side_at_edge* side = begin; side != end; ++side)
        sides.push_back(side->side());
      function(v, begin->larger_end, sides);
    });
  }
  static Index face(Index side) { return side / 3; }
  bool has_corner(Index face, Index v) const
  {
    const Index_triangle& t = triangles_[face];
    return std::find(t.begin(), t.end(), v) != t.end();
  }

private:
  const std::vector<Index_triangle>& triangles_;
  Sides_by_edge sides_;
};

class Polygon_repairer
{
  using Index = std::size_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  Polygon_repairer(std::vector<std::array<double, 3>> points, std::vector<std::vector<Index>> polygons,
                   const std::optional<double>& stitching_tolerance)
    : input_points_(std::move(points)), input_polygons_(std::move(polygons)), tolerance_(stitching_tolerance),
      is_reversed_(input_polygons_.size(), false), is_repeated_(input_polygons_.size(), false),
      has_lost_part_(input_polygons_.size(), false)
  {
    for (Index f = 0; f < input_polygons_.size(); ++f)
      polygons_.push_back({f, input_polygons_[f]});
  }

  Repaired_polygons run(const Progress_function& progress)
  {
    // Only the triangulation of polygons can take long: the other steps count for little.
    merge_points(progress);
    ask(progress, 0.08);
    remove_repeated_corners();
    triangulate(progress);
    ask(progress, 0.8);
    remove_flat_spikes();
    ask(progress, 0.82);
    if (tolerance_)
      stitch(progress);
    ask(progress, 0.85);
    remove_duplicates();
    ask(progress, 0.9);
    glue(progress);
    ask(progress, 0.95);
    collect(progress);
    ask(progress, 0.98);
    report();
    ask(progress, 1);
    return std::move(result_);
  }

private:
  static void ask(const Progress_function& progress, double fraction)
  {
    report_progress(progress, fraction, "the repair");
  }

  // Inner vertices are no candidates: sheets that lie on each other would be glued together.
  void merge_points(const Progress_function& progress)
  {
    const Loop_progress at_edges(progress, "the repair", 0, 0.03, polygons_.size()),
      at_vertices(progress, "the repair", 0.04, 0.08, input_points_.size());
    std::vector<std::array<Index, 2>> edges;
    std::vector<bool> may_merge(input_points_.size(), false);
    representative_.assign(input_points_.size(), none);
    for (const Polygon_part& polygon : polygons_) {
      at_edges.at(polygon.input);
      for (Index i = 0; i < polygon.corners.size(); ++i) {
        const Index v = polygon.corners[i], w = polygon.corners[(i + 1) % polygon.corners.size()];
        representative_[v] = v;
        if (input_points_[v] == input_points_[w] || (tolerance_ && distance(v, w) <= *tolerance_))
          may_merge[v] = may_merge[w] = true;
        edges.push_back({(std::min)(v, w), (std::max)(v, w)});
      }
    }
    ask(progress, 0.03);
    std::sort(edges.begin(), edges.end());
    for (Index i = 0; i < edges.size(); ++i)
      if ((i == 0 || edges[i] != edges[i - 1]) && (i + 1 == edges.size() || edges[i] != edges[i + 1]))
        may_merge[edges[i][0]] = may_merge[edges[i][1]] = true;

    std::map<std::array<double, 3>, Index> first_at;
    for (Index v = 0; v < input_points_.size(); ++v) {
      at_vertices.at(v);
      if (may_merge[v])
        representative_[v] = first_at.emplace(input_points_[v], v).first->second;
    }
    if (tolerance_ && *tolerance_ > 0)
      merge_near(may_merge);
    for (Polygon_part& polygon : polygons_)
      for (Index& v : polygon.corners)
        v = representative_[v];
  }

  double distance(Index v, Index w) const
  {
    return Vertices_on_edges::norm(Vertices_on_edges::difference(input_points_[v], input_points_[w]));
  }

  void merge_near(const std::vector<bool>& may_merge)
  {
    std::vector<std::uint32_t> vertices;
    for (Index v = 0; v < may_merge.size(); ++v)
      if (may_merge[v] && representative_[v] == v)
        vertices.push_back(std::uint32_t(v));
    const Vertices_on_edges near(input_points_, vertices);
    Disjoint_sets sets(input_points_.size());
    for (std::uint32_t v : vertices)
      near.for_each_within(input_points_[v], *tolerance_, [&](std::uint32_t w, double) { sets.unite(v, w); });
    for (Index& v : representative_)
      if (v != none)
        v = sets.find(std::uint32_t(v));
  }

  // Of corners that follow each other. A polygon with fewer than three different ones goes.
  void remove_repeated_corners()
  {
    std::vector<Polygon_part> polygons;
    std::vector<Index> last_polygon(input_points_.size(), none); // with each vertex
    is_kept_.assign(input_polygons_.size(), false);
    for (Polygon_part& polygon : polygons_) {
      std::vector<Index>& corners = polygon.corners;
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      while (corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
      is_kept_[polygon.input] = std::count_if(corners.begin(), corners.end(), [&](Index v) {
                                  return std::exchange(last_polygon[v], polygon.input) != polygon.input;
                                }) >= 3;
      if (is_kept_[polygon.input])
        polygons.push_back(std::move(polygon));
    }
    polygons_ = std::move(polygons);
  }

  std::vector<Index> number_of_parts() const
  {
    std::vector<Index> result(input_polygons_.size(), 0);
    for (const Polygon_part& polygon : polygons_)
      ++result[polygon.input];
    return result;
  }

  // The triangles that stay; a face may have lost a part.
  void keep(const std::vector<bool>& is_kept)
  {
    const std::vector<Index> before = number_of_parts();
    std::vector<Polygon_part> triangles;
    for (Index t = 0; t < polygons_.size(); ++t)
      if (is_kept[t])
        triangles.push_back(std::move(polygons_[t]));
    polygons_ = std::move(triangles);
    const std::vector<Index> after = number_of_parts();
    for (Index f = 0; f < before.size(); ++f)
      if (before[f] > 1 && after[f] < before[f] && (after[f] > 0 || !is_repeated_[f]))
        has_lost_part_[f] = true;
  }

  // Of triangles with the same corners, in either direction, the first stays, and another if both are a wall.
  void remove_duplicates()
  {
    const std::vector<Index_triangle> all = triangles();
    const Doubled_faces doubled(input_points_.size(), all);
    std::vector<bool> is_kept;
    for (Index t = 0; t < all.size(); ++t)
      is_kept.push_back(doubled.is_kept(t));
    keep(is_kept);
  }

  // Polygons with the same corners in the same order, or turned over, are cut alike.
  void triangulate(const Progress_function& progress)
  {
    Index number_of_corners = 0, done = 0;
    for (const Polygon_part& polygon : polygons_)
      number_of_corners += polygon.corners.size();
    std::vector<Polygon_part> triangles;
    struct Cut
    {
      Index first, size; // triangles
      bool is_turned;    // whether the polygon is the reverse of the key
    };
    std::unordered_map<std::vector<Index>, Cut, boost::hash<std::vector<Index>>> seen;
    for (const auto& [input, corners] : polygons_) {
      if (corners.size() == 3) {
        done += 3;
        triangles.push_back({input, corners});
        continue;
      }
      ask(progress, 0.1 + 0.7 * double(done) / double(number_of_corners));
      done += corners.size();
      std::vector<Index> cycle = corners;
      std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
      const bool is_turned = cycle.back() < cycle[1];
      if (is_turned)
        std::reverse(cycle.begin() + 1, cycle.end());
      const auto [found, is_new] = seen.emplace(std::move(cycle), Cut{triangles.size(), 0, is_turned});
      Cut& cut = found->second;
      is_repeated_[input] = !is_new;
      if (is_new) {
        const Polygon_triangles parts = triangulate_polygon(input_points_, corners, input);
        for (const auto& [a, b, c] : parts.triangles)
          triangles.push_back({input, {a, b, c}});
        cut.size = parts.triangles.size();
        if (!parts.warning.empty()) {
          first_fan_ = fans_.count() == 0 ? parts.warning : first_fan_;
          fans_.add(input);
        }
      } else
        for (Index i = 0; i < cut.size; ++i) {
          triangles.push_back({input, triangles[cut.first + i].corners});
          if (is_turned != cut.is_turned)
            std::swap(triangles.back().corners[0], triangles.back().corners[2]);
        }
      is_kept_[input] = cut.size > 0;
    }
    polygons_ = std::move(triangles);
  }

  void remove_flat_spikes()
  {
    std::vector<Index_triangle> all = triangles();
    const Flat_spikes spikes(input_points_, all);
    if (spikes.tips().empty() && spikes.merged().empty())
      return;
    tips_.insert(spikes.tips().begin(), spikes.tips().end());
    std::map<Index, Index> to(spikes.merged().begin(), spikes.merged().end());
    for (Index& v : representative_)
      for (auto it = to.find(v); it != to.end(); it = to.find(v))
        v = it->second;
    std::vector<Polygon_part> left;
    std::fill(is_kept_.begin(), is_kept_.end(), false);
    for (Index t = 0; t < all.size(); ++t) {
      const auto& [a, b, c] = all[t];
      if (a == b || b == c || c == a)
        continue;
      left.push_back({polygons_[t].input, {a, b, c}});
      is_kept_[polygons_[t].input] = true;
    }
    polygons_ = std::move(left);
  }

  // Splits edges at the vertices that hang within them.
  void stitch(const Progress_function& progress)
  {
    const std::vector<Index_triangle> all = triangles();
    const Edges_of_triangles edges(input_points_.size(), all);
    std::size_t calls = 0;
    struct Place
    {
      double position;
      Index vertex;
    };
    std::map<std::uint32_t, std::vector<Place>> places; // within each side, from its smaller end
    std::set<std::uint32_t> border;                     // sides
    Hanging_vertices(input_points_, all.size(), edges)
      .find(
        *tolerance_, 0,
        [&](Index, Index, const std::vector<std::uint32_t>& sides, Index vertex, double, double position) {
          for (std::uint32_t side : sides)
            places[side].push_back({position, vertex});
          if (sides.size() == 1)
            border.insert(sides.front());
        },
        [&] {
          if (++calls % 4096 == 0)
            ask(progress, 0.85);
        });
    std::map<std::uint32_t, std::vector<Index>> within; // in the direction of the side
    for (auto& [side, list] : places) {
      std::sort(list.begin(), list.end(), [](const Place& a, const Place& b) {
        return a.position != b.position ? a.position < b.position : a.vertex < b.vertex;
      });
      for (const Place& place : list)
        if (std::vector<Index>& vertices = within[side];
            vertices.empty() || input_points_[vertices.back()] != input_points_[place.vertex])
          vertices.push_back(place.vertex);
    }
    std::vector<Polygon_part> result;
    for (Index t = 0; t < all.size(); ++t) {
      std::vector<std::vector<Index>> parts{polygons_[t].corners};
      for (std::uint32_t s = 3 * std::uint32_t(t), i = 0; i < 3; ++i, ++s)
        if (const auto found = within.find(s); found != within.end()) {
          if (all[t][i] > all[t][(i + 1) % 3])
            std::reverse(found->second.begin(), found->second.end());
          note_stitch(all[t][i], all[t][(i + 1) % 3], found->second, polygons_[t].input, border.count(s) != 0);
          split_side(parts, all[t][i], all[t][(i + 1) % 3], found->second);
        }
      for (std::vector<Index>& part : parts)
        result.push_back({polygons_[t].input, std::move(part)});
    }
    polygons_ = std::move(result);
  }
  void note_stitch(Index v, Index w, const std::vector<Index>& within, Index face, bool is_border)
  {
    if (stitched_.count() == 0 || face < stitched_.first())
      first_stitch_ = {v, w, within.front()};
    stitched_.add(face);
    for (Index last = v, i = 0; i <= within.size(); ++i) {
      const Index next = i < within.size() ? within[i] : w;
      const std::array<Index, 2> ends = {(std::min)(last, next), (std::max)(last, next)};
      if (is_border)
        new_sides_.insert(ends);
      else
        new_inner_sides_.insert({ends[0], ends[1], face});
      last = next;
    }
  }
  // The triangle that has the side becomes a fan.
  static void split_side(std::vector<std::vector<Index>>& parts, Index v, Index w, const std::vector<Index>& within)
  {
    for (std::vector<Index>& part : parts)
      for (Index i = 0; i < 3; ++i)
        if (part[i] == v && part[(i + 1) % 3] == w) {
          const Index apex = part[(i + 2) % 3];
          part = {v, within.front(), apex};
          for (Index k = 0; k < within.size(); ++k)
            parts.push_back({within[k], k + 1 < within.size() ? within[k + 1] : w, apex});
          return;
        }
  }

  std::vector<Index_triangle> triangles() const
  {
    std::vector<Index_triangle> result;
    for (const auto& [input, v] : polygons_)
      result.push_back({std::uint32_t(v[0]), std::uint32_t(v[1]), std::uint32_t(v[2])});
    return result;
  }

  // Turns triangles, and copies vertices for the fans that are left.
  void glue(const Progress_function& progress)
  {
    const Points points(input_points_.begin(), input_points_.end());
    const std::vector<Index_triangle> all = triangles();
    const Surface_gluer gluer(points, all, [&progress] { ask(progress, 0.92); });

    for (Index f = 0; f < all.size(); ++f)
      if (gluer.is_turned(f)) {
        is_reversed_[polygons_[f].input] = true;
        std::swap(polygons_[f].corners[0], polygons_[f].corners[2]);
      }
    ask(progress, 0.93);
    find_opened_edges(gluer);
    ask(progress, 0.94);
    copied_from_ = gluer.vertices();
    for (Index c = 0; c < 3 * all.size(); ++c)
      polygons_[c / 3].corners[c % 3] = gluer.vertex(c);
    remove_sheets(gluer);
  }

  // Two triangles that are glued to each other alone enclose nothing, and have the same corners. Nothing is lost with
  // pieces of zero area that were cut off.
  void remove_sheets(const Surface_gluer& gluer)
  {
    std::vector<bool> is_kept;
    for (Index t : cut_off_)
      is_kept_[polygons_[t].input] = false;
    for (Index t = 0; t < polygons_.size(); ++t) {
      std::array<std::uint32_t, 3> beyond;
      for (Index i = 0; i < 3; ++i)
        beyond[i] =
          gluer.neighbor(3 * t + i) == Surface_gluer::none ? Surface_gluer::none : gluer.neighbor(3 * t + i) / 3;
      is_kept.push_back(beyond[0] == Surface_gluer::none || beyond[0] != beyond[1] || beyond[0] != beyond[2]);
      if (!is_kept.back())
        other_side_.emplace(polygons_[t].input, polygons_[beyond[0]].input);
      is_kept.back() = is_kept.back() && cut_off_.count(t) == 0;
    }
    keep(is_kept);
    for (const Polygon_part& polygon : polygons_)
      is_kept_[polygon.input] = true;
  }

  // Triangles that are glued together.
  Disjoint_sets pieces(const Surface_gluer& gluer) const
  {
    Disjoint_sets result(polygons_.size());
    for (Index c = 0; c < 3 * polygons_.size(); ++c)
      if (gluer.neighbor(c) != Surface_gluer::none)
        result.unite(std::uint32_t(c / 3), gluer.neighbor(c) / 3);
    return result;
  }

  bool has_area(Index triangle) const
  {
    const std::vector<Index>& v = polygons_[triangle].corners;
    return !are_collinear(input_points_[v[0]], input_points_[v[1]], input_points_[v[2]]);
  }

  // Border edges that had several faces in the input, or lay inside one.
  void find_opened_edges(const Surface_gluer& gluer)
  {
    using Edge = std::array<Index, 2>;
    const auto edge = [](Index v, Index w) { return Edge{(std::min)(v, w), (std::max)(v, w)}; };
    std::vector<std::pair<Edge, Index>> border; // with the triangle
    for (Index c = 0; c < 3 * polygons_.size(); ++c)
      if (gluer.neighbor(c) == Surface_gluer::none) {
        const std::vector<Index>& v = polygons_[c / 3].corners;
        border.emplace_back(edge(v[c % 3], v[(c + 1) % 3]), c / 3);
      }
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
    std::vector<Index> opened; // positions in the list
    for (Index i = 0; i < border.size(); ++i) {
      const auto& [ends, triangle] = border[i];
      const bool was_inner = new_inner_sides_.count({ends[0], ends[1], polygons_[triangle].input}) != 0;
      number_of_faces[i] += was_inner ? 2 : 0;
      if (was_inner || (number_of_faces[i] != 1 && new_sides_.count(ends) == 0))
        opened.push_back(i);
    }
    if (opened.empty())
      return;
    Disjoint_sets pieces = this->pieces(gluer);
    std::set<Index> with_area, cut_off;
    for (Index t = 0; t < polygons_.size(); ++t)
      if (has_area(t))
        with_area.insert(pieces.find(std::uint32_t(t)));
    for (Index i : opened) {
      const auto& [ends, triangle] = border[i];
      const Index face = polygons_[triangle].input, piece = pieces.find(std::uint32_t(triangle));
      if (!with_area.empty() && with_area.count(piece) == 0) {
        cut_off.insert(piece);
        continue;
      }
      if (opened_.count() == 0 || face < opened_.first())
        first_opened_edge_ = {ends[0], ends[1], number_of_faces[i]};
      opened_.add(face);
    }
    for (Index t = 0; t < polygons_.size() && !cut_off.empty(); ++t)
      if (cut_off.count(pieces.find(std::uint32_t(t))) != 0)
        cut_off_.insert(t);
  }

  // The vertices that are left, and for each the first vertex of the input that has become it.
  void collect(const Progress_function& progress)
  {
    std::vector<Index> input(copied_from_.size(), none);
    for_each_corner([&](Index v, Index in_input) { input[v] = (std::min)(input[v], in_input); });
    for (const Polygon_part& triangle : polygons_)
      for (Index v : triangle.corners)
        if (input[v] == none) // all its faces had other corners before
          input[v] = copied_from_[v];
    std::vector<Index> number(input.size(), none);
    for (Index v = 0; v < input.size(); ++v)
      if (input[v] != none) {
        number[v] = result_.points.size();
        result_.points.push_back(input_points_[input[v]]);
        result_.input_vertices.push_back(input[v]);
      }
    for (const auto& [face, v] : polygons_) {
      result_.triangles.push_back({number[v[0]], number[v[1]], number[v[2]]});
      result_.input_faces.push_back(face);
    }
    ask(progress, 0.96);
    const Index before = number_of_components([this](Index v) { return copied_from_[v]; }),
                after = number_of_components([](Index v) { return v; });
    if (after > before)
      new_components_ = " (" + std::to_string(before) + (before == 1 ? " component" : " components") + " became " +
                        std::to_string(after) + ")";
    ask(progress, 0.97);
    merged_with_.assign(input_points_.size(), none);
    for_each_corner([&](Index v, Index in_input) {
      if (input[v] != in_input)
        merged_with_[in_input] = input[v];
    });
  }

  // Of triangles that share vertices, which the function gives.
  template <class Vertex>
  Index number_of_components(const Vertex& vertex) const
  {
    Disjoint_sets sets(copied_from_.size());
    for (const Polygon_part& triangle : polygons_)
      for (Index i = 1; i < 3; ++i)
        sets.unite(std::uint32_t(vertex(triangle.corners[0])), std::uint32_t(vertex(triangle.corners[i])));
    std::set<std::uint32_t> roots;
    for (const Polygon_part& triangle : polygons_)
      roots.insert(sets.find(std::uint32_t(vertex(triangle.corners[0]))));
    return roots.size();
  }

  // Calls function(vertex, vertex of the input) for each corner of the input face that a corner of the triangle may
  // come from.
  template <class Function>
  void for_each_corner(const Function& function) const
  {
    std::vector<std::array<Index, 2>> corners; // of one face: representative, vertex
    Index face = none;
    for (const Polygon_part& triangle : polygons_) {
      if (triangle.input != face) {
        face = triangle.input;
        corners.clear();
        for (Index v : input_polygons_[face])
          corners.push_back({representative_[v], v});
        std::sort(corners.begin(), corners.end());
      }
      for (Index v : triangle.corners)
        for (auto it = std::lower_bound(corners.begin(), corners.end(), std::array<Index, 2>{copied_from_[v], 0});
             it != corners.end() && (*it)[0] == copied_from_[v]; ++it)
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

    Element_collector merged, collapsed, duplicates, lost_parts, triangulated, spikes, reversed, split, dropped;
    for (Index v = 0; v < vertex_count.size(); ++v) {
      if (vertex_count[v] > 1)
        split.add(v);
      else if (vertex_count[v] == 0)
        (merged_with_[v] != none ? merged : tips_.count(v) != 0 ? spikes : dropped).add(v);
    }
    for (Index f = 0; f < face_count.size(); ++f) {
      if (!is_kept_[f])
        collapsed.add(f);
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
    add(Repair_kind::MERGED_VERTEX, merged, [&](Index v) {
      const double apart = distance(v, merged_with_[v]);
      std::ostringstream where;
      if (apart > 0)
        where << ", which is " << apart << " away";
      else
        where << " at the same place";
      return vertex(v) + " was merged with " + vertex(merged_with_[v]) + where.str();
    });
    add(Repair_kind::COLLAPSED_FACE, collapsed,
        [&](Index f) { return face(f) + " was removed, as it encloses nothing"; });
    add(Repair_kind::DUPLICATE_FACE, duplicates, [&](Index f) {
      const auto other = other_side_.find(f);
      return face(f) + (other == other_side_.end() ? " was removed, as another face has the same corners"
                                                   : " was removed with " + face(other->second) +
                                                       ", as they have the same corners and enclose nothing");
    });
    add(Repair_kind::DUPLICATE_PART, lost_parts, [&](Index f) {
      return face(f) + (face_count[f] == 0 ? " was removed" : " was removed in part") +
             " after it was cut, as other faces have the same corners";
    });
    add(Repair_kind::TRIANGULATED_FACE, triangulated, [&](Index f) {
      return face(f) + " (" + std::to_string(input_polygons_[f].size()) + " corners) was cut into triangles";
    });
    add(Repair_kind::FANNED_FACE, fans_, [&](Index) { return first_fan_; });
    add(Repair_kind::FLAT_SPIKE, spikes, [&](Index v) {
      return vertex(v) + " was removed: all faces around it had zero area and an angle of zero there";
    });
    add(Repair_kind::STITCHED_EDGE, stitched_, [&](Index f) {
      const auto [v, w, x] = first_stitch_;
      return "edge " + std::to_string(v) + "-" + std::to_string(w) + " of " + face(f) + " was split at " + vertex(x) +
             ", which lies within it";
    });
    add(Repair_kind::REVERSED_FACE, reversed, [&](Index f) { return face(f) + " was turned over"; });
    add(Repair_kind::SPLIT_VERTEX, split, [&](Index v) {
      return vertex(v) + " became " + std::to_string(vertex_count[v]) + " vertices, one for each fan of its faces" +
             new_components_;
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
  const std::optional<double> tolerance_;
  std::vector<Polygon_part> polygons_;      // in the order of the input
  std::vector<Index> representative_;       // of each input vertex that a face names, the one it was merged into
  std::vector<std::uint32_t> copied_from_;  // of each vertex after the gluing, the one of the input
  std::vector<Index> merged_with_;          // of each input vertex, the one whose place it took, or none
  std::vector<bool> is_kept_, is_reversed_; // of each input face
  std::vector<bool> is_repeated_;           // of each input face, whether one before it has the same corners in order
  std::vector<bool> has_lost_part_;         // of each input face of which several parts were left
  std::map<Index, Index> other_side_;       // of input faces that enclose nothing
  Element_collector fans_, stitched_, opened_;
  std::string first_fan_;                          // its description in messages
  std::string new_components_;                     // how many became how many; empty if none came apart
  std::set<Index> tips_;                           // of flat spikes that were removed
  std::array<Index, 3> first_stitch_ = {};         // ends, and the vertex
  std::set<std::array<Index, 2>> new_sides_;       // parts of border edges that were split
  std::set<std::array<Index, 3>> new_inner_sides_; // parts of other edges, and a face
  std::array<Index, 3> first_opened_edge_ = {};    // ends, and how many faces it had
  std::set<Index> cut_off_;                        // triangles of pieces without area
  Repaired_polygons result_;
};

Repaired_polygons repair(std::vector<std::array<double, 3>> points, std::vector<std::vector<std::size_t>> polygons,
                         const Progress_function& progress, const std::optional<double>& stitching_tolerance)
{
  return Polygon_repairer(std::move(points), std::move(polygons), stitching_tolerance).run(progress);
}

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations
