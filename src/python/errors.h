// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exceptions of the library as those of the Python package.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_ERRORS_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_ERRORS_H

namespace idt_python {

// For the extension module that calls it.
void register_errors();

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_ERRORS_H
