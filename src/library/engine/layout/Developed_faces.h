// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Faces laid out in the plane once, and carried along by flips.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include "../../arithmetic/Disk.h"
#include "../../arithmetic/Planar_vector.h"
#include "../../arithmetic/Residues.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The corner opposite to a halfedge in both forms, one of which may be unknown.
struct Known_corner
{
  Halfedge_index side;
  Triangle_corner<Bounded_double_double> corner;
  std::optional<Triangle_corner<Residues>> image;
};

// Laying out a face over the input costs time proportional to the crossings of its edges. If many tests are close, as
// in the caps of a prism or along the folds of a pillow, strips of thousands of triangles would be laid out again and
// again. So a face that was laid out is kept, as the positions of its corners in some plane. If both faces of a flip
// lie in one plane, side by side, there is nothing to compute: a flip moves no vertex. Otherwise the smaller plane is
// moved to the other one: its points have true positions in which each of its faces is congruent to the true one, so
// one motion moves them all. So most flips change two numbers, and corners are moved seldom, while each flip would
// multiply errors of lengths.
//
// Only faces of close calls, and faces that flips make of them, are kept. Besides the positions, their images in finite
// fields can be carried along: these have no errors at all, and reveal ties at once.
class Developed_faces
{
  using Real = Bounded_double_double;
  using Vector = Double_double_disk;
  using Corner = Triangle_corner<Real>;
  using Image = Planar_vector<Residues>;
  using Image_corner = Triangle_corner<Residues>;

  // A corner that was laid out. Two faces that share both points of an edge need not be brought together.
  struct Point
  {
    Vector position;
    std::uint32_t plane;
    std::uint32_t copy; // in the plane to which it was last moved, if that was after the last compaction
    std::unique_ptr<const Image> image; // seldom known, and large
  };
  struct Plane
  {
    std::uint32_t size;                   // the number of points
    std::unique_ptr<const Residues> unit; // the squared length that is 1 in the images, if these are known
  };
  // The numbers of the points at the source, the target and opposite to a halfedge.
  using Triangle = std::array<std::uint32_t, 3>;

public:
  // Whether the face of h is kept.
  bool contains(Halfedge_index h) const { return !sources_.empty() && source(h) != none; }

  // The corner opposite to h, with half of the digits if that suffices. \pre contains(h)
  Corner corner(const Delta_complex& complex, Halfedge_index h, bool in_doubles = false) const
  {
    const auto [i, j, k] = triangle(complex, h);
    const Vector &p = points_[i].position, &q = points_[j].position, &r = points_[k].position;
    return in_doubles ? corner_in_doubles(p, q, r) : corner(p, q, r);
  }

  // The image of that corner, if it is known. \pre contains(h)
  std::optional<Image_corner> image_of_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    const Triangle t = triangle(complex, h);
    if (!points_[t[0]].image || !points_[t[1]].image || !points_[t[2]].image)
      return std::nullopt;
    const Image &i = *points_[t[0]].image, &j = *points_[t[1]].image, &k = *points_[t[2]].image;
    const Image u = i - k, w = j - k, z = times_conjugate(w, u);
    const Residues &unit = *planes_[points_[t[0]].plane].unit, two_units = unit + unit;
    return Image_corner{two_units * z.x(), two_units * z.y(), unit * squared_norm(u), unit * squared_norm(w),
                        unit * squared_norm(j - i)};
  }

  // Keeps a face of which a corner is known, unless its error is too large.
  void insert(const Delta_complex& complex, const Known_corner& c)
  {
    if (const std::optional<Triangle> t = laid_out(c))
      keep(complex, c.side, *t);
  }

  // Must be called before the flip of the connectivity. Follows it if both faces lie in one plane, side by side: then
  // there is nothing to compute. Returns whether they do.
  bool flip_in_plane(const Hinge_halfedges& around)
  {
    if (!contains(around.ij) || source(around.ij) != source(around.il) || source(around.ji) != source(around.jk))
      return false;
    // After the flip ij leads from l to k (see Delta_complex::flip()).
    source(around.ij) = source(around.lj);
    source(around.ji) = source(around.ki);
    return true;
  }
  // Likewise if they do not: brings them together if possible. lay_out(h) gives a corner of the face of h, or none if
  // that is not worth its cost. If this fails, and after an exception, the two faces are forgotten.
  template <class LayOut>
  void flip(const Delta_complex& complex, const Hinge_halfedges& around, const LayOut& lay_out)
  {
    // Repeated flips may take the place of all faces while one is laid out.
    const auto find = [&](Halfedge_index h) {
      if (!contains(h))
        if (const std::optional<Known_corner> c = lay_out(h))
          contains(complex.opposite(h)) ? insert_beside(complex, h, *c) : insert(complex, *c);
      return contains(h);
    };
    const auto size_of_plane = [&](Halfedge_index h) { return planes_[points_[source(h)].plane].size; };
    const auto forget_both = [&] {
      forget(complex, around.ij);
      forget(complex, around.ji);
    };
    try {
      if (!find(around.ij) || !find(around.ji) || !find(around.ij))
        return forget_both();
      if (!flip_in_plane(around)) {
        if (!join(complex, size_of_plane(around.ij) <= size_of_plane(around.ji) ? around.ij : around.ji))
          return forget_both();
        flip_in_plane(around);
      }
      if (points_.size() > 2 * most_points_)
        compact();
    } catch (...) {
      forget_both();
      throw;
    }
  }

  // A face that will be split by a vertex inside of it.
  struct Whole
  {
    std::array<Halfedge_index, 3> sides;
    Triangle corners;
  };
  // To be called before the split. \pre contains(h)
  Whole whole(const Delta_complex& complex, Halfedge_index h) const
  {
    return {{h, complex.next(h), complex.prev(h)}, triangle(complex, h)};
  }
  // Keeps its three parts, given a corner, the one at the new vertex in one of them; not if errors have become too
  // large.
  void keep_parts(const Delta_complex& complex, const Whole& whole, const Known_corner& c)
  {
    const std::optional<Triangle> part = laid_out(c);
    const std::size_t turn = c.side == whole.sides[0] ? 0 : c.side == whole.sides[1] ? 1 : 2;
    const std::uint32_t i = whole.corners[turn], j = whole.corners[(turn + 1) % 3];
    const std::uint32_t v = part ? moved((*part)[2], motion({(*part)[0], (*part)[1]}, {i, j}), i) : none;
    for (std::size_t n = 0; v != none && n < 3; ++n)
      keep(complex, whole.sides[n], {whole.corners[n], whole.corners[(n + 1) % 3], v});
  }

  // Forgets the face of h, whose data is no longer valid. Never throws.
  void forget(const Delta_complex& complex, Halfedge_index h)
  {
    if (!sources_.empty()) // some sides of a flip that was not followed may be known
      for (Halfedge_index side : {h, complex.next(h), complex.prev(h)})
        source(side) = none;
  }
  // Makes room for this many more edges, ...
  void make_room(std::size_t number)
  {
    if (!sources_.empty())
      internal::make_room(sources_, number);
  }
  // ... and appends them.
  void append(std::size_t number)
  {
    if (!sources_.empty())
      sources_.resize(sources_.size() + number, {none, none});
  }
  template <class Edges>
  void remove(const Edges& edges)
  {
    if (!sources_.empty())
      remove_entries(sources_, edges);
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  // Relative to the edges. Beyond this, it is better to lay the face out anew: doubles leave open what is below 2^-53.
  static constexpr double largest_radius = 0x1p-61;

  std::uint32_t source(Halfedge_index h) const { return sources_[h.idx() >> 1][h.idx() & 1]; }
  std::uint32_t& source(Halfedge_index h) { return sources_[h.idx() >> 1][h.idx() & 1]; }
  Triangle triangle(const Delta_complex& complex, Halfedge_index h) const
  {
    return {source(h), source(complex.next(h)), source(complex.prev(h))};
  }
  void keep(const Delta_complex& complex, Halfedge_index h, const Triangle& t)
  {
    if (sources_.empty())
      sources_.resize(complex.number_of_edges(), {none, none});
    source(h) = t[0];
    source(complex.next(h)) = t[1];
    source(complex.prev(h)) = t[2];
  }

  static Corner corner(const Vector& i, const Vector& j, const Vector& k)
  {
    const Vector u = i - k, w = j - k, z = times_conjugate(w, u);
    return {z.x().scaled(2), z.y().scaled(2), squared_norm(u), squared_norm(w), squared_norm(j - i)};
  }

  // The same corner in a fraction of the time. With u = 2^-53, a difference of positions is right up to 1.01 u of
  // itself and the radii of both. So for sides of lengths m and n, the scalar and cross products are wrong by at most
  // 2.03 u m n for the differences, 2.01 u m n for the rounding of two products and their sum, and R (m + n + R) for
  // the radii, which sum to R; what is left of 4.1 u and 1.01 R covers products of errors, and the rounding of the
  // bound.
  static Corner corner_in_doubles(const Vector& i, const Vector& j, const Vector& k)
  {
    const Two_doubles u = rounded_difference(i, k), w = rounded_difference(j, k), v = rounded_difference(j, i);
    const Two_doubles uu = u * u, ww = w * w, vv = v * v, along = u * w, across = w * swapped(u);
    const Two_doubles squares = firsts(uu, ww) + seconds(uu, ww);
    const double square = vv.first() + vv.second(), radii = i.radius() + j.radius() + k.radius();
    const Two_doubles lengths = length_of(squares);
    const double first = lengths.first(), second = lengths.second(), opposite = length_of(square);
    const auto product = [&](double x, double m, double n) {
      return Real(x, 0, 4.1 * 0x1p-53 * m * n + 1.01 * radii * (m + n + radii) + 1e-300);
    };
    return {product(along.first() + along.second(), first, second).scaled(2),
            product(across.second() - across.first(), first, second).scaled(2), product(squares.first(), first, first),
            product(squares.second(), second, second), product(square, opposite, opposite)};
  }
  // An upper bound, also where the square underflows.
  template <class Number>
  static Number length_of(const Number& square)
  {
    return rounded_sqrt(square) * Number(1 + 0x1p-45) + Number(1e-150);
  }

  // Rounded up.
  static double distance(const Vector& p, const Vector& q)
  {
    const Two_doubles v = rounded_difference(p, q), squares = v * v;
    return length_of(squares.first() + squares.second());
  }
  static bool is_accurate(const Vector& position, const Vector& other)
  {
    return position.radius() < largest_radius * distance(position, other);
  }

  std::uint32_t add_point(const Vector& position, std::uint32_t plane, std::unique_ptr<const Image> image)
  {
    points_.push_back({position, plane, 0, std::move(image)});
    ++planes_[plane].size;
    return std::uint32_t(points_.size() - 1);
  }

  // Relative to its side ij, in a plane of its own: the origin is the opposite corner k, and ki runs along the first
  // axis. In the images ki is the unit. None if the error would be too large.
  std::optional<Triangle> laid_out(const Known_corner& known)
  {
    const Corner& c = known.corner;
    const Real length = sqrt(c.s_first);
    const Vector j = Vector(c.p, c.four_areas) / length.scaled(2);
    if (!(j.radius() < largest_radius * j.modulus()))
      return std::nullopt;
    std::unique_ptr<const Image> image_of_i, image_of_j, image_of_k;
    std::unique_ptr<const Residues> unit;
    if (known.image) {
      const Image_corner& x = *known.image;
      const Residues zero = x.p - x.p, two_s_image = x.s_first + x.s_first;
      unit = std::make_unique<const Residues>(x.s_first);
      image_of_i = std::make_unique<const Image>(two_s_image / two_s_image, zero);
      image_of_j = std::make_unique<const Image>(Image(x.p, x.four_areas) / two_s_image);
      image_of_k = std::make_unique<const Image>(zero, zero);
    }
    planes_.push_back({0, std::move(unit)});
    const auto plane = std::uint32_t(planes_.size() - 1);
    return Triangle{add_point(Vector(length, Real(0)), plane, std::move(image_of_i)),
                    add_point(j, plane, std::move(image_of_j)),
                    add_point(Vector(Real(0), Real(0)), plane, std::move(image_of_k))};
  }

  // Keeps the face of h, of which a corner is known, beside the face beyond h, unless its error is too large.
  void insert_beside(const Delta_complex& complex, Halfedge_index h, Known_corner c)
  {
    const auto turn = [](auto& x) {
      x = {x.s_first + x.s_first - x.p, x.four_areas, x.s_opposite, x.s_first, x.s_second};
    };
    for (; c.side != h; c.side = complex.next(c.side)) {
      turn(c.corner);
      if (c.image)
        turn(*c.image);
    }
    const Halfedge_index beyond = complex.opposite(h);
    const std::uint32_t i = source(complex.next(beyond)), j = source(beyond);
    const bool is_from_j = c.corner.s_second.hi() < c.corner.s_first.hi(); // from the nearer end of ij
    const std::uint32_t end = is_from_j ? j : i;
    const auto from_end = [&](const auto& x, const auto& p, const auto& q) {
      using Position = std::decay_t<decltype(p)>;
      const auto along = is_from_j ? x.p - x.s_second - x.s_second : x.s_first + x.s_first - x.p;
      return Position(along, x.four_areas) / (x.s_opposite + x.s_opposite) * (q - p);
    };
    const Vector position = points_[end].position + from_end(c.corner, points_[i].position, points_[j].position);
    if (!is_accurate(position, points_[end].position))
      return;
    std::unique_ptr<const Image> image;
    if (c.image && points_[i].image && points_[j].image)
      image =
        std::make_unique<const Image>(*points_[end].image + from_end(*c.image, *points_[i].image, *points_[j].image));
    keep(complex, h, {i, j, add_point(position, points_[end].plane, std::move(image))});
  }

  // The motion that takes an edge, and its whole plane, to an edge of the same length in another plane.
  struct Motion
  {
    std::array<std::uint32_t, 2> from, to;
    Vector turn;
    std::optional<Image> turn_of_images;
  };
  Motion motion(std::array<std::uint32_t, 2> from, std::array<std::uint32_t, 2> to) const
  {
    const auto turn = [&](const auto& get) {
      const auto edge = *get(from[1]) - *get(from[0]);
      return times_conjugate(*get(to[1]) - *get(to[0]), edge) / squared_norm(edge);
    };
    const auto image = [&](std::uint32_t point) { return points_[point].image.get(); };
    Motion result{from, to, turn([&](std::uint32_t point) { return &points_[point].position; }), {}};
    if (image(from[0]) && image(from[1]) && image(to[0]) && image(to[1]))
      result.turn_of_images = turn(image);
    return result;
  }
  // A moved point; none if the error would be too large relative to the distance from another one.
  std::uint32_t moved(std::uint32_t point, const Motion& m, std::uint32_t other)
  {
    // From the nearer end of the edge, so that the error of the rotation moves it less.
    const Vector& old = points_[point].position;
    const auto end_of_edge = [&](std::size_t end) -> const Vector& { return points_[m.from[end]].position; };
    const std::size_t end = distance(old, end_of_edge(1)) < distance(old, end_of_edge(0)) ? 1 : 0;
    const Vector position = points_[m.to[end]].position + (old - end_of_edge(end)) * m.turn;
    if (!is_accurate(position, points_[other].position))
      return none;
    std::unique_ptr<const Image> image;
    if (m.turn_of_images && points_[point].image)
      image = std::make_unique<const Image>(*points_[m.to[end]].image +
                                            (*points_[point].image - *points_[m.from[end]].image) * *m.turn_of_images);
    return points_[point].copy = add_point(position, points_[m.to[0]].plane, std::move(image));
  }

  // Moves the face of h into the plane of the face beyond h, next to it, together with its adjacent faces in its plane,
  // as far as their errors allow. Returns whether it was moved itself.
  bool join(const Delta_complex& complex, Halfedge_index h)
  {
    const Halfedge_index beyond = complex.opposite(h);
    const std::uint32_t plane = points_[source(h)].plane, i = source(complex.next(beyond)), j = source(beyond);
    const std::array<std::uint32_t, 2> from{source(h), source(complex.next(h))};
    const Motion m = motion(from, {i, j});
    const std::size_t first_copy = points_.size();
    const auto copy = [&](std::uint32_t point) {
      return point == from[0]                   ? i
             : point == from[1]                 ? j
             : points_[point].copy < first_copy ? none
                                                : points_[point].copy;
    };
    const bool is_alone = points_[i].plane == plane;
    boost::container::small_vector<Halfedge_index, 16> sides{h};
    while (!sides.empty()) {
      const Halfedge_index side = sides.back();
      sides.pop_back();
      const Triangle t = triangle(complex, side);
      if (points_[t[0]].plane != plane) // it was moved before
        continue;
      std::uint32_t apex = copy(t[2]);
      if (apex == none && (apex = moved(t[2], m, copy(t[0]))) == none)
        continue;
      for (Halfedge_index g : {complex.opposite(complex.next(side)), complex.opposite(complex.prev(side))})
        if (!is_alone && contains(g) && source(g) == source(complex.next(complex.opposite(g))) &&
            source(complex.next(g)) == source(complex.opposite(g)))
          sides.push_back(g);
      keep(complex, side, {copy(t[0]), copy(t[1]), apex});
    }
    return source(h) == i && source(complex.next(h)) == j;
  }

  // Removes unused points and planes. The others keep their order.
  void compact()
  {
    std::vector<std::uint32_t> new_point(points_.size(), none), new_plane(planes_.size(), none);
    for (const Ends& ends : sources_)
      for (std::uint32_t point : ends)
        if (point != none)
          new_point[point] = new_plane[points_[point].plane] = 0;
    move_up(points_, new_point);
    move_up(planes_, new_plane);
    for (Plane& plane : planes_)
      plane.size = 0;
    for (Point& point : points_) {
      ++planes_[point.plane = new_plane[point.plane]].size;
      point.copy = 0;
    }
    for (Ends& ends : sources_)
      for (std::uint32_t& point : ends)
        if (point != none)
          point = new_point[point];
    most_points_ = (std::max)(points_.size(), most_points_at_first + sources_.size() / 4);
  }

  template <class Element>
  static void move_up(std::vector<Element>& elements, std::vector<std::uint32_t>& new_number)
  {
    std::uint32_t n = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (new_number[i] != none) {
        elements[n] = std::move(elements[i]);
        new_number[i] = n++;
      }
    elements.erase(elements.begin() + n, elements.end());
  }

  static constexpr std::size_t most_points_at_first = 1024;

  // For both halfedges of an edge, the source as a point of the face, or none. Empty at first.
  using Ends = std::array<std::uint32_t, 2>;
  Large_vector<Ends> sources_;
  std::vector<Point> points_;
  std::vector<Plane> planes_;
  std::size_t most_points_ = most_points_at_first; // after the last compaction
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H
