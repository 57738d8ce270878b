// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A look at a text on its way to CGAL's reader, piece by piece: the file is gone through once, and never
// held as a whole.

#ifndef IDT_FORMATS_TEXT_CHECK_H
#define IDT_FORMATS_TEXT_CHECK_H

#include "input/formats/text_file.h"

#include <cstddef>
#include <cstring>
#include <optional>
#include <memory>
#include <string>

namespace idt {

inline bool is_white(const char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

inline const char* skip_white(const char* p, const char* const end)
{
  while (p != end && is_white(*p))
    ++p;
  return p;
}

inline const char* skip_word(const char* p, const char* const end)
{
  while (p != end && !is_white(*p))
    ++p;
  return p;
}

// Behind a number that is beyond doubt, null at anything that needs a closer look: most numbers
// are of this kind, and reading them in full would cost as much as CGAL's reader does.
inline const char* skip_plain_number(const char* p, const char* const end)
{
  const char* const begin = p;
  if (p != end && (*p == '-' || *p == '+'))
    ++p;
  const char* const digits = p;
  while (p != end && *p >= '0' && *p <= '9')
    ++p;
  std::ptrdiff_t number_of_digits = p - digits;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    while (p != end && *p >= '0' && *p <= '9')
      ++p;
    number_of_digits += p - fraction;
  }
  if (number_of_digits == 0)
    return nullptr;
  if (p != end && (*p == 'e' || *p == 'E')) {
    ++p;
    if (p != end && (*p == '-' || *p == '+'))
      ++p;
    const char* const exponent = p;
    while (p != end && *p >= '0' && *p <= '9')
      ++p;
    // Two digits cannot leave the range of a double, as long as there are not hundreds before.
    if (p == exponent || p - exponent > 2)
      return nullptr;
  }
  return p - begin <= 100 && (p == end || is_white(*p)) ? p : nullptr;
}

// Gets a text in pieces. \exception Invalid_surface_error at what must not be passed on
class Text_check
{
public:
  Text_check() = default;
  Text_check(const Text_check&) = delete;
  Text_check& operator=(const Text_check&) = delete;
  virtual ~Text_check() = default;

  virtual void take(const char* first, const char* last) = 0;
  // The text is at its end.
  virtual void finish() = 0;
  // The text begins once more.
  virtual void restart() = 0;
};

// Calls line() with each line, without its end.
class Line_check : public Text_check
{
public:
  void take(const char* first, const char* const last) override
  {
    while (first != last) {
      const char* const end =
        static_cast<const char*>(std::memchr(first, '\n', static_cast<std::size_t>(last - first)));
      if (end == nullptr) {
        rest_.append(first, last);
        return;
      }
      if (rest_.empty())
        pass(first, end);
      else {
        rest_.append(first, end);
        pass(rest_.data(), rest_.data() + rest_.size());
        rest_.clear();
      }
      first = end + 1;
    }
  }
  void finish() override
  {
    if (!rest_.empty())
      pass(rest_.data(), rest_.data() + rest_.size());
    rest_.clear();
  }
  void restart() override
  {
    rest_.clear();
    number_ = 0;
  }

protected:
  // The number of the line, counted from 1.
  std::size_t number() const { return number_; }

private:
  virtual void line(const char* first, const char* last) = 0;

  void pass(const char* const first, const char* const last)
  {
    ++number_;
    line(first, last);
  }

  std::string rest_; // the beginning of a line whose end has not come
  std::size_t number_ = 0;
};

// Calls word() with each word between white space.
class Word_check : public Text_check
{
public:
  void take(const char* first, const char* const last) override
  {
    for (;;) {
      if (rest_.empty())
        for (; first != last && is_white(*first); ++first)
          number_ += *first == '\n';
      if (first == last)
        return;
      const char* const end = skip_word(first, last);
      if (end == last) {
        rest_.append(first, end);
        return;
      }
      if (rest_.empty())
        word(first, end);
      else {
        rest_.append(first, end);
        word(rest_.data(), rest_.data() + rest_.size());
        rest_.clear();
      }
      first = end;
    }
  }
  void finish() override
  {
    if (!rest_.empty())
      word(rest_.data(), rest_.data() + rest_.size());
    rest_.clear();
  }
  void restart() override
  {
    rest_.clear();
    number_ = 1;
  }

protected:
  // The number of the line on which the word is, counted from 1.
  std::size_t number() const { return number_; }
  void set_number(const std::size_t number) { number_ = number; }

private:
  virtual void word(const char* first, const char* last) = 0;

  std::string rest_; // the beginning of a word whose end has not come
  std::size_t number_ = 1;
};

// How a file is to be read: with a look at it on the way, or not as it stands.
struct Prepared_text
{
  std::unique_ptr<Text_check> check; // null if there is nothing to look at
  std::optional<std::string> text;   // in place of the content of the file
};

} // namespace idt

#endif // IDT_FORMATS_TEXT_CHECK_H
