// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results that cannot be written.

#include "Command_test.h"

#include <sys/mount.h>
#include <unistd.h>

namespace {
using Command_output = Command_test;
}

TEST_F(Command_output, replaces_a_file_when_the_new_one_is_complete)
{
  write_kite("kite.off");
  write("e.csv", "old");
  fs::create_symlink("e.csv", folder_ / "link.csv");
  ASSERT_EQ(idt("triangulate kite.off --edges link.csv").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.csv"));
  EXPECT_EQ(lines(content(folder_ / "e.csv")).size(), 6u);
  EXPECT_EQ(files().size(), 3u);
}

TEST_F(Command_output, goes_where_links_lead_though_nothing_is_there)
{
  write_kite("kite.off");
  fs::create_directory(folder_ / "results");
  fs::create_symlink("results/link.csv", folder_ / "first.csv");
  fs::create_symlink("e.csv", folder_ / "results" / "link.csv");
  ASSERT_EQ(idt("triangulate kite.off --edges first.csv").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "first.csv"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "results" / "link.csv"));
  EXPECT_EQ(lines(content(folder_ / "results" / "e.csv")).size(), 6u);

  fs::create_symlink("loop.csv", folder_ / "loop.csv");
  const Command_run loop = idt("triangulate kite.off --edges loop.csv");
  EXPECT_EQ(loop.status, 1);
  EXPECT_TRUE(contains(loop.err, "loop.csv")) << loop.err;
  EXPECT_TRUE(fs::is_symlink(folder_ / "loop.csv"));
}

TEST_F(Command_output, keeps_the_permissions_of_the_file_that_it_replaces)
{
  write_kite("kite.off");
  for (const fs::perms mode : {fs::perms(0600), fs::perms(0640), fs::perms(0755), fs::perms(0444)}) {
    write("e.csv", "old");
    fs::permissions(folder_ / "e.csv", mode);
    ASSERT_EQ(idt("triangulate kite.off --edges e.csv").status, 0);
    EXPECT_EQ(fs::status(folder_ / "e.csv").permissions(), mode);
    fs::remove(folder_ / "e.csv");
  }
  ASSERT_EQ(shell("umask 027; '" + command_path() + "' triangulate kite.off --edges e.csv").status, 0);
  EXPECT_EQ(fs::status(folder_ / "e.csv").permissions(), fs::perms(0640));
}

TEST_F(Command_output, leaves_nothing_behind_when_the_space_ends)
{
  ASSERT_EQ(idt("sample torus -o torus.off").status, 0);
  write("e.csv", "old");
  // The largest file that the shell allows is smaller than the result.
  const Command_run run = shell("ulimit -f 8; '" + command_path() + "' triangulate torus.off --edges e.csv");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "e.csv"));
  EXPECT_EQ(content(folder_ / "e.csv"), "old");
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(Command_output, says_when_a_file_cannot_be_written)
{
  write_kite("kite.off");
  for (const char* option : {"--edges", "--stats"})
    for (const char* path : {"missing/file", "."}) {
      const Command_run run = idt(std::string("triangulate kite.off ") + option + " " + path);
      EXPECT_EQ(run.status, 1) << option << ' ' << path;
      EXPECT_TRUE(contains(run.err, path)) << run.err;
    }
  EXPECT_EQ(files(), std::vector<std::string>{"kite.off"});
}

TEST_F(Command_output, takes_names_as_long_as_the_file_system_does)
{
  write_kite("kite.off");
  const std::string name = std::string(250, 'x') + ".csv";
  EXPECT_EQ(idt("triangulate kite.off --edges " + name).status, 0);
  EXPECT_TRUE(fs::exists(folder_ / name));
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(Command_output, says_when_a_folder_is_read_only)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "the superuser may write anywhere";
  write_kite("kite.off");
  fs::create_directory(folder_ / "locked");
  fs::permissions(folder_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  const Command_run run = idt("triangulate kite.off --edges locked/e.csv");
  fs::permissions(folder_ / "locked", fs::perms::owner_all);
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(fs::is_empty(folder_ / "locked"));
}

TEST_F(Command_output, leaves_nothing_on_a_full_or_read_only_disk)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("sample torus -o torus.off").status, 0);
  ASSERT_EQ(idt("sample strip -o strip.off").status, 0);
  const std::string disk = (folder_ / "disk").string();
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=16k") != 0)
    GTEST_SKIP() << "only the superuser may mount a file system";
  write("disk/old.ply", "old");
  for (const char* arguments :
       {"triangulate torus.off --overlay disk/old.ply", "triangulate torus.off --edges disk/new.csv",
        "triangulate torus.off --laplacian disk/new.mtx", "sample torus -o disk/new.ply",
        "parameterize strip.off --uv disk/new.obj"}) {
    const Command_run run = idt(arguments);
    EXPECT_EQ(run.status, 1) << arguments << ": " << run.err;
    EXPECT_TRUE(contains(run.err, "No space left")) << run.err;
    EXPECT_EQ(content(folder_ / "disk/old.ply"), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(disk), fs::directory_iterator()), 1) << arguments;
  }
  ::mount("tmpfs", disk.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr);
  const Command_run run = idt("triangulate kite.off --edges disk/e.csv");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "disk/e.csv: cannot be written: Read-only file system")) << run.err;
  EXPECT_EQ(::umount(disk.c_str()), 0);
}

TEST_F(Command_output, says_when_a_device_is_full)
{
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  write_kite("kite.off");
  EXPECT_EQ(idt("triangulate kite.off --edges /dev/full").status, 1);
  EXPECT_EQ(idt("triangulate kite.off --stats /dev/full").status, 1);
  EXPECT_EQ(idt("triangulate kite.off > /dev/full").status, 1);
  EXPECT_EQ(idt("table kite.off > /dev/full").status, 1);
  EXPECT_EQ(idt("sample torus > /dev/full").status, 1);
  EXPECT_EQ(idt("sample --list > /dev/full").status, 1);
  EXPECT_EQ(idt("--help > /dev/full").status, 1);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_EQ(idt("triangulate kite.off --edges /dev/null --stats /dev/null").status, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Command_output, does_not_wait_for_a_reader_of_a_pipe)
{
  write_kite("kite.off");
  const std::string triangulate = "timeout 20 '" + command_path() + "' triangulate kite.off ";
  const Command_run run = shell("mkfifo pipe; " + triangulate + "--edges pipe");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "pipe: cannot be written: no program reads from this pipe")) << run.err;
  // A pipe with a reader is a file like any other.
  EXPECT_EQ(shell("cat pipe > got & sleep 0.3; " + triangulate + "--edges pipe; wait").status, 0);
  EXPECT_EQ(lines(content(folder_ / "got")).size(), 6u);
}

TEST_F(Command_output, says_when_the_standard_output_is_closed)
{
  write_kite("kite.off");
  const Command_run run = idt("triangulate kite.off --edges e.csv >&-");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(contains(run.err, "standard output"));
  EXPECT_EQ(lines(run.err).size(), 1u) << run.err;
  EXPECT_EQ(lines(idt("compare kite.off kite.off --number-types double >&-").err).size(), 1u);
  // The report must not go to a file that got the free descriptor.
  EXPECT_EQ(lines(content(folder_ / "e.csv")).size(), 6u);
  EXPECT_EQ(idt("sample torus >&-").status, 1);
  EXPECT_EQ(idt("triangulate kite.off 2>&-").status, 0);
}

TEST_F(Command_output, is_not_killed_by_a_closed_pipe)
{
  const Command_run run = shell("{ '" + command_path() + "' sample strip; echo $? > status; } | head -n 1");
  EXPECT_EQ(run.out, "OFF\n");
  EXPECT_EQ(content(folder_ / "status"), "1\n");
}

TEST_F(Command_output, is_silent_when_nobody_reads_the_report)
{
  write_kite("kite.off");
  const Command_run run =
    shell("{ sleep 0.3; '" + command_path() + "' triangulate kite.off --edges e.csv; echo $? > status; } | head -c 0");
  EXPECT_EQ(content(folder_ / "status"), "1\n");
  EXPECT_EQ(run.err, "");
  // An older complete file stays.
  EXPECT_EQ(lines(content(folder_ / "e.csv")).size(), 6u);
}
