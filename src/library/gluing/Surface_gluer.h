// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From triangles in space to an oriented surface with as few cuts as possible.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include "Faces_around_edge.h"
#include "Sides_by_edge.h"
#include "../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Decides which triangles are turned over, which sides become one edge, and which vertices have to be copied.
//
// - The two sides of an edge with two faces become one, unless a one-sided surface has to be cut there.
// - At other edges, the faces are taken in their order around the edge. Counterclockwise about the edge, material lies
//   between a face that runs backward and the next one that runs forward, as in a solid whose faces point outward.
//   Such faces are glued, and whatever lies between them is left out; then the next ones are, until none remain. So
//   each pair bounds a set where the winding number is at least some value, and a solid that touches itself comes apart
//   along the edge. Where solids overlap and several faces could be glued, faces of the same piece are.
// - If the solid is inside out, which its volume tells, material is on the other sides. Solids that only touch may
//   differ in this.
// - Pieces that hang on others by one edge alone, as a fin does, are glued after all others. If their number at an edge
//   is odd, as for three sheets, only faces of the same piece, or of pieces that are glued elsewhere, are glued to each
//   other: the others would leave a slit in the surface.
// - If as many faces run forward at an edge as backward, and the two sides of a wall do not run alike, nothing is
//   turned there. Otherwise pieces are turned so that directions alternate around each edge with an even number of
//   faces, as they do around each solid.
// - Faces in one half-plane have nothing between them. So where material ends comes first, and two such faces, as of a
//   wall between two rooms, have opposite directions. Three or more such faces, and faces without area, say nothing: no
//   piece is turned because of them.
// - Triangles are given by their corners, so two edges must not have the same ends. Where two pairs at an edge would,
//   the faces that have nothing between them are glued instead, so that the solid is connected along the edge. If that
//   fails, too, all are cut. The same is tried where the two sides of a wall were glued to each other.
class Surface_gluer
{
  using Index = std::uint32_t;

public:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // \param ask is called between the steps, and may throw
  // \pre no triangle names a vertex twice
  Surface_gluer(
    const Points& points, const std::vector<Index_triangle>& triangles, const std::function<void()>& ask = [] {})
    : points_(points), triangles_(triangles), sides_(points.size(), triangles),
      pieces_((ask(), sides_), triangles.size()), is_turned_(pieces_.is_turned), glued_to_(3 * triangles.size(), none),
      is_hanging_(pieces_.pieces.size(), false), turns_(2 * pieces_.pieces.size()), joined_(pieces_.pieces.size())
  {
    ask();
    look_at_edges();
    ask();
    find_hanging_pieces();
    for (const bool are_hanging : {false, true}) {
      turn_pieces(are_hanging);
      for (const bool is_odd : {false, true})
        for (Crowded_edge& edge : crowded_edges_)
          if (entries_left(edge, are_hanging).size() % 2 == is_odd)
            glue(edge, are_hanging);
    }
    ask();
    turn_triangles();
    separate_edges();
  }

  // Whether a triangle is turned over: its corners 0 and 2 are exchanged. The first triangle of each part connected by
  // edges is not.
  bool is_turned(std::size_t face) const { return is_turned_[face]; }
  // The vertices of the surface: first the given ones, then copies; for each, the original.
  const std::vector<Index>& vertices() const { return fans_.first; }
  // The vertex of the surface at a corner of a triangle, after turning.
  Index vertex(std::size_t corner) const { return fans_.second[corner]; }
  // The side glued to the one from a corner to the next, after turning the triangles; none at the border.
  Index neighbor(std::size_t corner) const { return glued_to_[corner]; }

private:
  // A side at an edge with more than two faces.
  struct Entry
  {
    Index side, piece;
    Index half_plane;             // counted around the edge
    bool is_flat;                 // without area: in every half-plane
    bool runs_backward, is_glued; // seen from the smaller end of the edge, before its piece is turned
  };
  enum Rule {
    MATERIAL,
    VOID,
    CUT
  };
  // The entries of an edge, in their order around it.
  struct Crowded_edge
  {
    std::vector<Entry> entries;
    bool is_inside_out = false, has_been_void = false;
    Rule rule = MATERIAL;
  };
  using Entries = std::vector<Entry*>;

  // Glues the sides of simple edges.
  void look_at_edges()
  {
    std::vector<Faces_around_edge::Face> around;
    sides_.for_each_edge([&](Index v, const Sides_by_edge::Side* begin, const Sides_by_edge::Side* end) {
      const auto runs_backward = [this](const Sides_by_edge::Side& s) {
        return s.runs_to_smaller_end() != is_turned_[s.face()];
      };
      if (end - begin <= 2) {
        if (end - begin == 2 && runs_backward(begin[0]) != runs_backward(begin[1]))
          glue_sides(begin[0].side(), begin[1].side());
        else
          is_hanging_[pieces_.piece_of[begin->face()]] = true;
        return;
      }
      around.clear();
      for (const Sides_by_edge::Side* s = begin; s < end; ++s)
        around.push_back({triangles_[s->face()][(s->side() + 2) % 3], Index(s - begin)});
      Faces_around_edge order(points_, v, begin->larger_end);
      order.sort(around);
      Crowded_edge edge;
      for (std::size_t i = 0, half_plane = 0; i < around.size(); ++i) {
        const Sides_by_edge::Side& s = begin[around[i].side];
        if (i > 0 && !order.are_in_one_half_plane(around[i - 1], around[i]))
          ++half_plane;
        edge.entries.push_back({s.side(), pieces_.piece_of[s.face()], Index(half_plane),
                                order.is_on_edge_line(around[i]), runs_backward(s), false});
      }
      crowded_edges_.push_back(std::move(edge));
    });
  }

  // A piece hangs if it has a border, or is the only one left at an edge once other hanging pieces are removed.
  void find_hanging_pieces()
  {
    std::vector<std::array<std::size_t, 2>> edges_of_pieces; // piece, edge; once for each face
    std::vector<std::size_t> number_left;
    for (std::size_t e = 0; e < crowded_edges_.size(); ++e) {
      number_left.push_back(crowded_edges_[e].entries.size());
      for (const Entry& entry : crowded_edges_[e].entries)
        edges_of_pieces.push_back({entry.piece, e});
    }
    std::sort(edges_of_pieces.begin(), edges_of_pieces.end());
    std::vector<Index> hanging;
    for (Index p = 0; p < is_hanging_.size(); ++p)
      if (is_hanging_[p])
        hanging.push_back(p);
    while (!hanging.empty()) {
      const std::size_t piece = hanging.back();
      hanging.pop_back();
      for (auto it =
             std::lower_bound(edges_of_pieces.begin(), edges_of_pieces.end(), std::array<std::size_t, 2>{piece, 0});
           it != edges_of_pieces.end() && (*it)[0] == piece; ++it) {
        if (--number_left[(*it)[1]] != 1)
          continue;
        for (const Entry& entry : crowded_edges_[(*it)[1]].entries)
          if (!is_hanging_[entry.piece]) {
            is_hanging_[entry.piece] = true;
            hanging.push_back(entry.piece);
          }
      }
    }
  }

  // The sides not glued yet; none if there is only one.
  Entries entries_left(Crowded_edge& edge, bool are_hanging)
  {
    Entries result;
    for (Entry& entry : edge.entries)
      if (!entry.is_glued && (are_hanging || !is_hanging_[entry.piece]))
        result.push_back(&entry);
    if (result.size() < 2)
      result.clear();
    return result;
  }

  // A network consists of pieces joined by these edges.
  void turn_pieces(bool are_hanging)
  {
    const std::size_t n = is_hanging_.size();
    std::vector<Index> group(n); // pieces that are turned together
    for (Index p = 0; p < n; ++p)
      group[p] = turns_.find(2 * p) / 2;
    Disjoint_sets networks(n);
    for (Crowded_edge& edge : crowded_edges_)
      if (const Entries entries = entries_left(edge, are_hanging); !entries.empty())
        for (const Entry* entry : entries)
          networks.unite(group[entries[0]->piece], group[entry->piece]);

    std::vector<bool> has_to_turn(n, false);
    for (Crowded_edge& edge : crowded_edges_)
      if (const Entries entries = entries_left(edge, are_hanging); !entries.empty()) {
        const auto backward = std::size_t(
          std::count_if(entries.begin(), entries.end(), [this](const Entry* e) { return runs_backward(*e); }));
        if (2 * backward > entries.size() + 1 || 2 * backward + 1 < entries.size() || is_wall_turned(entries))
          has_to_turn[networks.find(group[entries[0]->piece])] = true;
      }
    for (Crowded_edge& edge : crowded_edges_)
      if (const Entries entries = entries_left(edge, are_hanging);
          !entries.empty() && has_to_turn[networks.find(group[entries[0]->piece])])
        tie_around(entries);
    if (are_hanging || crowded_edges_.empty())
      return;
    // Pieces that do not close each other may be inside out or not.
    Disjoint_sets solids(n);
    std::vector<Index> open_piece(crowded_edges_.size(), none);
    for (std::size_t e = 0; e < crowded_edges_.size(); ++e) {
      std::map<Index, int> balance;
      for (const Entry* entry : entries_left(crowded_edges_[e], false))
        balance[entry->piece] += runs_backward(*entry) ? 1 : -1;
      for (const auto& [piece, number] : balance)
        if (number != 0) {
          if (open_piece[e] != none)
            solids.unite(open_piece[e], piece);
          open_piece[e] = piece;
        }
    }
    const std::vector<bool> is_network_inside_out = find_inside_out(networks), is_inside_out = find_inside_out(solids);
    for (std::size_t e = 0; e < crowded_edges_.size(); ++e)
      if (const Entries entries = entries_left(crowded_edges_[e], false); !entries.empty())
        crowded_edges_[e].is_inside_out = open_piece[e] == none
                                            ? is_network_inside_out[networks.find(entries[0]->piece)]
                                            : is_inside_out[solids.find(open_piece[e])];
  }

  // Whether two faces with the same corners have the same direction.
  bool is_wall_turned(const Entries& entries)
  {
    const auto third_vertex = [this](const Entry& e) { return triangles_[e.side / 3][(e.side + 2) % 3]; };
    for (std::size_t i = 1; i < entries.size(); ++i)
      if (third_vertex(*entries[i - 1]) == third_vertex(*entries[i]) &&
          runs_backward(*entries[i - 1]) == runs_backward(*entries[i]))
        return true;
    return false;
  }

  // Directions alternate among faces that are alone in their half-planes, and within a half-plane of two.
  void tie_around(const Entries& entries)
  {
    const auto tie_opposite = [this](const Entry* a, const Entry* b) {
      tie(a->piece, b->piece, a->runs_backward == b->runs_backward);
    };
    if (entries.size() == 2)
      return tie_opposite(entries[0], entries[1]);
    Entries alone;
    bool is_known = entries.size() % 2 == 0;
    for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
      bool has_flat = false;
      for (; j < entries.size() && entries[j]->half_plane == entries[i]->half_plane; ++j)
        has_flat = has_flat || entries[j]->is_flat;
      if (j - i == 1)
        alone.push_back(entries[i]);
      else if (j - i == 2 && !has_flat)
        tie_opposite(entries[i], entries[i + 1]);
      else
        is_known = false;
    }
    for (std::size_t i = 1; is_known && i < alone.size(); ++i)
      tie_opposite(alone[i - 1], alone[i]);
  }

  void glue(Crowded_edge& edge, bool are_hanging)
  {
    Entries entries = entries_left(edge, are_hanging);
    const bool may_join_pieces = !are_hanging || entries.size() % 2 == 0;
    const auto group = [&](const Entry& entry) { return may_join_pieces ? entry.piece : joined_.find(entry.piece); };
    const bool is_material_forward = edge.is_inside_out != (edge.rule == VOID);
    std::stable_sort(entries.begin(), entries.end(), [&](const Entry* a, const Entry* b) {
      if (a->half_plane != b->half_plane)
        return a->half_plane < b->half_plane;
      return runs_backward(*a) == is_material_forward && runs_backward(*b) != is_material_forward;
    });
    // Where material began that has not ended: for all pieces, and for each one. Goes around the edge twice, because it
    // may begin in material.
    Entries begun;
    std::map<Index, Entries> begun_of_piece;
    for (const bool is_second_time : {false, true})
      for (Entry* const end : entries) {
        if (end->is_glued)
          continue;
        if (runs_backward(*end) != is_material_forward) {
          if (!is_second_time) {
            begun.push_back(end);
            begun_of_piece[group(*end)].push_back(end);
          }
          continue;
        }
        while (!begun.empty() && begun.back()->is_glued)
          begun.pop_back();
        if (begun.empty())
          continue;
        const auto same = begun_of_piece.find(group(*end));
        const bool is_same = same != begun_of_piece.end() && !same->second.empty();
        if (!is_same && !may_join_pieces)
          continue;
        Entries& candidates = is_same ? same->second : begun_of_piece[group(*begun.back())];
        Entry* const begin = candidates.back();
        candidates.pop_back();
        begin->is_glued = end->is_glued = true;
        glue_sides(begin->side, end->side);
        joined_.unite(begin->piece, end->piece);
        tie(begin->piece, end->piece, turns(begin->piece) != turns(end->piece));
      }
  }

  // From here on, sides belong to the turned triangles.
  void turn_triangles()
  {
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      is_turned_[f] = is_turned_[f] != turns(pieces_.piece_of[f]);
    const auto turned = [this](Index s) { return is_turned_[s / 3] && s % 3 != 2 ? 6 * (s / 3) + 1 - s : s; };
    corners_ = Large_vector<Index>(glued_to_.size(), none);
    Large_vector<Index> glued_to(glued_to_.size(), none);
    for (Index s = 0; s < corners_.size(); ++s) {
      corners_[s] = triangles_[s / 3][is_turned_[s / 3] ? 2 - s % 3 : s % 3];
      if (glued_to_[s] != none)
        glued_to[turned(s)] = turned(glued_to_[s]);
    }
    glued_to_ = std::move(glued_to);
    for (Crowded_edge& edge : crowded_edges_)
      for (Entry& entry : edge.entries)
        entry.side = turned(entry.side);
    fans_ = separate_fans(points_.size(), corners_, glued_to_);
  }

  void separate_edges()
  {
    constexpr int number_of_trials = 20;
    for (int trial = 0;; ++trial) {
      bool is_changed = false;
      std::vector<bool> is_near(points_.size(), false); // to a change: decisions there may differ now
      for (Crowded_edge& edge : crowded_edges_) {
        if (edge.rule == CUT || !(is_double(edge) || (!edge.has_been_void && joins_sides_of_wall(edge))))
          continue;
        const Index s = edge.entries[0].side, v = corners_[s], w = corners_[next_side(s)];
        if (trial < number_of_trials && (is_near[v] || is_near[w]))
          continue;
        is_near[v] = is_near[w] = is_changed = true;
        for (Entry& entry : edge.entries) {
          entry.is_glued = false;
          glued_to_[entry.side] = none;
        }
        edge.rule = trial >= number_of_trials ? CUT : edge.rule == MATERIAL ? VOID : MATERIAL;
        edge.has_been_void = true;
        for (const bool are_hanging : {false, true})
          if (edge.rule != CUT)
            glue(edge, are_hanging);
      }
      if (!is_changed)
        break;
      fans_ = separate_fans(points_.size(), corners_, glued_to_);
    }
    // Two remaining sides with the same ends are one edge.
    for (Crowded_edge& edge : crowded_edges_)
      for (Entry& entry : edge.entries)
        for (Entry& other : edge.entries)
          if (edge.rule == CUT && entry.side < other.side && ends(entry.side) == ends(other.side))
            glue_sides(entry.side, other.side);
  }

  // Whether two of the edges that were made have the same ends.
  bool is_double(const Crowded_edge& edge) const
  {
    std::vector<std::pair<Index, Index>> all;
    for (const Entry& entry : edge.entries)
      if (glued_to_[entry.side] == none || entry.side < glued_to_[entry.side])
        all.push_back(ends(entry.side));
    std::sort(all.begin(), all.end());
    return std::adjacent_find(all.begin(), all.end()) != all.end();
  }

  // Whether two faces with the same corners were glued: as those of a wall between two rooms that are inside out, when
  // not everything joined with them is.
  bool joins_sides_of_wall(const Crowded_edge& edge) const
  {
    return std::any_of(edge.entries.begin(), edge.entries.end(), [this](const Entry& entry) {
      const Index other = glued_to_[entry.side];
      return other != none && corners_[previous_side(entry.side)] == corners_[previous_side(other)];
    });
  }

  // The networks with negative volume.
  std::vector<bool> find_inside_out(Disjoint_sets& networks)
  {
    const std::size_t n = is_hanging_.size();
    std::vector<Index> network_of(n, none); // of each piece with crowded edges
    for (const Crowded_edge& edge : crowded_edges_)
      for (const Entry& entry : edge.entries)
        if (!is_hanging_[entry.piece])
          network_of[entry.piece] = networks.find(entry.piece);
    // Adds six times the volume below each face to that of its network, if that is among the given ones.
    const auto add_volumes = [&](auto& six_times, const auto& is_wanted) {
      using Number = std::decay_t<decltype(six_times[0])>;
      for (std::size_t f = 0; f < triangles_.size(); ++f) {
        const Index piece = pieces_.piece_of[f], network = network_of[piece];
        if (network == none || !is_wanted(network))
          continue;
        std::array<Vector_3<Number>, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
          p[i] = difference<Number>(points_, Vertex_index(triangles_[0][0]), Vertex_index(triangles_[f][i]));
        const Number volume = scalar_product(cross_product(p[0], p[1]), p[2]);
        const bool is_turned = is_turned_[f] != turns(piece);
        six_times[network] = six_times[network] + (is_turned ? Number(-volume) : volume);
      }
    };
    std::vector<Double_with_bound> bounded(n);
    add_volumes(bounded, [](Index) { return true; });
    std::vector<bool> result(n, false), is_open(n, false); // if the bounds leave it open
    for (Index i = 0; i < n; ++i) {
      const Uncertain<Sign> sign = bounded[i].sign();
      result[i] = certainly(sign == NEGATIVE);
      is_open[i] = !is_certain(sign);
    }
    if (std::find(is_open.begin(), is_open.end(), true) == is_open.end())
      return result;
    std::vector<Exact_ring> exact(n);
    add_volumes(exact, [&is_open](Index network) { return is_open[network]; });
    for (Index i = 0; i < n; ++i)
      if (is_open[i])
        result[i] = CGAL::sign(exact[i]) == NEGATIVE;
    return result;
  }

  void glue_sides(Index s, Index t)
  {
    glued_to_[s] = t;
    glued_to_[t] = s;
  }

  bool turns(Index piece) { return (turns_.find(2 * piece) & 1) != 0; }
  bool runs_backward(const Entry& e) { return e.runs_backward != turns(e.piece); }
  // Decides whether exactly one of the two pieces is turned, unless that is decided already.
  void tie(Index piece, Index other, bool is_one_turned)
  {
    const Index same = 2 * other + is_one_turned, opposite = 2 * other + !is_one_turned;
    if (turns_.find(2 * piece) == turns_.find(opposite))
      return;
    turns_.unite(2 * piece, same);
    turns_.unite(2 * piece + 1, opposite);
  }

  std::pair<Index, Index> ends(Index side) const
  {
    const Index v = fans_.second[side], w = fans_.second[next_side(side)];
    return fans_.first[v] < fans_.first[w] ? std::make_pair(v, w) : std::make_pair(w, v);
  }

  const Points& points_;
  const std::vector<Index_triangle>& triangles_;
  const Sides_by_edge sides_;
  Triangle_pieces pieces_;
  std::vector<bool> is_turned_; // of each triangle; at first, within its piece
  Large_vector<Index> glued_to_;
  std::vector<Crowded_edge> crowded_edges_;
  std::vector<bool> is_hanging_; // of each piece
  // Piece p is node 2p with its first face as given, and node 2p + 1 turned over. The smallest number of a set is even,
  // so nodes in its set are not turned.
  Disjoint_sets turns_;
  Disjoint_sets joined_;        // pieces that were glued
  Large_vector<Index> corners_; // of the turned triangles
  std::pair<std::vector<Index>, Large_vector<Index>> fans_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H
