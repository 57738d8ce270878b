// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and curves of the input in the faces of a triangulation.

#include <CGAL/Intrinsic_triangulations/internal/distances/Curve_sources.h>

#include "../gluing/Cut_faces.h"
#include "../connectivity/checked_coordinates.h"
#include "plane_vectors.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using plane::Vector;
using Coordinates = std::array<double, 3>;

// Relative to the halfedge.
Coordinates coordinates_in_face_of(const Delta_complex& complex, Halfedge_index h, const Surface_point& p)
{
  Coordinates result;
  if (find_coordinates(complex, h, p, result))
    return result;
  throw Invalid_point_error("two consecutive points of a curve do not lie in the face of the first, face " +
                            std::to_string(complex.face(h).idx()));
}

class Curve_sources_builder
{
public:
  Curve_sources_builder(const Exact_engine& engine, const Delta_complex& complex, const Laid_out_faces& faces)
    : engine_(engine), input_(engine.correspondence().input()), complex_(complex), faces_(faces),
      row_of_(complex.number_of_vertices(), Laid_out_faces::none)
  {
    for (const Laid_out_faces::Side& side : faces.sides())
      row_of_[side.vertex] = side.row;
  }

  Window_sources build(const std::vector<Geodesic_source>& sources)
  {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      if (!(sources[i].offset >= 0 && std::isfinite(sources[i].offset)))
        throw Invalid_argument_error("the offset of source " + std::to_string(i) + " is negative or not finite");
      number_ = std::uint32_t(i);
      offset_ = std::ldexp(sources[i].offset, -faces_.exponent());
      for (const std::vector<Surface_point>& part : sources[i].parts)
        add_part(part);
    }
    for (auto& [row, source] : rows_) {
      if (source.is_isolated)
        source.at_row.segments.clear();
      result_.rows.push_back(std::move(source.at_row));
    }
    return std::move(result_);
  }

private:
  // A segment of a curve, from one of its points to the next.
  struct Segment
  {
    Surface_point start, end; // in the same face of the input
    Vector direction;         // in the plane of that face
    Surface_point located;    // the start in the triangulation
    std::vector<Face_source> pieces;
  };

  struct Source_at_row
  {
    Row_source at_row;
    bool is_isolated = false; // whether some source is the vertex alone
  };

  Surface_point checked(Surface_point p) const
  {
    const std::optional<Coordinates> coordinates = checked_coordinates(p.coordinates);
    if (p.halfedge.idx() >= input_.number_of_halfedges() || input_.is_border(p.halfedge) || !coordinates)
      throw Invalid_point_error("a point of source " + std::to_string(number_) +
                                " does not lie on the surface: it needs a face, and coordinates that are finite, not "
                                "negative and not all zero");
    p.coordinates = on_near_edges(*coordinates);
    return p;
  }

  // From a point to another one in its face, or to a corner. The coordinate that falls by the sum of the others is not
  // zero, so that rounding does not lead out of the face.
  Surface_direction direction(const Surface_point& start, const Coordinates& end) const
  {
    const std::size_t i = largest(start.coordinates), j = (i + 1) % 3, k = (i + 2) % 3;
    Halfedge_index h = start.halfedge;
    for (std::size_t n = 0; n < i; ++n)
      h = input_.next(h);
    const Coordinates& c = start.coordinates;
    return {{h, {c[i], c[j], c[k]}}, {end[j] - c[j], end[k] - c[k]}};
  }
  static std::size_t largest(const Coordinates& c)
  {
    return std::size_t(std::max_element(c.begin(), c.end()) - c.begin());
  }

  void add_part(const std::vector<Surface_point>& part)
  {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + 1 < part.size(); ++i) {
      Surface_point start = checked(part[i]);
      const Surface_point end{start.halfedge, coordinates_in_face_of(input_, start.halfedge, checked(part[i + 1]))};
      if (length(start, end) > 0)
        segments.push_back(segment(start, end));
    }
    if (segments.empty()) {
      if (!part.empty())
        add_point(checked(part.front()));
      return;
    }
    for (const Segment& s : segments)
      add_pieces(s);
    const Surface_point &first = segments.front().start, &last = segments.back().end;
    if (are_same_place(first, last) && part.size() > 2) {
      add_joint(segments.back(), segments.front());
    } else {
      add_beginning(segments.front());
      Segment back = segment(last, segments.back().start);
      add_beginning(back);
    }
    for (std::size_t i = 0; i + 1 < segments.size(); ++i)
      add_joint(segments[i], segments[i + 1]);
  }

  bool are_same_place(const Surface_point& p, const Surface_point& q) const
  {
    if (p.dimension() != q.dimension())
      return false;
    if (p.dimension() == 0)
      return Cut_faces::vertex_at(input_, p) == Cut_faces::vertex_at(input_, q);
    try {
      const Coordinates c = coordinates_in_face_of(input_, p.halfedge, q);
      return c == p.coordinates;
    } catch (const Invalid_point_error&) {
      return false;
    }
  }

  // The corners of an input face in the plane, from the source of the halfedge on.
  std::array<Vector, 3> corners(Halfedge_index h) const
  {
    std::array<double, 3> lengths;
    std::size_t longest = 0;
    Halfedge_index g = h;
    for (std::size_t i = 0; i < 3; ++i, g = input_.next(g)) {
      lengths[i] =
        std::sqrt((std::max)(0., engine_.metric().squared_length_double_double(input_, input_.edge(g)).hi()));
      if (lengths[i] > lengths[longest])
        longest = i;
    }
    const double a = lengths[longest], b = lengths[(longest + 1) % 3] / a, c = lengths[(longest + 2) % 3] / a,
                 x = ((c - b) * (c + b) + 1) / 2,
                 height = std::sqrt((std::max)(0., squared_four_areas_from_lengths(1., b, c))) / 2;
    std::array<Vector, 3> result;
    result[longest] = {0, 0};
    result[(longest + 1) % 3] = {a, 0};
    result[(longest + 2) % 3] = {a * x, a * height};
    return result;
  }

  static Vector position(const std::array<Vector, 3>& corners, const Coordinates& c)
  {
    return {c[0] * corners[0][0] + c[1] * corners[1][0] + c[2] * corners[2][0],
            c[0] * corners[0][1] + c[1] * corners[1][1] + c[2] * corners[2][1]};
  }

  // The distance of two points, in the unit of the input.
  double length(const Surface_point& p, const Surface_point& q) const
  {
    const auto& points = engine_.metric().points();
    double result;
    if (points.empty()) {
      const std::array<Vector, 3> c = corners(p.halfedge);
      const Vector way = plane::difference(position(c, q.coordinates), position(c, p.coordinates));
      result = std::hypot(way[0], way[1]);
    } else {
      std::array<double, 3> way{0, 0, 0};
      Halfedge_index h = p.halfedge;
      for (std::size_t i = 0; i < 3; ++i, h = input_.next(h))
        for (std::size_t k = 0; k < 3; ++k)
          way[k] += (q.coordinates[i] - p.coordinates[i]) * points[input_.source(h).idx()][k];
      result = std::hypot(way[0], way[1], way[2]);
    }
    return std::ldexp(result, engine_.metric().unit_exponent());
  }

  Segment segment(const Surface_point& start, const Surface_point& end) const
  {
    Segment result;
    result.start = start;
    result.end = end;
    const std::array<Vector, 3> c = corners(start.halfedge);
    result.direction = plane::unit(plane::difference(position(c, end.coordinates), position(c, start.coordinates)));
    if (const Halfedge_index kept = kept_side(start.halfedge); kept.is_valid()) {
      result.located = {kept, start.coordinates};
      result.pieces = {piece_in_kept_face(result.located, end.coordinates)};
      if (result.pieces.front().length > 0)
        return result;
      result.pieces.clear();
    }
    const Surface_direction onward = direction(start, end.coordinates);
    // Goes to the end of the first face, because the direction of a short piece would be rounded; if that end is near,
    // the longest piece gives the direction.
    const double whole = length(start, end), long_way = std::ldexp(1, 30) * whole;
    const std::vector<Surface_point> into = trace_in_triangulation(engine_, onward, long_way, 1).points;
    result.located = into.front();
    Face_source first = piece(into, 0, true);
    const double way = std::ldexp(whole, -faces_.exponent());
    if (way <= first.length) {
      first.length = way;
      result.pieces.push_back(first);
      return result;
    }
    const std::vector<Surface_point> points =
      trace_in_triangulation(engine_, onward, whole, (std::numeric_limits<std::size_t>::max)()).points;
    std::size_t longest = 0;
    double most = first.length;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      result.pieces.push_back(piece(points, i, i + 2 < points.size()));
      if (result.pieces.back().length > most) {
        most = result.pieces.back().length;
        longest = i;
      }
    }
    if (longest == 0)
      result.pieces.front().direction = first.direction;
    // The line goes straight on over sides.
    for (std::size_t i = longest + 1; i < result.pieces.size(); ++i)
      if (points[i].dimension() == 1)
        result.pieces[i].direction = plane::turned(result.pieces[i - 1].direction, turn(result.pieces, points, i));
    for (std::size_t i = longest; i > 0; --i)
      if (points[i].dimension() == 1)
        result.pieces[i - 1].direction = plane::turned(result.pieces[i].direction, -turn(result.pieces, points, i));
    return result;
  }

  // The halfedge of the triangulation along one of the input, if its face was not changed; otherwise invalid.
  Halfedge_index kept_side(Halfedge_index of_input) const
  {
    const Correspondence& correspondence = engine_.correspondence();
    const auto is_along = [&](Halfedge_index h, Halfedge_index k) {
      return crossings(correspondence, complex_.edge(h)) < 0 && !correspondence.is_inserted(complex_.source(h)) &&
             !correspondence.is_inserted(complex_.target(h)) && correspondence.input_halfedge(h) == k;
    };
    Halfedge_index h = piece_at_source(complex_, correspondence, of_input).side;
    for (std::size_t i = 0; i < 3; ++i, h = complex_.next(h))
      if (is_along(h, of_input) && is_along(complex_.next(h), input_.next(of_input)) &&
          is_along(complex_.prev(h), input_.prev(of_input)))
        return h;
    return {};
  }

  Face_source piece_in_kept_face(const Surface_point& start, const Coordinates& end) const
  {
    Face_source result = piece({start}, 0, false);
    const Laid_out_faces::Side& base = faces_.side(result.side);
    const double second = end[1] - start.coordinates[1], third = end[2] - start.coordinates[2];
    const Vector way{second * base.length + third * base.apex_x, third * base.apex_y};
    result.length = std::hypot(way[0], way[1]);
    result.direction = {way[0] / result.length, way[1] / result.length};
    return result;
  }

  // The turn from the piece before a point on a side to the piece after it, each in its own face.
  double turn(const std::vector<Face_source>& pieces, const std::vector<Surface_point>& points, std::size_t i) const
  {
    const Halfedge_index on = side_of(complex_, points[i]);
    return plane::angle_between(along(pieces[i - 1].side, complex_.opposite(on)), along(pieces[i].side, on)) - CGAL_PI;
  }

  // A side of a face relative to another one.
  Vector along(std::uint32_t base, Halfedge_index side) const
  {
    const Laid_out_faces::Side& s = faces_.side(base);
    const std::array<Vector, 3> corner{Vector{0, 0}, Vector{s.length, 0}, Vector{s.apex_x, s.apex_y}};
    std::size_t i = 0;
    for (std::uint32_t k = base; i < 2 && faces_.halfedge(k) != side; k = Laid_out_faces::next(k))
      ++i;
    return plane::difference(corner[(i + 1) % 3], corner[i]);
  }

  std::uint32_t side(Halfedge_index h) const
  {
    const std::uint32_t first = 3 * std::uint32_t(complex_.face(h).idx());
    return faces_.halfedge(first) == h ? first : faces_.halfedge(first + 1) == h ? first + 1 : first + 2;
  }

  Vector place(std::uint32_t s, const Coordinates& c) const
  {
    const Laid_out_faces::Side& base = faces_.side(s);
    return {c[1] * base.length + c[2] * base.apex_x, c[2] * base.apex_y};
  }

  // \param leaves whether the line crosses the side where the piece ends: then that point is given in the face beyond,
  // which may be the same one
  Face_source piece(const std::vector<Surface_point>& points, std::size_t i, bool leaves) const
  {
    Face_source result;
    result.side = side(points[i].halfedge);
    result.from = place(result.side, points[i].coordinates);
    if (i + 1 < points.size()) {
      Surface_point end = points[i + 1];
      if (leaves && end.dimension() == 1)
        if (const Halfedge_index h = complex_.opposite(side_of(complex_, end));
            !complex_.is_border(h) && complex_.face(h) == complex_.face(points[i].halfedge)) {
          const auto [a, b] = coordinates_on_edge(complex_, end, h);
          end = {h, {a, b, 0}};
        }
      const Vector way =
        plane::difference(place(result.side, coordinates_in_face_of(complex_, points[i].halfedge, end)), result.from);
      result.length = std::hypot(way[0], way[1]);
      if (result.length > 0)
        result.direction = {way[0] / result.length, way[1] / result.length};
    }
    result.offset = offset_;
    result.number = number_;
    return result;
  }

  void add_pieces(const Segment& s)
  {
    result_.in_faces.insert(result_.in_faces.end(), s.pieces.begin(), s.pieces.end());
  }

  Source_at_row& at_row(std::uint32_t row)
  {
    const auto [it, is_new] = rows_.insert({row, {}});
    Row_source& source = it->second.at_row;
    if (is_new || offset_ < source.offset) {
      it->second = Source_at_row();
      source.row = row;
      source.offset = offset_;
      source.number = number_;
    }
    return it->second;
  }

  void add_point(const Surface_point& p)
  {
    if (p.dimension() == 0) {
      at_row(row_of_[Cut_faces::vertex_at(input_, p).idx()]).is_isolated = true;
      return;
    }
    if (const Halfedge_index kept = kept_side(p.halfedge); kept.is_valid())
      return add_place({kept, p.coordinates}, {});
    // Traces a line of length 0 toward a corner, which locates the point.
    Coordinates corner{0, 0, 0};
    corner[largest(p.coordinates)] = 1;
    add_place(trace_in_triangulation(engine_, direction(p, corner), 0, 1).points.front(), {});
  }

  // Adds ways from a point that is not a vertex, or is an inserted one. A point as near to a side as rounding errors
  // counts as on it: otherwise the directions of ways that leave through that side would be lost.
  void add_place(Surface_point located, const std::vector<Vector>& limits)
  {
    for (double& x : located.coordinates)
      x = x < 0x1p-45 ? 0 : x;
    if (located.dimension() == 0) {
      at_row(row_of_[Cut_faces::vertex_at(complex_, located).idx()]).is_isolated = true;
      return;
    }
    Face_source source = piece({located}, 0, false);
    source.limits = limits;
    if (located.dimension() == 1) {
      // Relative to the side on which it lies.
      const Halfedge_index on = side_of(complex_, located);
      const double angle = plane::angle_between(along(source.side, on), {1, 0});
      for (Vector& limit : source.limits)
        limit = plane::turned(limit, angle);
      source.side = side(on);
      const auto [a, b] = coordinates_on_edge(complex_, located, on);
      source.from = {b / (a + b) * faces_.side(source.side).length, 0};
      source.is_on_side = true;
      const std::uint32_t opposite = faces_.side(source.side).opposite;
      if (!source.limits.empty() && opposite != Laid_out_faces::none) {
        Face_source beyond = source;
        beyond.side = opposite;
        beyond.from = {faces_.side(opposite).length - source.from[0], 0};
        for (Vector& limit : beyond.limits)
          limit = plane::reverse(limit);
        result_.in_faces.push_back(beyond);
      }
    }
    result_.in_faces.push_back(source);
  }

  // The beginning of a curve: ways into the half plane behind it, or around a vertex.
  void add_beginning(const Segment& s)
  {
    if (s.start.dimension() == 0)
      add_at_vertex(s);
    else
      add_place(s.located, {plane::reverse(s.pieces.front().direction)});
  }

  void add_at_vertex(const Segment& s)
  {
    const Face_source first = s.pieces.front();
    const Coordinates& c = s.located.coordinates;
    const std::size_t i = largest(c);
    std::uint32_t at = first.side;
    for (std::size_t k = 0; k < i; ++k)
      at = Laid_out_faces::next(at);
    const double angle = plane::angle_between(along(first.side, faces_.halfedge(at)), first.direction);
    Row_source& source = at_row(faces_.side(at).row).at_row;
    if (source.offset == offset_) // the fronts of a farther source cover nothing of a nearer one
      source.segments.push_back({at, (std::min)((std::max)(angle, 0.), faces_.side(at).angle)});
  }

  // Between two segments: ways into the wedge that no front covers.
  void add_joint(const Segment& before, const Segment& behind)
  {
    if (behind.start.dimension() == 0) {
      add_at_vertex(behind);
      add_at_vertex(segment(before.end, before.start));
      return;
    }
    const double turn = angle_of_turn(before, behind);
    if (std::abs(turn) < 1e-9)
      return;
    const Vector& direction = behind.pieces.front().direction;
    add_place(behind.located, {plane::turned(direction, -turn), plane::reverse(direction)});
  }

  double angle_of_turn(const Segment& before, const Segment& behind) const
  {
    const Halfedge_index g = before.start.halfedge, h = behind.start.halfedge;
    Vector onward = before.direction, direction = behind.direction;
    if (input_.face(g) != input_.face(h)) { // across the edge on which the joint lies, seen from both faces
      const Halfedge_index side = side_of(input_, before.end), beyond = input_.opposite(side);
      onward = plane::turned(onward, -angle_of_side(g, side));
      direction = plane::turned(direction, CGAL_PI - angle_of_side(h, beyond));
    } else if (g != h) {
      direction = plane::turned(direction, angle_of_side(g, h) - angle_of_side(h, h));
    }
    return plane::angle_between(onward, direction);
  }

  // The angle of a side of the face of h, in the plane of corners(h).
  double angle_of_side(Halfedge_index h, Halfedge_index side) const
  {
    const std::array<Vector, 3> c = corners(h);
    for (std::size_t i = 0; i < 3; ++i, h = input_.next(h))
      if (h == side)
        return plane::angle_between({1, 0}, plane::difference(c[(i + 1) % 3], c[i]));
    throw Invalid_point_error("two consecutive points of a curve do not lie in the face of the first, face " +
                              std::to_string(input_.face(h).idx()));
  }

  const Exact_engine& engine_;
  const Delta_complex &input_, &complex_;
  const Laid_out_faces& faces_;
  std::vector<std::uint32_t> row_of_; // of the vertices with faces
  std::map<std::uint32_t, Source_at_row> rows_;
  Window_sources result_;
  std::uint32_t number_ = 0;
  double offset_ = 0;
};

} // namespace

Window_sources sources_in_faces(const Exact_engine& engine, const Delta_complex& complex, const Laid_out_faces& faces,
                                const std::vector<Geodesic_source>& sources)
{
  return Curve_sources_builder(engine, complex, faces).build(sources);
}

} // namespace CGAL::Intrinsic_triangulations::internal
