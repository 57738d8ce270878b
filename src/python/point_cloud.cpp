// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Laplace-Beltrami operator of points: an extension module of its own, because it includes a GPL header.

#include "python/Signal_watch.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/point_cloud_Laplacian.h>

namespace idt_python {

namespace {

py::tuple point_cloud_Laplacian(const Doubles& points, std::size_t number_of_neighbors)
{
  require(number_of_neighbors >= 2, "there have to be two neighbors or more");
  const Rows<double> rows(points);
  IT::Tufted_Laplacian result = without_lock(
    [&] { return IT::point_cloud_Laplacian(rows, number_of_neighbors, CGAL::parameters::visitor(Signal_visitor())); });
  return py::make_tuple(to_sparse(std::move(result.stiffness)), to_sparse(std::move(result.mass)));
}

} // namespace

} // namespace idt_python

PYBIND11_MODULE(_point_cloud, module)
{
  module.doc() = "Point cloud Laplacians for the package intrinsic_triangulations, under the GPL.";
  idt_python::register_errors();
  module.def("laplacian", &idt_python::point_cloud_Laplacian, pybind11::arg("points").noconvert(),
             pybind11::arg("number_of_neighbors"));
}
