// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Rows of numbers, least byte first on any processor.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_BYTE_STREAM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_BYTE_STREAM_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <ios>
#include <istream>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Byte_writer
{
public:
  explicit Byte_writer(std::ostream& os) : os_(os) {}

  template <class... Number>
  void put(Number... x)
  {
    std::array<unsigned char, (sizeof(Number) + ...)> row;
    unsigned char* at = row.data();
    const auto put_one = [&at](auto number) {
      boost::endian::endian_store<decltype(number), sizeof(number), boost::endian::order::little>(at, number);
      at += sizeof(number);
    };
    (put_one(x), ...);
    bytes_.append(reinterpret_cast<const char*>(row.data()), row.size());
    if (bytes_.size() > block)
      flush();
  }
  void put(const std::string& text) { bytes_ += text; }
  void flush()
  {
    os_.write(bytes_.data(), std::streamsize(bytes_.size()));
    bytes_.clear();
  }

private:
  static constexpr std::size_t block = 1 << 16;

  std::ostream& os_;
  std::string bytes_;
};

// Reads no more than requested, and keeps at most one block.
class Byte_reader
{
public:
  explicit Byte_reader(std::istream& is) : is_(is)
  {
    if (!is.good())
      return;
    std::streambuf& buffer = *is.rdbuf();
    try {
      const std::streamoff begin = buffer.pubseekoff(0, std::ios::cur, std::ios::in),
                           end = begin < 0 ? -1 : std::streamoff(buffer.pubseekoff(0, std::ios::end, std::ios::in));
      if (end >= begin && begin >= 0) {
        size_of_stream_ = std::uint64_t(end - begin);
        buffer.pubseekpos(begin, std::ios::in);
      }
    } catch (const std::exception&) { // a filter that cannot seek
    }
  }

  // A line of a text, without its end. \exception Invalid_surface_error if it is longer than lines of a header are
  std::string line()
  {
    constexpr std::size_t longest = 200;
    std::string result;
    for (char c; is_.get(c); result.push_back(c)) {
      ++offset_;
      if (c == '\n')
        return result;
      if (result.size() == longest)
        break;
    }
    fail(offset_, "there is no header of an intrinsic triangulation");
  }

  // Announces this many rows of an element, with this many bytes each.
  void begin(const char* element, std::size_t number, std::size_t size)
  {
    element_ = element;
    number_ = number;
    size_ = size;
    row_ = 0;
    left_ = 0;
  }
  // This many rows, or as many as the stream can have, if known, to reserve room for.
  std::size_t rows_to_expect() const
  {
    const std::uint64_t rest = size_of_stream_ > offset_ ? size_of_stream_ - offset_ : 0;
    return std::size_t((std::min<std::uint64_t>)(number_, rest / size_));
  }
  // Goes to the next row, from which `get` reads the numbers.
  void next_row()
  {
    if (left_ == 0) {
      const std::size_t rows = (std::min)(number_ - row_, (std::max)(std::size_t(1), block / size_));
      bytes_.resize(rows * size_);
      is_.read(bytes_.data(), std::streamsize(bytes_.size()));
      const std::size_t n = std::size_t(is_.gcount()), whole = n / size_;
      offset_ += n;
      if (whole < rows) {
        row_ += whole;
        fail(offset_, "the file ends there");
      }
      left_ = rows;
      next_ = bytes_.data();
    }
    --left_;
    ++row_;
  }
  template <class Number>
  Number get()
  {
    const auto* const at = reinterpret_cast<const unsigned char*>(next_);
    next_ += sizeof(Number);
    return boost::endian::endian_load<Number, sizeof(Number), boost::endian::order::little>(at);
  }
  // Whether this row is the first of the current block.
  bool begins_block() const { return next_ == bytes_.data(); }

  // A text of this many bytes.
  std::string text(std::size_t size)
  {
    std::string result;
    while (result.size() < size) {
      std::array<char, 4096> part;
      is_.read(part.data(), std::streamsize((std::min)(part.size(), size - result.size())));
      const std::size_t n = std::size_t(is_.gcount());
      offset_ += n;
      if (n == 0)
        fail(offset_, "the file ends there");
      result.append(part.data(), n);
    }
    return result;
  }

  // Of the row that was taken last.
  [[noreturn]] void fail_here(const std::string& what) const { fail(offset_ - left_ * size_ - size_, what); }
  [[noreturn]] void fail(std::uint64_t offset, const std::string& what) const
  {
    const std::size_t row = row_ == 0 ? 0 : row_ - 1;
    throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, row, 1,
                                "byte " + std::to_string(offset) +
                                  (element_ ? ", " + std::string(element_) + " " + std::to_string(row) : "") + ": " +
                                  what);
  }

private:
  static constexpr std::size_t block = 1 << 16;

  std::istream& is_;
  std::uint64_t size_of_stream_ = 0; // or 0 if unknown
  std::uint64_t offset_ = 0;         // the number of bytes read from the stream
  const char* element_ = nullptr;
  std::size_t number_ = 0, size_ = 0, row_ = 0, left_ = 0;
  std::vector<char> bytes_;
  const char* next_ = nullptr;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_BYTE_STREAM_H
