// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The triangles that a closed ring of straight sides in the plane encloses.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_PLANAR_RING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_PLANAR_RING_H

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The ring winds once around the region that it encloses, in either direction. Its sides may touch each other, run
// along each other and come back, as at the slit to a hole, but not cross. The corners of triangles are corners of the
// ring.
//
// The border of the triangles consists of the undivided sides of the ring: a side that passes through other corners
// gets a fan of flat triangles with them. So a neighbor that shares the side finds it.
class Planar_ring
{
public:
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Index = std::uint32_t;

  enum Status {
    CUT,
    FLAT,       // all corners are on a line
    CROSSING,   // two sides cross
    OVERLAPPING // the ring winds twice around something
  };

  // \param tolerance the distance up to which a corner beyond a side touches it: where sides cross by less, as by
  // rounding, the side goes through the corner
  Planar_ring(const std::vector<Point>& corners, double tolerance)
    : corners_(corners), squared_tolerance_(tolerance * tolerance)
  {}

  Status cut()
  {
    find_places();
    if (sides_.size() < 3)
      return FLAT;
    for (int round = 0; round < 30; ++round) {
      const Status status = insert_sides();
      if (status == FLAT || (status == CROSSING && !split_crossing_sides(round == 29)))
        return status;
      if (status == CUT && find_windings())
        return collect_triangles();
      if (status == CUT && !split_beside_overlaps())
        break;
    }
    return OVERLAPPING;
  }

  // The corners by their numbers in the ring.
  const std::vector<std::array<std::size_t, 3>>& triangles() const { return triangles_; }
  // The corners at the beginning and end of each of the two sides that cross.
  const std::array<std::array<std::size_t, 2>, 2>& crossing_sides() const { return crossing_sides_; }
  // A corner next to a part around which the ring winds twice.
  std::size_t overlap() const { return overlap_; }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr int unknown = (std::numeric_limits<int>::max)();
  using Pair = std::pair<Index, Index>;

  struct Face_info
  {
    int winding;
    std::array<Index, 3> corners;
  };
  using Vertex_base = Triangulation_vertex_base_with_info_2<Index, Kernel>; // the place
  using Face_base =
    Constrained_triangulation_face_base_2<Kernel, Triangulation_face_base_with_info_2<Face_info, Kernel>>;
  using Base = Constrained_Delaunay_triangulation_2<Kernel, Triangulation_data_structure_2<Vertex_base, Face_base>>;

  class Triangulation : public Base
  {
  public:
    struct Crossing
    {
      Index source, target; // of the side that is there
    };

  private:
    typename Base::Vertex_handle intersect(typename Base::Face_handle f, int i, typename Base::Vertex_handle,
                                           typename Base::Vertex_handle) override
    {
      throw Crossing{f->vertex(this->cw(i))->info(), f->vertex(this->ccw(i))->info()};
    }
  };
  using Vertex_handle = Triangulation::Vertex_handle;
  using Face_handle = Triangulation::Face_handle;

  // A side of the ring, from corner to corner, and the places that it passes.
  struct Side
  {
    Index source, target;
    std::vector<Index> passed;
  };

  static Pair sorted(Index a, Index b) { return std::minmax(a, b); }

  // Corners at the same point form one place. For sides, the last of consecutive ones stands for all; flat triangles
  // with the previous corner join the others to it.
  void find_places()
  {
    const Index n = Index(corners_.size());
    std::vector<Index> order(n);
    for (Index c = 0; c < n; ++c)
      order[c] = c;
    std::sort(order.begin(), order.end(),
              [this](Index a, Index b) { return corners_[a] != corners_[b] ? corners_[a] < corners_[b] : a < b; });
    place_.resize(n);
    for (Index i = 0; i < n; ++i) {
      if (i == 0 || corners_[order[i]] != corners_[order[i - 1]])
        points_.emplace_back(corners_[order[i]], Index(points_.size()));
      place_[order[i]] = Index(points_.size() - 1);
    }
    if (points_.size() < 3)
      return;
    const auto next = [n](Index c) { return c + 1 < n ? c + 1 : 0; };
    Index start = 0; // a corner at another place than the previous one
    while (place_[start] == place_[start == 0 ? n - 1 : start - 1])
      ++start;
    Index before = start == 0 ? n - 1 : start - 1, c = start;
    first_corner_.assign(points_.size(), none);
    has_several_corners_.assign(points_.size(), false);
    do {
      const Index first = c;
      for (; place_[next(c)] == place_[first]; c = next(c))
        triangles_.push_back({before, c, next(c)});
      if (!sides_.empty())
        sides_.back().target = c;
      sides_.push_back({c, none, {}});
      if (Index& at = first_corner_[place_[c]]; at == none)
        at = c;
      else
        has_several_corners_[place_[c]] = true;
      before = c;
      c = next(c);
    } while (c != start);
    sides_.back().target = sides_.front().source;
  }

  // The place at a position of a side's way, 0 for its source.
  Index place_on(const Side& side, std::size_t i) const
  {
    return i == 0 ? place_[side.source] : i <= side.passed.size() ? side.passed[i - 1] : place_[side.target];
  }
  template <class Function>
  void for_each_piece(const Side& side, const Function& function) const
  {
    for (std::size_t i = 0; i <= side.passed.size(); ++i)
      function(place_on(side, i), place_on(side, i + 1));
  }

  // Inserts all sides as edges, and records the places through which they pass and the sides that they cross.
  Status insert_sides()
  {
    triangulation_.clear();
    triangulation_.insert(points_.begin(), points_.end());
    if (triangulation_.dimension() < 2)
      return FLAT;
    handles_.resize(points_.size());
    for (Vertex_handle v : triangulation_.finite_vertex_handles())
      handles_[v->info()] = v;
    crossings_.clear();
    for (const Side& side : sides_)
      for_each_piece(side, [this](Index p, Index q) {
        const auto [a, b] = sorted(p, q); // the way back along a slit is the same
        try {
          triangulation_.insert_constraint(handles_[a], handles_[b]);
        } catch (const typename Triangulation::Crossing& crossing) {
          crossings_.emplace_back(Pair(a, b), sorted(crossing.source, crossing.target));
        }
      });
    std::sort(crossings_.begin(), crossings_.end());
    for (Side& side : sides_)
      find_passed_places(side);
    return crossings_.empty() ? CUT : CROSSING;
  }

  void find_passed_places(Side& side) const
  {
    std::vector<Index> way;
    for_each_piece(side, [&](Index p, Index q) {
      const auto it = std::lower_bound(crossings_.begin(), crossings_.end(), std::pair(sorted(p, q), Pair(0, 0)));
      if (it == crossings_.end() || it->first != sorted(p, q))
        for (p = next_towards(p, q); p != q; p = next_towards(p, q))
          way.push_back(p);
      way.push_back(q);
    });
    way.pop_back();
    side.passed = std::move(way);
  }

  // The next place on the way between two, along which there are edges.
  Index next_towards(Index p, Index q) const
  {
    if (triangulation_.is_edge(handles_[p], handles_[q]))
      return q;
    const Kernel kernel;
    auto neighbor = triangulation_.incident_vertices(handles_[p]);
    for (;; ++neighbor)
      if (!triangulation_.is_infinite(neighbor) &&
          kernel.orientation_2_object()(handles_[p]->point(), handles_[q]->point(), neighbor->point()) == COLLINEAR &&
          kernel.collinear_are_ordered_along_line_2_object()(handles_[p]->point(), neighbor->point(),
                                                             handles_[q]->point()))
        return neighbor->info();
  }

  // If two sides cross, the nearest of their four corners becomes a place that the other side passes. Returns false if
  // none is near.
  bool split_crossing_sides(const bool is_last_round)
  {
    std::map<Pair, std::vector<Index>> passed;
    for (const auto& [one, other] : crossings_) {
      double least = std::numeric_limits<double>::infinity();
      Index place = none;
      Pair piece;
      for (const auto& [through, ends] : {std::pair(other, one), std::pair(one, other)})
        for (Index p : {ends.first, ends.second})
          if (const double distance = squared_distance(
                points_[p].first, Kernel::Segment_2(points_[through.first].first, points_[through.second].first));
              distance < least) {
            least = distance;
            place = p;
            piece = through;
          }
      if (!(least <= squared_tolerance_) || is_last_round) {
        crossing_sides_ = {side_with(one), side_with(other)};
        std::sort(crossing_sides_.begin(), crossing_sides_.end());
        return false;
      }
      passed[piece].push_back(place);
    }
    split(passed);
    return true;
  }

  // Where the ring winds twice around thin triangles, because sides overlap that should touch, one side goes through
  // the corner beside it. Returns false if a triangle is not thin.
  bool split_beside_overlaps()
  {
    std::map<Pair, std::vector<Index>> passed;
    for (Face_handle f : triangulation_.finite_face_handles()) {
      if (f->info().winding >= -1 && f->info().winding <= 1)
        continue;
      overlap_ = first_corner_[f->vertex(0)->info()];
      double least = std::numeric_limits<double>::infinity(), longest = 0;
      int split_edge = -1;
      for (int i = 0; i < 3; ++i) {
        const Kernel::Segment_2 edge(source(f, i)->point(), target(f, i)->point());
        const double distance = squared_distance(f->vertex(i)->point(), edge), length = edge.squared_length();
        least = (std::min)(least, distance);
        if (f->is_constrained(i) && distance <= squared_tolerance_ && length > longest) {
          longest = length;
          split_edge = i;
        }
      }
      if (!(least <= squared_tolerance_))
        return false;
      if (split_edge >= 0)
        passed[sorted(source(f, split_edge)->info(), target(f, split_edge)->info())].push_back(
          f->vertex(split_edge)->info());
    }
    split(passed);
    return !passed.empty();
  }

  // Lets pieces pass through places.
  void split(const std::map<Pair, std::vector<Index>>& passed)
  {
    for (Side& side : sides_) {
      std::vector<Index> way;
      for_each_piece(side, [&](Index p, Index q) {
        if (const auto it = passed.find(sorted(p, q)); it != passed.end()) {
          std::vector<Index> places = it->second;
          std::sort(places.begin(), places.end(), [&](Index a, Index b) {
            const Kernel::Vector_2 direction = points_[q].first - points_[p].first;
            const double along = (points_[a].first - points_[b].first) * direction;
            return along != 0 ? along < 0 : a < b;
          });
          places.erase(std::unique(places.begin(), places.end()), places.end());
          way.insert(way.end(), places.begin(), places.end());
        }
        way.push_back(q);
      });
      way.pop_back();
      side.passed = std::move(way);
    }
  }

  std::array<std::size_t, 2> side_with(const Pair& piece) const
  {
    for (const Side& side : sides_) {
      bool is_found = false;
      for_each_piece(side, [&](Index p, Index q) { is_found = is_found || sorted(p, q) == piece; });
      if (is_found)
        return {side.source, side.target};
    }
    return {}; // unreachable: each crossed edge is a piece of a side, or part of one that passes its ends
  }

  // Computes how often the ring winds around each face. Returns false if it winds twice around one.
  bool find_windings()
  {
    std::vector<std::pair<Pair, int>> turns; // of each piece: the winding number is larger by this on its left; sorted
    for (const Side& side : sides_)
      for_each_piece(side, [&](Index p, Index q) { turns.emplace_back(sorted(p, q), p < q ? 1 : -1); });
    std::sort(turns.begin(), turns.end());
    const auto turn = [&turns](Index p, Index q) {
      int sum = 0;
      for (auto it = std::lower_bound(turns.begin(), turns.end(), std::pair(sorted(p, q), -1));
           it != turns.end() && it->first == sorted(p, q); ++it)
        sum += it->second;
      return p < q ? sum : -sum;
    };
    for (Face_handle f : triangulation_.all_face_handles())
      f->info().winding = unknown;
    std::vector<Face_handle> stack{triangulation_.infinite_face()};
    stack[0]->info().winding = 0;
    bool is_once = true;
    while (!stack.empty()) {
      const Face_handle f = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face_handle g = f->neighbor(i);
        if (g->info().winding != unknown)
          continue;
        g->info().winding =
          f->info().winding - (f->is_constrained(i) ? turn(source(f, i)->info(), target(f, i)->info()) : 0);
        is_once = is_once && std::abs(g->info().winding) <= 1;
        stack.push_back(g);
      }
    }
    return is_once;
  }

  // The ends of side i of a face, with the face to its left.
  static Vertex_handle source(Face_handle f, int i) { return f->vertex(Triangulation::ccw(i)); }
  static Vertex_handle target(Face_handle f, int i) { return f->vertex(Triangulation::cw(i)); }

  Status collect_triangles()
  {
    for (Face_handle f : triangulation_.finite_face_handles())
      for (int i = 0; i < 3; ++i)
        f->info().corners[i] = first_corner_[f->vertex(i)->info()];
    find_ends();
    for (Vertex_handle v : triangulation_.finite_vertex_handles())
      if (has_several_corners_[v->info()])
        find_corners_around(v);
    for (Face_handle f : triangulation_.finite_face_handles()) {
      const auto [a, b, c] = f->info().corners;
      if (f->info().winding > 0)
        triangles_.push_back({a, b, c});
      else if (f->info().winding < 0)
        triangles_.push_back({c, b, a});
    }
    add_flat_triangles();
    return CUT;
  }

  void find_ends()
  {
    const auto add = [this](Index corner, Index neighbor, bool is_source) {
      if (has_several_corners_[place_[corner]])
        ends_.push_back({place_[corner], neighbor, is_source, corner});
    };
    for (const Side& side : sides_) {
      add(side.source, place_on(side, 1), true);
      add(side.target, place_on(side, side.passed.size()), false);
    }
    std::sort(ends_.begin(), ends_.end());
  }

  // Between two sides the faces around a place belong to one corner.
  void find_corners_around(Vertex_handle v)
  {
    const auto begins = [v](Face_handle f) { return f->is_constrained(Triangulation::cw(f->index(v))); };
    auto f = triangulation_.incident_faces(v);
    while (!begins(f))
      ++f;
    const Face_handle start = f;
    do {
      const auto first = f;
      Vertex_handle last;
      do {
        last = f->vertex(Triangulation::cw(f->index(v)));
        ++f;
      } while (!begins(f));
      if (first->info().winding == 0)
        continue;
      const Index corner = corner_between(v->info(), first->vertex(Triangulation::ccw(first->index(v)))->info(),
                                          last->info(), first->info().winding > 0);
      auto g = first;
      do
        g->info().corners[g->index(v)] = corner;
      while (++g != f);
    } while (f != start);
  }

  // The corner at which a side to one place begins and a side from another place ends, or vice versa. Without such a
  // corner, one with one of these sides.
  Index corner_between(Index place, Index one, Index other, bool is_left) const
  {
    const auto corners = [this, place](Index neighbor, bool is_source) {
      std::vector<Index> result;
      for (auto it = std::lower_bound(ends_.begin(), ends_.end(), End{place, neighbor, is_source, 0});
           it != ends_.end() && it->place == place && it->neighbor == neighbor && it->is_source == is_source; ++it)
        result.push_back(it->corner);
      return result;
    };
    const std::vector<Index> from = corners(one, is_left), to = corners(other, !is_left);
    for (Index c : from)
      if (std::binary_search(to.begin(), to.end(), c))
        return c;
    return !from.empty() ? from[0] : !to.empty() ? to[0] : first_corner_[place];
  }

  // Adds flat triangles for each side that passes through places, unless another side returns the same way.
  void add_flat_triangles()
  {
    std::map<Pair, std::vector<const Side*>> alone; // by the places of their ends
    for (const Side& side : sides_) {
      if (side.passed.empty())
        continue;
      const Index p = place_[side.source], q = place_[side.target];
      if (std::vector<const Side*>& back = alone[{q, p}]; !back.empty())
        back.pop_back();
      else
        alone[{p, q}].push_back(&side);
    }
    for (const auto& [ends, sides] : alone)
      for (const Side* side : sides) {
        std::size_t before = side->target;
        for (std::size_t i = side->passed.size(); i > 0; --i) {
          const std::size_t corner = corner_beside(place_on(*side, i - 1), place_on(*side, i));
          triangles_.push_back({side->source, before, corner});
          before = corner;
        }
      }
  }

  // The corner of a triangle at the end of a piece, to its left if possible.
  Index corner_beside(Index from, Index to) const
  {
    Face_handle f;
    int i = 0;
    triangulation_.is_edge(handles_[from], handles_[to], f, i);
    const Face_handle g = f->neighbor(i);
    const bool is_left = source(f, i) == handles_[from];
    for (const Face_handle h : {is_left ? f : g, is_left ? g : f})
      if (h->info().winding != 0)
        return h->info().corners[h->index(handles_[to])];
    return first_corner_[to];
  }

  // An end of a side at a place with several corners, and the next place of the side.
  struct End
  {
    Index place, neighbor;
    bool is_source;
    Index corner;
    friend bool operator<(const End& a, const End& b)
    {
      return std::tie(a.place, a.neighbor, a.is_source, a.corner) <
             std::tie(b.place, b.neighbor, b.is_source, b.corner);
    }
  };

  const std::vector<Point>& corners_;
  const double squared_tolerance_;
  std::vector<Index> place_;                    // of each corner
  std::vector<std::pair<Point, Index>> points_; // of the places, with their numbers
  std::vector<Index> first_corner_;             // of each place
  std::vector<bool> has_several_corners_;       // of each place
  std::vector<Side> sides_;
  Triangulation triangulation_;
  std::vector<Vertex_handle> handles_;           // of the places
  std::vector<std::pair<Pair, Pair>> crossings_; // pieces that could not be inserted, and the edges in their way
  std::vector<End> ends_;
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::array<std::array<std::size_t, 2>, 2> crossing_sides_ = {};
  std::size_t overlap_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_PLANAR_RING_H
