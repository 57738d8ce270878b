// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Input edges followed through the intrinsic triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_EDGE_TRACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_EDGE_TRACER_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Only reads the integers: any number of threads may trace at once.
class Input_edge_tracer
{
public:
  // Where an input edge comes from the left of an intrinsic halfedge: `position` counts the
  // crossings of that edge from its halfedge 2e.
  struct Crossing
  {
    Halfedge_index halfedge;
    std::int64_t position;
  };

  Input_edge_tracer(const Delta_complex& intrinsic, const Correspondence& correspondence)
    : intrinsic_(intrinsic), correspondence_(correspondence), input_(correspondence.input()),
      coordinates_(correspondence.coordinates())
  {}

  // The n input halfedges that leave the corner opposite to ij. Those that leave a vertex within
  // an intrinsic triangle are consecutive around it.
  template <class Function>
  void for_each_start(Halfedge_index ij, std::int64_t n, const Function& function) const
  {
    if (n == 0)
      return;
    const Halfedge_index ki = intrinsic_.prev(ij);
    Halfedge_index start = correspondence_.input_halfedge(ki);
    if (coordinates_.is_original(intrinsic_.edge(ki)))
      start = input_.next_around_source(start);
    for (std::int64_t i = 0; i < n; ++i, start = input_.next_around_source(start))
      function(start, i);
  }

  // Calls function(h, ij, start) for the input halfedges h, those numbered 2e, that leave a corner
  // opposite to a side ij on the intrinsic edge e as number `start` of those there.
  template <class Function>
  void for_each_path_across(Edge_index e, const Function& function) const
  {
    if (coordinates_.crossings(e) <= 0)
      return;
    for (Halfedge_index ij : {intrinsic_.halfedge(e), intrinsic_.opposite(intrinsic_.halfedge(e))})
      for_each_start(ij, coordinates_.triangle_crossings(intrinsic_, ij).e_k,
                     [&](Halfedge_index h, std::int64_t i) {
                       if (h == input_.halfedge(input_.edge(h)))
                         function(h, ij, i);
                     });
  }

  // Visits the crossings of the input halfedge that leaves the corner opposite to ij as number
  // `start` of those there.
  template <class Function>
  void follow(Halfedge_index ij, std::int64_t start, const Function& visit) const
  {
    std::int64_t position = coordinates_.triangle_crossings(intrinsic_, ij).c_i + start;
    while (true) {
      // It leaves the triangle to the left of ij at `position`, counted from i.
      const std::int64_t n = coordinates_.number_of_crossings(intrinsic_.edge(ij));
      const bool is_first_halfedge = ij == intrinsic_.halfedge(intrinsic_.edge(ij));
      visit(Crossing{ij, is_first_halfedge ? position : n - 1 - position});
      const Halfedge_index ji = intrinsic_.opposite(ij);
      position = n - 1 - position;
      const Triangle_crossings t = coordinates_.triangle_crossings(intrinsic_, ji);
      if (position < t.c_i) { // around the source of ji
        ij = intrinsic_.prev(ji);
        position = coordinates_.number_of_crossings(intrinsic_.edge(ij)) - 1 - position;
      } else if (position < t.c_i + t.e_k) {
        return;
      } else { // around its target
        ij = intrinsic_.next(ji);
        position = n - 1 - position;
      }
    }
  }

private:
  const Delta_complex& intrinsic_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  const Normal_coordinates& coordinates_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INPUT_EDGE_TRACER_H
