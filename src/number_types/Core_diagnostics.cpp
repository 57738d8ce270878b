// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/Core_diagnostics.h"

#include "system/system_calls.h"

#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace idt {

#ifdef _WIN32
// The file stays where it is.
Discarded_core_diagnostics::Discarded_core_diagnostics() = default;
Discarded_core_diagnostics::~Discarded_core_diagnostics() = default;
#else
// If the folder cannot be created, nothing changes.
Discarded_core_diagnostics::Discarded_core_diagnostics()
{
  old_folder_ = ::open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  folder_ = make_temporary_folder();
  if (old_folder_ == -1 || folder_.empty() || ::chdir(folder_.c_str()) != 0)
    return;
  static_cast<void>(::symlink("/dev/null", "Core_Diagnostics"));
}

Discarded_core_diagnostics::~Discarded_core_diagnostics()
{
  if (old_folder_ != -1) {
    if (::fchdir(old_folder_) != 0)
      std::abort(); // otherwise results would go to a folder that the user did not name
    ::close(old_folder_);
  }
  std::error_code error;
  if (!folder_.empty())
    std::filesystem::remove_all(folder_, error);
}
#endif

} // namespace idt
