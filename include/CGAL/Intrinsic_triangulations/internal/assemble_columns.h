// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sparse symmetric matrices from one number for each edge, column by column on several threads.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ASSEMBLE_COLUMNS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ASSEMBLE_COLUMNS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/for_each_block.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Calls function(h) for the halfedges that point to v.
template <class Function>
void for_each_halfedge_around(const Delta_complex& complex, Vertex_index v, const Function& function)
{
  const Halfedge_index first = complex.halfedge(v);
  if (!first.is_valid())
    return;
  Halfedge_index h = first;
  do {
    function(h);
    h = complex.next_around_target(h);
  } while (h != first);
}

// The columns of a block of vertices.
template <class Edge_value, class Diagonal_value>
class Column_block
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = Matrix::StorageIndex;

public:
  Column_block(const Delta_complex& complex, const Edge_value& edge_value,
               const Diagonal_value& diagonal_value)
    : complex_(complex), edge_value_(edge_value), diagonal_value_(diagonal_value)
  {}

  void reserve(std::size_t number_of_columns)
  {
    const std::size_t usual = 7 * number_of_columns; // entries of a closed surface
    rows_.reserve(usual);
    values_.reserve(usual);
    sizes_.reserve(number_of_columns);
  }

  // Appends a column. Numbers are added up in the same order as by Symmetric_matrix_assembler.
  void add(Index c)
  {
    edges_.clear();
    for_each_halfedge_around(complex_, Vertex_index(Vertex_index::size_type(c)), [&](Halfedge_index h) {
      const Index row = Index(complex_.source(h).idx());
      if (row != c)
        edges_.push_back(std::uint64_t(row) << 32 | complex_.edge(h).idx());
    });
    sort(0);
    const std::size_t begin = rows_.size();
    std::size_t i = 0;
    double sum = 0;
    while (i < edges_.size() && row(i) < c)
      sum += append(i);
    const std::size_t diagonal = rows_.size(), larger = i;
    rows_.push_back(c);
    values_.push_back(0);
    while (i < edges_.size())
      append(i);
    for (i = larger; i < edges_.size(); ++i)
      edges_[i] &= 0xffffffff;
    sort(larger);
    for (i = larger; i < edges_.size(); ++i)
      sum += value(i);
    values_[diagonal] = diagonal_value_(c, sum);
    sizes_.push_back(Index(rows_.size() - begin));
  }

  std::size_t size() const { return rows_.size(); }

  // Copies the columns to where the matrix has room for them.
  void copy_to(Matrix& matrix, Index first_column, Index start) const
  {
    std::copy(rows_.begin(), rows_.end(), matrix.innerIndexPtr() + start);
    std::copy(values_.begin(), values_.end(), matrix.valuePtr() + start);
    for (Index size : sizes_)
      matrix.outerIndexPtr()[++first_column] = (start += size);
  }

private:
  Index row(std::size_t i) const { return Index(edges_[i] >> 32); }
  double value(std::size_t i) const
  {
    return edge_value_(Edge_index(Edge_index::size_type(edges_[i] & 0xffffffff)));
  }

  // Few vertices have so many edges that another way would be faster.
  void sort(std::size_t first)
  {
    if (edges_.size() - first > 32) {
      std::sort(edges_.begin() + std::ptrdiff_t(first), edges_.end());
      return;
    }
    for (std::size_t i = first + 1; i < edges_.size(); ++i) {
      const std::uint64_t x = edges_[i];
      std::size_t j = i;
      for (; j > first && edges_[j - 1] > x; --j)
        edges_[j] = edges_[j - 1];
      edges_[j] = x;
    }
  }

  // Appends the sum of the edges from number i on that lead to the same vertex, and returns it.
  double append(std::size_t& i)
  {
    const Index r = row(i);
    double sum = value(i);
    while (++i < edges_.size() && row(i) == r)
      sum += value(i);
    rows_.push_back(r);
    values_.push_back(sum);
    return sum;
  }

  const Delta_complex& complex_;
  const Edge_value& edge_value_;
  const Diagonal_value& diagonal_value_;
  std::vector<Index> rows_, sizes_;
  std::vector<double> values_;
  std::vector<std::uint64_t> edges_; // of a column: the other vertex, and the edge
};

// As assemble_symmetric_matrix() with one thread, bit for bit. \pre the matrix can hold as many entries
template <class ConcurrencyTag, class Edge_value, class Diagonal_value>
Eigen::SparseMatrix<double> assemble_columns(const Delta_complex& complex, const Edge_value& edge_value,
                                             const Diagonal_value& diagonal_value)
{
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  constexpr std::size_t columns_of_block = 4096;
  const std::size_t n = complex.number_of_vertices();
  std::vector<Column_block<Edge_value, Diagonal_value>> blocks(
    n / columns_of_block + 1, {complex, edge_value, diagonal_value});
  for_each_block<ConcurrencyTag>(n, columns_of_block, [&](std::size_t first, std::size_t last) {
    auto& block = blocks[first / columns_of_block];
    block.reserve(last - first);
    for (std::size_t c = first; c < last; ++c)
      block.add(Index(c));
  });
  std::vector<std::size_t> starts{0};
  for (const auto& block : blocks)
    starts.push_back(starts.back() + block.size());
  Eigen::SparseMatrix<double> result{Eigen::Index(n), Eigen::Index(n)};
  result.resizeNonZeros(Eigen::Index(starts.back()));
  result.outerIndexPtr()[0] = 0;
  for_each_block<ConcurrencyTag>(n, columns_of_block, [&](std::size_t first, std::size_t) {
    const std::size_t block = first / columns_of_block;
    blocks[block].copy_to(result, Index(first), Index(starts[block]));
  });
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ASSEMBLE_COLUMNS_H
