// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A long job shows its progress on a terminal, and ends in good order on request.

#include "Command_test.h"

#include "property/symmetric_surfaces.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <pty.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iomanip>
#include <random>
#include <thread>

namespace {

using Json = nlohmann::json;

class Command_long_job : public Command_test
{
protected:
  // A rough sheet of n times n vertices, with many edges to flip.
  void write_sheet(const std::string& name, int n, double roughness) const
  {
    std::ofstream out(folder_ / name, std::ios::binary);
    out << "ply\nformat binary_little_endian 1.0\nelement vertex " << n * n
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << 2 * (n - 1) * (n - 1)
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(0, 1);
    const auto append = [&out](const auto& x) { out.write(reinterpret_cast<const char*>(&x), sizeof x); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (double x : {i + 0.4 * noise(random), 0.5 * j + 0.2 * noise(random), roughness * noise(random)})
          append(x);
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j + 1 < n; ++j) {
        const int a = i * n + j;
        for (const auto& t : {std::array<int, 3>{a, a + n, a + n + 1}, std::array<int, 3>{a, a + n + 1, a + 1}}) {
          out.put(3);
          append(t);
        }
      }
  }

  // Runs the command and interrupts it after a while; returns the exit status.
  int interrupt(const std::vector<std::string>& arguments, double seconds, int signal = SIGINT) const
  {
    std::vector<std::string> words = {command_path()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words)
      argv.push_back(&word[0]);
    argv.push_back(nullptr);
    const std::string err = (folder_ / ".err").string();
    const pid_t child = ::fork();
    if (child == 0) {
      const int out = ::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0666);
      ::dup2(out, 1);
      ::dup2(out, 2);
      if (::chdir(folder_.c_str()) == 0)
        ::execv(argv[0], argv.data());
      ::_exit(127);
    }
    const auto begin = std::chrono::steady_clock::now();
    wait_until_caught(child, signal);
    std::this_thread::sleep_until(begin + std::chrono::duration<double>(seconds));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  // Until a new process has installed its handlers, signals end it like any other. Waits for that if the system can
  // tell.
  static void wait_until_caught(pid_t process, int signal)
  {
    const std::string status = "/proc/" + std::to_string(process) + "/status";
    for (int millisecond = 0; millisecond < 10000; ++millisecond) {
      std::ifstream lines(status);
      std::string word, mask;
      bool ended = false;
      while (lines >> word && word != "SigCgt:")
        ended = ended || word == "Z";
      if (ended || !(lines >> mask) || (std::stoull(mask, nullptr, 16) >> (signal - 1) & 1) != 0)
        return;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  // The output of a run whose standard error is a terminal. \param until ends the run as soon as this text appears
  std::string on_terminal(const std::string& arguments, const std::string& until = std::string()) const
  {
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    EXPECT_GE(child, 0);
    if (child == 0) {
      const std::string line =
        "cd '" + folder_.string() + "' && exec '" + command_path() + "' " + arguments + " > .out";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
    std::string shown;
    char buffer[4096];
    for (ssize_t n; (n = ::read(terminal, buffer, sizeof buffer)) > 0;)
      if (shown.append(buffer, static_cast<std::size_t>(n)); !until.empty() && contains(shown, until))
        ::kill(child, SIGKILL);
    ::close(terminal);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(status == 0 || !until.empty()) << status;
    return shown;
  }

  // The time for the whole job.
  double time(const std::string& arguments) const
  {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(idt(arguments).status, 0);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  void expect_nothing_temporary() const
  {
    for (const std::string& name : files())
      EXPECT_EQ(name.find(".part-"), std::string::npos) << name;
  }
  bool exists(const std::string& name) const { return fs::exists(folder_ / name); }
  void remove_results() const
  {
    for (const std::string& name : files())
      if (name.find("result") == 0)
        fs::remove(folder_ / name);
  }
};

TEST_F(Command_long_job, can_be_interrupted_at_any_time)
{
  write_sheet("sheet.ply", 300, 1);
  const std::size_t edges = 3 * 299 * 299 + 2 * 299;
  const double whole = time("triangulate sheet.ply --overlay result.ply --edges result.csv --stats result.json");
  const std::string overlay = content(folder_ / "result.ply");
  std::mt19937 random(std::random_device{}());
  std::size_t interrupted = 0;
  const auto interrupt_after = [&](double delay) {
    remove_results();
    SCOPED_TRACE(delay);
    const int status = interrupt(
      {"triangulate", "sheet.ply", "--overlay", "result.ply", "--edges", "result.csv", "--stats", "result.json"},
      delay);
    EXPECT_TRUE(status == 0 || status == 4) << status << ": " << content(folder_ / ".err");
    interrupted += status == 4;
    expect_nothing_temporary();
    if (status == 0) {
      EXPECT_EQ(content(folder_ / "result.ply"), overlay);
    } else if (exists("result.json")) {
      EXPECT_EQ(Json::parse(content(folder_ / "result.json"))["status"], "interrupted");
      EXPECT_EQ(lines(content(folder_ / "result.csv")).size(), edges + 1);
      // The file can be read to its end; if no edge was flipped, it has only triangles.
      if (exists("result.ply")) {
        const Command_run read = idt("triangulate result.ply");
        EXPECT_TRUE(read.status == 0 || contains(read.err, "corners instead of 3")) << read.err;
      }
    } else {
      // Files written before time was up are complete.
      if (exists("result.csv")) {
        EXPECT_EQ(lines(content(folder_ / "result.csv")).size(), edges + 1);
      }
      EXPECT_TRUE(exists("result.csv") || !exists("result.ply"));
      EXPECT_TRUE(contains(content(folder_ / ".err"), "cancelled")) << content(folder_ / ".err");
    }
  };
  // Once in each tenth of the time: writing, which is completed, takes most of it.
  for (int run = 0; run < 10; ++run)
    interrupt_after((std::max)(0.01, whole / 10 * std::uniform_real_distribution<double>(run, run + 1)(random)));
  // The machine may have become faster since the whole time was measured.
  for (double delay = whole / 20; interrupted == 0 && delay > 0.001; delay /= 2)
    interrupt_after(delay);
  EXPECT_GT(interrupted, 0u);
}

// An interrupted refinement lists the faces it did not reach.
TEST_F(Command_long_job, lists_what_an_interrupted_refinement_leaves)
{
  write_sheet("sheet.ply", 30, 1);
  for (double seconds : {0.1, 0.2, 0.4}) {
    remove_results();
    EXPECT_EQ(interrupt({"refine", "sheet.ply", "--maximum-edge-length", "1e-4", "--maximum-points", "100000000",
                         "--stats", "result.json"},
                        seconds),
              4);
    ASSERT_TRUE(exists("result.json"));
    const Json json = Json::parse(content(folder_ / "result.json"));
    EXPECT_EQ(json["status"], "interrupted");
    if (!json["minimum_angle_degrees"].is_null()) { // there was time to look at the faces
      EXPECT_GT(json["unrefined"]["budget"], 0);
    }
  }
}

// A proof of this tie is attempted for ten seconds and then given up.
TEST_F(Command_long_job, can_be_interrupted_within_a_decision)
{
  const samples::Indexed_triangles sheet = symmetric_surfaces::quarter_turns(5).mesh;
  std::ofstream off(folder_ / "tie.off");
  off << "OFF\n" << sheet.points.size() << ' ' << sheet.triangles.size() << " 0\n" << std::setprecision(17);
  for (const auto& p : sheet.points)
    off << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : sheet.triangles)
    off << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  off.close();
  for (int signal : {SIGTERM, SIGINT}) {
    remove_results();
    EXPECT_EQ(
      interrupt({"triangulate", "tie.off", "--tie-proof", "proven", "--edges", "result.csv", "--stats", "result.json"},
                1, signal),
      4);
    EXPECT_TRUE(contains(content(folder_ / ".err"), "cancelled")) << content(folder_ / ".err");
    const Json json = Json::parse(content(folder_ / "result.json"));
    EXPECT_EQ(json["status"], "interrupted");
    EXPECT_EQ(lines(content(folder_ / "result.csv")).size(), json["edges"].get<std::size_t>() + 1);
    expect_nothing_temporary();
  }
}

TEST_F(Command_long_job, can_be_interrupted_while_a_map_is_found)
{
  write_sheet("sheet.ply", 70, 0.3);
  const double whole = time("parameterize sheet.ply --method conformal --uv result.obj --json result.json");
  const std::vector<std::string> all = files();
  std::mt19937 random(std::random_device{}());
  for (int run = 0; run < 8; ++run) {
    remove_results();
    const double delay = std::uniform_real_distribution<double>(0.01, whole)(random);
    SCOPED_TRACE(delay);
    const int status = interrupt(
      {"parameterize", "sheet.ply", "--method", "conformal", "--uv", "result.obj", "--json", "result.json"}, delay);
    EXPECT_TRUE(status == 0 || status == 4) << status << ": " << content(folder_ / ".err");
    expect_nothing_temporary();
    if (status == 0) {
      EXPECT_EQ(files().size(), all.size());
    } else {
      EXPECT_EQ(files(), std::vector<std::string>{"sheet.ply"});
      EXPECT_TRUE(contains(content(folder_ / ".err"), "cancelled")) << content(folder_ / ".err");
    }
  }
}

TEST_F(Command_long_job, can_be_interrupted_while_polygons_are_cut)
{
  // Crowns of two hundred corners, the largest polygons that are triangulated optimally.
  const int crowns = 1000, corners = 200;
  std::ofstream out(folder_ / "crowns.off");
  out << "OFF\n" << crowns * corners << ' ' << crowns << " 0\n";
  for (int i = 0; i < crowns * corners; ++i)
    out << std::cos(2 * 3.14159265358979 * i / corners) << ' ' << std::sin(2 * 3.14159265358979 * i / corners) << ' '
        << i / corners * 3 + i % 2 << '\n';
  for (int crown = 0; crown < crowns; ++crown) {
    out << corners;
    for (int i = 0; i < corners; ++i)
      out << ' ' << crown * corners + i;
    out << '\n';
  }
  out.close();
  // Reading takes a hundredth of the time, and cutting about a fifth.
  const double whole = time("triangulate crowns.off --repair --edges result.csv");
  // On a busy machine, a moment may be during reading, or after the repair.
  int status = 0;
  for (double part : {0.1, 0.15, 0.05, 0.2, 0.3, 0.4, 0.5}) {
    remove_results();
    status = interrupt({"triangulate", "crowns.off", "--repair", "--edges", "result.csv"}, part * whole);
    if (contains(content(folder_ / ".err"), "while it was repaired"))
      break;
  }
  EXPECT_EQ(status, 4);
  EXPECT_TRUE(contains(content(folder_ / ".err"), "crowns.off: cancelled while it was repaired"))
    << content(folder_ / ".err");
  EXPECT_EQ(files(), std::vector<std::string>{"crowns.off"});
}

// A factorization reports no progress.
TEST_F(Command_long_job, ends_within_a_second_where_nothing_asks)
{
  write_sheet("sheet.ply", 400, 0.5);
  for (int signal : {SIGINT, SIGTERM}) {
    int status = 0;
    double seconds = 10;
    // On a busy machine, the first moments may be during reading, or after the end.
    for (double delay = 0.5; delay < 8 && !(status == 4 && contains(content(folder_ / ".err"), "not complete"));
         delay *= 1.2) {
      const auto begin = std::chrono::steady_clock::now();
      status = interrupt({"laplacian", "sheet.ply", "--eigenvalues", "60", "--stats", "result.json"}, delay, signal);
      seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() - delay;
    }
    EXPECT_EQ(status, 4);
    EXPECT_LT(seconds, 2); // one, on an idle machine
    EXPECT_EQ(files(), std::vector<std::string>{"sheet.ply"});
  }
}

TEST_F(Command_long_job, ends_at_once_at_a_second_signal_without_half_files)
{
  write_sheet("sheet.ply", 300, 1);
  bool was_writing = false;
  for (int run = 0; run < 20 && !was_writing; ++run) {
    remove_results();
    const pid_t child = ::fork();
    if (child == 0) {
      const int out = ::open((folder_ / ".err").c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0666);
      ::dup2(out, 1);
      ::dup2(out, 2);
      if (::chdir(folder_.c_str()) == 0)
        ::execl(command_path().c_str(), "idt", "triangulate", "sheet.ply", "--overlay", "result.ply", nullptr);
      ::_exit(127);
    }
    const auto is_writing = [&] {
      for (const std::string& name : files())
        if (contains(name, ".part-"))
          return true;
      return false;
    };
    while (!is_writing() && ::waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::kill(child, SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(2)); // one that comes before the first was handled is lost
    ::kill(child, SIGINT);
    int status = 0;
    was_writing = ::waitpid(child, &status, 0) == child && WIFSIGNALED(status) && WTERMSIG(status) == SIGINT;
    expect_nothing_temporary();
  }
  EXPECT_TRUE(was_writing);
  EXPECT_FALSE(exists("result.ply"));
  EXPECT_TRUE(contains(content(folder_ / ".err"), "cancelled")) << content(folder_ / ".err");
}

// getrusage() counts the memory of a program that was replaced in its process as its successor's.
TEST_F(Command_long_job, reports_its_own_memory)
{
  write("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const pid_t child = ::fork();
  if (child == 0) {
    std::vector<char> large(std::size_t(500) << 20, 1);
    ::close(large[random() % large.size()] + 1000); // keeps the compiler from omitting it
    if (::chdir(folder_.c_str()) == 0 && ::freopen(".out", "w", stdout) != nullptr)
      ::execl(command_path().c_str(), "idt", "triangulate", "triangle.off", "--stats", "result.json", nullptr);
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_EQ(status, 0);
  const Json json = Json::parse(content(folder_ / "result.json"));
  EXPECT_GT(json["peak_memory_bytes"], std::size_t(1) << 20);
  EXPECT_LT(json["peak_memory_bytes"], std::size_t(400) << 20);
}

TEST_F(Command_long_job, shows_progress_on_a_terminal_and_nowhere_else)
{
  write_sheet("sheet.ply", 1000, 1);
  const std::string arguments = "triangulate sheet.ply --overlay result.ply";
  EXPECT_EQ(idt(arguments).err, "");
  const std::string shown = on_terminal(arguments);
  EXPECT_TRUE(contains(shown, "sheet.ply: ")) << shown;
  EXPECT_TRUE(contains(shown, "reading [") || contains(shown, "flipping, ") || contains(shown, "overlay [")) << shown;
  // The line is erased in the end.
  EXPECT_EQ(shown.substr(shown.size() - 4), "\r\x1b[K") << shown;
}

TEST_F(Command_long_job, shows_on_a_terminal_what_it_does_where_nobody_knows_how_much_is_done)
{
  write_sheet("sheet.ply", 400, 0.5);
  const std::string shown = on_terminal("laplacian sheet.ply --eigenvalues 60", "eigenvalues, 1 s");
  EXPECT_TRUE(contains(shown, "sheet.ply: factoring, and finding eigenvalues, 0 s")) << shown;
  EXPECT_TRUE(contains(shown, "sheet.ply: factoring, and finding eigenvalues, 1 s")) << shown;
}

} // namespace
