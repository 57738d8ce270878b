// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that tells how much of it was read, and ends early if nobody wants to go on.

#ifndef IDT_FORMATS_WATCHED_FILE_H
#define IDT_FORMATS_WATCHED_FILE_H

#include <CGAL/Intrinsic_triangulations/Progress_function.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
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

  void turn_tabs_into_spaces() { has_tabs_turned_ = true; }

  bool is_cancelled() const { return is_cancelled_; }

protected:
  int_type underflow() override
  {
    if (!goes_on())
      return traits_type::eof();
    const int_type result = std::filebuf::underflow();
    taken_ += static_cast<double>(egptr() - gptr());
    if (!has_tabs_turned_ || result == traits_type::eof())
      return result;
    std::replace(gptr(), egptr(), '\t', ' ');
    return traits_type::to_int_type(*gptr());
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
    is_cancelled_ = is_cancelled_ || (progress_ && !progress_(size_ > 0 ? taken_ / size_ : 1));
    return !is_cancelled_;
  }

  std::vector<char> buffer_;
  double size_;
  double taken_ = 0;
  const CGAL::Intrinsic_triangulations::Progress_function& progress_;
  bool has_tabs_turned_ = false;
  bool is_cancelled_ = false;
};

} // namespace idt

#endif // IDT_FORMATS_WATCHED_FILE_H
