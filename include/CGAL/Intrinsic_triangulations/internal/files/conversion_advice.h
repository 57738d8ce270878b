// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Which program makes a file that can be read of one that cannot.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// "; convert it: COMMAND" with a command for the shell, or nothing if the extension is that of no format that is known to be converted.
std::string conversion_advice(const std::string& path);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/files/conversion_advice_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_H
