// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Cotangent weights and areas for matrices: from the stored numbers, which is fast, if they are accurate enough, and
// otherwise from the input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_COTANGENT_WEIGHT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_COTANGENT_WEIGHT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Direct_mapped_cache.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

[[noreturn]] inline void throw_no_cotangent(Face_index f)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::DEGENERATE_FACE, f.idx(), 1,
                              "face " + std::to_string(f.idx()) +
                                " has zero area, so its cotangents are infinite: remove it, "
                                "or mollify the lengths first");
}

// Decided exactly if the traits can.
template <class Triangulation>
bool has_positive_area(const Triangulation& triangulation, Face_index f)
{
  if constexpr (Triangulation::uses_exact_geometry) // the stored bound usually suffices
    return triangulation.traits().has_positive_area_object()(triangulation.face_data(f)) ||
           internal::engine(triangulation).sign_of_area(f) == POSITIVE;
  else
    return certainly(triangulation.area(f) > typename Triangulation::FT(0));
}

// Throws unless the faces beside an edge have positive area.
template <class Triangulation>
void require_positive_areas(const Triangulation& triangulation, Edge_index e)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index h = complex.halfedge(e);
  for (Halfedge_index side : {h, complex.opposite(h)}) {
    if (complex.is_border(side))
      continue;
    if (const Face_index f = complex.face(side); !has_positive_area(triangulation, f))
      throw_no_cotangent(f);
  }
}

// The sum of two rounded cotangents can be negative although the test of the number type, which does not use that sum,
// says otherwise.
template <class Triangulation>
double with_decided_sign(const Triangulation& triangulation, Edge_index e, double weight)
{
  return weight < 0 && !triangulation.connectivity().is_border(e) && certainly(triangulation.is_locally_Delaunay(e))
           ? 0
           : weight;
}

template <class Triangulation>
BOOST_NOINLINE double cotangent_weight_by_number_type(const Triangulation& triangulation, Edge_index e)
{
  if constexpr (Triangulation::uses_exact_geometry)
    if (e.idx() % 61 == 0) // reading the clock takes as long as a weight; a prime, because edge numbers have periods
      internal::engine(triangulation).decisions().interruption.check();
  require_positive_areas(triangulation, e);
  const double weight = CGAL::to_double(triangulation.cotangent_weight(e));
  if (!std::isfinite(weight))
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, e.idx(), 1,
                                "the cotangent weight of edge " + std::to_string(e.idx()) +
                                  " is beyond the range of double");
  return with_decided_sign(triangulation, e, weight);
}

// Weights and areas with at most this error are taken from the stored numbers.
constexpr double stored_number_accuracy = 0x1p-32;

// One number for each of n elements: number(element). Several threads, each with a copy of `number`, leave elements for
// which it throws to one thread, which finds the first of them.
template <class ConcurrencyTag, class Element, class Number>
std::vector<double> numbers_of_elements(std::size_t n, const Number& number)
{
  using size_type = typename Element::size_type;
  const Standard_arithmetic arithmetic;
  std::vector<double> result;
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value && Number::has_threads) {
    result.resize(n);
    for_each_block<ConcurrencyTag>(n, elements_of_block, [&](std::size_t first, std::size_t last) {
      const Number of_block = number;
      for (std::size_t i = first; i < last; ++i)
        try {
          result[i] = of_block(Element(size_type(i)));
        } catch (const Invalid_surface_error&) {
          result[i] = std::numeric_limits<double>::quiet_NaN();
        }
    });
    for (std::size_t i = 0; i < n; ++i)
      if (std::isnan(result[i]))
        result[i] = number(Element(size_type(i)));
  } else {
    result.reserve(n);
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(number(Element(size_type(i))));
  }
  return result;
}

// The cotangents of faces from the exact geometry, with error bounds. If the stored numbers are not accurate enough for
// an edge, they usually are not for any edge of the face: one corner of it is laid out for all three, and remembered
// for a while.
//
// \tparam Number `Double_with_bound` or `Bounded_double_double`
template <class Number>
class Known_cotangents
{
public:
  // Opposite to h; zero on the border.
  Number operator()(const Exact_engine& engine, Halfedge_index h)
  {
    const Delta_complex& complex = engine.connectivity();
    if (complex.is_border(h))
      return {};
    if (!of_faces_)
      of_faces_.emplace(1024);
    const Face_index f = complex.face(h);
    const auto& cotangents = (*of_faces_)(f, f.idx(), [&] {
      std::array<Number, 3> found;
      Engine_numbers(engine).find_cotangents(f, found);
      return found;
    });
    const Halfedge_index first = complex.halfedge(f);
    return cotangents[h == first ? 0 : h == complex.next(first) ? 1 : 2];
  }

private:
  std::optional<Direct_mapped_cache<Face_index, std::array<Number, 3>>> of_faces_; // none before it is needed
};

// The cotangent opposite to h, which has a face, from the stored numbers.
template <class Triangulation>
BOOST_FORCEINLINE auto bounded_cotangent(const Triangulation& triangulation, Halfedge_index h)
{
  const Delta_complex& complex = triangulation.connectivity();
  const auto data = [&](Halfedge_index side) -> const auto& { return triangulation.edge_data(complex.edge(side)); };
  return triangulation.traits().compute_bounded_cotangent_object()(triangulation.face_data(complex.face(h)), data(h),
                                                                   data(complex.next(h)), data(complex.prev(h)));
}

// Gives the weight of an edge, as documented for cotangent_weights().
template <class Traits, class = void>
class Cotangent_weight
{
public:
  static constexpr bool has_bounds = false; // of cotangents
  static constexpr bool has_threads = is_for_threads<typename Traits::Edge_data>;

  explicit Cotangent_weight(const Intrinsic_triangulation<Traits>& triangulation) : triangulation_(triangulation) {}
  double operator()(Edge_index e) const { return cotangent_weight_by_number_type(triangulation_, e); }

private:
  const Intrinsic_triangulation<Traits>& triangulation_;
};

// The same, for traits that store error bounds of cotangents.
template <class Traits>
class Cotangent_weight<Traits, std::void_t<typename Traits::Compute_bounded_cotangent>>
{
  using Triangulation = Intrinsic_triangulation<Traits>;

public:
  static constexpr bool has_bounds = true;
  static constexpr bool has_threads = true;

  explicit Cotangent_weight(const Triangulation& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity())
  {}

  double operator()(Edge_index e) const
  {
    prefetch_soon(e);
    const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    const Bounded_double k = cotangent(h), l = cotangent(g);
    // The rounding of the sum is far below the error of its terms.
    const double weight = k.value + l.value, error = 1.5 * (k.error + l.error);
    const bool is_precise = error <= stored_number_accuracy * (1 + std::abs(k.value) + std::abs(l.value));
    return is_precise && error < std::abs(weight) ? weight : by_exact_geometry(e, is_precise, k, l);
  }

private:
  // Edges are requested in order, so the records of their halfedges stream in by themselves; the data they refer to is
  // prefetched.
  BOOST_FORCEINLINE void prefetch_soon(Edge_index e) const
  {
    constexpr std::size_t distance = 32;
    const std::size_t soon = e.idx() + distance;
    if (soon >= complex_.number_of_edges())
      return;
    const Halfedge_index h = complex_.halfedge(Edge_index(Edge_index::size_type(soon)));
    for (Halfedge_index side : {h, complex_.opposite(h)}) {
      if (complex_.is_border(side))
        continue;
      prefetch(&triangulation_.face_data(complex_.face(side)));
      prefetch(&triangulation_.edge_data(complex_.edge(complex_.next(side))));
      prefetch(&triangulation_.edge_data(complex_.edge(complex_.prev(side))));
    }
  }

  // If only the sign is unknown, doubles will not settle it.
  BOOST_NOINLINE double by_exact_geometry(Edge_index e, bool is_sign_alone, const Bounded_double& stored_k,
                                          const Bounded_double& stored_l) const
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      const Exact_engine& engine = internal::engine(triangulation_);
      const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
      double weight;
      if (!is_sign_alone) {
        const auto cotangent = [&](Halfedge_index side, const Bounded_double& stored) {
          const bool is_precise = stored.error <= stored_number_accuracy / 4 * (1 + std::abs(stored.value));
          return is_precise ? Double_with_bound(stored.value, stored.error) : in_doubles_(engine, side);
        };
        if (find_weight(cotangent(h, stored_k), cotangent(g, stored_l), weight))
          return weight;
      }
      if (find_weight(in_double_doubles_(engine, h), in_double_doubles_(engine, g), weight))
        return weight;
    }
    return cotangent_weight_by_number_type(triangulation_, e);
  }

  // Returns whether the sum of two cotangents is accurate enough.
  template <class Number>
  static bool find_weight(const Number& k, const Number& l, double& result)
  {
    const Number weight = k + l;
    result = weight.hi();
    return weight.is_zero() || (weight.error() <= stored_number_accuracy * (1 + std::abs(k.hi()) + std::abs(l.hi())) &&
                                weight.error() < std::abs(weight.hi()));
  }

  // On the border there is no angle, and the cotangent counts as zero.
  Bounded_double cotangent(Halfedge_index h) const
  {
    return complex_.is_border(h) ? Bounded_double{0, 0} : bounded_cotangent(triangulation_, h);
  }

  const Triangulation& triangulation_;
  const Delta_complex& complex_;
  // So each thread needs its own object.
  mutable Known_cotangents<Double_with_bound> in_doubles_;
  mutable Known_cotangents<Bounded_double_double> in_double_doubles_;
};

// Gives the area of a face, as documented for face_areas().
template <class Traits>
class Face_area
{
  using Triangulation = Intrinsic_triangulation<Traits>;

public:
  static constexpr bool has_threads = is_for_threads<typename Traits::Edge_data>;

  explicit Face_area(const Triangulation& triangulation) : triangulation_(triangulation) {}

  double operator()(Face_index f) const
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      const auto& stored = triangulation_.face_data(f);
      if (is_accurate(stored.value, stored.error))
        return in_input_unit(stored.value, f);
      const Double_with_bound rounded = Engine_numbers(internal::engine(triangulation_)).rounded_four_areas(f);
      if (is_accurate(rounded.hi(), rounded.error()))
        return in_input_unit(rounded.hi(), f);
    }
    const double area = CGAL::to_double(triangulation_.area(f));
    if (!std::isfinite(area))
      throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, f.idx(), 1,
                                  "the area of face " + std::to_string(f.idx()) +
                                    " is beyond the range of double; scale the surface");
    return area;
  }

private:
  static bool is_accurate(double four_areas, double error) { return error <= stored_number_accuracy * four_areas; }
  double in_input_unit(double four_areas, Face_index f) const
  {
    return area_in_input_unit(four_areas / 4, triangulation_.unit_exponent(), f);
  }

  const Triangulation& triangulation_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_COTANGENT_WEIGHT_H
