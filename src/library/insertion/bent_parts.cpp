// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of bent_parts.h.

#include <CGAL/Intrinsic_triangulations/internal/insertion/bent_parts.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include "../measures/Face_directions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Which of the edges stay whole near each vertex, and how far the others are cut back.
class Bent_edge_trimmer
{
public:
  Bent_edge_trimmer(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                    const std::vector<bool>& is_fixed, double deviation)
    : complex_(complex), is_fixed_(is_fixed), deviation_(deviation), directions_(complex, points, deviation / 2),
      chords_(complex.number_of_edges()), parts_(complex.number_of_edges())
  {
    for (Edge_index e : complex_.edges()) {
      if (complex_.is_border(e))
        continue;
      const Halfedge_index h = complex_.halfedge(e);
      const auto m = directions_(complex_.face(h)), n = directions_(complex_.face(complex_.opposite(h)));
      chords_[e.idx()] = std::hypot(m[0] - n[0], m[1] - n[1], m[2] - n[2]);
      if (chords_[e.idx()] / (1 / reach(h) + 1 / reach(complex_.opposite(h))) > deviation_ / 2)
        parts_[e.idx()].end = 1;
    }
  }

  std::vector<Edge_part> operator()()
  {
    for (Vertex_index v : complex_.vertices())
      if (complex_.halfedge(v).is_valid())
        trim_at(v);
    // What is left should be worth the two vertices at its ends, and these are not to round to the ends of the edge.
    constexpr double least = 0x1p-40;
    for (Edge_part& part : parts_) {
      if (!(part.end - part.begin > 0.25))
        part.begin = part.end = 0;
      if (part.begin < least)
        part.begin = 0;
      if (part.end > 1 - least)
        part.end = 1;
    }
    return parts_;
  }

private:
  // Larger corners are refined well, in shells.
  static constexpr double smallest_corner = CGAL_PI / 5;

  double reach(Halfedge_index h) const
  {
    const double height = directions_.height_over(h);
    return 2 * height < deviation_ && directions_.length(h) > 8 * height ? (std::numeric_limits<double>::infinity)()
                                                                         : height;
  }
  bool is_kept(Edge_index e) const { return complex_.is_border(e) || is_fixed_[e.idx()] || parts_[e.idx()].end > 0; }
  bool can_be_cut_back(Edge_index e) const { return !complex_.is_border(e) && !is_fixed_[e.idx()]; }

  // A halfedge that leaves a vertex along an edge to keep, and the angle to the next one.
  struct Spoke
  {
    Halfedge_index halfedge;
    double angle;     // infinite at the border
    double chord = 0; // of the edges that were cut back in that corner
    std::vector<Halfedge_index> cut{};
  };

  void trim_at(Vertex_index v)
  {
    std::vector<Spoke> spokes;
    const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    double before = 0; // the angle before the first spoke
    Halfedge_index h = first;
    do { // counterclockwise
      if (is_kept(complex_.edge(h)))
        spokes.push_back({h, 0});
      (spokes.empty() ? before : spokes.back().angle) +=
        complex_.is_border(h) ? (std::numeric_limits<double>::infinity)() : angle_at_source(h);
      h = complex_.next_around_source(h);
    } while (h != first);
    if (spokes.empty())
      return;
    spokes.back().angle += before;
    while (spokes.size() > 1) {
      std::size_t best = spokes.size();
      for (std::size_t i = 0; i < spokes.size(); ++i) {
        const Spoke &spoke = spokes[i], &previous = spokes[(i + spokes.size() - 1) % spokes.size()];
        if (can_be_cut_back(complex_.edge(spoke.halfedge)) &&
            (std::min)(spoke.angle, previous.angle) < smallest_corner &&
            (best == spokes.size() || chord(spoke) < chord(spokes[best])))
          best = i;
      }
      if (best == spokes.size())
        break;
      Spoke& previous = spokes[(best + spokes.size() - 1) % spokes.size()];
      Spoke& spoke = spokes[best];
      previous.angle += spoke.angle;
      previous.chord += spoke.chord + chord(spoke);
      previous.cut.push_back(spoke.halfedge);
      previous.cut.insert(previous.cut.end(), spoke.cut.begin(), spoke.cut.end());
      spokes.erase(spokes.begin() + std::ptrdiff_t(best));
    }
    // A line across the corner at this distance from v, which is as long as that and twice the sine, cuts off a quarter
    // of it times the chord.
    for (const Spoke& spoke : spokes) {
      const double sine = std::sin((std::min)(spoke.angle, CGAL_PI) / 2);
      for (Halfedge_index cut : spoke.cut) {
        const double t = deviation_ / (sine * spoke.chord) / directions_.length(cut);
        Edge_part& part = parts_[complex_.edge(cut).idx()];
        if (cut == complex_.halfedge(complex_.edge(cut)))
          part.begin = t;
        else
          part.end = 1 - t;
      }
    }
  }
  double chord(const Spoke& spoke) const { return chords_[complex_.edge(spoke.halfedge).idx()]; }
  double angle_at_source(Halfedge_index h) const
  {
    const auto a = directions_.half_side(h), b = directions_.half_side(complex_.prev(h)); // which points to the source
    const auto across = cross_product(directions_.normalized(a), directions_.normalized(b));
    return std::atan2(std::hypot(across[0], across[1], across[2]),
                      -scalar_product(directions_.normalized(a), directions_.normalized(b)));
  }

  const Delta_complex& complex_;
  const std::vector<bool>& is_fixed_;
  const double deviation_;
  Face_directions directions_;
  std::vector<double> chords_; // 2 sin(angle / 2) between the directions on both sides of an edge
  std::vector<Edge_part> parts_;
};

std::vector<Edge_part> bent_parts(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                                  const std::vector<bool>& is_fixed, double deviation)
{
  return Bent_edge_trimmer(complex, points, is_fixed, deviation)();
}

} // namespace CGAL::Intrinsic_triangulations::internal
