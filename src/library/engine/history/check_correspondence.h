// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Checks untrusted integers that describe how an input lies in a triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CHECK_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CHECK_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Rotation_system.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes the checks that need no metric: that the input edges, followed through the triangles, are those of the input,
// in the same order around each vertex, and that both surfaces have the same topology. Then the input edges cut the
// surface into the input faces, up to isotopy: their rotation system determines the faces, and no region between them
// has room for a handle or a hole.
//
// \exception Invalid_surface_error if not
// Time: proportional to the size and the number of crossings
class Correspondence_check
{
public:
  Correspondence_check(const Delta_complex& complex, const Correspondence& correspondence,
                       const Interruption& interruption)
    : complex_(complex), correspondence_(correspondence), coordinates_(correspondence.coordinates()),
      input_(correspondence.input()), interruption_(interruption)
  {}

  // Queries that are valid before everything else is known.
  void check_locations() const
  {
    const std::size_t first = input_.number_of_vertices();
    for (std::size_t i = 0; i < correspondence_.locations().size(); ++i) {
      const Surface_point& point = correspondence_.locations()[i];
      double sum = 0;
      bool is_good = point.halfedge.idx() < input_.number_of_halfedges() && !input_.is_border(point.halfedge);
      for (double x : point.coordinates) {
        is_good = is_good && x >= 0;
        sum += x;
      }
      if (!is_good || !std::isfinite(sum) || point.dimension() < 1)
        fail("vertex", first + i, "was inserted at no point inside of an input face or edge");
      if (!complex_.halfedge(Vertex_index(std::uint32_t(first + i))).is_valid())
        fail("vertex", first + i, "was inserted, and has no face");
    }
  }

  void operator()(const Block_runner& run)
  {
    check_places();
    check_counts();
    for (Halfedge_index h : complex_.halfedges())
      check_name(complex_.source(h), correspondence_.input_halfedge(h));
    const Rotation_system around(input_);
    std::atomic<std::uint64_t> number_of_met{0}; // crossings of input edges that were followed
    run(complex_.number_of_vertices(), elements_of_block, [&](std::size_t first, std::size_t last) {
      interruption_.check();
      std::uint64_t number = 0;
      for (std::size_t v = first; v < last; ++v)
        check_vertex(Vertex_index(std::uint32_t(v)), around, number);
      number_of_met += number;
    });
    std::uint64_t number_of_crossings = 0;
    for (Edge_index e : complex_.edges())
      number_of_crossings += std::uint64_t(coordinates_.number_of_crossings(e));
    // An input edge was followed from both ends.
    if (number_of_met != 2 * number_of_crossings)
      fail("edge", first_edge_with_crossings(), "is crossed by a curve that is no input edge");
    check_topology();
  }

private:
  [[noreturn]] static void fail(const char* kind, std::size_t element, const std::string& what)
  {
    throw_not_a_triangulation(kind, element, what);
  }

  // Checks that no two vertices are at one place inside an input face; those on edges are compared with their
  // neighbors there.
  void check_places() const
  {
    struct Place
    {
      std::uint32_t face;
      std::array<double, 3> coordinates;
      std::size_t vertex;
    };
    std::vector<Place> places;
    for (std::size_t i = 0; i < correspondence_.locations().size(); ++i) {
      const Surface_point& p = correspondence_.locations()[i];
      const Face_index f = input_.face(p.halfedge);
      if (p.dimension() == 2)
        places.push_back({f.idx(), coordinates_from(input_, p, input_.halfedge(f)), i + input_.number_of_vertices()});
    }
    // By the ratios of coordinates, which are positive: that is a total order.
    const auto compare = [](const Place& p, const Place& q) {
      if (p.face != q.face)
        return p.face < q.face ? NEGATIVE : POSITIVE;
      const std::array<double, 3>& a = p.coordinates;
      const std::array<double, 3>& b = q.coordinates;
      const Sign first = compare_products(a[0], b[1], b[0], a[1]);
      return first != ZERO ? first : compare_products(a[1], b[2], b[1], a[2]);
    };
    std::sort(places.begin(), places.end(), [&](const Place& p, const Place& q) { return compare(p, q) == NEGATIVE; });
    for (std::size_t i = 1; i < places.size(); ++i)
      if (compare(places[i - 1], places[i]) == ZERO)
        fail("vertex", places[i].vertex, "lies where vertex " + std::to_string(places[i - 1].vertex) + " does");
  }

  void check_counts() const
  {
    for (Edge_index e : complex_.edges()) {
      const std::int64_t n = coordinates_.crossings(e);
      if (n < -1)
        fail("edge", e.idx(), "has a negative number of crossings");
      if (n >= 0 && complex_.is_border(e))
        fail("edge", e.idx(), "lies on the border, and coincides with no input edge");
    }
    for (Face_index f : complex_.faces()) {
      const Triangle_crossings t = coordinates_.triangle_crossings(complex_, complex_.halfedge(f));
      const int number_of_ends = (t.e_i > 0) + (t.e_j > 0) + (t.e_k > 0);
      if (t.e_i < 0 || t.e_j < 0 || t.e_k < 0 || number_of_ends > 1)
        fail("face", f.idx(), "has sides with numbers of crossings that do not fit together");
    }
  }

  // Checks that the halfedges around a vertex name the input halfedges around it, in their order and once each.
  void check_vertex(Vertex_index v, const Rotation_system& around, std::uint64_t& number_of_met) const
  {
    if (!complex_.halfedge(v).is_valid()) {
      if (input_.halfedge(v).is_valid())
        fail("vertex", v.idx(), "has no face, though the input has one there");
      return;
    }
    const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    Halfedge_index expected = correspondence_.input_halfedge(first);
    std::uint64_t number = 0; // of input halfedges
    const auto pass = [&] {
      if (!expected.is_valid())
        fail("vertex", v.idx(), "lies inside of an input face, and an input edge ends there");
      ++number;
      expected = next_input_halfedge(correspondence_, v, expected);
    };
    Halfedge_index ki = first;
    do {
      if (correspondence_.input_halfedge(ki) != expected)
        fail("halfedge", ki.idx(), "does not name the next input halfedge around its source");
      if (coordinates_.is_original(complex_.edge(ki))) {
        check_along(ki, expected);
        pass();
      }
      if (!complex_.is_border(ki)) {
        const Halfedge_index ij = complex_.next(ki);
        const Triangle_crossings t = coordinates_.triangle_crossings(complex_, ij);
        for (std::int64_t i = 0; i < t.e_k; ++i) {
          const Halfedge_index start = expected;
          pass();
          follow(v, ij, t.c_i + i, start, around, number_of_met);
        }
      }
      ki = complex_.next_around_source(ki);
    } while (ki != first);
    if (number != degree(v, first))
      fail("vertex", v.idx(), "is met by another number of input edges than in the input");
  }
  void check_name(Vertex_index v, Halfedge_index named) const
  {
    if (!correspondence_.is_inserted(v)) {
      if (!named.is_valid() || named.idx() >= input_.number_of_halfedges() || input_.source(named) != v)
        fail("vertex", v.idx(), "has a halfedge that names no input halfedge from there");
      return;
    }
    const Surface_point& location = correspondence_.location(v);
    const bool is_on_edge = location.dimension() == 1;
    if (named.is_valid() ? !is_on_edge || named.idx() >= input_.number_of_halfedges() ||
                             input_.edge(named) != input_.edge(side_of(input_, location))
                         : is_on_edge)
      fail("vertex", v.idx(), "has a halfedge that names no input halfedge through its location");
  }
  std::uint64_t degree(Vertex_index v, Halfedge_index from_v) const
  {
    if (correspondence_.is_inserted(v))
      return correspondence_.input_halfedge(from_v).is_valid() ? 2 : 0;
    std::uint64_t result = 0;
    for ([[maybe_unused]] Halfedge_index h : Halfedges_around(input_, v))
      ++result;
    return result;
  }

  void check_along(Halfedge_index h, Halfedge_index along) const
  {
    if (!along.is_valid() || correspondence_.input_halfedge(complex_.opposite(h)) != input_.opposite(along) ||
        complex_.is_border(h) != input_.is_border(along))
      fail("halfedge", h.idx(), "does not coincide with the input halfedge that it names");
    check_order(along, complex_.source(h), complex_.target(h));
  }
  // Compares two vertices along an input halfedge.
  void check_order(Halfedge_index along, Vertex_index u, Vertex_index v) const
  {
    if (!correspondence_.is_inserted(u) && !correspondence_.is_inserted(v))
      return;
    const auto weights = [&](Vertex_index x, const std::pair<double, double>& at_end) {
      return correspondence_.is_inserted(x) ? coordinates_on_edge(input_, correspondence_.location(x), along) : at_end;
    };
    const auto [a, b] = weights(u, {1, 0});
    const auto [c, d] = weights(v, {0, 1});
    if (compare_products(b, c, d, a) != NEGATIVE)
      fail("vertex", v.idx(), "does not lie behind vertex " + std::to_string(u.idx()) + " on their input edge");
  }

  // Follows an input halfedge that leaves v, the corner opposite to ij, until it ends.
  void follow(Vertex_index v, Halfedge_index ij, std::int64_t position, Halfedge_index start,
              const Rotation_system& around, std::uint64_t& number_of_met) const
  {
    if (input_.is_border(start) || input_.is_border(input_.opposite(start)))
      fail("edge", complex_.edge(ij).idx(), "is crossed by a border edge of the input");
    const std::int64_t n = coordinates_.number_of_crossings(complex_.edge(ij));
    Input_edge_walk walk(complex_, correspondence_, complex_.opposite(ij), n - 1 - position);
    bool has_ended = false;
    while (!has_ended) {
      if ((++number_of_met & 0xffff) == 0)
        interruption_.check();
      has_ended = walk.step();
    }
    if (walk.end(around) != input_.opposite(start))
      fail("edge", complex_.edge(ij).idx(),
           "is crossed by input edge " + std::to_string(input_.edge(start).idx()) +
             ", which does not end where it should");
    check_order(start, v, walk.end_vertex());
  }

  std::size_t first_edge_with_crossings() const
  {
    for (Edge_index e : complex_.edges())
      if (coordinates_.number_of_crossings(e) > 0)
        return e.idx();
    return 0;
  }

  // Checks that each component of the triangulation has the vertices of one component of the input, and the same Euler
  // characteristic.
  void check_topology() const
  {
    const std::size_t number_of_vertices = complex_.number_of_vertices();
    Disjoint_sets of_triangulation(number_of_vertices), of_input(number_of_vertices);
    const auto unite = [](const Delta_complex& complex, Disjoint_sets& sets) {
      for (Edge_index e : complex.edges())
        sets.unite(complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx());
    };
    unite(complex_, of_triangulation);
    unite(input_, of_input);
    std::vector<std::uint32_t> input_piece(number_of_vertices, Vertex_index::null_index());
    for (std::uint32_t v = 0; v < input_.number_of_vertices(); ++v) {
      std::uint32_t& piece = input_piece[of_triangulation.find(v)];
      if (piece == Vertex_index::null_index())
        piece = of_input.find(v);
      if (piece != of_input.find(v))
        fail("vertex", v, "belongs to another piece of the surface than in the input");
    }
    for (std::uint32_t v = 0; v < number_of_vertices; ++v)
      if (input_piece[of_triangulation.find(v)] == Vertex_index::null_index())
        fail("vertex", v, "belongs to a piece of the surface that the input does not have");
    const auto characteristic = [](const Delta_complex& complex) {
      return std::int64_t(complex.number_of_vertices()) - complex.number_of_edges() + complex.number_of_faces();
    };
    if (characteristic(complex_) != characteristic(input_))
      fail("face", 0, "and the others form a surface of another topological type than the input");
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Normal_coordinates& coordinates_;
  const Delta_complex& input_;
  const Interruption& interruption_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CHECK_CORRESPONDENCE_H
