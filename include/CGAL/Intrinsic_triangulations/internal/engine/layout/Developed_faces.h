// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Faces laid out in the plane once, and carried along by the flips.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Residues.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The corner opposite to a halfedge in both forms, one of which is not always known.
template <class Corner, class Image_corner>
struct Known_corner
{
  Halfedge_index side;
  Corner corner;
  std::optional<Image_corner> image;
};

// To lay out a face over the input costs as much as its edges cross input edges. Where tests
// are close for long, as in the caps of a prism or along the folds of a pillow, that would be
// done again and again for strips of thousands of triangles. So a face that was laid out is
// kept, as the positions of its corners in some plane, and a flip carries the corner of one
// face over into the plane of the other. If both lie in the same plane there is nothing to
// compute: a flip moves no vertex. Thus errors add up with the number of planes that a corner
// is carried through, while errors of lengths would be multiplied by each flip.
//
// Only faces of close calls, and those that flips make of them, are kept. Beside the positions, their images
// in finite fields can be carried along: these have no errors at all, and tell ties at once.
//
// \tparam Real, Vector numbers with error bounds, and complex ones
// \tparam Corner, Image_corner as `Unfolding::Corner`, of `Real` and of `Residues`
template <class Real, class Vector, class Corner, class Image_corner>
class Developed_faces
{
  using Image = Planar_vector<Residues>;

  // A corner that was laid out. Two faces that share both points of an edge need not be brought together.
  struct Point
  {
    Vector position;
    std::unique_ptr<const Image> image; // seldom known, and large
  };
  struct Plane
  {
    Real unit; // squared length
    std::unique_ptr<const Residues> image_of_unit;
  };
  // The plane, and the points at the source, the target and opposite to a halfedge.
  struct Layout
  {
    Halfedge_index first;
    std::uint32_t plane;
    std::array<std::uint32_t, 3> corners;
  };

public:
  using Known_corner = internal::Known_corner<Corner, Image_corner>;

  bool contains(Face_index f) const { return !layout_of_.empty() && layout_of_[f.idx()] != none; }

  // The corner opposite to h. \pre contains(complex.face(h))
  Corner corner(const Delta_complex& complex, Halfedge_index h) const
  {
    const Layout layout = seen_from(complex, h);
    return corner<Corner>(planes_[layout.plane].unit, point(layout, 0).position, point(layout, 1).position,
                          point(layout, 2).position);
  }

  // The image of that corner, if it is known. \pre contains(complex.face(h))
  std::optional<Image_corner> image_of_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    const Layout layout = seen_from(complex, h);
    if (!has_images(layout))
      return std::nullopt;
    return corner<Image_corner>(*planes_[layout.plane].image_of_unit, *point(layout, 0).image, *point(layout, 1).image,
                                *point(layout, 2).image);
  }

  // Keeps a face of which a corner is known.
  void insert(const Delta_complex& complex, const Known_corner& c)
  {
    const std::optional<Layout> layout = laid_out(c);
    if (layout)
      keep(complex, complex.face(c.side), *layout);
  }

  // To be called before the flip of the connectivity. lay_out(h) gives a corner of the face of h, or none if that is
  // not worth its price; where errors have become too large, so many faces are laid out anew. After an exception,
  // nothing is known of the two faces.
  template <class LayOut>
  void flip(const Delta_complex& complex, const Hinge_halfedges& around, int number_of_retries, const LayOut& lay_out)
  {
    const Face_index ijk = complex.face(around.ij), jil = complex.face(around.ji);
    try {
      if (!follow(complex, around, number_of_retries, lay_out)) {
        forget(ijk);
        forget(jil);
      }
    } catch (...) {
      forget(ijk);
      forget(jil);
      throw;
    }
  }

  // A face that will be split by a vertex inside of it.
  struct Whole
  {
    Layout layout;
    std::array<Halfedge_index, 3> sides;
  };
  // To be called before the split. \pre contains(f)
  Whole whole(const Delta_complex& complex, Face_index f) const
  {
    const Layout& kept = layouts_[layout_of_[f.idx()]];
    return {kept, {kept.first, complex.next(kept.first), complex.prev(kept.first)}};
  }
  // Keeps its three parts, of which a corner is known, that at the new vertex in one of them. Returns whether that was
  // done: not where errors have become too large.
  bool keep_parts(const Delta_complex& complex, const Whole& whole, const Known_corner& c)
  {
    const std::optional<Layout> part = laid_out(c);
    if (!part)
      return false;
    const std::size_t turn = c.side == whole.sides[0] ? 0 : c.side == whole.sides[1] ? 1 : 2;
    const auto& [i, j, k] = whole.layout.corners;
    const std::array<std::uint32_t, 5> corners{i, j, k, i, j};
    const std::optional<std::uint32_t> v =
      moved_apex(*part, {c.side, whole.layout.plane, {corners[turn], corners[turn + 1], corners[turn + 2]}});
    if (!v)
      return false;
    for (std::size_t n = 0; n < 3; ++n)
      keep(complex, complex.face(whole.sides[n]),
           Layout{whole.sides[n], whole.layout.plane, {corners[n], corners[n + 1], *v}});
    return true;
  }

  // What is known of a face is no longer true. Never throws.
  void forget(Face_index f)
  {
    if (!contains(f))
      return;
    const std::uint32_t position = std::exchange(layout_of_[f.idx()], none);
    layouts_[position].plane = first_free_;
    first_free_ = position;
  }
  // Makes room for so many faces more, ...
  void make_room(std::size_t number)
  {
    if (!layout_of_.empty())
      internal::make_room(layout_of_, number);
  }
  // ... and appends them.
  void append(std::size_t number)
  {
    if (!layout_of_.empty())
      layout_of_.resize(layout_of_.size() + number, none);
  }
  // Follows the removal of a vertex, after that of the connectivity. Layouts name halfedges, so those at edges that
  // have moved are no longer true. Never throws.
  void remove(const Delta_complex& complex, const Removed_elements& removed)
  {
    if (layout_of_.empty())
      return;
    for (Face_index f : removed.faces)
      forget(f);
    remove_entries(layout_of_, removed.faces);
    for (Edge_index e : removed.edges)
      if (e.idx() < complex.number_of_edges())
        for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
          if (!complex.is_border(h))
            forget(complex.face(h));
  }

private:
  template <class LayOut>
  bool follow(const Delta_complex& complex, const Hinge_halfedges& around, int number_of_retries, const LayOut& lay_out)
  {
    const auto lay_out_anew = [&](Halfedge_index h) -> std::optional<Layout> {
      const std::optional<Known_corner> c = lay_out(h);
      const std::optional<Layout> layout = c ? laid_out(*c) : std::nullopt;
      return layout ? std::make_optional(turned(complex, *layout, h)) : std::nullopt;
    };
    const auto find = [&](Halfedge_index h) {
      return contains(complex.face(h)) ? seen_from(complex, h) : lay_out_anew(h);
    };
    std::optional<Layout> above = find(around.ij), below = above ? find(around.ji) : std::nullopt;
    if (!above || !below)
      return false;
    // Where errors have become too large, the older plane has the larger ones.
    for (int number_of_trials = 0; !unite(*above, *below); ++number_of_trials) {
      if (number_of_trials == number_of_retries)
        return false;
      std::optional<Layout>& older = above->plane < below->plane ? above : below;
      older = lay_out_anew(older->first);
      if (!older)
        return false;
    }
    const auto [i, j, k] = above->corners;
    const std::uint32_t l = below->corners[2];
    // After the flip ij leads from l to k (see Delta_complex::flip()).
    keep(complex, complex.face(around.ij), Layout{around.ij, above->plane, {l, k, i}});
    keep(complex, complex.face(around.ji), Layout{around.ji, above->plane, {k, l, j}});
    if (points_.size() > 2 * most_points_)
      compact();
    return true;
  }

  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  // Beyond, it is better to lay the face out anew. Relative to the edges.
  static constexpr double largest_radius = 0x1p-65;

  template <class Result, class Number, class Complex>
  static Result corner(const Number& unit, const Complex& i, const Complex& j, const Complex& k)
  {
    const Complex u = i - k, w = j - k, z = times_conjugate(w, u);
    const Number two_units = unit + unit;
    return {two_units * z.x(), two_units * z.y(), unit * squared_norm(u), unit * squared_norm(w),
            unit * squared_norm(j - i)};
  }

  // A point of the current plane of a layout.
  const Point& point(const Layout& layout, int i) const { return points_[layout.corners[std::size_t(i)]]; }
  bool has_images(const Layout& layout) const
  {
    return planes_[layout.plane].image_of_unit && point(layout, 0).image && point(layout, 1).image &&
           point(layout, 2).image;
  }

  std::uint32_t add_point(const Vector& position, std::unique_ptr<const Image> image)
  {
    points_.push_back({position, std::move(image)});
    return std::uint32_t(points_.size() - 1);
  }

  // The origin is the corner k opposite to the side ij, and the unit is ki.
  std::optional<Layout> laid_out(const Known_corner& known)
  {
    const Corner& c = known.corner;
    const Real two_s = c.s_first.scaled(2);
    const Vector j(c.p / two_s, c.four_areas / two_s);
    if (!(j.radius() < largest_radius * j.modulus()))
      return std::nullopt;
    std::unique_ptr<const Image> image_of_i, image_of_j, image_of_k;
    std::unique_ptr<const Residues> image_of_unit;
    if (known.image) {
      const Image_corner& x = *known.image;
      const Residues zero = x.p - x.p, two_s_image = x.s_first + x.s_first;
      image_of_unit = std::make_unique<const Residues>(x.s_first);
      image_of_i = std::make_unique<const Image>(two_s_image / two_s_image, zero);
      image_of_j = std::make_unique<const Image>(x.p / two_s_image, x.four_areas / two_s_image);
      image_of_k = std::make_unique<const Image>(zero, zero);
    }
    planes_.push_back({c.s_first, std::move(image_of_unit)});
    return Layout{known.side,
                  std::uint32_t(planes_.size() - 1),
                  {add_point(Vector(Real(1), Real(0)), std::move(image_of_i)), add_point(j, std::move(image_of_j)),
                   add_point(Vector(Real(0), Real(0)), std::move(image_of_k))}};
  }

  Layout seen_from(const Delta_complex& complex, Halfedge_index h) const
  {
    return turned(complex, layouts_[layout_of_[complex.face(h).idx()]], h);
  }
  static Layout turned(const Delta_complex& complex, const Layout& kept, Halfedge_index h)
  {
    const std::size_t turn = h == kept.first ? 0 : h == complex.next(kept.first) ? 1 : 2;
    return {h, kept.plane, {kept.corners[turn], kept.corners[(turn + 1) % 3], kept.corners[(turn + 2) % 3]}};
  }

  // Brings two faces (i, j, k) and (j, i, l) into the older of their planes.
  bool unite(Layout& above, Layout& below)
  {
    if (above.corners[0] == below.corners[1] && above.corners[1] == below.corners[0])
      return true;
    Layout &stays = above.plane < below.plane ? above : below, &moves = above.plane < below.plane ? below : above;
    const auto& [i, j, k] = stays.corners;
    const std::optional<std::uint32_t> apex = moved_apex(moves, {moves.first, stays.plane, {j, i, k}});
    if (!apex)
      return false;
    moves.corners = {j, i, *apex};
    moves.plane = stays.plane;
    return true;
  }

  // The point opposite to a side, if the side is moved to the first side of a layout in another plane; its third point
  // does not matter beyond its image. None where the error would be too large.
  std::optional<std::uint32_t> moved_apex(const Layout& from, const Layout& to)
  {
    const Vector side = moved_side(point(from, 0).position, point(from, 1).position, point(from, 2).position,
                                   point(to, 0).position, point(to, 1).position);
    const Vector apex = point(to, 0).position + side;
    if (!(apex.radius() < largest_radius * side.modulus()))
      return std::nullopt;
    std::unique_ptr<const Image> image;
    if (has_images(from) && has_images(to))
      image = std::make_unique<const Image>(
        *point(to, 0).image + moved_side(*point(from, 0).image, *point(from, 1).image, *point(from, 2).image,
                                         *point(to, 0).image, *point(to, 1).image));
    return add_point(apex, std::move(image));
  }

  // The side to the apex of a triangle over from-to, if that is moved to new_from-new_to.
  template <class Complex>
  static Complex moved_side(const Complex& from, const Complex& to, const Complex& apex, const Complex& new_from,
                            const Complex& new_to)
  {
    const Complex edge = to - from, product = times_conjugate(apex - from, edge);
    const auto norm = squared_norm(edge);
    return (new_to - new_from) * Complex(product.x() / norm, product.y() / norm);
  }

  void keep(const Delta_complex& complex, Face_index f, const Layout& layout)
  {
    if (layout_of_.empty())
      layout_of_.assign(complex.number_of_faces(), none);
    std::uint32_t& position = layout_of_[f.idx()];
    if (position == none && first_free_ != none) {
      position = first_free_;
      first_free_ = layouts_[position].plane;
    } else if (position == none) {
      layouts_.emplace_back();
      position = std::uint32_t(layouts_.size() - 1);
    }
    layouts_[position] = layout;
  }

  // Forgets the points and planes that no face lies in any more. What stays keeps its order.
  void compact()
  {
    std::vector<bool> is_free(layouts_.size(), false);
    for (std::uint32_t i = first_free_; i != none; i = layouts_[i].plane)
      is_free[i] = true;
    std::vector<std::uint32_t> new_point(points_.size(), none), new_plane(planes_.size(), none);
    for (std::size_t i = 0; i < layouts_.size(); ++i)
      if (!is_free[i]) {
        new_plane[layouts_[i].plane] = 0;
        for (std::uint32_t corner : layouts_[i].corners)
          new_point[corner] = 0;
      }
    move_up(points_, new_point);
    move_up(planes_, new_plane);
    for (std::size_t i = 0; i < layouts_.size(); ++i)
      if (!is_free[i]) {
        layouts_[i].plane = new_plane[layouts_[i].plane];
        for (std::uint32_t& corner : layouts_[i].corners)
          corner = new_point[corner];
      }
    most_points_ = (std::max)(points_.size(), most_points_at_first);
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

  static constexpr std::size_t most_points_at_first = 4096;

  Large_vector<std::uint32_t> layout_of_; // for each face its position in layouts_, or none
  std::vector<Layout> layouts_;
  std::uint32_t first_free_ = none; // positions in layouts_ that are not in use: each has the next one as `plane`
  std::vector<Point> points_;
  std::vector<Plane> planes_;                      // those that are older come first
  std::size_t most_points_ = most_points_at_first; // after the last compaction
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DEVELOPED_FACES_H
