// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that tells how much of it was read, and ends early if nobody wants to go on.

#ifndef IDT_FORMATS_WATCHED_FILE_H
#define IDT_FORMATS_WATCHED_FILE_H

#include <CGAL/Intrinsic_triangulations/observer.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ios>
#include <string>
#include <vector>

namespace idt {

// A buffer for a std::istream. Each time that it takes a piece of the file it asks `progress`
// with the part of the file that was taken before.
class Watched_file : public std::filebuf
{
public:
  // \param size the size of the file in bytes
  Watched_file(const std::string& path, std::uintmax_t size,
               const CGAL::Intrinsic_triangulations::Progress_function& progress)
    : buffer_(std::size_t(1) << 20), size_(static_cast<double>(size)), progress_(progress)
  {
    pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    open(path, std::ios::in | std::ios::binary);
  }

  bool is_cancelled() const { return is_cancelled_; }

protected:
  int_type underflow() override
  {
    is_cancelled_ = is_cancelled_ || (progress_ && !progress_(size_ > 0 ? taken_ / size_ : 1));
    if (is_cancelled_)
      return traits_type::eof();
    const int_type result = std::filebuf::underflow();
    if (result != traits_type::eof())
      taken_ += static_cast<double>(egptr() - gptr());
    return result;
  }

private:
  std::vector<char> buffer_;
  double size_;
  double taken_ = 0;
  const CGAL::Intrinsic_triangulations::Progress_function& progress_;
  bool is_cancelled_ = false;
};

} // namespace idt

#endif // IDT_FORMATS_WATCHED_FILE_H
