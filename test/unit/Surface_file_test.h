// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A folder for files that are read or refused, and the beginnings of some.

#ifndef IDT_TEST_SURFACE_FILE_TEST_H
#define IDT_TEST_SURFACE_FILE_TEST_H

#include "input/read_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace fs = std::filesystem;
typedef IT::Invalid_surface_error::Defect Defect;

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A folder that goes away with the test.
class Surface_file_test : public ::testing::Test
{
protected:
  void SetUp() override
  {
    const ::testing::TestInfo* const info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
      fs::temp_directory_path() / ("idt_read_surface_" + std::to_string(std::random_device()()) + "_" + info->name());
    fs::create_directories(folder_);
  }
  void TearDown() override
  {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  // Removes the file first: file systems flush a file to the disk when its content is replaced, so that thousands of
  // damaged files took minutes.
  std::string write(const std::string& name, const std::string& content) const
  {
    fs::remove(path(name));
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  // Expects that a file is refused, with a message that begins with its name and contains the text.
  IT::Invalid_surface_error refused(const std::string& file, const std::string& text,
                                    const Defect defect = Defect::UNREADABLE) const
  {
    try {
      idt::read_surface(file);
    } catch (const IT::Invalid_surface_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.compare(0, file.size() + 2, file + ": "), 0) << message;
      EXPECT_TRUE(contains(message, text)) << message;
      EXPECT_EQ(static_cast<int>(error.defect()), static_cast<int>(defect)) << message;
      return error;
    }
    ADD_FAILURE() << file << " was read";
    return IT::Invalid_surface_error(defect, 0, 0, "");
  }
  IT::Invalid_surface_error refused(const std::string& name, const std::string& content, const std::string& text,
                                    const Defect defect = Defect::UNREADABLE) const
  {
    return refused(write(name, content), text, defect);
  }

  fs::path folder_;
};

template <class T>
void append(std::string& text, const T& value)
{
  text.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

inline std::string ply_header(const std::string& format, const std::size_t points, const std::size_t faces,
                              const std::string& real = "double", const std::string& list = "uchar int")
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(points) + "\nproperty " + real +
         " x\nproperty " + real + " y\nproperty " + real + " z\nelement face " + std::to_string(faces) +
         "\nproperty list " + list + " vertex_indices\nend_header\n";
}

inline std::string binary_stl(const std::vector<std::array<float, 9>>& facets, const std::size_t announced)
{
  std::string text(80, 'x');
  append(text, static_cast<std::uint32_t>(announced));
  for (const std::array<float, 9>& facet : facets) {
    append(text, std::array<float, 3>{{0, 0, 1}});
    append(text, facet);
    append(text, std::uint16_t(0));
  }
  return text;
}

#endif // IDT_TEST_SURFACE_FILE_TEST_H
