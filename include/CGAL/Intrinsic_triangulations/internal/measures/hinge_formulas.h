// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The formulas for one triangle and one hinge, on a bare number type.
//
// Notation: s_ij is the squared length of edge ij, a_ijk is four times the area of
// triangle ijk. A hinge is an edge ij with the triangle (i, j, k) to its left and
// (j, i, l) to its right.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_HINGE_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_HINGE_FORMULAS_H

#include <CGAL/Uncertain.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsFormulas
/// @{

/// \brief the data on which the decisions and the flip of an edge depend: those of the five
/// edges and the two faces of a hinge.
template <class Edge_data, class Face_data>
struct Hinge
{
  const Edge_data& ij;  ///< the edge itself
  const Edge_data& jk;  ///< from j to the corner k on its left
  const Edge_data& ki;  ///< from k to i
  const Edge_data& il;  ///< from i to the corner l on its right
  const Edge_data& lj;  ///< from l to j
  const Face_data& ijk; ///< the face to the left
  const Face_data& jil; ///< the face to the right
};

/// \brief the data of a hinge's other diagonal and of the two faces beside it.
template <class Edge_data, class Face_data>
struct Flipped_hinge
{
  Edge_data kl;  ///< the other diagonal
  Face_data ilk; ///< the new face at i
  Face_data jkl; ///< the new face at j
};

/// \brief returns `p = s_a + s_b − s_c`, twice the scalar product of the sides a and b of a
/// triangle as seen from their common corner, where c is the opposite side.
///
/// `p` over four times the area is the cotangent of that corner.
template <class FT>
FT twice_scalar_product(const FT& s_a, const FT& s_b, const FT& s_c)
{
  return s_a + s_b - s_c;
}

/// \brief returns the square of four times the area of a triangle, by Heron's formula:
/// `q = 4 s_ij s_jk − (s_ij + s_jk − s_ki)²`.
template <class FT>
FT squared_four_areas(const FT& s_ij, const FT& s_jk, const FT& s_ki)
{
  const FT p = twice_scalar_product(s_ij, s_jk, s_ki);
  return FT(4) * s_ij * s_jk - p * p;
}

namespace internal {

// Sorts so that a >= b >= c. If intervals overlap, any order will do.
template <class FT>
void sort_lengths(FT& a, FT& b, FT& c)
{
  if (certainly(a < b))
    std::swap(a, b);
  if (certainly(b < c))
    std::swap(b, c);
  if (certainly(a < b))
    std::swap(a, b);
}

} // namespace internal

/// \brief returns the square of four times the area of a triangle from its lengths, in
/// an order of operations that is accurate even for slivers.
///
/// Unless it underflows, the value is negative exactly if the lengths violate the triangle
/// inequality: the sign of the decisive factor is computed exactly in floating point.
/// Source: W. Kahan, "Miscalculating area and angles of a needle-like triangle".
template <class FT>
FT squared_four_areas_from_lengths(FT a, FT b, FT c)
{
  internal::sort_lengths(a, b, c);
  return (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
}

/// \brief returns whether three lengths certainly violate the triangle inequality; exact in
/// floating point, whatever their magnitude.
///
/// It computes only the decisive factor of `squared_four_areas_from_lengths()`, as the product can underflow.
template <class FT>
bool violate_triangle_inequality(FT a, FT b, FT c)
{
  internal::sort_lengths(a, b, c);
  return certainly(c - (a - b) < FT(0));
}

/// \brief returns `p_k a_jil + p_l a_ijk`, whose sign is that of `cot k + cot l`.
///
/// It needs neither a division nor a square root.
template <class FT>
FT Delaunay_value(const FT& p_k, const FT& a_ijk, const FT& p_l, const FT& a_jil)
{
  return p_k * a_jil + p_l * a_ijk;
}

/// \brief computes squared length and areas after the flip of ij to kl.
///
/// With i at the origin and j on the first axis, k has the coordinates `(x_k, a_ijk) / (2 √s_ij)` and l has `(x_l,
/// −a_jil) / (2 √s_ij)`, where `x_k = s_ki + s_ij − s_jk` and `x_l = s_il + s_ij − s_lj`. Hence `s_kl = ((x_k − x_l)² +
/// (a_ijk + a_jil)²) / (4 s_ij)`, `a_ilk = (x_k a_jil + x_l a_ijk) / (2 s_ij)`, and with `y = 2 s_ij − x` `a_jkl = (y_k
/// a_jil + y_l a_ijk) / (2 s_ij)`. This takes one division, no root, and no differences except in x and y. If all
/// radicals in the input are areas of input faces, so are all in the output: radicals never nest.
template <class FT>
void flip_hinge(const FT& s_ij, const FT& s_jk, const FT& s_ki, const FT& s_il, const FT& s_lj, const FT& a_ijk,
                const FT& a_jil, FT& s_kl, FT& a_ilk, FT& a_jkl)
{
  const FT x_k = twice_scalar_product(s_ki, s_ij, s_jk);
  const FT x_l = twice_scalar_product(s_il, s_ij, s_lj);
  const FT y_k = twice_scalar_product(s_jk, s_ij, s_ki);
  const FT y_l = twice_scalar_product(s_lj, s_ij, s_il);
  const FT r = FT(1) / (s_ij + s_ij);
  const FT along = x_k - x_l;
  const FT across = a_ijk + a_jil;
  s_kl = (along * along + across * across) * r / FT(2);
  a_ilk = (x_k * a_jil + x_l * a_ijk) * r;
  a_jkl = (y_k * a_jil + y_l * a_ijk) * r;
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_HINGE_FORMULAS_H
