// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file that gets its name only when it is complete; and the standard output, named "-".

#ifndef IDT_OUTPUT_FILE_H
#define IDT_OUTPUT_FILE_H

#include "system/Exit_status.h"
#include "system/Interruption.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

// Writes under a temporary name in the same folder, and renames the file in commit(). Without a commit(), the
// destructor removes it, and so does an interruption that ends the process. An existing target that is not a regular
// file, such as a device or a pipe, is written to directly, and so is the standard output.
class Output_file
{
public:
  // \exception Output_error if nothing can be written there
  explicit Output_file(const std::string& path);
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file();

  std::ostream& stream();

  // \exception Output_error if not everything could be written; then there is no file, or the old one is unchanged
  void commit();

private:
  [[noreturn]] void fail(int error_number) const;
  void remove_temporary() const;

  std::string path_;
  std::string target_;    // path_ behind symbolic links
  std::string temporary_; // empty if the target is written directly
  std::ofstream stream_;
  bool is_committed_ = false;
  std::optional<Unfinished> unfinished_;
};

// Calls write(stream) for a file, unless its name is empty.
// \exception Output_error as Output_file
template <class Write>
void write_file(const std::string& path, const Write& write)
{
  if (path.empty())
    return;
  Output_file file(path);
  write(file.stream());
  file.commit();
}

// A name that tells the format: the name of the file, or for the standard output one that ends in `format`.
inline std::string name_with_format(const std::string& path, const std::string& format)
{
  return path == "-" ? "-." + format : path;
}

// The extension of that name.
inline std::string extension_with_format(const std::string& path, const std::string& format)
{
  return std::filesystem::path(name_with_format(path, format)).extension().string();
}

// From now on, output to std::cout is dropped, or goes to the standard error if a result takes the standard output.
void route_reports(bool is_quiet, bool is_output_taken);

// Refuses output files that would replace each other or an input. Empty names are ignored.
// \exception Usage_error
void check_output_paths(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

// Flushes the standard output.
// \exception Output_error if that fails, at the first time
void flush_standard_output();

} // namespace idt

#endif // IDT_OUTPUT_FILE_H
