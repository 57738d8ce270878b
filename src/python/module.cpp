// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The extension module below the Python package, which checks arguments and contains the documentation. It includes
// LGPL headers only.

#include "python/bindings.h"

PYBIND11_MODULE(_core, module)
{
  module.doc() = "The compiled core of the package intrinsic_triangulations.";
  module.attr("version") = INTRINSIC_TRIANGULATIONS_VERSION;
  idt_python::register_errors();
  idt_python::add_conformal_maps(module);
  idt_python::add_files(module);
  idt_python::add_Laplacian(module);
  idt_python::add_triangulation(module);
  idt_python::add_simplification(module);
  idt_python::add_subdivision(module);
  idt_python::add_heat(module);
  idt_python::add_geodesics(module);
  idt_python::add_lines(module);
  idt_python::add_vectors(module);
}
