// SPDX-License-Identifier: GPL-3.0-or-later

#include "gluing_file.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex_io.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

bool is_gluing_file(const std::string& path)
{
  return std::filesystem::path(path).extension() == ".gluing";
}

void read_gluing_file(const std::string& path, IT::Delta_complex& connectivity,
                      std::vector<double>& lengths)
{
  using Error = IT::Invalid_surface_error;
  const auto refuse = [&](const std::string& text) {
    throw Error(Error::Defect::UNREADABLE, 0, 1, path + ": " + text);
  };
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    refuse("is a folder");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    refuse(errno == 0 ? "cannot be opened" : std::strerror(errno));
  try {
    auto gluing = IT::read_gluing(in);
    if (in.bad())
      refuse("cannot be read");
    connectivity = std::move(gluing.complex);
    lengths = std::move(gluing.lengths);
  } catch (const Error& e) {
    throw Error(e.defect(), e.element(), e.count(), path + ": " + e.what());
  }
}

} // namespace idt
