// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A list of polygons in flat arrays: all corners, and the sides sorted so that those of an edge
// are together.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_SIDES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_SIDES_H

#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts elements and keeps the ten smallest.
class Element_collector
{
public:
  void add(const std::size_t element)
  {
    ++count_;
    if (smallest_.size() == 10 && element > smallest_.back())
      return;
    smallest_.insert(std::upper_bound(smallest_.begin(), smallest_.end(), element), element);
    if (smallest_.size() > 10)
      smallest_.pop_back();
  }
  std::size_t count() const { return count_; }
  std::size_t first() const { return smallest_.front(); }
  const std::vector<std::size_t>& elements() const { return smallest_; }

private:
  std::vector<std::size_t> smallest_; // sorted
  std::size_t count_ = 0;
};

// The corners of all faces one after the other, and the sides in buckets by their smaller
// vertex (a counting sort), so that the sides of an edge are found in one bucket with one mark
// per vertex.
class Polygon_sides
{
public:
  typedef std::uint32_t Index;
  static constexpr Index none = Polygon_copies::none;

  // A side of a face: the corners that it joins, in the face's direction, and the larger of
  // the two vertices.
  struct Side
  {
    Index other, source, target;
  };

  // The corners of a face with a bad index all become `none`, so that nothing later looks at that face.
  explicit Polygon_sides(Polygon_copies&& polygons)
    : number_of_vertices_(polygons.number_of_vertices), number_of_faces_(polygons.number_of_faces),
      first_bad_index_(polygons.first_bad_index), can_be_numbered_(polygons.can_be_numbered()),
      corners_(std::move(polygons.corners))
  {
    if (!can_be_numbered_)
      return;
    is_used_.assign(number_of_vertices_, 0);
    for (const Index corner : corners_)
      if (corner != none)
        is_used_[corner] = 1;
    std::size_t begin = 0;
    for (std::size_t face = 0; face < polygons.ends.size(); ++face) {
      const std::size_t end = polygons.ends[face];
      all_triangles_ = all_triangles_ && end - begin == 3;
      const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(begin),
                 last = corners_.begin() + static_cast<std::ptrdiff_t>(end);
      if (std::find(first, last, none) != last) {
        bad_faces_.add(face);
        std::fill(first, last, none);
      }
      begin = end;
    }
    if (!all_triangles_) {
      first_corner_ = std::move(polygons.ends);
      first_corner_.insert(first_corner_.begin(), 0);
    }
  }
  bool can_be_numbered() const { return can_be_numbered_; }

  void sort_sides()
  {
    bucket_begin_.assign(number_of_vertices_ + 2, 0);
    for_each_side([this](const Index s, const Index t) { ++bucket_begin_[(std::min)(corners_[s], corners_[t]) + 2]; });
    std::partial_sum(bucket_begin_.begin(), bucket_begin_.end(), bucket_begin_.begin());
    sides_.resize(bucket_begin_.back());
    for_each_side([this](const Index s, const Index t) {
      const std::pair<Index, Index> v = std::minmax({corners_[s], corners_[t]});
      sides_[bucket_begin_[v.first + 1]++] = Side{v.second, s, t};
    });
    bucket_begin_.pop_back(); // now the beginning of each bucket, and the end of the last
  }

  std::size_t number_of_vertices() const { return number_of_vertices_; }
  bool is_used(const std::size_t vertex) const { return is_used_[vertex] != 0; }
  const Element_collector& faces_with_bad_index() const { return bad_faces_; }
  // The first bad index in the first of these faces.
  std::size_t first_bad_index() const { return first_bad_index_; }
  std::size_t number_of_faces() const { return number_of_faces_; }
  std::size_t number_of_corners() const { return corners_.size(); }
  bool are_triangles() const { return all_triangles_; }

  // The vertex of a corner.
  Index vertex(const std::size_t corner) const { return corners_[corner]; }
  std::size_t begin_of_face(const std::size_t face) const { return all_triangles_ ? 3 * face : first_corner_[face]; }
  std::size_t degree(const std::size_t face) const { return begin_of_face(face + 1) - begin_of_face(face); }
  std::size_t face_of_corner(const std::size_t corner) const
  {
    if (all_triangles_)
      return corner / 3;
    return static_cast<std::size_t>(std::upper_bound(first_corner_.begin(), first_corner_.end(), corner) -
                                    first_corner_.begin()) -
           1;
  }

  // Calls function(source corner, target corner) for the sides of the faces
  // that have at least three corners, without the sides from a vertex to itself.
  template <class Function>
  void for_each_side(Function function) const
  {
    for (std::size_t f = 0; f < number_of_faces_; ++f) {
      const std::size_t begin = begin_of_face(f), end = begin_of_face(f + 1);
      if (end - begin < 3 || corners_[begin] == none)
        continue;
      for (std::size_t c = begin, last = end - 1; c < end; last = c++)
        if (corners_[last] != corners_[c])
          function(static_cast<Index>(last), static_cast<Index>(c));
    }
  }

  // The sides of the edges whose smaller vertex is this one are those from bucket_begin(vertex)
  // to before bucket_begin(vertex + 1). \pre for these and what follows: the sides are sorted
  std::size_t bucket_begin(const std::size_t vertex) const { return bucket_begin_[vertex]; }
  const Side& side(const std::size_t position) const { return sides_[position]; }
  std::size_t face_of_side(const std::size_t position) const { return face_of_corner(sides_[position].source); }
  bool leaves(const Side& side, const std::size_t vertex) const { return corners_[side.source] == vertex; }
  // The vertex of a triangle that is not on a side, or `none` if the face is not a triangle.
  Index third_vertex(const Side& side) const
  {
    const std::size_t face = face_of_corner(side.source);
    if (degree(face) != 3)
      return none;
    const std::size_t begin = begin_of_face(face);
    return corners_[3 * begin + 3 - side.source - side.target];
  }
  // The two vertices of a side, the smaller first.
  std::array<std::size_t, 2> ends(const std::size_t position) const
  {
    const std::size_t a = corners_[sides_[position].source], b = corners_[sides_[position].target];
    return {{(std::min)(a, b), (std::max)(a, b)}};
  }
  // Calls function(smaller end, larger end, positions of the sides) for each edge.
  template <class Function>
  void for_each_edge(const Function& function) const
  {
    std::vector<Index> bucket, sides;
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      bucket.resize(bucket_begin(v + 1) - bucket_begin(v));
      std::iota(bucket.begin(), bucket.end(), bucket_begin_[v]);
      std::sort(bucket.begin(), bucket.end(), [this](Index s, Index t) {
        return std::make_pair(sides_[s].other, s) < std::make_pair(sides_[t].other, t);
      });
      for (std::size_t i = 0; i < bucket.size(); i += sides.size()) {
        const Index w = sides_[bucket[i]].other;
        sides.clear();
        for (std::size_t j = i; j < bucket.size() && sides_[bucket[j]].other == w; ++j)
          sides.push_back(bucket[j]);
        function(Index(v), w, sides);
      }
    }
  }
  Index face(const Index position) const { return Index(face_of_side(position)); }
  bool has_corner(const std::size_t face, const Index v) const
  {
    const auto begin = corners_.begin() + std::ptrdiff_t(begin_of_face(face)),
               end = corners_.begin() + std::ptrdiff_t(begin_of_face(face + 1));
    return std::find(begin, end, v) != end;
  }
  // The faces of the edge whose first side this is.
  std::vector<std::size_t> faces_of_edge(const std::size_t position) const
  {
    std::vector<std::size_t> faces;
    for (std::size_t s = position; s < bucket_begin_[ends(position)[0] + 1]; ++s)
      if (sides_[s].other == sides_[position].other)
        faces.push_back(face_of_side(s));
    return faces;
  }

private:
  std::size_t number_of_vertices_, number_of_faces_;
  std::vector<unsigned char> is_used_;
  Element_collector bad_faces_;
  std::size_t first_bad_index_;
  bool can_be_numbered_;
  std::vector<Index> corners_;
  std::vector<Index> first_corner_; // only if not all faces are triangles
  bool all_triangles_ = true;
  std::vector<Index> bucket_begin_;
  std::vector<Side> sides_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_SIDES_H
