// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The Laplace-Beltrami operator of points on an unknown surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POINT_CLOUD_LAPLACIAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POINT_CLOUD_LAPLACIAN_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The triangles around each point in the Delaunay triangulation of its neighbors' projections to a plane.
class Local_triangulations
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point_3 = Kernel::Point_3;
  using Numbered_point = std::pair<Point_3, std::uint32_t>;
  using Search_traits =
    Search_traits_adapter<Numbered_point, First_of_pair_property_map<Numbered_point>, Search_traits_3<Kernel>>;
  using Search = Orthogonal_k_neighbor_search<Search_traits>;
  using Planar_triangulation = Delaunay_triangulation_2<
    Kernel, Triangulation_data_structure_2<Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>>>;

public:
  // \pre the points are different and finite
  explicit Local_triangulations(const std::vector<std::array<double, 3>>& points)
  {
    std::uint32_t i = 0;
    for (const auto& [x, y, z] : points)
      points_.emplace_back(Point_3(x, y, z), i++);
    tree_.insert(points_.begin(), points_.end());
    tree_.build();
  }

  // Adds the triangles around a point.
  void add_star(std::uint32_t center, std::size_t n_neighbors, std::vector<Index_triangle>& triangles)
  {
    const Point_3& origin = points_[center].first;
    Search search(tree_, origin, unsigned(n_neighbors + 1)); // the point itself is one of them
    std::vector<std::uint32_t> neighbors;
    std::vector<Eigen::Vector3d> vectors;
    for (const auto& found : search)
      if (found.first.second != center) {
        neighbors.push_back(found.first.second);
        const Point_3& p = found.first.first;
        vectors.emplace_back(p.x() - origin.x(), p.y() - origin.y(), p.z() - origin.z());
      }
    const Eigen::Matrix<double, 3, 2> plane = tangent_plane(vectors);
    Planar_triangulation triangulation;
    const auto insert = [&](const Eigen::Vector2d& p, std::uint32_t number) {
      const std::size_t before = triangulation.number_of_vertices();
      const auto v = triangulation.insert(Kernel::Point_2(p[0], p[1]));
      if (triangulation.number_of_vertices() > before) // otherwise a nearer point is at the same place
        v->info() = number;
      return v;
    };
    const auto middle = insert(Eigen::Vector2d(0, 0), center);
    for (std::size_t i = 0; i < vectors.size(); ++i)
      insert(plane.transpose() * vectors[i], neighbors[i]);
    if (triangulation.dimension() < 2)
      return;
    auto face = triangulation.incident_faces(middle);
    const auto end = face;
    do {
      if (!triangulation.is_infinite(face))
        triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    } while (++face != end);
  }

private:
  // Two orthonormal vectors: the main directions of the neighbors.
  static Eigen::Matrix<double, 3, 2> tangent_plane(const std::vector<Eigen::Vector3d>& vectors)
  {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double size = 0;
    for (const Eigen::Vector3d& v : vectors) {
      mean += v / double(vectors.size() + 1);
      size = (std::max)(size, v.cwiseAbs().maxCoeff());
    }
    Eigen::Matrix3d covariance = mean * mean.transpose() / (size * size);
    for (const Eigen::Vector3d& v : vectors)
      covariance += (v - mean) * (v - mean).transpose() / (size * size);
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().rightCols<2>();
  }

  std::vector<Numbered_point> points_;
  Kd_tree<Search_traits> tree_;
};

// Gives the rows and columns of a matrix other numbers, for a matrix of n rows.
inline Eigen::SparseMatrix<double> with_rows(const Eigen::SparseMatrix<double>& matrix,
                                             const std::vector<std::uint32_t>& row, std::size_t n, double factor)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < matrix.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, c); i; ++i)
      entries.emplace_back(int(row[std::size_t(i.row())]), int(row[std::size_t(c)]), factor * i.value());
  Eigen::SparseMatrix<double> result{Eigen::Index(n), Eigen::Index(n)};
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCover
/// \brief returns the Laplace-Beltrami operator of points that lie near an unknown surface.
///
/// The nearest neighbors of each point are projected to the plane that fits them best; their Delaunay triangulation
/// provides the triangles around the point. The operator belongs to the tufted cover of all these triangles, divided by
/// three, because ideally each triangle appears at all three corners. So it has all properties of `tufted_Laplacian()`,
/// wherever the points are: no positive entry off the diagonal, and no tolerance. It is under the GPL, like the parts
/// of CGAL that it uses.
///
/// \tparam PointRange a range of points whose coordinates are `p[0]`, `p[1]` and `p[2]`; they are rounded to `double`
///
/// \param points the points; the first of several at the same place represents all, and the others have rows of zeros
/// \param n_neighbors the number of neighbors
/// \param np an optional sequence of named parameters, those of `tufted_Laplacian()`. A visitor is asked from the
///   beginning
///
/// \exception Invalid_surface_error if a coordinate is not finite, there are fewer than three different points, or all
///   triangles have zero area
/// \exception Cancelled_error if the visitor asks for it
/// \pre `n_neighbors` is at least 2
///
/// Complexity: O(n log n) for n points in practice.
///
/// Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020, section 5.7.
template <class PointRange, class NamedParameters = parameters::Default_named_parameters>
Tufted_Laplacian point_cloud_Laplacian(const PointRange& points, std::size_t n_neighbors = 30,
                                       const NamedParameters& np = parameters::default_values())
{
  CGAL_precondition(n_neighbors >= 2);
  using Defect = Invalid_surface_error::Defect;
  std::vector<std::array<double, 3>> places; // different ones
  std::vector<std::uint32_t> first_of_place, representative;
  std::map<std::array<double, 3>, std::uint32_t> number_of_place;
  for (const auto& p : points) {
    const std::uint32_t number = std::uint32_t(representative.size());
    // Adding zero turns -0 into 0.
    const std::array<double, 3> place = {to_double(p[0]) + 0., to_double(p[1]) + 0., to_double(p[2]) + 0.};
    for (double x : place)
      if (!std::isfinite(x))
        throw Invalid_surface_error(Defect::NOT_FINITE, number, 1,
                                    "point " + std::to_string(number) + " has a coordinate that is not finite");
    const auto [found, is_new] = number_of_place.insert({place, std::uint32_t(places.size())});
    if (is_new) {
      places.push_back(place);
      first_of_place.push_back(number);
    }
    representative.push_back(first_of_place[found->second]);
  }
  std::vector<internal::Index_triangle> triangles;
  if (places.size() >= 3) {
    internal::Local_triangulations local(places);
    const std::function<bool()> goes_on = internal::go_further_function_of(np);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      if (i % 64 == 0 && goes_on && !goes_on())
        throw Cancelled_error("the Laplacian of points was cancelled");
      local.add_star(i, (std::min)(n_neighbors, places.size() - 1), triangles);
    }
  }
  if (triangles.empty())
    throw Invalid_surface_error(Defect::EMPTY, 0, 1, "the points lie on a line: there is no triangle between them");

  Tufted_Laplacian result = tufted_Laplacian(places, triangles, np);
  result.stiffness = internal::with_rows(result.stiffness, first_of_place, representative.size(), 1. / 3);
  result.mass = internal::with_rows(result.mass, first_of_place, representative.size(), 1. / 3);
  result.minimum_weight /= 3;
  result.report.number_of_vertices = representative.size();
  result.report.merged_vertices = representative.size() - places.size();
  result.representative = std::move(representative);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POINT_CLOUD_LAPLACIAN_H
