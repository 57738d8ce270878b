// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The parts of the extension modules, one for each source.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_BINDINGS_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_BINDINGS_H

#include <pybind11/pybind11.h>

namespace idt_python {

// Translates the library's exceptions to those of the Python package, for the extension module that calls this.
void register_errors();

void add_Laplacian(pybind11::module_& module);
void add_conformal_maps(pybind11::module_& module);
void add_files(pybind11::module_& module);
void add_triangulation(pybind11::module_& module);
void add_simplification(pybind11::module_& module);
void add_subdivision(pybind11::module_& module);
void add_heat(pybind11::module_& module);
void add_geodesics(pybind11::module_& module);
void add_lines(pybind11::module_& module);
void add_vectors(pybind11::module_& module);

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_BINDINGS_H
