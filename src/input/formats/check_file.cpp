// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace idt {

std::uintmax_t check_file(const std::string& path)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    refuse(path, "there is no such file");
  if (fs::is_directory(status))
    refuse(path, "this is a directory, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse(path, "this is not a regular file");
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
    refuse(path, std::string("the file cannot be opened") +
                   (errno == 0 ? "" : std::string(" (") + std::strerror(errno) + ")"));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
    refuse(path, "the file cannot be read (" + error.message() + ")");
  return size;
}

void check_encoding(const std::string& path)
{
  const std::string head = load(path, 1 << 16);
  if (head.compare(0, 3, "\xef\xbb\xbf") == 0)
    refuse(path, "the file begins with a byte order mark: save it as UTF-8 without one");
  if (head.compare(0, 2, "\xff\xfe") == 0 || head.compare(0, 2, "\xfe\xff") == 0)
    refuse(path, "the text is in UTF-16: save it as ASCII or UTF-8");
  const std::size_t end = head.find('\r');
  if (end != std::string::npos && head.find('\n') == std::string::npos &&
      head.find_first_not_of(" \t\r", end) != std::string::npos)
    refuse(path, "the lines end with CR alone, as on old Macintosh computers: convert them to LF");
}

} // namespace idt
