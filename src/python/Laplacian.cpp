// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Laplace-Beltrami operator of any triangles.

#include "python/Signal_watch.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <pybind11/stl.h>

#include <sstream>
#include <string>
#include <vector>

namespace idt_python {

namespace {

py::tuple Laplacian_of_triangles(const Doubles& points, const Indices& triangles, double mollification, bool is_lumped)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const auto options = CGAL::parameters::mollification(mollification)
                         .mass_type(is_lumped ? IT::Mass_type::LUMPED : IT::Mass_type::GALERKIN)
                         .visitor(Signal_visitor());
  IT::Tufted_Laplacian result = without_lock([&] { return IT::tufted_Laplacian(rows, faces, options); });
  return py::make_tuple(to_sparse(std::move(result.stiffness)), to_sparse(std::move(result.mass)));
}

// The text about gaps.
std::vector<std::string> gaps(const Doubles& points, const Indices& triangles)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const IT::Surface_report report = without_lock([&] { return IT::find_gaps(rows, faces); });
  std::ostringstream advice;
  advice << "repair(V, F, stitching_tolerance=" << report.stitching_tolerance << ") joins them";
  std::vector<std::string> texts;
  for (const IT::Gap& gap : report.gaps)
    texts.push_back(IT::message(gap, advice.str()));
  return texts;
}

} // namespace

void add_Laplacian(py::module_& module)
{
  module.def("laplacian", &Laplacian_of_triangles, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("mollification"), py::arg("is_lumped"));
  module.def("gaps", &gaps, py::arg("points").noconvert(), py::arg("triangles").noconvert());
}

} // namespace idt_python
