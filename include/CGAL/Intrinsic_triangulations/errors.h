// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The exceptions of the package: errors that users can cause by input throw one of these in every build; programming
// errors are CGAL preconditions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ERRORS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ERRORS_H

#include <CGAL/Intrinsic_triangulations/Index.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsErrors
/// @{

/// \brief the base of every exception that the package throws.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \brief is thrown if the input is not a surface with a metric.
///
/// The message names the first offending element and how many more there are.
class Invalid_surface_error : public Error
{
public:
  /// the kinds of defects: first those that `examine_polygons()` finds, in the order in which to fix them.
  enum class Defect {
    EMPTY,                    ///< there is no face
    BAD_INDEX,                ///< a face names a vertex that does not exist
    NOT_FINITE,               ///< a coordinate or a length is NaN or infinite
    NOT_A_TRIANGLE,           ///< a face has fewer or more than three corners
    REPEATED_CORNER,          ///< a face names a vertex twice
    DUPLICATE_FACE,           ///< a face has the three corners of an earlier one
    NON_MANIFOLD_EDGE,        ///< an edge has more than two faces
    INCONSISTENT_ORIENTATION, ///< the two faces of an edge traverse it in the same direction
    NON_MANIFOLD_VERTEX,      ///< the faces around a vertex form more than one fan
    ZERO_LENGTH_EDGE,         ///< the ends of an edge coincide
    OUT_OF_RANGE,             ///< squared lengths over- or underflow, or there are too many elements
    DEGENERATE_FACE,          ///< a face of zero area: no error unless the number type cannot handle it
    UNREFERENCED_VERTEX,      ///< a vertex belongs to no face: never an error
    SEVERAL_COMPONENTS,       ///< the surface is in several pieces: never an error
    INVALID_GLUING,           ///< a side is glued twice, to itself, or out of range
    TRIANGLE_INEQUALITY,      ///< three lengths violate the triangle inequality
    WRONG_TOPOLOGY,           ///< the surface has the wrong topological type
    UNREADABLE                ///< the text or file does not have the expected format
  };

  /// constructs the error from the defect, the first offending element, the number of offending elements, and a message
  /// that names them.
  Invalid_surface_error(Defect defect, std::size_t element, std::size_t count, const std::string& message)
    : Error(message), defect_(defect), element_(element), count_(count)
  {}

  /// returns the defect.
  Defect defect() const { return defect_; }
  /// returns the index of the first offending vertex, edge or face, as the message names it.
  std::size_t element() const { return element_; }
  /// returns the number of offending elements.
  std::size_t count() const { return count_; }

private:
  Defect defect_;
  std::size_t element_;
  std::size_t count_;
};

/// \brief is thrown if an argument is invalid although the surface is valid: a vertex or halfedge that does not exist,
/// an option out of range, or a polygon that is not convex.
class Invalid_argument_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if a refinement would need more new vertices than its default maximum.
class Too_many_vertices_error : public Invalid_argument_error
{
public:
  /// constructs the error from the estimated number and the maximum, which the message contains.
  Too_many_vertices_error(std::uint64_t number, std::uint64_t maximum)
    : Invalid_argument_error("edges of these lengths need about " + std::to_string(number) +
                             " new vertices, more than the default maximum of " + std::to_string(maximum) +
                             ": allow longer edges, or set the maximum number of vertices"),
      number_(number)
  {}

  /// returns the estimated number.
  std::uint64_t number() const { return number_; }

private:
  std::uint64_t number_;
};

/// \brief is thrown if a point does not lie on the surface; the message says why.
class Invalid_point_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if the exact geometry cannot decide.
///
/// There are three causes, which the message tells apart:
/// - an edge crosses more than 2<sup>20</sup> input edges, too many to be laid out;
/// - `Tie_proof::PROVEN` demands a proof that a number is zero, and the number has too many independent square roots;
/// - an edge is not a straight line over the input triangles, because rounded decisions flipped a hinge that is not
/// convex.
///
/// The first two can happen with any traits, including the default ones; nothing is changed then. An interval number
/// type that cannot decide is no error: `flip_to_Delaunay()` reports `Flip_status::UNDECIDED`.
class Undecided_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if a vertex cannot be removed; the message says why.
class Invalid_removal_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if a count of crossings exceeds the range of its type.
class Integer_overflow_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if a computation in double fails: a positive definite matrix loses that property by rounding, or an
/// iteration does not converge.
class Numerical_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if the program's arithmetic on doubles does not follow IEEE 754, so that no answer can be trusted.
///
/// The causes are compiler options that no macro reveals, a processor that flushes subnormal numbers to zero and cannot
/// be reset, or a fault that the library detects because more digits do not lead to a decision.
class Arithmetic_error : public Error
{
public:
  using Error::Error;
};

/// \brief is thrown if a visitor, or the function given to `set_interruption()`, asks to end a computation.
///
/// The object in use stays valid, and the call can be repeated.
class Cancelled_error : public Error
{
public:
  using Error::Error;
};

/// @}

namespace internal {

// Throws unless there is such a vertex among n.
inline void require_vertex(std::size_t v, std::size_t n)
{
  if (!(v < n))
    throw Invalid_argument_error("there is no vertex " + std::to_string(v) + ": there are " + std::to_string(n) +
                                 " vertices, counted from 0");
}
inline void require_vertex(Vertex_index v, std::size_t n) { require_vertex(std::size_t(v.idx()), n); }

// Throws for a contradiction in the file of a triangulation.
[[noreturn]] inline void throw_not_a_triangulation(const char* kind, std::size_t element, const std::string& what)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, element, 1,
                              std::string(kind) + " " + std::to_string(element) + " " + what);
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ERRORS_H
