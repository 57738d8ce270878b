// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor of flips for the commands that run the library themselves.

#ifndef IDT_FLIP_WATCH_H
#define IDT_FLIP_WATCH_H

#include "system/Interruption.h"
#include "system/Progress.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <cstdint>

namespace idt {

// Shows how far the flips are, and ends them when asked to.
struct Flip_watch
{
  Progress& progress;
  bool go_further(const CGAL::Intrinsic_triangulations::Progress& done)
  {
    progress.show_flips(done.tests, done.flips);
    return !is_interrupted();
  }
};

} // namespace idt

#endif // IDT_FLIP_WATCH_H
