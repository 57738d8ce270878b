// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The surface as heat methods need it: matrices, and each face in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_SURFACE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A face in the plane: its corners are (0, 0), (base, 0) and (x, height). The base is the longest side, so that x and
// the height are found without cancellation.
struct Heat_face
{
  std::array<std::uint32_t, 3> row; // of the corners
  float share;                      // the weight of the face: one half if it has a second copy
  double base, x, height;

  double area() const { return share * base * height / 2; }

  // The gradient of a function by its values at the corners, times twice the area.
  std::array<double, 2> slope(const std::array<double, 3>& u) const
  {
    return {(u[1] - u[0]) * height, (u[2] - u[0]) * base - (u[1] - u[0]) * x};
  }
};

// All lengths are in units of the mean edge length of their component, until they are lengthened, so that no number
// depends on the scale of the input or on its other components.
struct Heat_surface
{
  double mean_length = 0;    // of all edges, in units of 2^exponent units of the input
  std::vector<double> units; // of the component of each row, likewise
  int exponent = 0;
  std::vector<Heat_face> faces; // the faces with an area
  std::vector<double> weights;  // half the sums of cotangents, for each edge of the triangulation
  Eigen::SparseMatrix<double> stiffness;
  Eigen::VectorXd mass;                 // zero for a vertex without faces
  std::vector<bool> is_border;          // whether a row is a vertex of a border edge
  std::vector<std::uint32_t> component; // the smallest row that faces connect with this one

  std::size_t size() const { return std::size_t(mass.size()); }
  // A length at some row, in the unit of the input.
  double in_input_unit(double length, std::size_t row) const { return std::ldexp(length * units[row], exponent); }
  double from_input_unit(double length, std::size_t row) const { return std::ldexp(length, -exponent) / units[row]; }

  // Multiplies the unit of each row, equally for all rows of a component.
  void lengthen_units(const std::vector<double>& factors)
  {
    for (std::size_t v = 0; v < size(); ++v) {
      units[v] *= factors[v];
      mass[Eigen::Index(v)] /= factors[v] * factors[v];
    }
    for (Heat_face& face : faces)
      for (double* length : {&face.base, &face.x, &face.height})
        *length /= factors[face.row[0]];
  }

  // The rows in the components of these rows.
  // \tparam Values a range of pairs whose first member is a row
  template <class Values>
  std::vector<bool> connected_with(const Values& values) const
  {
    std::vector<bool> components(size()), result(size());
    for (const auto& value : values)
      components[component[value.first]] = true;
    for (std::size_t v = 0; v < size(); ++v)
      result[v] = components[component[v]];
    return result;
  }
};

inline void require_time_coefficient(double coefficient)
{
  if (!(coefficient > 0 && std::isfinite(coefficient)))
    throw Invalid_argument_error("the time coefficient has to be a positive number");
}

// Whether an angle opposite to a border edge is obtuse.
template <class Traits>
bool has_obtuse_border(const Intrinsic_triangulation<Traits>& triangulation)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Accurate_shapes<Traits> shapes(triangulation);
  for (Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h) && complex.is_border(complex.opposite(h)) && shapes.has_area(complex.face(h)) &&
        shapes.cotangent(h) < 0)
      return true;
  return false;
}

// \tparam Row gives the row of a vertex and the weight of a face, like Row_of_vertex
template <class Traits, class Row>
class Heat_surface_builder
{
public:
  Heat_surface_builder(const Intrinsic_triangulation<Traits>& triangulation, const Row& row)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), shapes_(triangulation), row_(row)
  {
    measure_edges();
    find_components();
    choose_units();
    lay_out_faces();
    sum_up_masses();
    assemble();
  }

  Heat_surface take() { return std::move(result_); }

private:
  void measure_edges()
  {
    double sum = 0;
    lengths_.reserve(complex_.number_of_edges());
    for (Edge_index e : complex_.edges()) {
      lengths_.push_back(shapes_.length(e));
      sum += lengths_.back() / complex_.number_of_edges();
    }
    result_.exponent = shapes_.exponent();
    result_.mean_length = sum > 0 ? sum : 1;
  }

  void find_components()
  {
    const std::size_t n = row_.number_of_rows();
    Disjoint_sets components(n);
    has_area_.reserve(complex_.number_of_faces());
    for (Face_index f : complex_.faces()) {
      has_area_.push_back(shapes_.has_area(f));
      const Halfedge_index h = complex_.halfedge(f);
      if (has_area_.back())
        for (Halfedge_index side : {h, complex_.next(h)})
          components.unite(row(side), row(complex_.opposite(side)));
    }
    result_.component.reserve(n);
    for (std::size_t v = 0; v < n; ++v)
      result_.component.push_back(components.find(std::uint32_t(v)));
  }

  void choose_units()
  {
    std::vector<double> number(result_.component.size(), 0), sum(number);
    const auto component = [&](Edge_index e) { return result_.component[row(complex_.halfedge(e))]; };
    for (Edge_index e : complex_.edges())
      ++number[component(e)];
    for (Edge_index e : complex_.edges())
      sum[component(e)] += lengths_[e.idx()] / number[component(e)];
    result_.units.reserve(sum.size());
    for (std::uint32_t c : result_.component)
      result_.units.push_back(sum[c] > 0 ? sum[c] : 1);
    for (Edge_index e : complex_.edges())
      lengths_[e.idx()] /= result_.units[row(complex_.halfedge(e))];
  }

  // The row of the source of h.
  std::uint32_t row(Halfedge_index h) const { return std::uint32_t(row_(complex_.source(h))); }

  double length(Halfedge_index h) const { return lengths_[complex_.edge(h).idx()]; }

  // A face without area is a piece of the edge beside it, and is omitted.
  void lay_out_faces()
  {
    result_.faces.reserve(complex_.number_of_faces());
    for (Face_index f : complex_.faces()) {
      if (!has_area_[f.idx()])
        continue;
      const Halfedge_index base = side_with_largest(complex_, f, [&](Halfedge_index h) { return length(h); });
      const Halfedge_index next = complex_.next(base), prev = complex_.prev(base);
      const std::optional<Face_apex> by_lengths = apex_by_lengths({length(base), length(next), length(prev)});
      const Face_apex apex = by_lengths ? *by_lengths : apex_by_cotangents(shapes_, complex_, base);
      const double x = apex.x * length(base), height = apex.height * length(base);
      if (height < least_height * length(base))
        thicken(base, x);
      result_.faces.push_back({{row(base), row(next), row(prev)}, float(row_.share(f)), length(base), x, height});
    }
  }

  // In the matrix a thinner face would make all others vanish in double: its corners get the cotangents of a face that
  // is just thick enough.
  void thicken(Halfedge_index base, double x)
  {
    const double height = least_height * length(base), first = x / height, second = (length(base) - x) / height;
    cotangents_[complex_.next(base)] = first;
    cotangents_[complex_.prev(base)] = second;
    cotangents_[base] = (1 - first * second) / (first + second);
  }

  double cotangent(Halfedge_index h) const
  {
    const auto thickened = cotangents_.find(h);
    return thickened != cotangents_.end() ? thickened->second : shapes_.cotangent(h);
  }

  void sum_up_masses()
  {
    result_.mass = Eigen::VectorXd::Zero(Eigen::Index(row_.number_of_rows()));
    for (const Heat_face& face : result_.faces)
      for (std::uint32_t row : face.row)
        result_.mass[row] += face.area() / 3;
  }

  bool has_area(Halfedge_index h) const { return !complex_.is_border(h) && has_area_[complex_.face(h).idx()]; }

  void assemble()
  {
    const Cotangent_weight<Traits> weight(triangulation_); // its sign is right
    result_.is_border.resize(row_.number_of_rows());
    result_.weights.reserve(complex_.number_of_edges());
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
      const bool is_left = has_area(h), is_right = has_area(g);
      double cotangents = 0;
      if (is_left && is_right)
        cotangents = row_.share(complex_.face(h)) *
                     (cotangents_.count(h) + cotangents_.count(g) > 0 ? cotangent(h) + cotangent(g) : weight(e));
      else if (is_left || is_right) {
        const Halfedge_index side = is_left ? h : g;
        result_.is_border[row_(complex_.source(h))] = result_.is_border[row_(complex_.target(h))] = true;
        cotangents = row_.share(complex_.face(side)) * cotangent(side);
      }
      result_.weights.push_back(cotangents / 2);
    }
    result_.stiffness = assemble_symmetric_matrix(
      complex_, row_, [&](Edge_index e) { return -result_.weights[e.idx()]; },
      [](int, double sum_of_others) { return 0 - sum_of_others; });
  }

  static constexpr double least_height = 0x1p-30; // in units of the base

  const Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  const Accurate_shapes<Traits> shapes_;
  const Row& row_;
  std::vector<double> lengths_;
  std::vector<bool> has_area_;
  std::unordered_map<Halfedge_index, double> cotangents_; // of faces that were too thin, opposite to the halfedge
  Heat_surface result_;
};

template <class Traits, class Row>
Heat_surface make_heat_surface(const Intrinsic_triangulation<Traits>& triangulation, const Row& row)
{
  return Heat_surface_builder<Traits, Row>(triangulation, row).take();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_SURFACE_H
