// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Sparse symmetric matrices from one number for each edge, without a list of triplets.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_SYMMETRIC_MATRIX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_SYMMETRIC_MATRIX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/tags.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Fills the compressed columns of a symmetric matrix in order, without sorting. Edges go into buckets by their smaller
// vertex. When it is the turn of vertex c, all smaller vertices are done, so the rows above the diagonal of column c
// are complete and in order. Now c enters itself as a row: below the diagonal in the columns of these smaller vertices,
// and above the diagonal in the columns of the larger vertices in its bucket. Several edges between the same vertices
// are consecutive and are added up.
// \tparam Row like Row_of_vertex; several vertices may have the same row
template <class Row>
class Symmetric_matrix_assembler
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = Matrix::StorageIndex;

  struct Entry
  {
    Index larger_vertex;
    double value;
  };

public:
  Symmetric_matrix_assembler(const Delta_complex& complex, const Row& row)
    : complex_(complex), row_(row), size_(row.number_of_rows()), below_(size_, 0), above_(size_, 0),
      bucket_(size_, default_init), diagonal_(size_, default_init)
  {}

  template <class Edge_value, class Diagonal_value>
  Matrix assemble(const Edge_value& edge_value, const Diagonal_value& diagonal_value)
  {
    count();
    fill_buckets(edge_value);
    start_columns();
    enter_rows(diagonal_value);
    if (number_of_merged_ > 0)
      close_gaps();
    Matrix result;
    result.swap(matrix_); // up to Eigen 3.4, moving it would copy it
    return result;
  }

private:
  template <class Function>
  void for_each_pair(const Function& function) const
  {
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      const Index v = Index(row_(complex_.source(h))), w = Index(row_(complex_.target(h)));
      if (v != w)
        function(e, (std::min)(v, w), (std::max)(v, w));
    }
  }

  void count()
  {
    Index *const below = below_.data(), *const above = above_.data();
    for_each_pair([below, above](Edge_index, Index v, Index w) {
      ++below[v];
      ++above[w];
    });
  }

  template <class Edge_value>
  void fill_buckets(const Edge_value& edge_value)
  {
    Index sum = 0;
    for (std::size_t v = 0; v < size_; ++v) {
      bucket_[v] = sum;
      sum += below_[v];
    }
    entries_.resize(std::size_t(sum), default_init);
    Index* const bucket = bucket_.data();
    Entry* const entries = entries_.data();
    for_each_pair([bucket, entries, &edge_value](Edge_index e, Index v, Index w) {
      entries[bucket[v]++] = {w, edge_value(e)};
    });
  }

  // From now on above_ and below_ are the positions for the next row in each part of a column.
  void start_columns()
  {
    matrix_.resize(Eigen::Index(size_), Eigen::Index(size_));
    const std::size_t n = 2 * entries_.size() + size_;
    matrix_.resizeNonZeros(Eigen::Index(n));
    wish_for_huge_pages(matrix_.innerIndexPtr(), n * sizeof(Index));
    wish_for_huge_pages(matrix_.valuePtr(), n * sizeof(double));
    Index* const start = matrix_.outerIndexPtr();
    start[0] = 0;
    for (std::size_t c = 0; c < size_; ++c) {
      diagonal_[c] = start[c] + above_[c];
      start[c + 1] = diagonal_[c] + 1 + below_[c];
      above_[c] = start[c];
      below_[c] = diagonal_[c] + 1;
    }
  }

  template <class Diagonal_value>
  void enter_rows(const Diagonal_value& diagonal_value)
  {
    // All in local variables: otherwise writes might alias the members.
    const Index *const start = matrix_.outerIndexPtr(), *const diagonal = diagonal_.data(),
                       *const bucket = bucket_.data();
    Index *const row = matrix_.innerIndexPtr(), *const above = above_.data(), *const below = below_.data();
    double* const value = matrix_.valuePtr();
    const Entry* entry = entries_.data();
    const Entry* const behind_all = entry + entries_.size();
    for (Index c = 0; c < Index(size_); ++c) {
      double sum = 0;
      for (Index i = start[c], end = above[c]; i < end; ++i) {
        const Index position = below[row[i]]++;
        row[position] = c;
        value[position] = value[i];
        sum += value[i];
      }
      for (const Entry* const end = entries_.data() + bucket[c]; entry != end; ++entry) {
        if (behind_all - entry > entries_ahead) {
          const Index soon = above[entry[entries_ahead].larger_vertex];
          prefetch(row + soon);
          prefetch(value + soon);
        }
        const Index column = entry->larger_vertex, position = above[column];
        sum += entry->value;
        if (position > start[column] && row[position - 1] == c) {
          value[position - 1] += entry->value;
          ++number_of_merged_;
        } else {
          row[position] = c;
          value[position] = entry->value;
          above[column] = position + 1;
        }
      }
      row[diagonal[c]] = c;
      value[diagonal[c]] = diagonal_value(c, sum);
    }
  }

  // Sums of several edges have left gaps at the ends of both parts of a column. Entries between two gaps are moved at
  // once.
  void close_gaps()
  {
    Index *const row = matrix_.innerIndexPtr(), *const start = matrix_.outerIndexPtr();
    double* const value = matrix_.valuePtr();
    Index first = 0, end = 0; // what begins at `first` will begin at `end`
    const auto move = [&](Index gap, Index behind) {
      if (first != end) {
        std::copy(row + first, row + gap, row + end);
        std::copy(value + first, value + gap, value + end);
      }
      end += gap - first;
      first = behind;
    };
    for (std::size_t c = 0; c < size_; ++c) {
      start[c] -= first - end;
      if (above_[c] != diagonal_[c])
        move(above_[c], diagonal_[c]);
      if (below_[c] != start[c + 1])
        move(below_[c], start[c + 1]);
    }
    move(start[size_], start[size_]);
    start[size_] = end;
    matrix_.resizeNonZeros(end);
  }

  // How early the end of a column is fetched.
  static constexpr std::ptrdiff_t entries_ahead = 24;

  const Delta_complex& complex_;
  const Row& row_;
  const std::size_t size_;
  Large_vector<Index> below_, above_;
  Large_vector<Index> bucket_; // where each bucket begins, and when it is full, where it ends
  Large_vector<Index> diagonal_;
  Large_vector<Entry> entries_;
  std::size_t number_of_merged_ = 0;
  Matrix matrix_;
};

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

  // Appends a column. Numbers are added up in the same order as in Symmetric_matrix_assembler.
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

  // Copies the columns into the matrix.
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

  // Sorts the entries from number `first` on. A few entries are put in place without branches, which would be
  // unpredictable.
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

// Same result as assemble_symmetric_matrix() with one thread, bit for bit. \pre the matrix can hold as many entries
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

inline void check_matrix_size(const Delta_complex& complex, std::size_t number_of_rows)
{
  using Index = Eigen::SparseMatrix<double>::StorageIndex;
  if (std::size_t(complex.number_of_halfedges()) + number_of_rows > std::size_t((std::numeric_limits<Index>::max)()))
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, complex.number_of_edges(), 1,
                                std::to_string(complex.number_of_edges()) +
                                  " edges are more than a sparse matrix can hold");
}

// The matrix whose entry (v, w) is the sum of edge_value(e) over the edges e between the rows v and w,
// and whose entry (v, v) is diagonal_value(v, sum of the other entries of the row). Edges from a row to itself are
// left out.
template <class Row, class Edge_value, class Diagonal_value>
Eigen::SparseMatrix<double> assemble_symmetric_matrix(const Delta_complex& complex, const Row& row,
                                                      const Edge_value& edge_value,
                                                      const Diagonal_value& diagonal_value)
{
  check_matrix_size(complex, row.number_of_rows());
  return Symmetric_matrix_assembler<Row>(complex, row).assemble(edge_value, diagonal_value);
}

// As above, with a row for each vertex. With Parallel_tag several threads may call both functions.
template <class ConcurrencyTag, class Edge_value, class Diagonal_value>
Eigen::SparseMatrix<double> assemble_symmetric_matrix(const Delta_complex& complex, const Edge_value& edge_value,
                                                      const Diagonal_value& diagonal_value)
{
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    check_matrix_size(complex, complex.number_of_vertices());
    if (number_of_threads<ConcurrencyTag>() > 2) // two threads take as long for all columns as one for all edges
      return assemble_columns<ConcurrencyTag>(complex, edge_value, diagonal_value);
  }
  return assemble_symmetric_matrix(complex, Row_of_vertex(complex), edge_value, diagonal_value);
}

// For each row the sum over all corners there of the area of the face times a factor.
template <class Row>
std::vector<double> corner_sums(const Delta_complex& complex, const Row& row, const std::vector<double>& areas,
                                double factor)
{
  std::vector<double> sums(row.number_of_rows(), 0);
  for (Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h))
      sums[row(complex.target(h))] += factor * areas[complex.face(h).idx()];
  return sums;
}

// The areas of the faces beside an edge.
inline double area_beside(const Delta_complex& complex, const std::vector<double>& areas, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e);
  double sum = 0;
  for (Halfedge_index side : {h, complex.opposite(h)})
    if (!complex.is_border(side))
      sum += areas[complex.face(side).idx()];
  return sum;
}

// The diagonal matrix with a third of the area of the faces at each row.
template <class Row>
Eigen::SparseMatrix<double> assemble_lumped_mass_matrix(const Delta_complex& complex, const Row& row,
                                                        const std::vector<double>& areas)
{
  const std::vector<double> sums = corner_sums(complex, row, areas, 1. / 3);
  Eigen::SparseMatrix<double> mass(Eigen::Index(sums.size()), Eigen::Index(sums.size()));
  mass.setIdentity();
  std::copy(sums.begin(), sums.end(), mass.valuePtr());
  return mass;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MATRICES_ASSEMBLE_SYMMETRIC_MATRIX_H
