// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest distances on a triangulated surface.

#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>

#include "First_ways.h"
#include "Waiting_windows.h"
#include "Window.h"
#include "wave_functions.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The points of a side that straight ways from a vertex reach through the same faces are a window. Windows are passed
// on from face to face, the nearest first, and dropped where a way over a vertex is not longer. Ways bend only at
// vertices whose angles sum to more than 2π, and on the border: these send windows of their own into their shadow.
//
// Source: J. Chen, Y. Han, "Shortest paths on a polyhedron", 1996; S. Xin, G. Wang, "Improving Chen and Han's algorithm
// on the discrete geodesic problem", 2009; V. Surazhsky et al., "Fast exact and approximate geodesics on meshes", 2005
// (merging windows).
class Window_propagation
{
public:
  // \param surface, points, waves, rests must outlive this
  // \param rests see Waiting_windows
  Window_propagation(const Laid_out_faces& surface, double tolerance, const Laid_out_points* points = nullptr,
                     std::vector<Wave>* waves = nullptr, const std::vector<double>* rests = nullptr)
    : surface_(surface), points_(points), waves_(waves), tolerance_(tolerance),
      distances_(surface.number_of_rows(), infinity), arrivals_(surface.number_of_rows()),
      origins_(surface.number_of_rows(), none), splits_(surface.sides().size()), waiting_(surface, tolerance, rests),
      at_narrow_edges_(surface.number_of_narrow_edges())
  {
    // Of two ways to a corner, the window of the longer one is cut off beyond the other, because they have crossed in
    // the face before. If they may come from different faces, nothing is known.
    for (std::uint32_t side = 0; side < splits_.size(); ++side)
      if (surface.beside(side) != none)
        splits_[side].distance = std::numeric_limits<double>::quiet_NaN();
  }

  // \return whether the maximum number of steps was enough
  bool run(const Window_sources& sources, std::uint64_t most, const Interruption& interruption,
           std::vector<std::uint32_t> goals, double farthest = infinity)
  {
    const bool has_goals = !goals.empty();
    const double farther = tolerance_ > 0 ? surface_.longest_side() / 2 : 0; // than any point of the next side
    begin_at(sources);
    while (!waiting_.is_empty()) {
      if (++number_of_steps_ > most)
        return false;
      if (number_of_steps_ % 4096 == 0)
        interruption.check();
      const auto [least, window] = waiting_.pop();
      while (!goals.empty() && least - farther > distances_[goals.back()])
        goals.pop_back();
      if ((has_goals && goals.empty()) || least - farther > farthest)
        break;
      if (window.kind == Window::WAY_TO_VERTEX)
        send_from(window.side, window.x, window.sigma);
      else if (window.kind == Window::SOURCE)
        send_from_source(sources.rows[window.source], window.sigma);
      else if (tolerance_ == 0 && window.next != Window::taken)
        send_on(window);
      else if (tolerance_ > 0)
        send_all_on(window.side);
    }
    return true;
  }

  // Does the same from points.
  void run_from_points(const std::vector<std::uint32_t>& numbers, const Interruption& interruption)
  {
    Window_sources sources;
    for (std::uint32_t number : numbers)
      if (const Laid_out_points::Point* const p = points_->find(number)) {
        if (p->row != none) {
          sources.rows.push_back({p->row, 0, 0, {}});
          continue;
        }
        for (const Laid_out_points::Point& q : points_->in_face(p->face))
          come_nearer(q, length_of(q.at[0][0] - p->at[0][0], q.at[0][1] - p->at[0][1]));
        Face_source source;
        source.side = 3 * p->face;
        source.from = p->at[0];
        sources.in_faces.push_back(source);
      }
    run(sources, (std::numeric_limits<std::uint64_t>::max)(), interruption, {});
  }

  // The distances of the points; infinite where no way leads. Ways that bend at a corner of the face come from there.
  std::vector<double> distances_of_points() const
  {
    std::vector<double> result = point_distances_;
    for (std::uint32_t i = 0; i < result.size(); ++i)
      if (const Laid_out_points::Point* const p = points_->find(i))
        for (std::uint32_t k = 0; k < 3; ++k)
          result[i] =
            (std::min)(result[i], distances_[surface_.side(3 * p->face + k).row] + length_of(p->at[k][0], p->at[k][1]));
    return result;
  }

  Window_distances result(bool is_complete)
  {
    return {std::move(distances_), std::move(arrivals_), std::move(origins_), number_of_steps_, is_complete};
  }

private:
  using Side = Laid_out_faces::Side;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t none = Laid_out_faces::none;
  static constexpr double equal = 1 + 1e-15;
  static constexpr std::size_t most_at_narrow_edge = 32;
  static constexpr double least_angle = 1e-9;
  static constexpr double shadow_begin = CGAL_PI - least_angle; // from the way to a vertex

  // The nearest straight way across a side to the opposite corner, and where it crosses the side.
  struct Split
  {
    double distance = infinity, crossing = 0;
  };

  void send_all_on(std::uint32_t side)
  {
    const std::vector<Window>& windows = waiting_.take_all(side);
    number_of_steps_ += windows.size() - 1;
    for (const Window& w : windows)
      send_on(w);
  }

  // A way to the vertex where the side begins, from the angle to the left of the side.
  void reach(std::uint32_t side, double angle, double distance, std::uint32_t source)
  {
    double& known = distances_[surface_.side(side).row];
    if (!(distance < known * shorter))
      return;
    known = distance;
    arrivals_[surface_.side(side).row] = {side, angle};
    origins_[surface_.side(side).row] = source;
    waiting_.add_event(distance, {0, 0, angle, 0, 0, side, none, source, 0, Window::WAY_TO_VERTEX});
  }

  // Whether ways over an end of the side are shorter for all points of the window.
  bool is_useless(const Window& w) const
  {
    const Side& s = surface_.side(w.side);
    return distances_[s.row] + w.b1 <= w.distance(w.b1) * shorter ||
           distances_[surface_.side(surface_.next(w.side)).row] + (s.length - w.b0) <= w.distance(w.b0) * shorter;
  }

  // A window leaves a face across one of its sides, and is given as seen from there. If the surface was cut, the window
  // continues into each of the other faces.
  void leave(std::uint32_t side, const Window& w)
  {
    const std::uint32_t opposite = surface_.side(side).opposite;
    if (opposite != none)
      return enter(opposite, w);
    for (std::uint32_t other = surface_.beside(side); other != none && other != side; other = surface_.beside(other))
      enter(other,
            surface_.side(other).row == surface_.side(side).row ? turned_over(w, surface_.side(side).length) : w);
  }

  void enter(std::uint32_t side, Window w)
  {
    w.side = side;
    const double length = surface_.side(w.side).length;
    // No way goes there: where a face is thinner than rounding, it cannot be told where the way to its corner crosses.
    if (w.y < -1e-12 * (w.kind == Window::FRONT ? 1 : std::abs(w.x) + length))
      return;
    w.b0 = (std::max)(w.b0, 0.);
    w.b1 = (std::min)(w.b1, length);
    w.y = (std::max)(w.y, 0.);
    if (w.b1 - w.b0 > least_width * length && !is_useless(w) &&
        (surface_.side(side).narrow == none || crosses_narrow_edge(w)))
      waiting_.add(w);
  }

  // Whether a window has to be followed across a narrow edge: not if other ways to the edge are shorter at all its
  // points, or equally long with fewer turns. So no way circles a needle back to its place.
  //
  // Apart from rounding, no shortest way is lost. Let a shortest way be dropped where its last straight part crosses an
  // edge. It is not longer than the other way to there and its own rest. The shortest way of those that cross the same
  // edges as this consists of the shortest way to some vertex, which is nearer, and of a straight part with fewer
  // turns. By induction over both, a way as long as this is found. Each time, it may have become longer by the factor
  // `equal`, of which a thousand are less than `shorter`.
  bool crosses_narrow_edge(Window& w)
  {
    const std::uint32_t narrow = surface_.side(w.side).narrow;
    std::vector<Window>& others = at_narrow_edges_[narrow / 2];
    const Window forward = narrow % 2 == 0 ? w : turned_over(w, surface_.side(w.side).length);
    for (const Window& other : others)
      if (is_nowhere_longer(other, forward, other.turns < w.turns ? equal : shorter))
        return false;
    if (others.size() < most_at_narrow_edge)
      others.push_back(forward);
    else
      others[number_of_steps_ % most_at_narrow_edge] = forward;
    if (w.turns < (std::numeric_limits<std::uint16_t>::max)())
      ++w.turns;
    return true;
  }

  // The error of compared lengths across a side. Dropping a window for another one that only seems to be shorter leaves
  // a gap.
  double slack(const Side& s) const { return 5 * tolerance_ * s.length; }

  // The ways from a vertex into a face at it, between two angles to the left of the side that begins there.
  void send_into_face(std::uint32_t side, double from, double to)
  {
    const Side &s = surface_.side(side), &o = surface_.side(surface_.next(side)),
               &last = surface_.side(surface_.prev(side));
    const auto at = [&](double angle) { // where that direction meets the opposite side, seen from beyond it
      if (angle <= 0)
        return o.length;
      if (angle >= s.angle)
        return 0.;
      const double u = s.length * std::sin(angle), v = last.length * std::sin(s.angle - angle);
      return u + v > 0 ? o.length * (v / (u + v)) : 0;
    };
    leave(surface_.next(side),
          {at(to), at(from), o.length - o.apex_x, o.apex_y, distances_[s.row], 0, none, origins_[s.row]});
  }

  // The ways of a window from a point to the points of the face that it enters, straight or over its nearest end.
  void reach_points(const Window& w)
  {
    for (const Laid_out_points::Point& p : points_->in_face(w.side / 3)) {
      const auto [x, y] = p.at[w.side % 3];
      const double height = w.y + y, crossing = height > 0 ? w.x + (x - w.x) * (w.y / height) : x,
                   at = (std::min)((std::max)(crossing, w.b0), w.b1);
      come_nearer(p, w.distance(at) + length_of(x - at, y));
    }
  }

  void come_nearer(const Laid_out_points::Point& p, double distance)
  {
    double& known = point_distances_[p.number];
    known = (std::min)(known, distance);
  }

  void begin_at(const Window_sources& sources)
  {
    for (const Row_source& source : sources.rows)
      if (source.offset < distances_[source.row]) {
        distances_[source.row] = source.offset;
        origins_[source.row] = source.number;
      }
    for (std::size_t i = 0; i < sources.rows.size(); ++i) {
      const Row_source& source = sources.rows[i];
      const std::uint32_t first = surface_.first_corner(source.row);
      if (source.offset == 0)
        send_from_source(source, 0);
      else if (first < surface_.first_corner(source.row + 1))
        waiting_.add_event(source.offset,
                           {0, 0, 0, 0, 0, surface_.corner(first), none, std::uint32_t(i), 0, Window::SOURCE});
    }
    for (const Face_source& source : sources.in_faces)
      for (std::uint32_t side : {source.side, surface_.next(source.side), surface_.prev(source.side)})
        if (surface_.side(side).opposite != none) // ways into that face may begin between others
          splits_[surface_.side(side).opposite].distance = std::numeric_limits<double>::quiet_NaN();
    for (const Face_source& source : sources.in_faces) {
      const First_ways first = first_ways(surface_, source);
      for (const auto& [side, angle, distance] : first.to_corners)
        reach(side, angle, distance, source.number);
      for (const auto& [side, window] : first.windows)
        leave(side, window);
    }
  }

  // The ways from a row, but not between the perpendiculars to a source that begins there.
  void send_from_source(const Row_source& source, double distance)
  {
    if (distance > distances_[source.row])
      return;
    if (source.segments.empty())
      return send_all_around(source.row, none);
    send_along_edges(source.row);
    std::map<std::uint32_t, std::pair<double, double>>
      covered; // from the right side of a corner, and from the left one
    for (const auto& [first, angle] : source.segments) {
      double from = angle, rest = CGAL_PI / 2;
      for (std::uint32_t side = first; side != none && rest > 0; from = 0, side = surface_.left_of(side)) {
        const double whole = surface_.side(side).angle, part = (std::min)(whole - from, rest);
        rest -= whole - from;
        cover(covered[side], from, from + part, whole);
      }
      rest = CGAL_PI / 2;
      double to = angle;
      for (std::uint32_t side = first; side != none && rest > 0;) {
        cover(covered[side], (std::max)(0., to - rest), to, surface_.side(side).angle);
        rest -= to;
        side = surface_.right_of(side);
        to = side == none ? 0 : surface_.side(side).angle;
      }
    }
    for (std::uint32_t i = surface_.first_corner(source.row); i < surface_.first_corner(source.row + 1); ++i) {
      const std::uint32_t side = surface_.corner(i);
      const double from = covered[side].first, to = surface_.side(side).angle - covered[side].second;
      if (to - from > least_angle)
        send_into_face(side, from, to);
    }
  }

  // \param covered up to which angles from the right and from the left side of a corner
  static void cover(std::pair<double, double>& covered, double from, double to, double whole)
  {
    if (from <= covered.first + least_angle)
      covered.first = (std::max)(covered.first, to);
    if (to >= whole - covered.second - least_angle)
      covered.second = (std::max)(covered.second, whole - from);
  }

  void send_along_edges(std::uint32_t row)
  {
    for (std::uint32_t i = surface_.first_corner(row); i < surface_.first_corner(row + 1); ++i) {
      const std::uint32_t side = surface_.corner(i), next = surface_.next(side), last = surface_.prev(side);
      reach(last, 0, distances_[row] + surface_.side(last).length, origins_[row]);
      if (surface_.side(side).opposite == none)
        reach(next, surface_.side(next).angle, distances_[row] + surface_.side(side).length, origins_[row]);
    }
    for (auto edge = surface_.flat_edges_at(row); edge != surface_.flat_edges().end() && edge->first == row; ++edge)
      reach(surface_.other_end(edge->second), 0, distances_[row] + surface_.side(edge->second).length, origins_[row]);
  }

  // The ways from a row: along all edges, and into all faces at its vertices except one.
  void send_all_around(std::uint32_t row, std::uint32_t but)
  {
    send_along_edges(row);
    for (std::uint32_t i = surface_.first_corner(row); i < surface_.first_corner(row + 1); ++i) {
      const std::uint32_t side = surface_.corner(i);
      if (surface_.side(side).vertex != but)
        send_into_face(side, 0, surface_.side(side).angle);
    }
  }

  // The ways from a reached vertex: along all edges, and straight into its shadow, at more than a straight angle from
  // the way to it.
  void send_from(std::uint32_t side, double angle, double distance)
  {
    const Side& start = surface_.side(side);
    if (distance > distances_[start.row])
      return;
    if (surface_.is_flat_edge(side))
      return send_all_around(start.row, none);
    send_all_around(start.row, start.vertex);
    const double whole = surface_.angle_sum(start.vertex);
    if (whole < infinity)
      return send_to_left(side, angle, whole - CGAL_PI);
    double to_border = -angle; // from the way to the left
    for (std::uint32_t s = side; s != none; s = surface_.left_of(s))
      to_border += surface_.side(s).angle;
    send_to_left(side, angle, to_border);
    to_border = angle; // from the way to the right
    for (std::uint32_t s = surface_.right_of(side); s != none; s = surface_.right_of(s))
      to_border += surface_.side(s).angle;
    if (to_border - CGAL_PI < least_angle)
      return;
    double sum = angle;
    for (std::uint32_t s = surface_.right_of(side); s != none; s = surface_.right_of(s)) {
      const double corner = surface_.side(s).angle;
      if (sum + corner > shadow_begin)
        send_into_face(s, 0, sum + corner - shadow_begin);
      sum += corner;
    }
  }

  // The ways from a reached vertex into its shadow, up to an angle to the left of the way to it. A straight border and
  // a vertex in a plane have no shadow: one due to rounding would be passed on across all faces.
  void send_to_left(std::uint32_t side, double angle, double shadow_end)
  {
    if (shadow_end - CGAL_PI < least_angle)
      return;
    double sum = -angle; // of the side, from the way to the left
    for (std::uint32_t s = side; s != none && sum < shadow_end + least_angle;) {
      const double corner = surface_.side(s).angle;
      if (sum + corner > shadow_begin)
        send_into_face(s, shadow_begin - sum, shadow_end + least_angle - sum);
      sum += corner;
      s = surface_.left_of(s);
      if (s == side)
        break;
    }
  }

  void send_on(const Window& w)
  {
    const Side& s = surface_.side(w.side);
    if (is_useless(w)) // by now
      return;
    if (points_)
      reach_points(w);
    if (waves_)
      waves_->push_back(wave_of(surface_, w));
    const std::uint32_t next = surface_.next(w.side), prev = surface_.next(next);
    const double cx = s.apex_x, cy = s.apex_y,
                 crossing = w.kind == Window::FRONT ? cx - cy * (w.x / w.y) : w.x + (cx - w.x) * (w.y / (w.y + cy));
    bool goes_left = w.b0<crossing, goes_right = w.b1> crossing;
    // To the corner, straight or over the end of the window that is nearest to the straight way.
    const double at = (std::min)((std::max)(crossing, w.b0), w.b1);
    const double to_corner = w.distance(at) + length_of(cx - at, cy);
    if (to_corner < distances_[surface_.side(prev).row] * shorter) // otherwise the angle is not needed
      reach(prev, std::atan2(cy * at, cx * (cx - at) + cy * cy), to_corner, w.source);
    if (goes_left && goes_right) {
      Split& split = splits_[w.side];
      if (to_corner < split.distance)
        split = {to_corner, crossing};
      else if (to_corner * shorter - slack(s) > split.distance && std::abs(crossing - split.crossing) > 1e-8 * s.length)
        (crossing < split.crossing ? goes_right : goes_left) = false;
    }
    if (goes_left) { // over the side from the corner to the beginning
      const Side& side = surface_.side(prev);
      const double ex = cx / side.length, ey = cy / side.length;
      const double b0 = on_left(w, s, w.b0) * side.length,
                   b1 = w.b1 >= crossing ? side.length : on_left(w, s, w.b1) * side.length;
      const Window child = seen_along(w, 0, 0, ex, ey, b0, b1);
      if (!is_shorter_over(surface_.side(next).row, s.length - b0 * ex, b0 * ey, child, b0, slack(s)))
        leave(prev, child);
    }
    if (goes_right) { // over the side from the end to the corner
      const Side& side = surface_.side(next);
      const double ex = side.apex_x / s.length, // (s.length - cx) / side.length without cancellation on a short side
        ey = -cy / side.length;
      const double b0 = w.b0 > crossing ? (1 - on_right(w, s, w.b0)) * side.length : 0,
                   b1 = (1 - on_right(w, s, w.b1)) * side.length;
      const Window child = seen_along(w, cx, cy, ex, ey, b0, b1);
      if (!is_shorter_over(s.row, cx + b1 * ex, cy + b1 * ey, child, b1, slack(s)))
        leave(next, child);
    }
  }

  // The window relative to a side from (cx, cy) in the direction (ex, ey).
  static Window seen_along(const Window& w, double cx, double cy, double ex, double ey, double b0, double b1)
  {
    Window result = w;
    result.b0 = b0;
    result.b1 = b1;
    if (w.kind == Window::FRONT) {
      result.sigma = w.sigma + (cx * w.x + cy * w.y);
      result.x = w.x * ex + w.y * ey;
      result.y = w.y * ex - w.x * ey;
    } else {
      result.x = (w.x - cx) * ex - (w.y + cy) * ey;
      result.y = (w.x - cx) * ey + (w.y + cy) * ex;
    }
    return result;
  }

  // Whether ways over the third corner of the face on the left are shorter for all points of the window. They cross all
  // its ways if the one to the end b farthest from the corner does.
  // \param x, y from the corner to that end
  bool is_shorter_over(std::uint32_t row, double x, double y, const Window& child, double b, double slack) const
  {
    return distances_[row] + length_of(x, y) + slack <= child.distance(b) * shorter;
  }

  // Where the way across a point of the side meets the side from its beginning to the corner, as a fraction of that
  // side.
  static double on_left(const Window& w, const Side& s, double b)
  {
    const double up = w.y * b, down = w.y * s.apex_x - w.run(b) * s.apex_y;
    return up <= 0 ? 0 : (down > up ? up / down : 1);
  }
  // The same for the side from the end to the corner.
  static double on_right(const Window& w, const Side& s, double b)
  {
    const double up = w.y * (s.length - b), down = w.y * (s.length - s.apex_x) + w.run(b) * s.apex_y;
    return up <= 0 ? 0 : (down > up ? up / down : 1);
  }

  const Laid_out_faces& surface_;
  const Laid_out_points* points_; // or null
  std::vector<Wave>* waves_;      // likewise
  std::vector<double> point_distances_ = std::vector<double>(points_ ? points_->size() : 0, infinity);
  double tolerance_;
  std::vector<double> distances_;                   // of the rows
  std::vector<Window_distances::Arrival> arrivals_; // likewise
  std::vector<std::uint32_t> origins_;              // likewise
  std::vector<Split> splits_;                       // of the sides
  Waiting_windows waiting_;
  std::vector<std::vector<Window>> at_narrow_edges_; // some of the windows that arrived, by the number of the edge
  std::uint64_t number_of_steps_ = 0;
};

} // namespace

Window_distances propagate_windows(const Laid_out_faces& surface, double tolerance, const Window_sources& sources,
                                   std::uint64_t most, const Interruption& interruption,
                                   const std::vector<std::uint32_t>& goals, double farthest, std::vector<Wave>* waves)
{
  Window_propagation windows(surface, tolerance, nullptr, waves);
  const bool is_complete = windows.run(sources, most, interruption, goals, farthest);
  return windows.result(is_complete);
}

Window_distances propagate_windows_to(const Laid_out_faces& surface, std::uint32_t source, std::uint32_t goal,
                                      const std::vector<double>& rests, std::uint64_t most,
                                      const Interruption& interruption)
{
  Window_propagation windows(surface, 0, nullptr, nullptr, &rests);
  const bool is_complete = windows.run({{{source, 0, 0, {}}}, {}}, most, interruption, {goal});
  return windows.result(is_complete);
}

std::vector<double> propagate_windows(const Laid_out_faces& surface, const Laid_out_points& points,
                                      const std::vector<std::uint32_t>& sources, const Interruption& interruption)
{
  Window_propagation windows(surface, 0, &points);
  windows.run_from_points(sources, interruption);
  return windows.distances_of_points();
}

} // namespace CGAL::Intrinsic_triangulations::internal
