// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that tells how much of it was read, and ends early if nobody wants to go on or what is in it is no good.

#ifndef IDT_FORMATS_WATCHED_FILE_H
#define IDT_FORMATS_WATCHED_FILE_H

#include "input/formats/Obj_filter.h"
#include "input/formats/Text_check.h"

#include <CGAL/Intrinsic_triangulations/Progress_function.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <ios>
#include <optional>
#include <streambuf>
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

  // Takes out of an OBJ file what CGAL's reader does not understand.
  void filter_obj() { obj_filter_.emplace(); }

  // Shows each piece to `check` before anyone else gets it. What this throws ends the file.
  void look_with(Text_check* const check) { check_ = check; }

  bool is_cancelled() const { return is_cancelled_; }

  // \exception what the check has thrown
  void throw_what_was_found() const
  {
    if (error_)
      std::rethrow_exception(error_);
  }

protected:
  int_type underflow() override
  {
    if (!goes_on())
      return traits_type::eof();
    const int_type result = std::filebuf::underflow();
    if (result == traits_type::eof())
      return result;
    taken_ += static_cast<double>(egptr() - gptr());
    if (obj_filter_)
      (*obj_filter_)(gptr(), egptr());
    // An exception would not get through the functions of std::istream.
    try {
      if (check_ != nullptr)
        check_->take(gptr(), egptr());
    } catch (...) {
      error_ = std::current_exception();
      return traits_type::eof();
    }
    return traits_type::to_int_type(*gptr());
  }
  pos_type seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode mode) override
  {
    const pos_type result = std::filebuf::seekoff(offset, way, mode);
    if (offset == 0 && way == std::ios_base::beg) {
      taken_ = 0;
      if (obj_filter_)
        obj_filter_.emplace();
      if (check_ != nullptr)
        check_->restart();
    }
    return result;
  }
  std::streamsize xsgetn(char* to, std::streamsize n) override
  {
    if (n > egptr() - gptr() && !goes_on())
      return 0;
    const std::streamsize before = egptr() - gptr(), result = std::filebuf::xsgetn(to, n);
    if (result > before)
      taken_ += static_cast<double>(result - before + (egptr() - gptr()));
    return result;
  }

private:
  bool goes_on()
  {
    if (error_)
      return false;
    is_cancelled_ = is_cancelled_ || (progress_ && !progress_(size_ > 0 ? taken_ / size_ : 1));
    return !is_cancelled_;
  }

  std::vector<char> buffer_;
  double size_;
  double taken_ = 0;
  const CGAL::Intrinsic_triangulations::Progress_function& progress_;
  std::optional<Obj_filter> obj_filter_;
  bool is_cancelled_ = false;
  Text_check* check_ = nullptr;
  std::exception_ptr error_;
};

// The same for a text that is there already.
class Watched_text : public std::streambuf
{
public:
  Watched_text(std::string& text, const CGAL::Intrinsic_triangulations::Progress_function& progress)
    : text_(text), progress_(progress)
  {
  }

  bool is_cancelled() const { return is_cancelled_; }
  void throw_what_was_found() const {} // a text was looked at before

protected:
  int_type underflow() override
  {
    is_cancelled_ = is_cancelled_ || (progress_ && !progress_(static_cast<double>(taken_) / static_cast<double>(text_.size())));
    if (is_cancelled_ || taken_ == text_.size())
      return traits_type::eof();
    char* const begin = &text_[taken_];
    const std::size_t size = (std::min)(std::size_t(1) << 20, text_.size() - taken_);
    setg(begin, begin, begin + size);
    taken_ += size;
    return traits_type::to_int_type(*begin);
  }
  // Readers go back to the beginning, and ask where they are.
  pos_type seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode) override
  {
    if (offset == 0 && way == std::ios_base::beg) {
      taken_ = 0;
      setg(nullptr, nullptr, nullptr);
    } else if (offset != 0 || way != std::ios_base::cur)
      return pos_type(off_type(-1));
    return pos_type(static_cast<off_type>(taken_) - (egptr() - gptr()));
  }

private:
  std::string& text_;
  const CGAL::Intrinsic_triangulations::Progress_function& progress_;
  std::size_t taken_ = 0;
  bool is_cancelled_ = false;
};

} // namespace idt

#endif // IDT_FORMATS_WATCHED_FILE_H
