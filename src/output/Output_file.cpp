// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Output_file.h"

#include "system/system_calls.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <streambuf>
#include <system_error>

namespace idt {
namespace {

namespace fs = std::filesystem;

// The file behind symbolic links, which need not exist. Renaming onto a link would replace it.
std::string behind_links(const std::string& path, std::error_code& error)
{
  fs::path target = path;
  for (int links = 0; fs::is_symlink(fs::symlink_status(target, error)); ++links) {
    const fs::path link = fs::read_symlink(target, error);
    if (links == 40)
      error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    if (error)
      return path;
    target = target.parent_path() / link;
  }
  error.clear();
  return target.string();
}

// Creates a new file, so that no other process writes to the same one. Its permissions are no wider than those of the
// file that it will replace.
int create_beside(const std::string& target, std::string& temporary)
{
  const bool is_old = fs::exists(target);
  for (int attempt = 0; attempt < 1000; ++attempt) {
    // A name may have 255 bytes.
    const fs::path path(target);
    temporary = (path.parent_path() / path.filename().string().substr(0, 200)).string() + ".part-" +
                std::to_string(process_number()) + "-" + std::to_string(attempt);
    const int error_number = create_new_file(temporary, is_old);
    if (error_number == 0)
      return 0;
    if (error_number != EEXIST) {
      temporary.clear();
      return error_number;
    }
  }
  temporary.clear();
  return EEXIST;
}

// The destination of results for "-", and of reports by default.
std::ostream& standard_output()
{
  static std::ostream os(std::cout.rdbuf());
  return os;
}

class Null_buffer : public std::streambuf
{
  int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize n) override { return n; }
};

} // namespace

void route_reports(bool is_quiet, bool is_output_taken)
{
  standard_output();
  // std::cout is flushed after all static objects have ended.
  if (is_quiet)
    std::cout.rdbuf(new Null_buffer);
  else if (is_output_taken)
    std::cout.rdbuf(std::cerr.rdbuf());
}

Output_file::Output_file(const std::string& path) : path_(path), target_(path)
{
  if (path_ == "-")
    return;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status))
    fail(EISDIR);
  if (!fs::exists(status) || fs::is_regular_file(status)) {
    target_ = behind_links(path, error);
    if (error)
      fail(error.value());
    int error_number = 0;
    unfinished_.emplace([&] { error_number = create_beside(target_, temporary_); }, [this] { remove_temporary(); });
    if (error_number != 0)
      fail(error_number);
  }
  // Opening a pipe without a reader would wait forever. The descriptor that is open until the stream is keeps the
  // reader from seeing an end.
  const int pipe = fs::is_fifo(status) ? open_pipe_with_reader(path) : -1;
  if (fs::is_fifo(status) && pipe < 0) {
    if (errno == ENXIO)
      throw Output_error(path_ + ": cannot be written: no program reads from this pipe");
    fail(errno);
  }
  errno = 0;
  stream_.open(temporary_.empty() ? target_ : temporary_, std::ios::binary | std::ios::trunc);
  const int error_number = errno;
  if (pipe >= 0)
    close_descriptor(pipe);
  if (!stream_) {
    remove_temporary();
    fail(error_number);
  }
}

Output_file::~Output_file()
{
  stream_.close();
  if (!is_committed_)
    remove_temporary();
}

void Output_file::remove_temporary() const
{
  std::error_code error;
  if (!temporary_.empty())
    fs::remove(temporary_, error);
}

std::ostream& Output_file::stream() { return path_ == "-" ? standard_output() : stream_; }

void Output_file::commit()
{
  if (path_ == "-")
    return flush_standard_output();
  // A stream that has failed does not try again, so errno still has the reason.
  const int reason = stream_ ? 0 : errno;
  errno = 0;
  stream_.flush();
  stream_.close();
  if (!stream_)
    fail(errno == 0 ? reason : errno);
  if (!temporary_.empty()) {
    std::error_code error;
    const fs::file_status old = fs::status(target_, error);
    if (fs::exists(old))
      fs::permissions(temporary_, old.permissions(), error);
    fs::rename(temporary_, target_, error);
    if (error)
      fail(error.value());
  }
  is_committed_ = true;
}

void Output_file::fail(int error_number) const
{
  throw Output_error(path_ + ": cannot be written" +
                     (error_number == 0 ? "" : std::string(": ") + std::strerror(error_number)));
}

void check_output_paths(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs)
{
  const auto is_same_file = [](const std::string& a, const std::string& b) {
    if (a == "-" || b == "-")
      return a == b;
    std::error_code error;
    const fs::file_status status = fs::status(a, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
      return false; // a device accepts anything
    // If no part of a path exists yet, only an absolute path becomes canonical, and no link to it.
    const auto target = [&error](const std::string& path) {
      return fs::weakly_canonical(fs::absolute(behind_links(path, error)), error);
    };
    return target(a) == target(b) || fs::equivalent(a, b, error);
  };
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].empty())
      continue;
    for (std::size_t j = 0; j < i; ++j)
      if (!outputs[j].empty() && is_same_file(outputs[i], outputs[j]))
        throw Usage_error(outputs[i] == "-"
                            ? "two results cannot both go to the standard output"
                            : outputs[i] + ": two results cannot go to the same file: choose another name");
    for (const std::string& input : inputs)
      if (!input.empty() && input != "-" && is_same_file(outputs[i], input))
        throw Usage_error(outputs[i] + ": a result would replace an input: choose another name");
  }
}

void flush_standard_output()
{
  static bool has_failed = false; // and that was reported
  if (has_failed)
    return;
  errno = 0;
  std::cout.flush();
  standard_output().flush();
  has_failed = !std::cout || !standard_output();
  if (has_failed && has_lost_reader())
    throw Output_error(""); // as `head` ends when it has seen enough
  if (has_failed)
    throw Output_error(std::string("the standard output cannot be written") +
                       (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
}

} // namespace idt
