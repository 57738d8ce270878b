// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What is wanted at each vertex of a conformal metric: a sum of angles, or the scale u = 0.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/Doubled_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline std::string shown(double x, int digits = 17)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os.precision(digits);
  os << x;
  return os.str();
}

class Conformal_targets
{
public:
  // \exception Invalid_argument_error as discrete_conformal_metric()
  Conformal_targets(const Doubled_surface::Triangulation& surface, const Conformal_options& options)
    : surface_(surface.connectivity()), kinds_(surface_.number_of_vertices(), Kind::ANGLE),
      is_on_border_(kinds_.size()), angles_(kinds_.size(), two_pi)
  {
    for (Vertex_index v : surface_.vertices())
      if (!surface_.halfedge(v).is_valid())
        kinds_[v.idx()] = Kind::ISOLATED;
      else
        is_on_border_[v.idx()] = surface_.is_border(surface_.halfedge(v));
    find_components();
    set_given(options);
    set_border(surface, options);
  }

  // A vertex without an angle keeps its scale.
  bool has_angle(std::size_t v) const { return kinds_[v] == Kind::ANGLE || kinds_[v] == Kind::GIVEN_ANGLE; }
  double angle(std::size_t v) const { return angles_[v]; }
  // Before the sums were corrected.
  double given_angle(std::size_t v) const { return given_angles_[v]; }
  bool can_become_cone(std::size_t v) const { return kinds_[v] == Kind::ANGLE; }
  bool is_chosen(std::size_t v) const { return kinds_[v] == Kind::CONE; }
  void make_cone(std::size_t v)
  {
    kinds_[v] = Kind::CONE;
    components_[component_of_[v]].keeps_scale = true;
    cones_.push_back(Vertex_index(std::uint32_t(v)));
  }

  const std::vector<Vertex_index>& cones() const { return cones_; } // inside the surface

  std::size_t number_of_vertices() const { return kinds_.size(); }

  struct Component
  {
    std::vector<std::size_t> vertices;
    int Euler_characteristic = 0;
    bool keeps_scale = false; // at some vertex
    bool has_border = false;
    double total() const { return two_pi * Euler_characteristic; } // of curvatures
    // The vertex where u is set to 0, one unknown less, if no vertex keeps its scale.
    bool is_pin(std::size_t v) const { return !keeps_scale && v == vertices.front(); }
  };
  const std::vector<Component>& components() const { return components_; }
  const Component& component_of(std::size_t v) const { return components_[component_of_[v]]; }

  // By the theorem of Gauss and Bonnet, the wanted angles must have the right sum, and must leave some angle for other
  // vertices.
  void check_sums()
  {
    given_angles_ = angles_;
    std::vector<std::size_t> last_of(components_.size());
    for (std::size_t v = 0; v < kinds_.size(); ++v)
      last_of[component_of_[v]] = v;
    for (std::size_t v : given_)
      last_of[component_of_[v]] = v;
    for (const Component& component : components_) {
      if (kinds_[component.vertices.front()] == Kind::ISOLATED)
        continue;
      double missing = component.total(), flat = 0; // the latter of vertices that keep their scale
      int border = 0;                               // of them
      for (std::size_t v : component.vertices)
        if (has_angle(v))
          missing -= curvature(v);
        else {
          flat += is_on_border_[v] ? CGAL_PI : two_pi;
          border += is_on_border_[v];
        }
      if (component.keeps_scale) {
        if (flat - missing > 1e-9)
          continue;
        throw Invalid_argument_error(
          std::string("the angles of the ") + (border > 0 ? "free border" : "cones") + " in the component of vertex " +
          std::to_string(component.vertices.front()) + " would have the sum " + shown(flat - missing) +
          ": by the theorem of Gauss and Bonnet, it is " +
          (border > 0
             ? "pi for each of its " + std::to_string(border) + " vertices, and 2 pi for each chosen cone, minus " +
                 shown(missing) + ": give the cones smaller angles, or choose more of them"
             : "2 pi for each cone, minus " + shown(missing) + ": choose " +
                 std::to_string(std::size_t(missing / two_pi + 1e-9) + 1) + " cones or more, or give their angles"));
      }
      if (!(std::abs(missing) <= 1e-9 + 1e-14 * double(component.vertices.size())))
        throw Invalid_argument_error(
          "the angles wanted in the component of vertex " + std::to_string(component.vertices.front()) +
          " have the wrong sum: by the theorem of Gauss and Bonnet, the sums of angles have to be smaller by " +
          shown(missing) +
          " in total; the sum of 2 pi minus the angle, or of pi minus the angle on the border, has to be " +
          shown(component.total()) + ": name other angles, or let cones be chosen");
      angles_[last_of[component_of_[component.vertices.front()]]] -= missing;
    }
  }

private:
  static constexpr double two_pi = 2 * CGAL_PI;

  enum class Kind {
    ISOLATED,
    ANGLE,
    GIVEN_ANGLE,
    SCALE,
    CONE
  };

  void find_components()
  {
    Disjoint_sets sets(kinds_.size());
    for (Edge_index e : surface_.edges())
      sets.unite(surface_.source(surface_.halfedge(e)).idx(), surface_.target(surface_.halfedge(e)).idx());
    components_.resize(sets.number(component_of_));
    for (std::size_t v = 0; v < kinds_.size(); ++v) {
      components_[component_of_[v]].vertices.push_back(v);
      components_[component_of_[v]].has_border |= is_on_border_[v];
      ++components_[component_of_[v]].Euler_characteristic;
    }
    for (Edge_index e : surface_.edges())
      --components_[component_of_[surface_.source(surface_.halfedge(e)).idx()]].Euler_characteristic;
    for (Face_index f : surface_.faces())
      ++components_[component_of_[surface_.source(surface_.halfedge(f)).idx()]].Euler_characteristic;
  }

  void set_given(const Conformal_options& options)
  {
    if (!options.boundary_angles.empty() && options.boundary != Conformal_boundary::ANGLES)
      throw Invalid_argument_error("angles of the border are given, but it shall be free, or a disk: omit one of them");
    for (const bool on_border : {false, true})
      for (const auto& [vertex, angle] : on_border ? options.boundary_angles : options.cone_angles) {
        require_vertex(vertex, kinds_.size());
        const std::size_t v = vertex.idx();
        const std::string name = "vertex " + std::to_string(v);
        if (kinds_[v] == Kind::GIVEN_ANGLE)
          throw Invalid_argument_error("two angles are given for " + name);
        if (kinds_[v] == Kind::ISOLATED)
          throw Invalid_argument_error("an angle is given for " + name + ", which has no face");
        if (is_on_border_[v] != on_border)
          throw Invalid_argument_error(on_border
                                         ? "an angle of the border is given for " + name +
                                             ", which is not on the border: name it as a cone"
                                         : "an angle of a cone is given for " + name +
                                             ", which is on the border: name it among the angles of the border");
        if (!(angle > 0 && angle < (std::numeric_limits<double>::max)()))
          throw Invalid_argument_error("the angle given for " + name + " is not positive and finite");
        kinds_[v] = Kind::GIVEN_ANGLE;
        angles_[v] = angle;
        given_.push_back(v);
        if (!on_border)
          cones_.push_back(vertex);
      }
  }

  void set_border(const Doubled_surface::Triangulation& surface, const Conformal_options& options)
  {
    const auto for_each_border_vertex = [&](const auto& f) {
      for (std::size_t v = 0; v < kinds_.size(); ++v)
        if (is_on_border_[v])
          f(v);
    };
    if (options.boundary == Conformal_boundary::FREE) {
      for_each_border_vertex([&](std::size_t v) {
        kinds_[v] = Kind::SCALE;
        components_[component_of_[v]].keeps_scale = true;
      });
      return;
    }
    for_each_border_vertex([&](std::size_t v) {
      if (kinds_[v] != Kind::GIVEN_ANGLE)
        angles_[v] = CGAL_PI;
      kinds_[v] = Kind::GIVEN_ANGLE;
    });
    if (options.boundary == Conformal_boundary::ANGLES)
      return;
    std::vector<double> perimeters(components_.size(), 0.), turns(components_.size());
    for (std::size_t i = 0; i < components_.size(); ++i)
      turns[i] = components_[i].total();
    for (Vertex_index v : cones_)
      turns[component_of_[v.idx()]] -= curvature(v.idx());
    const auto for_each_border_halfedge = [&](const auto& to) {
      for (Halfedge_index h : surface_.halfedges())
        if (surface_.is_border(h))
          to(h);
    };
    for_each_border_halfedge([&](Halfedge_index h) {
      perimeters[component_of_[surface_.source(h).idx()]] += surface.length(surface_.edge(h));
    });
    for_each_border_halfedge([&](Halfedge_index h) {
      for (Vertex_index v : {surface_.source(h), surface_.target(h)}) {
        const std::size_t i = component_of_[v.idx()];
        angles_[v.idx()] -= turns[i] * (surface.length(surface_.edge(h)) / (2 * perimeters[i]));
      }
    });
    for_each_border_vertex([&](std::size_t v) {
      if (!(angles_[v] > 0))
        throw Invalid_argument_error("the border cannot become a convex polygon: an edge at vertex " +
                                     std::to_string(v) + " is too long a part of it; leave the border free");
      given_.push_back(v);
    });
  }

  double curvature(std::size_t v) const { return (is_on_border_[v] ? CGAL_PI : two_pi) - angles_[v]; }

  const Delta_complex& surface_;
  std::vector<Kind> kinds_;
  std::vector<bool> is_on_border_;
  std::vector<double> angles_, given_angles_;
  std::vector<std::size_t> component_of_, given_;
  std::vector<Component> components_;
  std::vector<Vertex_index> cones_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_TARGETS_H
