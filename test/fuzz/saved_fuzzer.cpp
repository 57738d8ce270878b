// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files of triangulations, damaged without changing their sizes: they are refused for a reason, or are read as a
// triangulation of the file's surface, which is written as it was read.

#include "check_core.h"
#include "fuzz_target.h"
#include "saved_files.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace {

using fuzz::require;
namespace IT = fuzz::IT;

// Each change takes up to eight bytes: its kind, place and value.
void change(std::string& file, fuzz::Bytes& bytes)
{
  const unsigned kind = bytes.below(8);
  // Seldom in the header, where almost every change is refused at once.
  const std::size_t header = file.find("end_header") + 11,
                    begin = bytes.below(16) == 0 || header + 8 > file.size() ? 0 : header;
  const auto place = [&] {
    std::size_t at = bytes.next();
    at = 256 * at + bytes.next();
    return begin + at % (file.size() - begin - 4);
  };
  const std::size_t at = place(), value = bytes.next();
  std::uint32_t word;
  std::memcpy(&word, &file[at], 4);
  switch (kind) {
  case 0:
    word += 1;
    break;
  case 1:
    word -= 1;
    break;
  case 2:
    word = std::uint32_t(value);
    break;
  case 3:
    word ^= std::uint32_t(1) << (value % 32);
    break;
  case 4: // the word of another place
    std::memcpy(&word, &file[place()], 4);
    break;
  case 5: { // both change places
    const std::size_t other = place();
    std::uint32_t there;
    std::memcpy(&there, &file[other], 4);
    std::memcpy(&file[other], &word, 4);
    word = there;
    break;
  }
  case 6:
    file[(at + value) % file.size()] = char(bytes.next());
    return;
  default:
    file.resize(value == 0 ? at : file.size());
    return;
  }
  std::memcpy(&file[at], &word, 4);
}

void check(const fuzz::Filtered_triangulation& t)
{
  require(t.connectivity().is_valid(true), "the connectivity is valid");
  require(IT::verify_Delaunay(t).inverted.empty(), "no face is inverted");
  bool has_no_area = false;
  std::vector<double> input_areas;
  const auto& metric = t.input_metric();
  for (IT::Face_index f : t.input().faces()) {
    const double squared = IT::squared_four_areas(metric, t.input(), f).convert_to<double>();
    input_areas.push_back(std::ldexp(std::sqrt(squared) / 4, 2 * t.unit_exponent()));
    has_no_area = has_no_area || squared == 0;
  }
  fuzz::check_numbers(t, false, has_no_area);
  try {
    const IT::Common_subdivision subdivision(t);
    if (!has_no_area)
      fuzz::check_areas(t, subdivision, input_areas);
  } catch (const IT::Undecided_error&) {
    require(false, "each edge is a line over the input");
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  static const std::vector<std::string> files = fuzz::saved_files();
  std::string file;
  const unsigned number = bytes.below(256);
  if (number < 200) {
    file = files[number % files.size()];
    while (!bytes.is_at_end() && file.size() >= 64)
      change(file, bytes);
  } else {
    file.assign(reinterpret_cast<const char*>(data) + 1, size - (size != 0));
  }
  std::istringstream is(file);
  try {
    const fuzz::Filtered_triangulation t = IT::read_triangulation(is);
    check(t);
    std::ostringstream os;
    IT::write_triangulation(os, t);
    std::istringstream again(os.str());
    std::ostringstream os_again;
    IT::write_triangulation(os_again, IT::read_triangulation(again));
    require(os.str() == os_again.str(), "what was read is written alike");
  } catch (const IT::Error& error) {
    require(*error.what() != '\0', "a refusal says why");
  }
  return 0;
}
