// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command on all evaluation meshes; a table shows the outcomes. None ends in a signal, an assertion, a NaN or an
// empty message.

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

class Command_evaluation_data : public Command_test
{
protected:
  void SetUp() override
  {
    Command_test::SetUp();
    if (!fs::is_directory(data_folder()))
      GTEST_SKIP() << "the evaluation meshes are not there";
  }

  static std::vector<fs::path> meshes(const std::string& folder)
  {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(data_folder() / folder))
      paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  // Except for text and the name of a file.
  static void expect_clean(std::string text)
  {
    for (const std::string allowed : {"synth_bad_nan.off", "the coordinate \"nan\" is not finite"})
      for (std::size_t i; (i = text.find(allowed)) != std::string::npos;)
        text.erase(i, allowed.size());
    for (const char* word : {"nan", "NaN", "assert", "CGAL ERROR", "internal error", "terminate", "what()"})
      EXPECT_FALSE(contains(text, word)) << word << " in " << text.substr(0, 2000);
  }

  // The outcome in a few words: the flips, or the first line of the message.
  std::string run(const fs::path& path, const std::string& options, int& status) const
  {
    const Command_run run =
      idt("triangulate '" + fs::canonical(path).string() + "' --verify --stats s.json --edges e.csv " + options);
    status = run.status;
    expect_clean(run.out + run.err);
    if (run.status == 0) {
      expect_clean(content(folder_ / "e.csv"));
      const Json stats = Json::parse(content(folder_ / "s.json"));
      EXPECT_EQ(stats["status"], "done");
      EXPECT_EQ(stats["verification"]["not_delaunay"], 0);
      return std::to_string(stats["flips"].get<std::uint64_t>()) + " flips";
    }
    EXPECT_EQ(run.status, 3) << run.err;
    const std::size_t begin = run.err.rfind(path.filename().string() + ": ");
    EXPECT_NE(begin, std::string::npos) << run.err;
    const std::string text = lines(run.err.substr(begin + path.filename().string().size() + 2)).at(0);
    EXPECT_GT(text.size(), 10u);
    return text;
  }
};

// Defects that nothing can repair.
const std::map<std::string, std::string> hopeless = {
  {"geogram_corrupted_invalid_facet_vertex.off", "the face names vertex 7, but there are 6 vertices"},
  {"geogram_corrupted_invalid_facet_vertex_2.off", "the face names vertex 100, but there are 12 vertices"},
  {"libhedra_hexagonalminimal_plusgauss.off", "the face names vertex 400, but there are 400 vertices"},
  {"synth_bad_inf.off", "vertex 0"},
  {"synth_bad_nan.off", "vertex 0"},
  {"synth_bad_only_vertices.off", "no face"}};

TEST_F(Command_evaluation_data, good_meshes_become_Delaunay)
{
  for (const char* folder : {"table1", "good"})
    for (const fs::path& path : meshes(folder)) {
      SCOPED_TRACE(path);
      int status = 0;
      const std::string outcome = run(path, "--overlay o.ply", status);
      EXPECT_EQ(status, 0);
      std::cout << folder << '/' << path.filename().string() << ": " << outcome << '\n';
      // A NaN would have all bits of the exponent set; these are vertex numbers.
      EXPECT_GT(fs::file_size(folder_ / "o.ply"), 0u);
    }
}

TEST_F(Command_evaluation_data, bad_meshes_are_refused_with_a_reason_or_repaired)
{
  std::size_t number_of_hopeless = 0;
  for (const fs::path& path : meshes("bad")) {
    SCOPED_TRACE(path);
    int status = 0, repaired_status = 0;
    const std::string outcome = run(path, "", status),
                      repaired = run(path, "--repair --repair-map m.csv --overlay o.ply", repaired_status);
    std::cout << path.filename().string() << ":\n    " << outcome << "\n    with --repair: " << repaired << '\n';
    EXPECT_EQ(status, 3);
    // A refusal names its element.
    EXPECT_TRUE(contains(outcome, "face") || contains(outcome, "edge") || contains(outcome, "vert")) << outcome;
    const auto found = hopeless.find(path.filename().string());
    if (found == hopeless.end()) {
      EXPECT_EQ(repaired_status, 0);
      EXPECT_TRUE(contains(outcome, "--repair")) << outcome;
    } else {
      ++number_of_hopeless;
      EXPECT_EQ(repaired_status, 3);
      EXPECT_TRUE(contains(outcome, found->second)) << outcome;
      EXPECT_FALSE(contains(outcome, "--repair")) << outcome;
    }
  }
  EXPECT_EQ(number_of_hopeless, hopeless.size());
}

// Rows sum to zero, no entry off the diagonal is positive, and none on it is negative: so the matrix is positive
// semidefinite.
void check_operator(const fs::path& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  std::size_t rows = 0, columns = 0, entries = 0;
  file >> rows >> columns >> entries;
  std::vector<double> sum(rows, 0), diagonal(rows, 0);
  std::size_t row, column, number_of_entries = 0;
  for (double value; file >> row >> column >> value; ++number_of_entries) {
    sum[row - 1] += value;
    if (row == column) {
      diagonal[row - 1] = value;
    } else {
      sum[column - 1] += value;
      EXPECT_LE(value, 0) << row << ' ' << column;
    }
  }
  EXPECT_GT(rows, 0u);
  EXPECT_EQ(number_of_entries, entries);
  for (std::size_t i = 0; i < rows; ++i)
    EXPECT_LE(std::abs(sum[i]), 1e-12 * diagonal[i]) << i + 1;
}

TEST_F(Command_evaluation_data, all_meshes_have_a_Laplacian)
{
  std::size_t number_of_hopeless = 0;
  for (const char* folder : {"table1", "good", "bad"})
    for (const fs::path& path : meshes(folder)) {
      SCOPED_TRACE(path);
      const Command_run run = idt("laplacian '" + fs::canonical(path).string() + "' --stiffness L.mtx");
      const auto found = hopeless.find(path.filename().string());
      if (found == hopeless.end()) {
        EXPECT_EQ(run.status, 0) << run.err;
        check_operator(folder_ / "L.mtx");
      } else {
        ++number_of_hopeless;
        EXPECT_EQ(run.status, 3);
        EXPECT_TRUE(contains(run.err, found->second)) << run.err;
      }
    }
  EXPECT_EQ(number_of_hopeless, hopeless.size());
}

} // namespace
