// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The steps of a repair, which keep track of where each element comes from in the input.

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>
#include "../gluing/Surface_gluer.h"
#include "Doubled_faces.h"
#include "Edge_stitcher.h"
#include "Flat_spikes.h"
#include "Opened_edges.h"
#include "Polygon_cutter.h"
#include "Polygon_part.h"
#include "Polygon_sides.h"
#include "Vertex_merger.h"

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

class Polygon_repairer
{
  using Index = std::size_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  Polygon_repairer(std::vector<std::array<double, 3>> points, std::vector<std::vector<Index>> polygons,
                   const std::optional<double>& stitching_tolerance)
    : input_points_(std::move(points)), input_polygons_(std::move(polygons)),
      merger_(input_points_, stitching_tolerance), is_reversed_(input_polygons_.size(), false),
      is_repeated_(input_polygons_.size(), false), has_lost_part_(input_polygons_.size(), false)
  {
    if (stitching_tolerance)
      stitcher_.emplace(input_points_, *stitching_tolerance);
    for (Index f = 0; f < input_polygons_.size(); ++f)
      polygons_.push_back({f, input_polygons_[f]});
  }

  Repaired_polygons run(const Progress_function& progress)
  {
    // Only the triangulation of polygons can take long: the other steps count for little.
    representative_ = merger_.representatives(input_polygons_, progress);
    for (Polygon_part& polygon : polygons_)
      for (Index& v : polygon.corners)
        v = representative_[v];
    ask(progress, 0.08);
    remove_repeated_corners();
    triangulate(progress);
    ask(progress, 0.8);
    remove_flat_spikes();
    ask(progress, 0.82);
    if (stitcher_) {
      const Loop_progress at_edges(progress, "the repair", 0.82, 0.85, 3 * polygons_.size());
      std::size_t edge = 0;
      stitcher_->stitch(polygons_, [&] { at_edges.at(edge++); });
    }
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

  // Removes consecutive equal corners, and polygons with fewer than three different corners.
  void remove_repeated_corners()
  {
    std::vector<Polygon_part> polygons;
    std::vector<Index> last_polygon(input_points_.size(), none); // at each vertex
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

  // Drops the other triangles; a face may lose a part.
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

  // Keeps only the first of several triangles with the same corners, in either direction, or two if they are a wall.
  void remove_duplicates()
  {
    const std::vector<Index_triangle> all = index_triangles(polygons_);
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
    std::vector<Index_triangle> all = index_triangles(polygons_);
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

  // Turns triangles, and copies vertices that still have several fans.
  void glue(const Progress_function& progress)
  {
    const Points points(input_points_.begin(), input_points_.end());
    const std::vector<Index_triangle> all = index_triangles(polygons_);
    const Surface_gluer gluer(points, all, [&progress] { ask(progress, 0.92); });

    for (Index f = 0; f < all.size(); ++f)
      if (gluer.is_turned(f)) {
        is_reversed_[polygons_[f].input] = true;
        std::swap(polygons_[f].corners[0], polygons_[f].corners[2]);
      }
    ask(progress, 0.93);
    Opened_edges opened(input_points_, polygons_, gluer);
    opened.find(input_polygons_, representative_, stitcher_ ? &*stitcher_ : nullptr);
    opened_ = opened.faces();
    first_opened_edge_ = opened.first_edge();
    ask(progress, 0.94);
    copied_from_ = gluer.vertices();
    for (Index c = 0; c < 3 * all.size(); ++c)
      polygons_[c / 3].corners[c % 3] = gluer.vertex(c);
    remove_sheets(gluer, opened.cut_off());
  }

  // Two triangles that are glued only to each other have the same corners and enclose nothing. Pieces of zero area that
  // were cut off are no loss.
  void remove_sheets(const Surface_gluer& gluer, const std::set<Index>& cut_off)
  {
    std::vector<bool> is_kept;
    for (Index t : cut_off)
      is_kept_[polygons_[t].input] = false;
    for (Index t = 0; t < polygons_.size(); ++t) {
      std::array<std::uint32_t, 3> beyond;
      for (Index i = 0; i < 3; ++i)
        beyond[i] =
          gluer.neighbor(3 * t + i) == Surface_gluer::none ? Surface_gluer::none : gluer.neighbor(3 * t + i) / 3;
      is_kept.push_back(beyond[0] == Surface_gluer::none || beyond[0] != beyond[1] || beyond[0] != beyond[2]);
      if (!is_kept.back())
        other_side_.emplace(polygons_[t].input, polygons_[beyond[0]].input);
      is_kept.back() = is_kept.back() && cut_off.count(t) == 0;
    }
    keep(is_kept);
    for (const Polygon_part& polygon : polygons_)
      is_kept_[polygon.input] = true;
  }

  // Collects the remaining vertices, each with the first vertex of the input that has become it.
  void collect(const Progress_function& progress)
  {
    std::vector<Index> input(copied_from_.size(), none);
    for_each_corner([&](Index v, Index in_input) { input[v] = (std::min)(input[v], in_input); });
    for (const Polygon_part& triangle : polygons_)
      for (Index v : triangle.corners)
        if (input[v] == none) // so far, all of its faces had other corners
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

  // Counts components of triangles that share vertices; `vertex` maps corners to these.
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
      const double apart = merger_.distance(v, merged_with_[v]);
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
    add(Repair_kind::STITCHED_EDGE, stitcher_ ? stitcher_->faces() : Element_collector(), [&](Index f) {
      const auto [v, w, x] = stitcher_->first_edge();
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
  const Vertex_merger merger_;
  std::optional<Edge_stitcher> stitcher_;
  std::vector<Polygon_part> polygons_;      // in the order of the input
  std::vector<Index> representative_;       // of each input vertex that a face names, the one it was merged into
  std::vector<std::uint32_t> copied_from_;  // of each vertex after the gluing, the one of the input
  std::vector<Index> merged_with_;          // of each input vertex, the one whose place it took, or none
  std::vector<bool> is_kept_, is_reversed_; // of each input face
  std::vector<bool> is_repeated_;           // of each input face, whether an earlier one has the same corners in order
  std::vector<bool> has_lost_part_;         // of each input face of which several parts were left
  std::map<Index, Index> other_side_;       // of input faces that enclose nothing
  Element_collector fans_, opened_;
  std::string first_fan_;                       // its description in messages
  std::string new_components_;                  // how many became how many; empty if none came apart
  std::set<Index> tips_;                        // of flat spikes that were removed
  std::array<Index, 3> first_opened_edge_ = {}; // ends, and how many faces it had
  Repaired_polygons result_;
};

Repaired_polygons repair(std::vector<std::array<double, 3>> points, std::vector<std::vector<std::size_t>> polygons,
                         const Progress_function& progress, const std::optional<double>& stitching_tolerance)
{
  return Polygon_repairer(std::move(points), std::move(polygons), stitching_tolerance).run(progress);
}

} // namespace internal
} // namespace CGAL::Intrinsic_triangulations
