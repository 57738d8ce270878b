// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Sparse symmetric matrices from one number for each edge, column by column on several threads.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_COLUMNS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_COLUMNS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The columns of a block of vertices.
template <class Edge_value, class Diagonal_value>
class Column_block
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = Matrix::StorageIndex;

public:
  Column_block(const Delta_complex& complex, const Edge_value& edge_value, const Diagonal_value& diagonal_value)
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
    entries_.clear();
    for (Halfedge_index h : Halfedges_around(complex_, Vertex_index(Vertex_index::size_type(c)))) {
      const Edge_index e = complex_.edge(h);
      const Index row = Index(complex_.source(h).idx());
      if (row != c)
        entries_.push_back({std::uint64_t(row) << 32 | e.idx(), edge_value_(e)});
    }
    sort(0, [](const Entry& x) { return x.row_and_edge; });
    const std::size_t begin = rows_.size();
    std::size_t i = 0;
    double sum = 0;
    while (i < entries_.size() && entries_[i].row() < c)
      sum += append(i);
    const std::size_t diagonal = rows_.size(), larger = i;
    rows_.push_back(c);
    values_.push_back(0);
    while (i < entries_.size())
      append(i);
    sort(larger, [](const Entry& x) { return std::uint32_t(x.row_and_edge); });
    for (i = larger; i < entries_.size(); ++i)
      sum += entries_[i].value;
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
  struct Entry
  {
    std::uint64_t row_and_edge; // no two are the same
    double value;
    Index row() const { return Index(row_and_edge >> 32); }
  };

  // Sorts the entries from number `first` on. Few of them are put where they belong without a branch
  // that nothing could predict.
  template <class Key>
  void sort(std::size_t first, const Key& key)
  {
    const std::size_t n = entries_.size() - first;
    Entry* const entries = entries_.data() + first;
    if (n > few) {
      std::sort(entries, entries + n, [&key](const Entry& a, const Entry& b) { return key(a) < key(b); });
      return;
    }
    std::array<Entry, few> sorted;
    for (std::size_t i = 0; i < n; ++i) {
      std::size_t rank = 0;
      for (std::size_t j = 0; j < n; ++j)
        rank += key(entries[j]) < key(entries[i]);
      sorted[rank] = entries[i];
    }
    std::copy(sorted.begin(), sorted.begin() + std::ptrdiff_t(n), entries);
  }

  // Appends the sum of the edges from number i on that lead to the same vertex, and returns it.
  double append(std::size_t& i)
  {
    const Index row = entries_[i].row();
    double sum = entries_[i].value;
    while (++i < entries_.size() && entries_[i].row() == row)
      sum += entries_[i].value;
    rows_.push_back(row);
    values_.push_back(sum);
    return sum;
  }

  static constexpr std::size_t few = 16;

  const Delta_complex& complex_;
  const Edge_value& edge_value_;
  const Diagonal_value& diagonal_value_;
  std::vector<Index> rows_, sizes_;
  std::vector<double> values_;
  std::vector<Entry> entries_; // of a column
};

// As assemble_symmetric_matrix() with one thread, bit for bit. \pre the matrix can hold as many entries
template <class ConcurrencyTag, class Edge_value, class Diagonal_value>
Eigen::SparseMatrix<double> assemble_columns(const Delta_complex& complex, const Edge_value& edge_value,
                                             const Diagonal_value& diagonal_value)
{
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  constexpr std::size_t columns_of_block = 4096;
  const std::size_t n = complex.number_of_vertices();
  std::vector<Column_block<Edge_value, Diagonal_value>> blocks(n / columns_of_block + 1,
                                                               {complex, edge_value, diagonal_value});
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_COLUMNS_H
