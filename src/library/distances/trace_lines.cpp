// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Triangles are divided until lines are nearly straight in them.

#include <CGAL/Intrinsic_triangulations/internal/distances/trace_lines.h>

#include "Line_budget.h"
#include "Line_pieces.h"
#include "Waves_in_triangle.h"
#include "wave_functions.h"

#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

struct Corner
{
  std::uint32_t vertex;
  Coordinates in_input;
  plane::Vector at; // in the laid out face
};

struct Triangle
{
  std::array<Corner, 3> corners; // counterclockwise
  Halfedge_index input;          // to which the coordinates refer
  std::uint32_t face;            // of the triangulation
  bool is_checked = false;       // whether no side was divided when it was looked at
};

// The faces of the overlay are cut into triangles, and these at their longest sides: until no line can be in them, or
// distances are nearly linear, or they are as small as the tolerance. Whether a vertex is above or below a level, or
// which source is nearest to it, is decided once, as is where a line crosses a side. So lines have no gaps.
class Line_tracer
{
public:
  Line_tracer(const Common_subdivision& subdivision, const Laid_out_faces& faces, const Waves& waves,
              const Wanted_lines& wanted, const Interruption& interruption)
    : subdivision_(subdivision), faces_(faces), waves_(waves), wanted_(wanted), interruption_(interruption),
      budget_(subdivision.overlay().number_of_vertices()), ranks_(subdivision.overlay().number_of_vertices(), unknown),
      divided_(ranks_.size(), 0)
  {}

  std::vector<Traced_line> run()
  {
    const Input_layer input(subdivision_);
    const Intrinsic_layer intrinsic(subdivision_);
    std::vector<Triangle> coarse;
    for (Overlay::Face f : subdivision_.overlay().faces())
      triangulate(input, intrinsic, f, coarse);
    budget_.require_few_expected(wanted_.levels.size() > 1);
    for (const Triangle& t : coarse)
      refine(t, waves_in(t.face));
    while (conform())
      ;
    for (const Triangle& t : fine_)
      add_pieces(t);
    return pieces_.join();
  }

private:
  using Seen = Waves_in_triangle;
  using Edge = std::pair<std::uint32_t, std::uint32_t>;
  using Crossing = std::pair<Line_pieces::Node, double>;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t unknown = (std::numeric_limits<std::uint32_t>::max)();
  static constexpr double rounding = 1e-13;      // of a distance, or of a side
  static constexpr double smallest_part = 1e-12; // of a side: triangles are not divided further

  bool has_levels() const { return !wanted_.levels.empty(); }

  // Adds the triangles in which there may be a line.
  void triangulate(const Input_layer& input, const Intrinsic_layer& intrinsic, Overlay::Face f,
                   std::vector<Triangle>& coarse)
  {
    const std::uint32_t face = intrinsic.face(f).idx();
    const std::vector<const Wave*> waves = waves_in(face);
    if (waves.empty())
      return;
    const Halfedge_index h = input.complex.halfedge(input.face(f)), base = faces_.halfedge(3 * face);
    const Laid_out_faces::Side& side = faces_.side(3 * face);
    std::vector<Corner> corners;
    const Overlay::Halfedge first = input.overlay.halfedge(f);
    Overlay::Halfedge g = first;
    do {
      const Coordinates c = corner_coordinates(intrinsic, g, base);
      corners.push_back({input.overlay.target(g).idx(),
                         corner_coordinates(input, g, h),
                         {c[1] * side.length + c[2] * side.apex_x, c[2] * side.apex_y}});
      g = input.overlay.next(g);
    } while (g != first);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      interruption_.check();
      const Triangle t{{corners[0], corners[i], corners[i + 1]}, h, face};
      const Seen seen = look(t, waves);
      if (is_far(t, seen))
        continue;
      coarse.push_back(t);
      if (has_levels())
        expect_points(t, seen);
    }
  }

  void expect_points(const Triangle& t, const Seen& seen)
  {
    const auto [lowest, highest] = seen.range();
    const auto begin = std::lower_bound(wanted_.levels.begin(), wanted_.levels.end(), lowest),
               end = std::upper_bound(begin, wanted_.levels.end(), highest);
    if (begin == end)
      return;
    double dip = 0;
    for (const Wave_in_triangle& w : seen)
      dip = (std::max)(dip, w.dip);
    budget_.expect(double(end - begin), (std::min)(dip, *(end - 1)) / tolerance(t, seen));
  }

  void keep(const Triangle& t)
  {
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    const auto [low, high] = std::minmax_element(ranks.begin(), ranks.end());
    fine_.push_back(t);
    budget_.count(has_levels() ? *high - *low : 0, fine_.size());
  }

  std::vector<const Wave*> waves_in(std::uint32_t face) const
  {
    std::vector<const Wave*> result;
    for (std::size_t i = waves_.first[face]; i < waves_.first[face + 1]; ++i)
      result.push_back(&waves_.waves[i]);
    return result;
  }

  // The waves that may be the lowest somewhere in a triangle. The ranks of its corners are then known.
  Seen look(const Triangle& t, const std::vector<const Wave*>& waves)
  {
    Seen result(waves, t.corners[0].at, t.corners[1].at, t.corners[2].at, slack(t));
    for (std::size_t i = 0; i < 3; ++i)
      if (ranks_[t.corners[i].vertex] == unknown)
        ranks_[t.corners[i].vertex] = rank(result, i);
    return result;
  }

  // The number of levels that are not above a corner, or its nearest source: the first one if there are several.
  std::uint32_t rank(const Seen& seen, std::size_t corner) const
  {
    double lowest = infinity;
    for (const Wave_in_triangle& w : seen)
      lowest = (std::min)(lowest, w.values[corner]);
    const double limit = lowest * (1 + rounding);
    if (has_levels())
      return std::uint32_t(std::upper_bound(wanted_.levels.begin(), wanted_.levels.end(), limit) -
                           wanted_.levels.begin());
    std::uint32_t result = unknown;
    for (const Wave_in_triangle& w : seen)
      if (w.values[corner] <= limit)
        result = (std::min)(result, w.wave->source);
    return result;
  }

  // By how much distances may differ from those in the next face.
  double slack(const Triangle& t) const { return 10 * wanted_.search_tolerance * faces_.side(3 * t.face).length; }

  static double length(const Triangle& t, std::size_t side)
  {
    return distance_in_plane(t.corners[side].at, t.corners[(side + 1) % 3].at);
  }
  static std::size_t longest_side(const Triangle& t)
  {
    std::size_t result = 0;
    for (std::size_t i : {1, 2})
      if (length(t, i) > length(t, result))
        result = i;
    return result;
  }

  void refine(const Triangle& t, const std::vector<const Wave*>& waves)
  {
    interruption_.check();
    const Seen seen = look(t, waves);
    if (is_far(t, seen))
      return;
    const double size = length(t, longest_side(t));
    if ((size <= tolerance(t, seen) / 2 || (has_levels() ? follows_levels(t, seen) : follows_cells(t, seen))) &&
        (size <= smallest_part * faces_.side(3 * t.face).length || meets_where_cells_do(t, seen))) {
      keep(t);
      return;
    }
    std::vector<const Wave*> left;
    for (const Wave_in_triangle& w : seen)
      left.push_back(w.wave);
    bisect(t, left);
  }

  void bisect(const Triangle& t, const std::vector<const Wave*>& waves)
  {
    const std::size_t i = longest_side(t);
    const Corner &a = t.corners[i], &b = t.corners[(i + 1) % 3];
    const auto [place, is_new] = middles_.insert({edge(a, b), std::uint32_t(ranks_.size())});
    if (is_new) {
      ranks_.push_back(unknown);
      divided_.push_back(pass_);
      divided_[a.vertex] = divided_[b.vertex] = pass_;
    }
    const Corner middle = between(a, b, 0.5, place->second);
    Triangle child = t;
    child.corners[(i + 1) % 3] = middle;
    refine(child, waves);
    child = t;
    child.corners[i] = middle;
    refine(child, waves);
  }

  static Edge edge(const Corner& a, const Corner& b) { return std::minmax<std::uint32_t>(a.vertex, b.vertex); }

  static Corner between(const Corner& a, const Corner& b, double t, std::uint32_t vertex)
  {
    return {vertex,
            internal::between(a.in_input, b.in_input, t),
            {(1 - t) * a.at[0] + t * b.at[0], (1 - t) * a.at[1] + t * b.at[1]}};
  }

  // Divides triangles with a divided side. \return whether there were any
  bool conform()
  {
    bool result = false;
    ++pass_;
    for (std::size_t i = 0; i < fine_.size();) {
      if (!has_divided_side(fine_[i])) {
        fine_[i].is_checked = true;
        ++i;
        continue;
      }
      result = true;
      Triangle t = fine_[i];
      t.is_checked = false;
      fine_[i] = fine_.back();
      fine_.pop_back();
      bisect(t, waves_in(t.face));
    }
    return result;
  }

  // Most triangles were looked at before, and nothing was divided at their corners since the last pass began.
  bool has_divided_side(const Triangle& t) const
  {
    const auto& [a, b, c] = t.corners;
    const auto is_recent = [this](const Corner& corner) { return divided_[corner.vertex] + 1 >= pass_; };
    if (t.is_checked && is_recent(a) + is_recent(b) + is_recent(c) < 2)
      return false;
    return middles_.count(edge(a, b)) + middles_.count(edge(b, c)) + middles_.count(edge(c, a)) > 0;
  }

  // At least the rounding of the numbers that are compared with it.
  double tolerance(const Triangle& t, const Seen& seen) const
  {
    const double rounding_of_dips = 0x1p-49 * (faces_.side(3 * t.face).length + seen.range().second);
    return (std::max)(wanted_.chord_tolerance, rounding_of_dips) + slack(t);
  }

  // Whether no line can be in a triangle or on its sides, wherever these will be divided. With a tolerance of the
  // search, distances on a side may differ in the next face.
  bool is_far(const Triangle& t, const Seen& seen) const
  {
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    if (ranks[0] != ranks[1] || ranks[1] != ranks[2])
      return false;
    if (!has_levels())
      return wanted_.search_tolerance == 0 && std::all_of(seen.begin(), seen.end(), [&](const Wave_in_triangle& w) {
               return w.wave->source == ranks[0];
             });
    const auto [lowest, highest] = seen.range();
    const double margin = (wanted_.search_tolerance > 0 ? faces_.side(3 * t.face).length : 0) + 10 * rounding * highest;
    const auto level = std::lower_bound(wanted_.levels.begin(), wanted_.levels.end(), lowest - margin);
    return level == wanted_.levels.end() || *level > highest + margin;
  }

  bool follows_levels(const Triangle& t, const Seen& seen) const
  {
    const auto [lowest, highest] = seen.range();
    const double margin = tolerance(t, seen);
    std::array<std::uint32_t, 3> ranks = ranks_of(t);
    std::sort(ranks.begin(), ranks.end());
    const std::vector<double>& levels = wanted_.levels;
    return (ranks[0] == 0 || !(lowest < levels[ranks[0] - 1] - margin)) &&
           (ranks[2] == levels.size() || !(highest > levels[ranks[2]] + margin)) &&
           (ranks[0] == ranks[2] || seen.is_nearly_linear(Seen::any_source, margin));
  }

  bool follows_cells(const Triangle& t, const Seen& seen) const
  {
    const double margin = tolerance(t, seen);
    std::array<std::uint32_t, 3> ranks = ranks_of(t);
    std::sort(ranks.begin(), ranks.end());
    if (ranks[0] != ranks[1] && ranks[1] != ranks[2])
      return false;
    const auto is_own = [&](const Wave_in_triangle& w) {
      return w.wave->source == ranks[0] || w.wave->source == ranks[2];
    };
    for (const Wave_in_triangle& other : seen)
      if (!is_own(other) && std::none_of(seen.begin(), seen.end(), [&](const Wave_in_triangle& w) {
            return is_own(w) && other.is_above(w, margin);
          }))
        return false;
    return ranks[0] == ranks[2] ||
           (seen.is_nearly_linear(ranks[0], margin / 2) && seen.is_nearly_linear(ranks[2], margin / 2));
  }

  // Whether lines cross the sides where no third source is nearer, and three lines have a common point inside.
  bool meets_where_cells_do(const Triangle& t, const Seen& seen)
  {
    if (has_levels() || wanted_.search_tolerance > 0)
      return true;
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t j = (i + 1) % 3;
          ranks[i] != ranks[j] && seen.has_source_beside({ranks[i], ranks[j], ranks[j]})) {
        const double at = cross_side(t, i, 0, seen).second;
        const auto& [a, b] = ends(t, i);
        if (seen.is_other_nearer(between(a, b, at, 0).at, {ranks[i], ranks[j], ranks[j]}))
          return false;
      }
    return !are_different(ranks) || common_point(t, seen);
  }
  static bool are_different(const std::array<std::uint32_t, 3>& r)
  {
    return r[0] != r[1] && r[1] != r[2] && r[2] != r[0];
  }

  // The point of a triangle at the same distance from the sources nearest to its corners, if it has one. Distances are
  // nearly linear there.
  std::optional<Coordinates> common_point(const Triangle& t, const Seen& seen) const
  {
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    // By how much the second and third source are farther than the first.
    const auto excess = [&](const plane::Vector& p) {
      const double d = seen.nearest(p, ranks[0]);
      return plane::Vector{seen.nearest(p, ranks[1]) - d, seen.nearest(p, ranks[2]) - d};
    };
    const plane::Vector &o = t.corners[0].at, a = plane::difference(t.corners[1].at, o),
                        b = plane::difference(t.corners[2].at, o), at_o = excess(o),
                        along_a = plane::difference(excess(t.corners[1].at), at_o),
                        along_b = plane::difference(excess(t.corners[2].at), at_o);
    const double det = plane::cross(along_a, along_b);
    plane::Vector p = o, now = at_o;
    double x = 0, y = 0;
    for (int i = 0; i < 30; ++i) {
      x += plane::cross(along_b, now) / det;
      y += plane::cross(now, along_a) / det;
      p = {o[0] + x * a[0] + y * b[0], o[1] + x * a[1] + y * b[1]};
      now = excess(p);
      if ((std::max)(std::abs(now[0]), std::abs(now[1])) <= 1e-15 * seen.nearest(p, ranks[0]))
        break;
    }
    if (!(x >= 0 && y >= 0 && x + y <= 1 &&
          (std::max)(std::abs(now[0]), std::abs(now[1])) <= 10 * rounding * seen.nearest(p, ranks[0])) ||
        seen.is_other_nearer(p, ranks))
      return std::nullopt;
    return Coordinates{1 - x - y, x, y};
  }

  std::array<std::uint32_t, 3> ranks_of(const Triangle& t) const
  {
    return {ranks_[t.corners[0].vertex], ranks_[t.corners[1].vertex], ranks_[t.corners[2].vertex]};
  }

  void add_pieces(const Triangle& t)
  {
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    const auto [low, high] = std::minmax_element(ranks.begin(), ranks.end());
    if (*low == *high)
      return;
    interruption_.check();
    const Seen seen = look(t, waves_in(t.face));
    if (!has_levels() && are_different(ranks))
      return add_junction(t, seen);
    for (std::uint32_t level = has_levels() ? *low : 0; level < (has_levels() ? *high : 1); ++level) {
      interruption_.check();
      const auto left_of = [&](std::size_t i) { return has_levels() ? std::uint32_t(ranks[i] > level) : ranks[i]; };
      std::size_t i = 0; // the corner that differs from the others
      while (left_of((i + 1) % 3) != left_of((i + 2) % 3))
        ++i;
      const auto p = cross(t, i, level, seen), q = cross(t, (i + 2) % 3, level, seen);
      const bool is_left = left_of(i) < left_of((i + 1) % 3);
      add_piece(t, is_left ? p : q, is_left ? q : p, level, {*low, *high});
    }
  }

  // Where three cells meet.
  void add_junction(const Triangle& t, const Seen& seen)
  {
    const std::array<std::uint32_t, 3> ranks = ranks_of(t);
    std::pair<Line_pieces::Node, Coordinates> middle{pieces_.add_node(true, Line_pieces::none), {}};
    const Coordinates point = common_point(t, seen).value_or(Coordinates{1. / 3, 1. / 3, 1. / 3});
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        middle.second[k] += point[i] * t.corners[i].in_input[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto p = cross(t, i, 0, seen);
      const std::uint32_t left = ranks[i], right = ranks[(i + 1) % 3];
      add_piece(t, left < right ? p : middle, left < right ? middle : p, 0, std::minmax(left, right));
    }
  }

  void add_piece(const Triangle& t, const std::pair<Line_pieces::Node, Coordinates>& from,
                 const std::pair<Line_pieces::Node, Coordinates>& to, std::uint32_t level,
                 const std::pair<std::uint32_t, std::uint32_t>& cells)
  {
    pieces_.add(from.first, to.first, {t.input, from.second}, to.second, has_levels() ? level : 0,
                has_levels() ? std::array<std::uint32_t, 2>{0, 0}
                             : std::array<std::uint32_t, 2>{cells.first, cells.second});
  }

  // The ends of a side, in the order of the vertices.
  static std::pair<const Corner&, const Corner&> ends(const Triangle& t, std::size_t side)
  {
    const Corner &a = t.corners[side], &b = t.corners[(side + 1) % 3];
    return a.vertex < b.vertex ? std::pair<const Corner&, const Corner&>(a, b)
                               : std::pair<const Corner&, const Corner&>(b, a);
  }

  // The node on a side, and which part of the side lies before it.
  Crossing cross_side(const Triangle& t, std::size_t side, std::uint32_t level, const Seen& seen)
  {
    const auto& [a, b] = ends(t, side);
    const auto [place, is_new] = crossings_.insert({{edge(a, b), level}, {}});
    if (is_new) {
      const double at = crossing(a, b, level, seen);
      place->second = {pieces_.add_node(false, at == 0 ? a.vertex : at == 1 ? b.vertex : Line_pieces::none), at};
    }
    return place->second;
  }

  // The node on a side, and where it lies.
  std::pair<Line_pieces::Node, Coordinates> cross(const Triangle& t, std::size_t side, std::uint32_t level,
                                                  const Seen& seen)
  {
    const auto [node, at] = cross_side(t, side, level, seen);
    const auto& [a, b] = ends(t, side);
    return {node, at == 0 ? a.in_input : at == 1 ? b.in_input : internal::between(a.in_input, b.in_input, at)};
  }

  // The fraction of a side up to a line.
  double crossing(const Corner& a, const Corner& b, std::uint32_t level, const Seen& seen) const
  {
    const std::uint32_t rank_a = ranks_[a.vertex], rank_b = ranks_[b.vertex];
    const bool rises = rank_a < rank_b; // from a to b
    double scale = 0;
    const auto function = [&](double t) { // negative before the line
      const plane::Vector p = between(a, b, t, 0).at;
      if (has_levels()) {
        scale = wanted_.levels[level];
        return (seen.nearest(p, Seen::any_source) - scale) * (rises ? 1 : -1);
      }
      scale = seen.nearest(p, rank_a);
      return scale - seen.nearest(p, rank_b);
    };
    double low = 0, high = 1, at_low = function(0), at_high = function(1);
    if (!(at_low < -rounding * scale))
      return 0;
    if (!(at_high > rounding * scale))
      return 1;
    double t = 0.5;
    for (int i = 0; i < 120 && high - low > 1e-16; ++i) {
      t = i % 3 < 2 ? low + (high - low) * (at_low / (at_low - at_high)) : low + (high - low) / 2;
      const double value = function(t);
      if (std::abs(value) <= 4e-16 * scale)
        break;
      (value < 0 ? low : high) = t;
      (value < 0 ? at_low : at_high) = value;
    }
    return t;
  }

  using Edge_and_level = std::pair<Edge, std::uint32_t>;

  const Common_subdivision& subdivision_;
  const Laid_out_faces& faces_;
  const Waves& waves_;
  const Wanted_lines& wanted_;
  const Interruption& interruption_;
  Line_budget budget_;
  std::vector<std::uint32_t> ranks_;   // of the vertices: first those of the overlay
  std::vector<std::uint32_t> divided_; // for each of them, the pass that last divided a side there
  std::uint32_t pass_ = 0;             // of conform()
  std::unordered_map<Edge, std::uint32_t, boost::hash<Edge>> middles_;
  std::vector<Triangle> fine_;
  std::unordered_map<Edge_and_level, Crossing, boost::hash<Edge_and_level>> crossings_;
  Line_pieces pieces_;
};

} // namespace

std::vector<Traced_line> trace_lines(const Common_subdivision& subdivision, const Laid_out_faces& faces,
                                     const Waves& waves, const Wanted_lines& wanted, const Interruption& interruption)
{
  return Line_tracer(subdivision, faces, waves, wanted, interruption).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal
