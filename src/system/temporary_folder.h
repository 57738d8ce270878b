// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_TEMPORARY_FOLDER_H
#define IDT_TEMPORARY_FOLDER_H

#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace idt {

// A new folder for this process alone; empty if there can be none.
inline std::string make_temporary_folder()
{
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  if (error)
    return std::string();
  std::string path = (parent / "idt-XXXXXX").string();
  return ::mkdtemp(&path[0]) ? path : std::string();
}

} // namespace idt

#endif // IDT_TEMPORARY_FOLDER_H
