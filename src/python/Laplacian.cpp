// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Laplace-Beltrami operator of any triangles.

#include "python/Signal_watch.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

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

} // namespace

void add_Laplacian(py::module_& module)
{
  module.def("laplacian", &Laplacian_of_triangles, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("mollification"), py::arg("is_lumped"));
}

} // namespace idt_python
