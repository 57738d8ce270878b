// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the command as a shell would, in a folder of its own for each test.

#ifndef IDT_TEST_COMMAND_TEST_H
#define IDT_TEST_COMMAND_TEST_H

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

// The results of a run.
struct Command_run
{
  int status = -1; // the exit status, or 128 + a signal that ended the run
  std::string out;
  std::string err;
};

inline std::string content(const fs::path& path)
{
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

inline std::vector<std::string> lines(const std::string& text)
{
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    result.push_back(line);
  return result;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The executable, named by the environment or else by the build.
inline std::string command_path()
{
  if (const char* path = std::getenv("IDT_COMMAND"))
    return path;
#ifdef IDT_COMMAND_PATH
  return IDT_COMMAND_PATH;
#else
  return "";
#endif
}

// The evaluation meshes, if present.
inline fs::path data_folder()
{
  if (const char* path = std::getenv("IDT_DATA_DIR"))
    return path;
  const fs::path root = fs::path(__FILE__).parent_path().parent_path().parent_path();
  return root / ".." / "shared" / "data";
}

class Command_test : public testing::Test
{
protected:
  void SetUp() override
  {
    if (command_path().empty())
      GTEST_SKIP() << "the environment variable IDT_COMMAND does not name the command";
    std::string name = (fs::temp_directory_path() / "idt-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(&name[0]), nullptr);
    folder_ = name;
  }
  void TearDown() override
  {
    if (!folder_.empty())
      fs::remove_all(folder_);
  }

  // Runs `idt ARGUMENTS` in the folder; the shell handles `>` and `<`.
  Command_run idt(const std::string& arguments) const { return shell("'" + command_path() + "' " + arguments); }

  Command_run shell(const std::string& line) const
  {
    const std::string command = "cd '" + folder_.string() + "' && { " + line + "\n} > .out 2> .err < /dev/null";
    const int result = std::system(command.c_str());
    Command_run run;
    run.status = WIFEXITED(result) ? WEXITSTATUS(result) : 128 + WTERMSIG(result);
    run.out = content(folder_ / ".out");
    run.err = content(folder_ / ".err");
    return run;
  }

  void write(const std::string& name, const std::string& text) const
  {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  // The names in the folder that a user would see.
  std::vector<std::string> files() const
  {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name != ".out" && name != ".err")
        names.push_back(name);
    }
    return names;
  }

  // Two triangles with a short diagonal, or, with `is_Delaunay` false, the long one.
  void write_kite(const std::string& name, bool is_Delaunay = false) const
  {
    write(name, std::string("OFF\n4 2 0\n0 0 0\n1 -0.25 0\n2 0 0\n1 0.25 0\n") +
                  (is_Delaunay ? "3 0 1 3\n3 1 2 3\n" : "3 0 1 2\n3 0 2 3\n"));
  }

  fs::path folder_;
};

#endif // IDT_TEST_COMMAND_TEST_H
