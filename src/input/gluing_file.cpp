// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/gluing_file.h"

#include "input/standard_input.h"

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <new>
#include <string>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// A buffer for a std::istream that reports how much of a file was read, and ends early on request. For each piece of
// the file that it takes, it calls `progress` with the fraction taken before.
class Watched_file : public std::filebuf
{
public:
  // \param size the size of the file in bytes
  Watched_file(const std::string& path, std::uintmax_t size, const IT::Progress_function& progress)
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
  const IT::Progress_function& progress_;
  bool is_cancelled_ = false;
};

} // namespace

bool is_gluing_file(const std::string& path)
{
  std::string extension = std::filesystem::path(readable_file(path)).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".gluing";
}

IT::Exact_gluing read_gluing_file(const std::string& name, const IT::Progress_function& progress)
{
  const std::string path = readable_file(name);
  const std::uintmax_t size = IT::readable_file_size(path);
  if (size == 0)
    refuse_file(path, "the file is empty");
  if (const int first = std::ifstream(path, std::ios::binary).get(); first == 0xfe || first == 0xff)
    refuse_file(path, "the text is in UTF-16: save it as ASCII or UTF-8");
  Watched_file file(path, size, progress);
  const auto stop_if_cancelled = [&] {
    if (file.is_cancelled())
      throw IT::Cancelled_error(path + ": cancelled while it was read");
  };
  try {
    std::istream in(&file);
    IT::Exact_gluing gluing = IT::read_exact_gluing(in);
    // To a reader, a cancelled file simply ends.
    stop_if_cancelled();
    if (!gluing.squared_lengths.empty())
      gluing.lengths = rounded_lengths(gluing.squared_lengths);
    return gluing;
  } catch (const IT::Invalid_surface_error& e) {
    stop_if_cancelled();
    throw IT::Invalid_surface_error(e.defect(), e.element(), e.count(), path + ": " + e.what());
  } catch (const std::bad_alloc&) {
    refuse_file(path, "there is not enough memory for this file");
  }
}

std::vector<double> rounded_lengths(const std::vector<IT::Rational>& squared_lengths)
{
  std::vector<double> lengths;
  lengths.reserve(squared_lengths.size());
  for (const IT::Rational& s : squared_lengths) {
    // The root of s 4^k, an integer of 64 bits or one more
    IT::Integer n = numerator(s), d = denominator(s);
    if (n <= 0) {
      lengths.push_back(0);
      continue;
    }
    const long k = 64 - (long(msb(n)) - long(msb(d))) / 2;
    (k > 0 ? n : d) <<= static_cast<unsigned long>(2 * std::labs(k));
    lengths.push_back(std::ldexp(sqrt(IT::Integer(n / d)).convert_to<double>(), int(-k)));
  }
  return lengths;
}

} // namespace idt
