// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Floating-point numbers of a chosen precision, as a number type of CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/boost_mp.h>
#include <CGAL/enum.h>
#include <CGAL/functional.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/multiprecision/mpfr.hpp>

#include <mpfr.h>

#include <type_traits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief a floating-point number of MPFR, of the precision that is the default when it is
/// constructed (see `Mpfr_precision`).
///
/// The result of an operation has the larger precision of its operands and is rounded to
/// nearest. Without expression templates, so that `auto` is safe.
///
/// \cgalModels `FieldWithSqrt`, `RealEmbeddable`
using Mpfr_float = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>,
                                                 boost::multiprecision::et_off>;

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief returns the precision of `x` in bits.
inline int precision_in_bits(const Mpfr_float& x)
{
  return int(mpfr_get_prec(x.backend().data()));
}

/// \ingroup PkgIntrinsicTriangulationsNumbers
/// \brief sets the precision of new `Mpfr_float`s for as long as it lives.
///
/// Boost counts decimal digits; the precision is that of the least number of digits with
/// at least the given number of bits: 65 for 64, 128 for 128, 257 for 256.
///
/// \warning Only a Boost that has `thread_default_precision()` keeps a default for each
/// thread. Boost 1.74 has one for all threads: there, use no two precisions at the same
/// time.
class Mpfr_precision
{
public:
  /// sets the precision to at least `bits` bits.
  explicit Mpfr_precision(int bits) : old_digits_(digits(Own_default()))
  {
    // log10(2) = 0.30103; two digits less leave the rest to the loop.
    unsigned d = bits > 16 ? unsigned(0.301 * bits) - 2 : 1;
    set_digits(d, Own_default());
    while (precision_in_bits(Mpfr_float()) < bits)
      set_digits(++d, Own_default());
    bits_ = precision_in_bits(Mpfr_float());
  }
  /// restores the precision.
  ~Mpfr_precision() { set_digits(old_digits_, Own_default()); }
  /// \cond SKIP_IN_MANUAL
  Mpfr_precision(const Mpfr_precision&) = delete;
  Mpfr_precision& operator=(const Mpfr_precision&) = delete;
  /// \endcond

  /// returns the precision that was set, in bits.
  int bits() const { return bits_; }

private:
  // Whether Boost keeps a default for each thread.
  template <class Number, class = void>
  struct Has_thread_default : std::false_type
  {};
  template <class Number>
  struct Has_thread_default<Number, decltype(void(Number::thread_default_precision()))>
    : std::true_type
  {};
  using Own_default = Has_thread_default<Mpfr_float>;

  // Templates, because only one of each two exists in a version of Boost.
  template <class Number = Mpfr_float>
  static unsigned digits(std::true_type)
  {
    return Number::thread_default_precision();
  }
  template <class Number = Mpfr_float>
  static unsigned digits(std::false_type)
  {
    return Number::default_precision();
  }
  template <class Number = Mpfr_float>
  static void set_digits(unsigned d, std::true_type)
  {
    Number::thread_default_precision(d);
  }
  template <class Number = Mpfr_float>
  static void set_digits(unsigned d, std::false_type)
  {
    Number::default_precision(d);
  }

  unsigned old_digits_;
  int bits_;
};

} // namespace Intrinsic_triangulations

/// \cond SKIP_IN_MANUAL

// CGAL 5.5 declares these templates for all numbers of Boost.Multiprecision and defines
// them for integers and rationals; later versions may define more. A full specialization
// goes before either.

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::Mpfr_float>
  : public Algebraic_structure_traits_base<Intrinsic_triangulations::Mpfr_float, Field_with_sqrt_tag>
{
public:
  using Type = Intrinsic_triangulations::Mpfr_float;
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  class Is_zero : public CGAL::cpp98::unary_function<Type, bool>
  {
  public:
    bool operator()(const Type& x) const { return mpfr_zero_p(x.backend().data()) != 0; }
  };

  class Sqrt : public CGAL::cpp98::unary_function<Type, Type>
  {
  public:
    Type operator()(const Type& x) const { return boost::multiprecision::sqrt(x); }
  };
};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::Mpfr_float>
  : public INTERN_RET::Real_embeddable_traits_base<Intrinsic_triangulations::Mpfr_float, Tag_true>
{
public:
  using Type = Intrinsic_triangulations::Mpfr_float;

  class Is_finite : public CGAL::cpp98::unary_function<Type, bool>
  {
  public:
    bool operator()(const Type& x) const { return mpfr_number_p(x.backend().data()) != 0; }
  };

  class Abs : public CGAL::cpp98::unary_function<Type, Type>
  {
  public:
    Type operator()(const Type& x) const { return boost::multiprecision::abs(x); }
  };

  class Sgn : public CGAL::cpp98::unary_function<Type, ::CGAL::Sign>
  {
  public:
    ::CGAL::Sign operator()(const Type& x) const
    {
      const int sign = mpfr_sgn(x.backend().data());
      return sign < 0 ? NEGATIVE : sign > 0 ? POSITIVE
                                            : ZERO;
    }
  };

  class Compare : public CGAL::cpp98::binary_function<Type, Type, Comparison_result>
  {
  public:
    Comparison_result operator()(const Type& x, const Type& y) const
    {
      const int order = mpfr_cmp(x.backend().data(), y.backend().data());
      return order < 0 ? SMALLER : order > 0 ? LARGER
                                             : EQUAL;
    }
    CGAL_IMPLICIT_INTEROPERABLE_BINARY_OPERATOR_WITH_RT(Type, Comparison_result)
  };

  // To nearest.
  class To_double : public CGAL::cpp98::unary_function<Type, double>
  {
  public:
    double operator()(const Type& x) const { return mpfr_get_d(x.backend().data(), MPFR_RNDN); }
  };

  // The two doubles next to the number.
  class To_interval : public CGAL::cpp98::unary_function<Type, std::pair<double, double>>
  {
  public:
    std::pair<double, double> operator()(const Type& x) const
    {
      return {mpfr_get_d(x.backend().data(), MPFR_RNDD), mpfr_get_d(x.backend().data(), MPFR_RNDU)};
    }
  };
};

/// \endcond

} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MPFR_FLOAT_H
