// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Header-only, or compiled once: what a program chooses when it is built.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONFIG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONFIG_H

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief By default the package is header-only. If `CGAL_INTRINSIC_TRIANGULATIONS_COMPILED` is defined, as the CMake target
/// `Intrinsic_triangulations::compiled` does, what is no template of the user's types comes from a library: programs compile in
/// half the time, and do the same.
///
/// Definitions stand in files whose names end in `_impl.h`. A header includes those of its classes unless the macro is defined.
#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE
#else
#define CGAL_INTRINSIC_TRIANGULATIONS_INLINE inline
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONFIG_H
