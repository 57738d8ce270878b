// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest distances on a triangulated surface.

#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>

#include "Nearest_first_queue.h"
#include "Window.h"

#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The points of a side that straight ways from a vertex reach through the same faces are a window. Windows are passed
// on from face to face, the nearest first, and dropped where a way over a vertex is not longer. Ways bend only at
// vertices whose angles sum to more than 2π, and on the border: these send windows of their own into their shadow.
//
// Windows that wait at the same side are merged if they come from the same point, as on both sides of a flat vertex. Of
// two that come from the same vertex over different faces, each is cut off where the other is shorter.
//
// With a tolerance, all windows at a side wait for each other. Those that are nowhere the shortest are dropped, and
// neighbors are merged if that changes no distance and no direction by more than the tolerance. Far from the sources,
// most sides are then crossed by a single window, however fine the faces are.
//
// Source: J. Chen, Y. Han, "Shortest paths on a polyhedron", 1996; S. Xin, G. Wang, "Improving Chen and Han's algorithm
// on the discrete geodesic problem", 2009; V. Surazhsky et al., "Fast exact and approximate geodesics on meshes", 2005
// (merging windows).
class Window_propagation
{
public:
  // \param surface, points must outlive this
  Window_propagation(const Laid_out_faces& surface, double tolerance, const Laid_out_points* points = nullptr)
    : surface_(surface), points_(points), tolerance_(tolerance), distances_(surface.number_of_rows(), infinity),
      arrivals_(surface.number_of_rows()), splits_(surface.sides().size()),
      waiting_(tolerance > 0 ? surface.sides().size() : 0, none), in_order_(tolerance > 0 ? 0 : surface.sides().size()),
      at_narrow_edges_(surface.number_of_narrow_edges())
  {
    // Of two ways to a corner, the longer one ends what lies beyond the other, because they have crossed in the face
    // before. If they may come from different faces, nothing is known.
    for (std::uint32_t side = 0; side < splits_.size(); ++side)
      if (surface.beside(side) != none)
        splits_[side].distance = std::numeric_limits<double>::quiet_NaN();
  }
  Window_propagation(const Window_propagation&) = delete; // the queue refers to it
  Window_propagation& operator=(const Window_propagation&) = delete;

  // \return whether the maximum number of steps was enough
  bool run(const std::vector<std::uint32_t>& sources, std::uint64_t most, const Interruption& interruption,
           std::uint32_t goal)
  {
    for (std::uint32_t row : sources)
      distances_[row] = 0;
    for (std::uint32_t row : sources)
      send_all_around(row, none);
    while (!queue_.empty()) {
      if (++number_of_steps_ > most)
        return false;
      if (number_of_steps_ % 4096 == 0)
        interruption.check();
      const auto [distance, slot] = queue_.top();
      queue_.pop();
      if (!queue_.empty())
        prefetch(&windows_[queue_.top().second]);
      if (goal != none && distance > distances_[goal])
        break;
      const Window window = windows_[slot];
      if (window.sigma >= 0 && tolerance_ > 0) {
        send_all_on(window.side);
        continue;
      }
      if (window.sigma < 0)
        send_from(window.side, window.x, distance);
      else if (window.next != taken) {
        remove(slot);
        send_on(window);
      }
      free_.push_back(slot);
    }
    return true;
  }

  // The same, from points.
  void run_from_points(const std::vector<std::uint32_t>& sources, const Interruption& interruption)
  {
    std::vector<std::uint32_t> rows;
    for (std::uint32_t number : sources)
      if (const Laid_out_points::Point* const p = points_->find(number)) {
        if (p->row != none)
          rows.push_back(p->row);
        else
          send_from_point(*p);
      }
    run(rows, (std::numeric_limits<std::uint64_t>::max)(), interruption, none);
  }

  // Of the points; infinite where no way leads. Ways that bend at a corner of the face come from there.
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
    return {std::move(distances_), std::move(arrivals_), number_of_steps_, is_complete};
  }

private:
  using Side = Laid_out_faces::Side;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t none = Laid_out_faces::none, taken = none - 1;
  static constexpr double equal = 1 + 1e-15;
  static constexpr std::size_t most_at_narrow_edge = 32;
  static constexpr double least_width = 1e-12, least_angle = 1e-9;
  static constexpr double shadow_begin = CGAL_PI - least_angle; // from the way to a vertex

  // A window in the queue: its distance, and where it is stored.
  using Place = std::pair<double, std::uint32_t>;
  // Among windows at the same distance, those at the first side come first, independent of numbering.
  struct Comes_later
  {
    const Window_propagation& windows;

    bool operator()(const Place& a, const Place& b) const
    {
      if (a.first != b.first)
        return a.first > b.first;
      const Window &u = windows.windows_[a.second], &v = windows.windows_[b.second];
      return u.side == v.side ? is_before(v, u) : windows.surface_.is_before(v.side, u.side);
    }
  };

  // The nearest straight way across a side to the opposite corner, and where it crosses the side.
  struct Split
  {
    double distance = infinity, crossing = 0;
  };

  std::uint32_t store(const Window& window)
  {
    std::uint32_t slot = std::uint32_t(windows_.size());
    if (free_.empty())
      windows_.push_back(window);
    else {
      slot = free_.back();
      free_.pop_back();
      windows_[slot] = window;
    }
    return slot;
  }

  // Removes a window from those that wait at its side in order.
  void remove(std::uint32_t slot)
  {
    std::vector<Place>& row = in_order_[windows_[slot].side];
    auto place = std::lower_bound(row.begin(), row.end(), Place(windows_[slot].x, 0));
    while (place->second != slot)
      ++place;
    row.erase(place);
  }

  void wait(Window w)
  {
    if (tolerance_ == 0)
      return wait_in_order(w);
    std::uint32_t& first = waiting_[w.side];
    w.next = first;
    first = store(w);
    if (w.next == none) // a front enters a face without obtuse angle through sides whose middles are nearer
      queue_.push({w.distance(surface_.side(w.side).length / 2), first});
  }

  // Between the waiting windows whose ways come from farther to the left and to the right. What others reach sooner is
  // cut off, of this window and of those.
  void wait_in_order(Window& w)
  {
    unite_with_waiting(w);
    std::vector<Place>& row = in_order_[w.side];
    auto place = std::lower_bound(row.begin(), row.end(), Place(w.x, 0));
    for (; place != row.end(); place = row.erase(place)) {
      Window& other = windows_[place->second];
      if (!trim_end(w, other))
        return;
      if (trim_beginning(other, w))
        break;
      other.next = taken;
    }
    for (; place != row.begin(); place = row.erase(place)) {
      Window& other = windows_[std::prev(place)->second];
      if (!trim_beginning(w, other))
        return;
      if (trim_end(other, w))
        break;
      other.next = taken;
      --place;
    }
    const std::uint32_t slot = store(w);
    row.insert(place, Place(w.x, slot));
    // At the distance of its nearest point: windows derived from it are not nearer, so ways continue from a vertex
    // only once the shortest way to it is known.
    queue_.push({w.distance((std::min)((std::max)(w.x, w.b0), w.b1)), slot});
  }

  // Merges a window with waiting ones that come from the same point, if possible.
  void unite_with_waiting(Window& w)
  {
    const double least_gap = least_width * surface_.side(w.side).length;
    std::vector<Place>& row = in_order_[w.side];
    const auto first_near = [&] {
      return std::lower_bound(row.begin(), row.end(), Place(w.x - 2 * least_difference(w), 0));
    };
    for (auto place = first_near(); place != row.end() && place->first <= w.x + 2 * least_difference(w);) {
      Window& other = windows_[place->second];
      const Window &u = other.b0 < w.b0 ? other : w, &v = other.b0 < w.b0 ? w : other;
      if (v.b0 > u.b1 + least_gap || !come_from_same_point(u, v)) {
        ++place;
        continue;
      }
      w = both(u, v);
      other.next = taken;
      row.erase(place);
      place = first_near();
    }
  }

  // All windows that wait at a side, merged as far as the tolerance allows.
  void send_all_on(std::uint32_t side)
  {
    meeting_.clear();
    for (std::uint32_t slot = waiting_[side]; slot != none; slot = windows_[slot].next) {
      meeting_.push_back(windows_[slot]);
      free_.push_back(slot);
    }
    waiting_[side] = none;
    std::sort(meeting_.begin(), meeting_.end(), is_before);
    std::size_t last = 0;
    for (std::size_t i = 1; i < meeting_.size(); ++i)
      if (!unite_nearly(meeting_[last], meeting_[i]))
        meeting_[++last] = meeting_[i];
    number_of_steps_ += last;
    for (std::size_t i = 0; i <= last; ++i)
      send_on(meeting_[i]);
  }

  // \param u begins before v
  // \return whether u now represents both
  bool unite_nearly(Window& u, const Window& v) const
  {
    const double length = surface_.side(u.side).length;
    if (is_nowhere_shorter(v, u))
      return true;
    if (is_nowhere_shorter(u, v)) {
      u = v;
      return true;
    }
    // Changed windows leave gaps between them, which grow with the distance.
    if (v.b1 <= u.b1 || v.b0 > u.b1 + length / 10)
      return false;
    Window result = both(u, v);
    if (!come_from_same_point(u, v)) {
      // The distances of the ends do not change.
      const double width = result.b1 - result.b0;
      result.sigma = (std::min)(u.sigma, v.sigma);
      const double r0 = u.distance(u.b0) - result.sigma, r1 = v.distance(v.b1) - result.sigma,
                   x = (width + (r0 - r1) * ((r0 + r1) / width)) / 2;
      if (!(std::abs(x) < r0))
        return false;
      result.x = result.b0 + x;
      result.y = std::sqrt((r0 - x) * (r0 + x));
      const auto differs = [&](const Window& w, double b) {
        return std::abs(w.distance(b) - result.distance(b)) > tolerance_ * length;
      };
      if (turns(u, result, u.b0) || turns(v, result, v.b1) || differs(u, u.b1) || differs(v, v.b0) ||
          differs(u, (u.b0 + u.b1) / 2) || differs(v, (v.b0 + v.b1) / 2))
        return false;
    }
    u = result;
    return true;
  }

  // Whether the ways of another window are shorter at all points of w; or longer by the tolerance at most, if they have
  // the same direction.
  bool is_nowhere_shorter(const Window& w, const Window& other) const
  {
    if (w.b0 < other.b0 || w.b1 > other.b1)
      return false;
    const double more = turns(w, other, w.b0) || turns(w, other, w.b1) ? 0 : tolerance_ * surface_.side(w.side).length;
    for (double b : {w.b0, (w.b0 + w.b1) / 2, w.b1})
      if (other.distance(b) > w.distance(b) + more)
        return false;
    return true;
  }

  // In a corridor of thin faces, turned ways would run into the wall.
  bool turns(const Window& u, const Window& v, double b) const
  {
    return std::abs((b - u.x) / length_of(b - u.x, u.y) - (b - v.x) / length_of(b - v.x, v.y)) > 3 * tolerance_;
  }

  // A way to the vertex where the side begins, from the angle to the left of the side.
  void reach(std::uint32_t side, double angle, double distance)
  {
    double& known = distances_[surface_.side(side).row];
    if (!(distance < known * shorter))
      return;
    known = distance;
    arrivals_[surface_.side(side).row] = {side, angle};
    queue_.push({distance, store({0, 0, angle, 0, -1, side})});
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
    w.b0 = (std::max)(w.b0, 0.);
    w.b1 = (std::min)(w.b1, length);
    w.y = (std::max)(w.y, 0.);
    if (w.b1 - w.b0 > least_width * length && !is_useless(w) &&
        (surface_.side(side).narrow == none || crosses_narrow_edge(w)))
      wait(w);
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
    leave(surface_.next(side), {at(to), at(from), o.length - o.apex_x, o.apex_y, distances_[s.row], 0});
  }

  // The ways from a point within a face.
  void send_from_point(const Laid_out_points::Point& p)
  {
    for (const Laid_out_points::Point& q : points_->in_face(p.face))
      come_nearer(q, length_of(q.at[0][0] - p.at[0][0], q.at[0][1] - p.at[0][1]));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t side = 3 * p.face + k;
      const double length = surface_.side(side).length, x = p.at[k][0], y = p.at[k][1];
      reach(side, std::atan2(y, x), length_of(x, y));
      leave(side, {0, length, length - x, y, 0, 0});
    }
  }

  // The ways of a window to the points of the face that it enters, straight or over its nearest end.
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

  // The ways from a row: along all edges, and into all faces at its vertices except one.
  void send_all_around(std::uint32_t row, std::uint32_t but)
  {
    const std::uint32_t begin = surface_.first_corner(row), end = surface_.first_corner(row + 1);
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t side = surface_.corner(i), next = surface_.next(side), last = surface_.prev(side);
      reach(last, 0, distances_[row] + surface_.side(last).length);
      if (surface_.side(side).opposite == none)
        reach(next, surface_.side(next).angle, distances_[row] + surface_.side(side).length);
    }
    for (std::uint32_t i = begin; i < end; ++i) {
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
    const std::uint32_t next = surface_.next(w.side), prev = surface_.next(next);
    const double cx = s.apex_x, cy = s.apex_y, crossing = w.x + (cx - w.x) * (w.y / (w.y + cy));
    bool goes_left = w.b0<crossing, goes_right = w.b1> crossing;
    // To the corner, straight or over the end of the window that is nearest to the straight way.
    const double at = (std::min)((std::max)(crossing, w.b0), w.b1);
    const double to_corner = w.distance(at) + length_of(cx - at, cy);
    if (to_corner < distances_[surface_.side(prev).row] * shorter) // otherwise the angle is not needed
      reach(prev, std::atan2(cy * at, cx * (cx - at) + cy * cy), to_corner);
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
      const Window child{b0, b1, w.x * ex - w.y * ey, w.x * ey + w.y * ex, w.sigma, 0, none, w.turns};
      if (!is_shorter_over(surface_.side(next).row, s.length - b0 * ex, b0 * ey, child, b0, slack(s)))
        leave(prev, child);
    }
    if (goes_right) { // over the side from the end to the corner
      const Side& side = surface_.side(next);
      const double ex = side.apex_x / s.length, // (s.length - cx) / side.length without cancellation on a short side
        ey = -cy / side.length;
      const double b0 = w.b0 > crossing ? (1 - on_right(w, s, w.b0)) * side.length : 0,
                   b1 = (1 - on_right(w, s, w.b1)) * side.length;
      const Window child{b0,   b1,     (w.x - cx) * ex - (w.y + cy) * ey, (w.x - cx) * ey + (w.y + cy) * ex, w.sigma, 0,
                         none, w.turns};
      if (!is_shorter_over(s.row, cx + b1 * ex, cy + b1 * ey, child, b1, slack(s)))
        leave(next, child);
    }
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
    const double up = w.y * b, down = w.y * s.apex_x - (b - w.x) * s.apex_y;
    return up <= 0 ? 0 : (down > up ? up / down : 1);
  }
  // The side from the end to the corner.
  static double on_right(const Window& w, const Side& s, double b)
  {
    const double up = w.y * (s.length - b), down = w.y * (s.length - s.apex_x) + (b - w.x) * s.apex_y;
    return up <= 0 ? 0 : (down > up ? up / down : 1);
  }

  const Laid_out_faces& surface_;
  const Laid_out_points* points_; // or null
  std::vector<double> point_distances_ = std::vector<double>(points_ ? points_->size() : 0, infinity);
  double tolerance_;
  std::vector<double> distances_;                   // of the rows
  std::vector<Window_distances::Arrival> arrivals_; // likewise
  std::vector<Split> splits_;                       // of the sides
  std::vector<Window> windows_;
  std::vector<Window> meeting_;                      // at one side
  std::vector<std::uint32_t> free_;                  // places for windows
  std::vector<std::uint32_t> waiting_;               // at each side, the first window, with a tolerance
  std::vector<std::vector<Place>> in_order_;         // at each side, all of them by `x`, without a tolerance
  std::vector<std::vector<Window>> at_narrow_edges_; // some of the windows that arrived, by the number of the edge
  Nearest_first_queue<Place, Comes_later> queue_{Comes_later{*this}};
  std::uint64_t number_of_steps_ = 0;
};

} // namespace

Window_distances propagate_windows(const Laid_out_faces& surface, double tolerance,
                                   const std::vector<std::uint32_t>& sources, std::uint64_t most,
                                   const Interruption& interruption, std::uint32_t goal)
{
  Window_propagation windows(surface, tolerance);
  const bool is_complete = windows.run(sources, most, interruption, goal);
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
