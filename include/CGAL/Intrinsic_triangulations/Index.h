// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Typed descriptors: a vertex cannot be passed where an edge is expected.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INDEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INDEX_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <ostream>

namespace CGAL::Intrinsic_triangulations {

class Delta_complex;

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief a descriptor: a 32-bit index whose type tells the kind of element.
///
/// A default-constructed descriptor is the null descriptor.
/// \tparam Tag distinguishes the kinds of elements; it supplies the letter that `operator<<` writes.
template <class Tag>
class Index
{
public:
  /// the type of positions
  using size_type = std::uint32_t;

  /// constructs the null descriptor.
  constexpr Index() = default;
  /// constructs the descriptor of the element at position `index`.
  constexpr explicit Index(size_type index) : index_(index) {}

  /// returns the position of the element.
  constexpr size_type idx() const { return index_; }
  /// returns whether this is not the null descriptor.
  constexpr bool is_valid() const { return index_ != null_index(); }
  /// returns the position that denotes no element.
  static constexpr size_type null_index() { return (std::numeric_limits<size_type>::max)(); }

  /// \name Comparison
  /// @{

  /// compares the positions; the null descriptor comes last.
  friend constexpr bool operator==(Index a, Index b) { return a.index_ == b.index_; }
  friend constexpr bool operator!=(Index a, Index b) { return a.index_ != b.index_; }
  friend constexpr bool operator<(Index a, Index b) { return a.index_ < b.index_; }
  friend constexpr bool operator>(Index a, Index b) { return b < a; }
  friend constexpr bool operator<=(Index a, Index b) { return !(b < a); }
  friend constexpr bool operator>=(Index a, Index b) { return !(a < b); }
  /// @}

  /// returns a hash value for `boost::hash`.
  friend std::size_t hash_value(Index a) { return a.index_; }
  /// writes the letter of the kind of element and the position.
  friend std::ostream& operator<<(std::ostream& os, Index a)
  {
    os << Tag::letter;
    return a.is_valid() ? os << a.index_ : os << "null";
  }

private:
  size_type index_ = null_index();
};

namespace internal {
// The tag of one kind of elements of one kind of graph.
template <char letter_, class Graph>
struct Element_tag
{
  static constexpr char letter = letter_;
};
} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief descriptor of a vertex.
using Vertex_index = Index<internal::Element_tag<'v', Delta_complex>>;
/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief descriptor of a halfedge; halfedges `2e` and `2e + 1` belong to edge `e`.
using Halfedge_index = Index<internal::Element_tag<'h', Delta_complex>>;
/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief descriptor of an edge.
using Edge_index = Index<internal::Element_tag<'e', Delta_complex>>;
/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief descriptor of a face.
using Face_index = Index<internal::Element_tag<'f', Delta_complex>>;

} // namespace CGAL::Intrinsic_triangulations

/// \cond SKIP_IN_MANUAL
template <class Tag>
struct std::hash<CGAL::Intrinsic_triangulations::Index<Tag>>
{
  std::size_t operator()(CGAL::Intrinsic_triangulations::Index<Tag> a) const { return a.idx(); }
};
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INDEX_H
