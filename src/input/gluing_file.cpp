// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/gluing_file.h"

#include "input/formats/Watched_file.h"
#include "input/formats/checks.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex_io.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <filesystem>
#include <istream>
#include <new>
#include <utility>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

bool is_gluing_file(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension == ".gluing";
}

void read_gluing_file(const std::string& path, IT::Delta_complex& connectivity,
                      std::vector<double>& lengths, const IT::Progress_function& progress)
{
  const std::uintmax_t size = check_file(path);
  if (size == 0)
    refuse(path, "the file is empty");
  check_encoding(path);
  Watched_file file(path, size, progress);
  const auto stop_if_cancelled = [&] {
    if (file.is_cancelled())
      throw IT::Cancelled_error(path + ": cancelled while it was read");
  };
  try {
    std::istream in(&file);
    auto gluing = IT::read_gluing(in);
    // To whoever reads, a cancelled file is one that ends.
    stop_if_cancelled();
    connectivity = std::move(gluing.complex);
    lengths = std::move(gluing.lengths);
  } catch (const IT::Invalid_surface_error& e) {
    stop_if_cancelled();
    throw IT::Invalid_surface_error(e.defect(), e.element(), e.count(), path + ": " + e.what());
  } catch (const std::bad_alloc&) {
    refuse(path, "there is not enough memory for this file");
  }
}

} // namespace idt
