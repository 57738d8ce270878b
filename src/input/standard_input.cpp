// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/standard_input.h"

#include "system/Interruption.h"
#include "system/system_calls.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

class Standard_input
{
public:
  Standard_input() : unfinished_([this] { folder_ = make_temporary_folder(); }, [this] { remove(); })
  {
    try {
      const std::string path = folder_ + "/content";
      std::ofstream content(path, std::ios::binary);
      const std::string begin = copy_to(content);
      name_ = folder_ + "/standard-input" + extension(begin);
      content.close();
      if (folder_.empty() || !content || std::rename(path.c_str(), name_.c_str()) != 0)
        refuse();
    } catch (...) {
      remove();
      throw;
    }
  }
  Standard_input(const Standard_input&) = delete;
  Standard_input& operator=(const Standard_input&) = delete;
  ~Standard_input() { remove(); }

  const std::string& name() const { return name_; }

private:
  void remove() const
  {
    std::error_code error;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, error);
  }

  [[noreturn]] static void refuse()
  {
    refuse_file("-", std::string("the standard input cannot be stored in a temporary file: ") + std::strerror(errno));
  }

  // Waits for input; an interruption ends the wait. Returns the first bytes.
  static std::string copy_to(std::ostream& content)
  {
    std::string begin, block(std::size_t(1) << 20, '\0');
    for (;;) {
      if (is_interrupted())
        throw IT::Cancelled_error("-: cancelled while it was read");
      const long size = read_standard_input(&block[0], unsigned(block.size()));
      if (size == 0)
        return begin;
      if (size < 0 && errno != EAGAIN)
        refuse_file("-", std::string("the standard input cannot be read: ") + std::strerror(errno));
      if (size < 0)
        continue;
      if (begin.size() < 4096)
        begin.append(block, 0, std::size_t(size));
      if (!content.write(block.data(), size))
        refuse();
    }
  }

  static std::string extension(const std::string& begin)
  {
    if (begin.empty())
      refuse_file("-", "the standard input is empty");
    if (const std::string other = IT::other_format(begin); !other.empty())
      refuse_file("-", "the standard input is " + other +
                         ", which is not read: turn it into OFF, OBJ, PLY, STL or TS before");
    const std::string extension = IT::extension_of_contents(begin);
    if (extension.empty())
      refuse_file(
        "-", "the format of the standard input is not recognized: write it to a file, whose name tells the format");
    return extension;
  }

  std::string folder_, name_;
  Unfinished unfinished_;
};

std::string& name_of_input()
{
  static std::string name;
  return name;
}

} // namespace

std::string readable_file(const std::string& path)
{
  if (path != "-")
    return path;
  static const Standard_input input;
  name_of_input() = input.name();
  return input.name();
}

std::string with_shown_names(std::string message)
{
  const std::string& name = name_of_input();
  if (!name.empty())
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
      message.replace(at, name.size(), "-");
  return message;
}

} // namespace idt
