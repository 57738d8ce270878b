// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Pieces of lines in triangles, joined to lines.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_PIECES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_PIECES_H

#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/trace_lines.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Nodes lie on edges between triangles, where a line has at most one piece on either side; or they are junctions.
// Pieces run so that whatever comes first in order lies to their left.
class Line_pieces
{
public:
  using Node = std::uint32_t;

  // \param vertex at which the node lies, or none
  Node add_node(bool is_junction, std::uint32_t vertex)
  {
    nodes_.push_back({none, vertex, is_junction, false});
    return Node(nodes_.size() - 1);
  }

  // \param start the first point
  // \param end the coordinates of the other one in the same face
  void add(Node from, Node to, const Surface_point& start, const std::array<double, 3>& end, std::uint32_t level,
           const std::array<std::uint32_t, 2>& cells)
  {
    const std::uint32_t piece = std::uint32_t(pieces_.size());
    pieces_.push_back({from, to, start, end, level, cells});
    if (nodes_[from].is_junction)
      beginnings_.push_back(piece);
    else
      nodes_[from].out = piece;
    nodes_[to].has_in = true;
  }

  std::vector<Traced_line> join()
  {
    std::vector<Traced_line> result;
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      if (!nodes_[pieces_[i].from].is_junction && !nodes_[pieces_[i].from].has_in)
        beginnings_.push_back(i);
    for (std::uint32_t i : beginnings_)
      follow(i, result);
    for (std::uint32_t i = 0; i < pieces_.size(); ++i)
      if (!pieces_[i].is_done)
        follow(i, result);
    return result;
  }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

private:
  struct Node_data
  {
    std::uint32_t out;
    std::uint32_t vertex;
    bool is_junction, has_in;
  };
  struct Piece
  {
    Node from, to;
    Surface_point start;
    std::array<double, 3> end;
    std::uint32_t level;
    std::array<std::uint32_t, 2> cells;
    bool is_done = false;
  };

  bool are_same(Node a, Node b) const
  {
    return a == b || (nodes_[a].vertex != none && nodes_[a].vertex == nodes_[b].vertex);
  }

  // A line that shrinks to a point is dropped.
  void follow(std::uint32_t i, std::vector<Traced_line>& result)
  {
    Traced_line line;
    line.level = pieces_[i].level;
    line.cells = pieces_[i].cells;
    const Node first = pieces_[i].from;
    std::uint32_t last = none;
    for (; i != none && !pieces_[i].is_done; i = nodes_[pieces_[i].to].is_junction ? none : nodes_[pieces_[i].to].out) {
      pieces_[i].is_done = true;
      if (are_same(pieces_[i].from, pieces_[i].to))
        continue;
      line.points.push_back(pieces_[i].start);
      last = i;
    }
    if (last == none)
      return;
    if (are_same(first, pieces_[last].to))
      line.points.push_back(line.points.front()); // with the same coordinates
    else
      line.points.push_back({pieces_[last].start.halfedge, pieces_[last].end});
    result.push_back(std::move(line));
  }

  std::vector<Node_data> nodes_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> beginnings_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_PIECES_H
