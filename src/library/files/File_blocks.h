// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Room for the contents of a file, and the file in large pieces. It is read once, never held as a whole, and asks
// before each piece whether to go on.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FILE_BLOCKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FILE_BLOCKS_H

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include "text_file.h"
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes room for n more elements, in huge pages: unused room costs only address space, and page faults would take as
// long as reading.
template <class T>
void reserve(std::vector<T>& elements, const std::uintmax_t n)
{
  elements.reserve(elements.size() + static_cast<std::size_t>(n));
  wish_for_huge_pages(elements.data() + elements.size(), (elements.capacity() - elements.size()) * sizeof(T));
}

// The same for points and triangles.
inline void reserve(Polygon_soup& soup, const std::uintmax_t points, const std::uintmax_t triangles)
{
  reserve(soup.points, points);
  reserve(soup.triangles, triangles);
}

class File_blocks
{
public:
  // \param size the size of the file, not 0
  // \param begin the first byte to read
  // \param line_end the end of a line
  File_blocks(const std::string& path, std::uintmax_t size, std::uintmax_t begin, const Progress_function& progress,
              const char line_end = '\n')
    : path_(path), size_(size), begin_(begin), taken_(begin), progress_(progress), buffer_(size_of_piece),
      line_end_(line_end)
  {
    file_.pubsetbuf(nullptr, 0); // reads go directly to their destination
    file_.open(path, std::ios::in | std::ios::binary);
    file_.pubseekpos(static_cast<std::streampos>(static_cast<std::streamoff>(begin)), std::ios::in);
  }
  File_blocks(const File_blocks&) = delete;
  File_blocks& operator=(const File_blocks&) = delete;

  // The unused bytes taken from the file: the caller advances `first`. Pointers are valid until the next piece.
  const char* first = nullptr;
  const char* last = nullptr;

  std::size_t available() const { return static_cast<std::size_t>(last - first); }
  // The position of `first` in the file.
  std::uintmax_t offset() const { return taken_ - static_cast<std::uintmax_t>(end_ - first); }
  // The number of bytes from `first` to the end of the file.
  std::uintmax_t left() const { return size_ - (std::min)(size_, offset()); }

  // Makes the rest of the last piece and the next one available; false if there is none.
  // \exception Cancelled_error on request
  bool take_piece()
  {
    if (is_at_end_) {
      if (!is_end_told_)
        tell();
      is_end_told_ = true;
      return false;
    }
    tell();
    const std::size_t rest = static_cast<std::size_t>(end_ - first);
    if (rest > 0)
      std::memmove(buffer_.data(), first, rest);
    if (rest > buffer_.size() / 2) // of a long line, or a long list
      buffer_.resize(2 * buffer_.size());
    const std::streamsize got = file_.sgetn(buffer_.data() + rest, static_cast<std::streamsize>(buffer_.size() - rest));
    first = buffer_.data();
    end_ = last = first + rest + got;
    taken_ += static_cast<std::uintmax_t>(got);
    is_at_end_ = got < static_cast<std::streamsize>(buffer_.size() - rest);
    return true;
  }

  // The same for a text: only whole lines are available, or whole words if they are shorter.
  bool take_lines()
  {
    return take_up_to([this](char c) { return c == line_end_; });
  }
  bool take_words() { return take_up_to(is_white); }

  // Skips a line, [begin, end) without its line end; false if there is none.
  bool take_line(const char*& begin, const char*& end)
  {
    if (first == last && !take_lines())
      return false;
    begin = first;
    const void* const found = std::memchr(first, line_end_, available());
    end = found == nullptr ? last : static_cast<const char*>(found);
    first = found == nullptr ? last : end + 1;
    return true;
  }

  // Makes bytes available; false if the file ends earlier.
  bool require(const std::size_t bytes)
  {
    while (available() < bytes)
      if (!take_piece())
        return false;
    return true;
  }

  // Skips bytes; false if the file ends earlier.
  bool skip(std::uintmax_t bytes)
  {
    while (bytes > available()) {
      bytes -= available();
      first = last;
      if (!take_piece())
        return false;
    }
    first += bytes;
    return true;
  }

private:
  void tell() const
  {
    // The fraction of the expected bytes: the file may have shrunk, or grown.
    const double all = static_cast<double>(size_) - static_cast<double>(begin_),
                 done = static_cast<double>(taken_ - begin_);
    if (progress_ && !progress_(done < all ? done / all : done > 0 ? 1 : 0))
      throw Cancelled_error(path_ + ": cancelled while it was read");
  }

  static constexpr std::size_t size_of_piece = std::size_t(1) << 20;

  template <class Is_separator>
  bool take_up_to(const Is_separator& is_separator)
  {
    while (take_piece()) {
      if (is_at_end_)
        return first != last;
      while (last != first && !is_separator(last[-1]))
        --last;
      if (last != first)
        return true;
    }
    return false;
  }

  std::string path_;
  std::uintmax_t size_, begin_, taken_;
  const Progress_function& progress_;
  std::vector<char> buffer_;
  const char line_end_;
  const char* end_ = nullptr; // of the bytes taken, possibly beyond `last`
  std::filebuf file_;
  bool is_at_end_ = false;
  bool is_end_told_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FILE_BLOCKS_H
