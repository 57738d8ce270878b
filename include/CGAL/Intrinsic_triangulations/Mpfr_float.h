// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Floating-point numbers of a chosen precision, as a number type of CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>

#include <boost/multiprecision/mpfr.hpp>

#include <mpfr.h>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief a floating-point number of MPFR, with the default precision at its construction (see `Mpfr_precision`).
///
/// The result of an operation has the larger precision of its operands and is rounded to
/// nearest. There are no expression templates, so `auto` is safe.
///
/// \cgalModels{FieldWithSqrt,RealEmbeddable}
using Mpfr_float =
  boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief returns the precision of a number in bits.
/// \param x the number
inline int precision_in_bits(const Mpfr_float& x) { return int(mpfr_get_prec(x.backend().data())); }

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief sets the precision of new `Mpfr_float`s during its lifetime.
///
/// Boost counts decimal digits; the precision becomes that of the fewest digits with at least the given number of bits:
/// 65 for 64, 128 for 128, 257 for 256.
///
/// \warning Only a Boost that has `thread_default_precision()` keeps a default for each thread. Boost 1.74 has one for
/// all threads: there, do not use two precisions at the same time.
class Mpfr_precision
{
public:
  /// sets the precision to at least `bits` bits.
  explicit Mpfr_precision(int bits) : old_digits_(Own_default::digits())
  {
    // log10(2) = 0.30103; two digits less leave the rest to the loop.
    unsigned d = bits > 16 ? unsigned(0.301 * bits) - 2 : 1;
    Own_default::set_digits(d);
    while (precision_in_bits(Mpfr_float()) < bits)
      Own_default::set_digits(++d);
    bits_ = precision_in_bits(Mpfr_float());
  }
  /// restores the precision.
  ~Mpfr_precision() { Own_default::set_digits(old_digits_); }
  /// \cond SKIP_IN_MANUAL
  Mpfr_precision(const Mpfr_precision&) = delete;
  Mpfr_precision& operator=(const Mpfr_precision&) = delete;
  /// \endcond

  /// returns the precision that was set, in bits.
  int bits() const { return bits_; }

private:
  // Boost's default, for this thread if Boost keeps one for each.
  template <class Number, class = void>
  struct Default
  {
    static unsigned digits() { return Number::default_precision(); }
    static void set_digits(unsigned d) { Number::default_precision(d); }
  };
  template <class Number>
  struct Default<Number, decltype(void(Number::thread_default_precision()))>
  {
    static unsigned digits() { return Number::thread_default_precision(); }
    static void set_digits(unsigned d) { Number::thread_default_precision(d); }
  };
  using Own_default = Default<Mpfr_float>;

  unsigned old_digits_;
  int bits_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H
