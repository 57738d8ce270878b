// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// NumPy arrays in and out, without avoidable copies.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_ARRAYS_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_ARRAYS_H

#include <Eigen/SparseCore>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

namespace py = pybind11;

// Arrays in the form in which the Python part of the module passes them: of exactly this type, with any strides.
using Doubles = py::array_t<double, 0>;
using Indices = py::array_t<std::uint32_t, 0>;
using Booleans = py::array_t<bool, 0>;

// The Python part has checked this, with messages for users.
inline void require(bool condition, const char* what)
{
  if (!condition)
    throw py::value_error(what);
}

// The rows of an array with three columns, read in place: a range of points for the library.
template <class T>
class Rows
{
public:
  class Row
  {
  public:
    Row(const char* begin, std::ptrdiff_t stride) : begin_(begin), stride_(stride) {}
    // Copied by bytes, because an array need not be aligned.
    T operator[](std::size_t i) const
    {
      T result;
      std::memcpy(&result, begin_ + std::ptrdiff_t(i) * stride_, sizeof(T));
      return result;
    }

  private:
    const char* begin_;
    std::ptrdiff_t stride_;
  };

  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Row;
    using difference_type = std::ptrdiff_t;
    using pointer = const Row*;
    using reference = Row;

    Iterator(const Rows& rows, std::size_t i) : rows_(&rows), i_(i) {}
    Row operator*() const { return (*rows_)[i_]; }
    Iterator& operator++()
    {
      ++i_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.i_ == b.i_; }
    friend bool operator!=(const Iterator& a, const Iterator& b) { return a.i_ != b.i_; }

  private:
    const Rows* rows_;
    std::size_t i_;
  };

  // \param array must outlive the range
  explicit Rows(const py::array_t<T, 0>& array)
  {
    require(array.ndim() == 2 && array.shape(1) == 3, "an array has not three columns");
    begin_ = reinterpret_cast<const char*>(array.data());
    size_ = std::size_t(array.shape(0));
    row_stride_ = array.strides(0);
    column_stride_ = array.strides(1);
  }

  std::size_t size() const { return size_; }
  Row operator[](std::size_t i) const { return Row(begin_ + std::ptrdiff_t(i) * row_stride_, column_stride_); }
  Iterator begin() const { return Iterator(*this, 0); }
  Iterator end() const { return Iterator(*this, size_); }

private:
  const char* begin_;
  std::size_t size_;
  std::ptrdiff_t row_stride_, column_stride_;
};

// A copy, because another Python thread must not change data that was checked.
template <class T>
std::vector<std::array<T, 3>> copied_rows(const py::array_t<T, 0>& array)
{
  std::vector<std::array<T, 3>> result;
  const Rows<T> rows(array);
  result.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    result.push_back({rows[i][0], rows[i][1], rows[i][2]});
  return result;
}

template <class T>
std::vector<T> copied(const py::array_t<T, 0>& array)
{
  require(array.ndim() == 1, "an array has not one dimension");
  const auto items = array.template unchecked<1>();
  std::vector<T> result(static_cast<std::size_t>(items.shape(0)));
  for (py::ssize_t i = 0; i < items.shape(0); ++i)
    result[std::size_t(i)] = items(i);
  return result;
}

// Gives an object to Python, which deletes it with the last array that refers to it.
template <class T>
std::pair<T*, py::capsule> handed_over(T&& object)
{
  T* const kept = new T(std::move(object));
  return {kept, py::capsule(kept, [](void* p) { delete static_cast<T*>(p); })};
}

template <class T>
py::array_t<T> to_array(std::vector<T>&& values)
{
  const std::size_t size = values.size();
  auto [kept, owner] = handed_over(std::move(values));
  return py::array_t<T>(py::ssize_t(size), kept->data(), owner);
}

// As a matrix.
template <class T, std::size_t n>
py::array_t<T> to_array(std::vector<std::array<T, n>>&& rows)
{
  const std::vector<py::ssize_t> shape = {py::ssize_t(rows.size()), py::ssize_t(n)};
  auto [kept, owner] = handed_over(std::move(rows));
  return py::array_t<T>(shape, kept->empty() ? nullptr : kept->front().data(), owner);
}

// The numbers of elements have this type in Python.
template <class Range>
py::array_t<std::int64_t> to_numbers(const Range& range)
{
  return to_array(std::vector<std::int64_t>(range.begin(), range.end()));
}
template <class T>
py::array_t<std::int64_t> to_numbers(const std::vector<std::array<T, 3>>& triangles)
{
  std::vector<std::array<std::int64_t, 3>> result;
  result.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    result.push_back({std::int64_t(a), std::int64_t(b), std::int64_t(c)});
  return to_array(std::move(result));
}

// Data, row indices, beginnings of columns, and shape: the arguments of SciPy's csc_matrix.
template <class Number>
py::tuple to_sparse(Eigen::SparseMatrix<Number>&& matrix)
{
  matrix.makeCompressed();
  auto [kept, owner] = handed_over(std::move(matrix));
  const py::ssize_t n = kept->nonZeros();
  return py::make_tuple(py::array_t<Number>(n, kept->valuePtr(), owner),
                        py::array_t<int>(n, kept->innerIndexPtr(), owner),
                        py::array_t<int>(py::ssize_t(kept->cols() + 1), kept->outerIndexPtr(), owner),
                        py::make_tuple(kept->rows(), kept->cols()));
}

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_ARRAYS_H
