// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Faces laid out in the plane once, and carried along by the flips.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEVELOPED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEVELOPED_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// To lay out a face over the input costs as much as its edges cross input edges. Where tests
// are close for long, as in the caps of a prism or along the folds of a pillow, that would be
// done again and again for strips of thousands of triangles. So a face that was laid out is
// kept, as the positions of its corners in some plane, and a flip carries the corner of one
// face over into the plane of the other. If both lie in the same plane there is nothing to
// compute: a flip moves no vertex. Thus errors add up with the number of planes that a corner
// is carried through, while errors of lengths would be multiplied by each flip.
//
// Only faces of close calls, and those that flips make of them, are kept.
//
// \tparam Real, Vector numbers with error bounds, and complex ones
// \tparam Corner as `Unfolding::Corner`
template <class Real, class Vector, class Corner>
class Developed_faces
{
public:
  bool contains(Face_index f) const { return !layout_of_.empty() && layout_of_[f.idx()] != none; }

  // The corner opposite to h. \pre contains(complex.face(h))
  Corner corner(const Delta_complex& complex, Halfedge_index h) const
  {
    const Layout layout = seen_from(complex, h);
    const Vector &i = layout.corners[0].position, &j = layout.corners[1].position,
                 &k = layout.corners[2].position;
    const Vector u = i - k, w = j - k, z = times_conjugate(w, u);
    const Real& s = layout.unit;
    return {s.scaled(2) * z.x(), s.scaled(2) * z.y(), s * squared_norm(u), s * squared_norm(w),
            s * squared_norm(j - i)};
  }

  // Keeps the face of h, of which the corner opposite to h is known.
  void insert(const Delta_complex& complex, Halfedge_index h, const Corner& c)
  {
    const std::optional<Layout> layout = laid_out(h, c);
    if (layout)
      keep(complex, complex.face(h), *layout);
  }

  // To be called before the flip of the connectivity. known_corner(h) gives the corner
  // opposite to h if it costs little.
  template <class KnownCorner>
  void flip(const Delta_complex& complex, Edge_index e, bool is_close_call,
            const KnownCorner& known_corner)
  {
    const Halfedge_index ij = complex.halfedge(e), ji = complex.opposite(ij);
    const Face_index ijk = complex.face(ij), jil = complex.face(ji);
    if (!is_close_call && !contains(ijk) && !contains(jil))
      return;
    const auto find = [&](Halfedge_index h) -> std::optional<Layout> {
      if (contains(complex.face(h)))
        return seen_from(complex, h);
      const std::optional<Corner> c = known_corner(h);
      return c ? laid_out(h, *c) : std::nullopt;
    };
    std::optional<Layout> above = find(ij), below = find(ji);
    if (!above || !below || !unite(*above, *below)) {
      erase(ijk);
      erase(jil);
      return;
    }
    const auto& [i, j, k] = above->corners;
    const Placement& l = below->corners[2];
    // After the flip ij leads from l to k (see Delta_complex::flip()).
    keep(complex, ijk, Layout{ij, above->plane, above->unit, {l, k, i}});
    keep(complex, jil, Layout{ji, above->plane, above->unit, {k, l, j}});
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
  // Beyond, it is better to lay the face out anew. Relative to the edges.
  static constexpr double largest_radius = 0x1p-75;

  // A corner that was laid out. Corners with the same number are the same point of the same
  // plane: two faces that share the numbers of an edge need not be brought together.
  struct Placement
  {
    std::uint64_t number;
    Vector position;
  };
  // The source, the target and the opposite corner of a halfedge.
  struct Layout
  {
    Halfedge_index first;
    std::uint64_t plane; // counts the planes
    Real unit;           // squared length of the unit
    std::array<Placement, 3> corners;
  };

  Placement place(const Vector& position) { return {number_of_placements_++, position}; }

  // The origin is the corner k opposite to h = ij, and the unit is ki.
  std::optional<Layout> laid_out(Halfedge_index h, const Corner& c)
  {
    const Real two_s = c.s_first.scaled(2);
    const Vector j(c.p / two_s, c.four_areas / two_s);
    if (!(j.radius() < largest_radius * j.modulus()))
      return std::nullopt;
    return Layout{h,
                  number_of_planes_++,
                  c.s_first,
                  {place(Vector(Real(1), Real(0))), place(j), place(Vector(Real(0), Real(0)))}};
  }

  Layout seen_from(const Delta_complex& complex, Halfedge_index h) const
  {
    const Layout& kept = layouts_[layout_of_[complex.face(h).idx()]];
    const int turn = h == kept.first ? 0 : h == complex.next(kept.first) ? 1
                                                                         : 2;
    return {h,
            kept.plane,
            kept.unit,
            {kept.corners[turn], kept.corners[(turn + 1) % 3], kept.corners[(turn + 2) % 3]}};
  }

  // Brings two faces (i, j, k) and (j, i, l) into the older of their planes.
  bool unite(Layout& above, Layout& below)
  {
    if (above.corners[0].number == below.corners[1].number &&
        above.corners[1].number == below.corners[0].number)
      return true;
    Layout &stays = above.plane < below.plane ? above : below,
           &moves = above.plane < below.plane ? below : above;
    const Vector &from = moves.corners[0].position, &to = moves.corners[1].position,
                 &new_from = stays.corners[1].position, &new_to = stays.corners[0].position;
    const Vector edge = to - from,
                 product = times_conjugate(moves.corners[2].position - from, edge);
    const Real norm = squared_norm(edge);
    const Vector side = (new_to - new_from) * Vector(product.x() / norm, product.y() / norm);
    const Vector apex = new_from + side;
    if (!(apex.radius() < largest_radius * side.modulus()))
      return false;
    moves.corners = {stays.corners[1], stays.corners[0], place(apex)};
    moves.plane = stays.plane;
    moves.unit = stays.unit;
    return true;
  }

  void erase(Face_index f)
  {
    if (!contains(f))
      return;
    free_.push_back(layout_of_[f.idx()]);
    layout_of_[f.idx()] = none;
  }

  void keep(const Delta_complex& complex, Face_index f, const Layout& layout)
  {
    if (layout_of_.empty())
      layout_of_.assign(complex.number_of_faces(), none);
    std::uint32_t& position = layout_of_[f.idx()];
    if (position == none && !free_.empty()) {
      position = free_.back();
      free_.pop_back();
    } else if (position == none) {
      layouts_.emplace_back();
      position = std::uint32_t(layouts_.size() - 1);
    }
    layouts_[position] = layout;
  }

  Large_vector<std::uint32_t> layout_of_; // for each face its position in layouts_, or none
  std::vector<Layout> layouts_;
  std::vector<std::uint32_t> free_; // positions in layouts_ that are not in use
  std::uint64_t number_of_placements_ = 0;
  std::uint64_t number_of_planes_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DEVELOPED_FACES_H
