// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The arithmetic that error bounds and error-free transformations assume: IEEE 754, rounded to nearest.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_STANDARD_ARITHMETIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_STANDARD_ARITHMETIC_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/unfused.h>

#include <CGAL/FPU.h>

#include <boost/config.hpp>

#include <cfenv>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// While an object of this class lives, its thread rounds to nearest and keeps subnormal numbers, whatever was set
// before: by fesetround(), or by a library that was linked with -ffast-math and flushes them to zero. The old mode
// returns at the end.
class Standard_arithmetic
{
public:
  Standard_arithmetic() : before_(mode())
  {
    if (BOOST_UNLIKELY((before_ & other_modes) != 0))
      set_mode(before_ & ~other_modes);
  }
  Standard_arithmetic(const Standard_arithmetic&) = delete;
  Standard_arithmetic& operator=(const Standard_arithmetic&) = delete;
  ~Standard_arithmetic()
  {
    if (BOOST_UNLIKELY((before_ & other_modes) != 0))
      set_mode(before_);
  }

  // Checks for options that no macro reveals and that setting the processor's mode does not cure: Clang has no macros
  // for -fassociative-math and -freciprocal-math.
  // \exception Arithmetic_error if doubles do not follow IEEE 754
  void check() const
  {
    const double one = unfused(1.), large = unfused(0x1p60);
    if (BOOST_UNLIKELY((one + large) - large != 0 || unfused(5.) / 3 != 0x1.aaaaaaaaaaaabp+0 || flushes_to_zero()))
      throw Arithmetic_error(
        "doubles do not follow IEEE 754: compile without -ffast-math and the options that it implies");
  }

private:
#if defined(CGAL_HAS_SSE2) && defined(__MINGW32__)
  // The C library computes in the x87 unit, whose rounding mode fesetround() sets as well: two bits, here stored next
  // to those of the other unit.
  using Mode = std::uint32_t;
  static constexpr Mode x87_rounding = 0xc00, other_modes = x87_rounding << 16 | 0xe040;
  static Mode mode() { return _mm_getcsr() | (x87_mode() & x87_rounding) << 16; }
  static void set_mode(Mode mode)
  {
    _mm_setcsr(mode & 0xffff);
    const std::uint16_t x87 = std::uint16_t((x87_mode() & ~x87_rounding) | (mode >> 16 & x87_rounding));
    asm volatile("fldcw %0" : : "m"(x87) : "memory");
  }
  static Mode x87_mode()
  {
    std::uint16_t result;
    asm volatile("fnstcw %0" : "=m"(result));
    return result;
  }
  static bool flushes_to_zero() { return false; }
#elif defined(CGAL_HAS_SSE2)
  using Mode = unsigned int;
  static constexpr Mode other_modes = 0xe040; // two bits for the rounding, flush to zero, denormals are zero
  static Mode mode() { return _mm_getcsr(); }
  static void set_mode(Mode mode) { _mm_setcsr(mode); }
  static bool flushes_to_zero() { return false; }
#elif defined(__GNUC__) && defined(__aarch64__)
  using Mode = std::uint64_t;
  static constexpr Mode other_modes = 0x1c00000; // two bits for the rounding, flush to zero
  static Mode mode()
  {
    Mode result;
    asm volatile("mrs %0, fpcr" : "=r"(result));
    return result;
  }
  static void set_mode(Mode mode) { asm volatile("msr fpcr, %0" : : "r"(mode) : "memory"); }
  static bool flushes_to_zero() { return false; }
#else
  using Mode = int;
  static constexpr Mode other_modes = ~FE_TONEAREST;
  static Mode mode() { return std::fegetround(); }
  static void set_mode(Mode mode) { std::fesetround((mode & other_modes) == 0 ? FE_TONEAREST : mode); }
  static bool flushes_to_zero() { return unfused((std::numeric_limits<double>::min)()) / 2 == 0; }
#endif

  Mode before_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_STANDARD_ARITHMETIC_H
