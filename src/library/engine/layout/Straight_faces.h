// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces of the current triangulation that are triangles in space, and which of them lie in one plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRAIGHT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRAIGHT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include "Vertex_positions.h"
#include "../../measures/Flat_geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A face is known to be straight if it is the flat triangle in space between its corners: at first all are, and the two
// faces of a flip are if the old ones were and lie in one plane, on different sides of the edge. Then lengths and
// angles come from three points, however many input edges are crossed. This keeps the exact stages cheap in the flat
// parts of a model, where ties are.
//
// Coplanarity is remembered: a straight face has the number of a plane, which is that of an input face in it, and
// numbers of the same plane are united. All faces with united numbers have one oriented normal, so that two of them
// that share an edge lie on different sides of it.
//
// The parts of a straight face that a new vertex makes are straight, too. A vertex may lie on an edge, so that a part
// has no area, as long as that edge is not flipped.
//
// Functions that are called before a change leave valid knowledge even if the change does not happen.
class Straight_faces
{
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

public:
  Straight_faces(std::size_t number_of_faces, std::size_t number_of_points)
    : plane_(number_of_points != 0 ? number_of_faces : 0, default_init), united_with_(plane_.size(), default_init)
  {
    for (std::size_t f = 0; f < plane_.size(); ++f)
      plane_[f] = united_with_[f] = std::uint32_t(f);
  }

  // With known planes: for each face an input face in its plane, or the null descriptor.
  Straight_faces(std::size_t number_of_input_faces, std::size_t number_of_points, const std::vector<Face_index>& planes)
    : Straight_faces(number_of_input_faces, number_of_points)
  {
    if (number_of_points == 0)
      return;
    plane_.resize(planes.size(), default_init);
    for (std::size_t f = 0; f < planes.size(); ++f)
      plane_[f] = planes[f].is_valid() ? planes[f].idx() : none;
  }

  bool operator()(Face_index f) const { return !plane_.empty() && plane_[f.idx()] != none; }

  // Whether the faces of h are straight, lie in one plane, and on different sides of h.
  // \pre h lies between two different faces
  bool are_coplanar(const Delta_complex& complex, const Vertex_positions& positions, Halfedge_index h)
  {
    const Face_index f = complex.face(h), g = complex.face(complex.opposite(h));
    if (!(*this)(f) || !(*this)(g))
      return false;
    const std::uint32_t p = united(plane_[f.idx()]), q = united(plane_[g.idx()]);
    if (p == q)
      return true;
    if (!lie_in_one_plane(complex, positions, h, p, q))
      return false;
    if (priority(p) > priority(q))
      united_with_[q] = p;
    else
      united_with_[p] = q;
    return true;
  }
  // As above; remembers nothing.
  bool are_coplanar(const Delta_complex& complex, const Vertex_positions& positions, Halfedge_index h) const
  {
    const Face_index f = complex.face(h), g = complex.face(complex.opposite(h));
    if (!(*this)(f) || !(*this)(g))
      return false;
    const std::uint32_t p = united(plane_[f.idx()]), q = united(plane_[g.idx()]);
    return p == q || lie_in_one_plane(complex, positions, h, p, q);
  }

  // To be called before the flip of the connectivity. Returns whether the new faces are straight; never if `is_bent`.
  bool flip(const Delta_complex& complex, const Vertex_positions& positions, Edge_index e, bool is_bent = false)
  {
    if (plane_.empty())
      return false;
    const Halfedge_index h = complex.halfedge(e);
    const Face_index f = complex.face(h), g = complex.face(complex.opposite(h));
    if (!(*this)(f) && !(*this)(g)) // often, along strips
      return false;
    if (!is_bent && are_coplanar(complex, positions, h))
      return true;
    plane_[f.idx()] = plane_[g.idx()] = none;
    return false;
  }

  // The knowledge about two faces, to be restored when the flip between them is undone. Never throws.
  using Planes = std::array<std::uint32_t, 2>;
  static constexpr Planes no_planes = {none, none};
  Planes planes(Face_index f, Face_index g) const
  {
    return plane_.empty() ? no_planes : Planes{plane_[f.idx()], plane_[g.idx()]};
  }
  void put_back(Face_index f, Face_index g, const Planes& planes)
  {
    if (plane_.empty())
      return;
    plane_[f.idx()] = planes[0];
    plane_[g.idx()] = planes[1];
  }

  // Must be called before a face is split and this many parts are appended in all.
  void prepare_split(const Vertex_positions& positions, Face_index f, std::size_t number)
  {
    if (plane_.empty())
      return;
    if ((*this)(f))
      straighten(positions, f, Face_index(plane_[f.idx()]));
    make_room(plane_, number);
  }
  // Appends this many parts of a face. Never throws.
  void split(Face_index f, std::size_t number)
  {
    if (!plane_.empty())
      plane_.resize(plane_.size() + number, plane_[f.idx()]);
  }
  // Records that a face lies in an input face, or in its plane. If that face has no area, nothing is recorded.
  void straighten(const Vertex_positions& positions, Face_index f, Face_index input_face)
  {
    const bool has_area = have_one_plane(positions.input(), positions.points(), input_face, input_face);
    plane_[f.idx()] = has_area ? input_face.idx() : none;
  }
  // To be called before faces are joined and called f: it is straight if all are in one plane.
  void join(Face_index f, std::initializer_list<Face_index> faces)
  {
    if (plane_.empty())
      return;
    const std::uint32_t plane = plane_[faces.begin()->idx()];
    bool is_one = plane != none;
    for (Face_index each : faces)
      is_one = is_one && plane_[each.idx()] != none && united(plane_[each.idx()]) == united(plane);
    plane_[f.idx()] = is_one ? plane : none;
  }
  template <class Faces>
  void remove(const Faces& faces)
  {
    if (!plane_.empty())
      remove_entries(plane_, faces);
  }

private:
  // \param p, q the planes of both faces
  static bool lie_in_one_plane(const Delta_complex& complex, const Vertex_positions& positions, Halfedge_index h,
                               std::uint32_t p, std::uint32_t q)
  {
    if (positions.has_inserted_corner(complex, h) || positions.has_inserted_corner(complex, complex.opposite(h)))
      return have_one_plane(positions.input(), positions.points(), Face_index(p), Face_index(q));
    return is_flat(complex, positions.points(), h);
  }

  // Random numbers keep the trees low, even if they are only read.
  static std::uint32_t priority(std::uint32_t p) { return p * 2654435769u; }

  std::uint32_t united(std::uint32_t p) const
  {
    while (united_with_[p] != p)
      p = united_with_[p];
    return p;
  }
  std::uint32_t united(std::uint32_t p)
  {
    while (united_with_[p] != p)
      p = united_with_[p] = united_with_[united_with_[p]];
    return p;
  }

  Large_vector<std::uint32_t> plane_;       // of each straight face, or none
  Large_vector<std::uint32_t> united_with_; // for each plane another one, or itself
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRAIGHT_FACES_H
