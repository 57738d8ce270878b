// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results do not depend on the processor modes that the program has set, and leave them unchanged.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cstdint>
#include <limits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// fegetround() tells that of the x87 unit.
bool rounds_to_nearest()
{
  volatile double one = 1, small = 1e-30;
  return one + small == one && one - small == one;
}

// The C library of Windows computes with these.
bool rounds_long_doubles_to_nearest()
{
  volatile long double one = 1, small = 1e-60L;
  return one + small == one && one - small == one;
}

// The register of the processor where a bit says that subnormal numbers become zero.
#if defined(CGAL_HAS_SSE2)
#define CAN_FLUSH_TO_ZERO
using Control = unsigned int;
constexpr Control flushing = 0x8040;
Control control() { return _mm_getcsr(); }
void set_control(Control c) { _mm_setcsr(c); }
#elif defined(__GNUC__) && defined(__aarch64__)
#define CAN_FLUSH_TO_ZERO
using Control = std::uint64_t;
constexpr Control flushing = 0x1000000;
Control control()
{
  Control result;
  asm volatile("mrs %0, fpcr" : "=r"(result));
  return result;
}
void set_control(Control c) { asm volatile("msr fpcr, %0" : : "r"(c) : "memory"); }
#else
using Control = int;
constexpr Control flushing = 0;
Control control() { return 0; }
void set_control(Control) {}
#endif

// A mode of the processor, until the end of its scope.
class Mode
{
public:
  explicit Mode(int rounding, bool flushes = false) : before_(control())
  {
    if (flushes)
      set_control(before_ | flushing);
    std::fesetround(rounding);
  }
  ~Mode()
  {
    std::fesetround(FE_TONEAREST);
    set_control(before_);
  }

private:
  Control before_;
};

// All kinds of numbers and decisions of a surface, in one row.
std::vector<double> results(const samples::Indexed_triangles& surface)
{
  auto [t, report] = IT::intrinsic_Delaunay_triangulation(surface.points, surface.triangles);
  std::vector<double> row{double(report.flips), double(IT::verify_Delaunay(t).ties)};
  const auto add_numbers = [&row, &t = t] {
    for (IT::Halfedge_index h : t.connectivity().halfedges())
      row.push_back(double(t.connectivity().target(h).idx()));
    for (IT::Edge_index e : t.connectivity().edges()) {
      row.push_back(t.length(e));
      row.push_back(t.is_locally_Delaunay(e) == true);
    }
    for (IT::Face_index f : t.connectivity().faces())
      row.push_back(t.area(f));
    for (double weight : IT::cotangent_weights(t))
      row.push_back(weight);
  };
  add_numbers();
  const IT::Common_subdivision subdivision(t);
  for (IT::Overlay::Vertex x : subdivision.overlay().crossings())
    row.push_back(subdivision.positions().on_input_edge(x));
  IT::refine_Delaunay(t, CGAL::parameters::maximum_number(20));
  row.push_back(double(IT::verify_Delaunay(t).not_Delaunay.size()));
  add_numbers();
  return row;
}

TEST(Standard_arithmetic, is_set_and_the_old_mode_returns)
{
  for (int rounding : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const Mode mode(rounding);
    {
      const IT::internal::Standard_arithmetic arithmetic;
      arithmetic.check();
      EXPECT_TRUE(rounds_to_nearest());
#ifdef __MINGW32__
      EXPECT_TRUE(rounds_long_doubles_to_nearest());
#endif
    }
    EXPECT_EQ(rounds_to_nearest(), rounding == FE_TONEAREST);
    EXPECT_EQ(rounds_long_doubles_to_nearest(), rounding == FE_TONEAREST);
  }
}

#ifdef CAN_FLUSH_TO_ZERO
TEST(Standard_arithmetic, keeps_subnormal_numbers)
{
  const auto half_of_smallest_normal = [] {
    volatile double x = (std::numeric_limits<double>::min)();
    return x / 2;
  };
  const Mode mode(FE_TONEAREST, true);
  {
    const IT::internal::Standard_arithmetic arithmetic;
    EXPECT_GT(half_of_smallest_normal(), 0);
  }
  EXPECT_EQ(half_of_smallest_normal(), 0);
}
#endif

TEST(Standard_arithmetic, results_do_not_depend_on_the_mode)
{
  const std::vector<samples::Indexed_triangles> surfaces{
    samples::prism(20, 7), samples::latitude_longitude_sphere(12, 6), samples::cap(1e-150)};
  for (const samples::Indexed_triangles& surface : surfaces) {
    const std::vector<double> expected = results(surface);
    for (int rounding : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
      for (bool flushes : {false, true}) {
        const Mode mode(rounding, flushes);
        const std::vector<double> found = results(surface);
        EXPECT_EQ(rounds_to_nearest(), rounding == FE_TONEAREST);
        EXPECT_TRUE(found == expected) << "rounding " << rounding << ", subnormal numbers "
                                       << (flushes ? "flushed" : "kept");
      }
  }
}

} // namespace
