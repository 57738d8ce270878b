// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What is wanted at each vertex of a conformal metric: a sum of angles, or the scale u = 0.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Conformal_targets
{
public:
  // \param lengths of the edges of the surface's input
  // \exception Invalid_argument_error as discrete_conformal_metric()
  Conformal_targets(const Delta_complex& surface, const std::vector<double>& border_lengths,
                    const Conformal_options& options);

  // A vertex without an angle keeps its scale.
  bool has_angle(std::size_t v) const { return kinds_[v] == Kind::ANGLE || kinds_[v] == Kind::GIVEN_ANGLE; }
  double angle(std::size_t v) const { return angles_[v]; }
  bool can_become_cone(std::size_t v) const { return kinds_[v] == Kind::ANGLE; }
  bool is_chosen(std::size_t v) const { return kinds_[v] == Kind::CONE; }
  void make_cone(std::size_t v);
  const std::vector<Vertex_index>& cones() const { return cones_; } // inside the surface

  std::size_t number_of_vertices() const { return kinds_.size(); }

  struct Component
  {
    std::vector<std::size_t> vertices;
    double total = 0;         // 2π times the Euler characteristic
    bool keeps_scale = false; // at some vertex
    // One unknown less, where u is 0 for now, if no vertex keeps its scale.
    bool is_pin(std::size_t v) const { return !keeps_scale && v == vertices.front(); }
  };
  const std::vector<Component>& components() const { return components_; }
  const Component& component_of(std::size_t v) const { return components_[component_of_[v]]; }

  // The theorem of Gauss and Bonnet: angles that are wanted have the right sum, and leave some for other vertices.
  void check_sums();

private:
  enum class Kind {
    ISOLATED,
    ANGLE,
    GIVEN_ANGLE,
    SCALE,
    CONE
  };

  void find_components();
  void set_given(const Conformal_options& options);
  void set_border(const std::vector<double>& border_lengths, const Conformal_options& options);
  double curvature(std::size_t v) const;

  const Delta_complex& surface_;
  std::vector<Kind> kinds_;
  std::vector<bool> is_on_border_;
  std::vector<double> angles_;
  std::vector<std::size_t> component_of_, given_;
  std::vector<Component> components_;
  std::vector<Vertex_index> cones_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H
