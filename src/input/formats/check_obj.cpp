// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Text_check.h"
#include "input/formats/text_file.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <system_error>

namespace idt {
namespace {

// CGAL's reader takes of each word what looks like a number, and drops the rest: "f 1 2 3 a4" and
// "f 1.9 3 2" are other faces then.
class Obj_check : public Line_check
{
public:
  explicit Obj_check(const std::string& path) : path_(path) {}

  // Which faces name a vertex that is not there is known when all vertices are.
  void finish() override
  {
    Line_check::finish();
    if (greatest_index_ <= vertices_)
      return;
    Obj_check second(path_);
    second.limit_ = vertices_;
    const std::string text = load(path_);
    second.take(text.data(), text.data() + text.size());
    second.Line_check::finish();
    if (second.bad_faces_ == 0)
      return;
    std::string message = second.first_bad_index_;
    if (second.bad_faces_ > 1)
      message += ", and " + std::to_string(second.bad_faces_ - 1) +
                 (second.bad_faces_ == 2 ? " more face like it" : " more faces like it");
    refuse(path_, message, Defect::BAD_INDEX, second.first_bad_face_, second.bad_faces_);
  }
  void restart() override
  {
    Line_check::restart();
    vertices_ = faces_ = greatest_index_ = 0;
  }

private:
  void line(const char* first, const char* const last) override
  {
    first = skip_white(first, last);
    if (first == last || (first + 1 != last && !is_white(first[1])))
      return;
    if (*first == 'v')
      vertex(first + 1, last);
    else if (*first == 'f')
      face(first + 1, last);
  }

  void vertex(const char* p, const char* const last)
  {
    for (int i = 0; i < 3; ++i) {
      p = skip_white(p, last);
      if (p == last || *p == '#')
        refuse(path_, where("vertex", vertices_) + ": there are " + std::to_string(i) + " numbers where 3 are needed",
               Defect::UNREADABLE, vertices_);
      const char* end = skip_plain_number(p, last);
      if (end == nullptr) {
        end = std::find(p, skip_word(p, last), '#');
        check_coordinate(path_, std::string(p, end), where("vertex", vertices_), vertices_);
      }
      p = end;
    }
    ++vertices_;
  }

  void face(const char* p, const char* const last)
  {
    bool is_bad = false;
    for (p = skip_white(p, last); p != last && *p != '#'; p = skip_white(p, last)) {
      const char* const end = skip_word(p, last);
      long long index = 0;
      const char* q = read_index(p, end, index);
      // Of the rest, "/texture/normal", CGAL skips 256 characters at most.
      for (int slashes = 0; q != nullptr && q != end;) {
        if (*q != '/' || ++slashes > 2 || end - p > 250)
          q = nullptr;
        else if (++q != end && *q != '/') {
          long long ignored = 0;
          q = read_index(q, end, ignored);
        }
      }
      if (q == nullptr)
        refuse_corner(std::string(p, end));
      if (index == 0)
        refuse(path_, where("face", faces_) + ": " + quote(std::string(p, end)) + " names vertex 0, but vertices are counted from 1",
               Defect::BAD_INDEX, faces_);
      const std::size_t size = static_cast<std::size_t>(index < 0 ? -index : index);
      if (index < 0 && size > vertices_)
        refuse(path_,
               where("face", faces_) + ": the face names vertex " + std::to_string(index) + ", but " +
                 std::to_string(vertices_) + " vertices come before it",
               Defect::BAD_INDEX, faces_);
      if (index > 0 && size > greatest_index_)
        greatest_index_ = size;
      if (index > 0 && size > limit_ && !is_bad) {
        is_bad = true;
        if (bad_faces_++ == 0) {
          first_bad_face_ = faces_;
          first_bad_index_ = where("face", faces_) + ": the face names vertex " + std::to_string(size) +
                             ", but there are " + std::to_string(limit_) + " vertices (counted from 1)";
        }
      }
      p = end;
    }
    ++faces_;
  }

  // Behind an index, null if there is none that CGAL's reader could hold.
  static const char* read_index(const char* p, const char* const end, long long& index)
  {
    if (p != end && *p == '+' && p + 1 != end && p[1] != '-')
      ++p;
    const std::from_chars_result result = std::from_chars(p, end, index);
    return result.ec == std::errc() && index <= (std::numeric_limits<int>::max)() &&
               index >= -(std::numeric_limits<int>::max)()
             ? result.ptr
             : nullptr;
  }

  [[noreturn]] void refuse_corner(const std::string& word) const
  {
    const std::string begin = where("face", faces_) + ": " + quote(word);
    long long index = 0;
    if (word == "\\")
      refuse(path_, begin + ": lines that go on behind a backslash are not read, write the face in one line",
             Defect::UNREADABLE, faces_);
    const std::string corner = word.substr(0, word.find('/'));
    const std::size_t sign = corner[0] == '+' || corner[0] == '-' ? 1 : 0;
    if (corner.size() > sign && corner.find_first_not_of("0123456789", sign) == std::string::npos &&
        read_index(corner.data(), corner.data() + corner.size(), index) == nullptr)
      refuse(path_, begin + " is beyond all numbers of vertices", Defect::BAD_INDEX, faces_);
    if (word.size() > 250)
      refuse(path_, begin + " is longer than a corner may be (250 characters)", Defect::UNREADABLE, faces_);
    refuse(path_,
           begin + " is not a corner of a face (the number of a vertex, alone or as in 1/2/3; comments begin"
                   " with # behind a blank)",
           Defect::UNREADABLE, faces_);
  }

  std::string where(const char* const kind, const std::size_t element) const
  {
    return "line " + std::to_string(number()) + " (" + kind + " " + std::to_string(element) + ")";
  }

  std::string path_;
  std::size_t vertices_ = 0, faces_ = 0, greatest_index_ = 0;
  // Greater indices are counted.
  std::size_t limit_ = (std::numeric_limits<std::size_t>::max)();
  std::size_t bad_faces_ = 0, first_bad_face_ = 0;
  std::string first_bad_index_;
};

} // namespace

Prepared_text check_obj(const std::string& path)
{
  return {std::make_unique<Obj_check>(path), std::nullopt};
}

} // namespace idt
