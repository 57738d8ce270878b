// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The content of large files: many numbers, put together by several threads.

#ifndef IDT_LONG_TEXT_H
#define IDT_LONG_TEXT_H

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace idt {

// A text that grows. Does the work of a stream in a fraction of the time.
class Long_text
{
public:
  Long_text& operator<<(char c)
  {
    text_ += c;
    return *this;
  }
  Long_text& operator<<(std::string_view text)
  {
    text_.append(text.data(), text.size());
    return *this;
  }
  template <class Integer, class = std::enable_if_t<std::is_integral<Integer>::value>>
  Long_text& operator<<(Integer number)
  {
    char digits[24];
    return append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
  }
  // As in_full().
  Long_text& operator<<(double number)
  {
    char digits[32];
    return append(digits, std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 17).ptr);
  }
  Long_text& operator<<(float) = delete;

  // The bytes of a number, lowest first, whatever the order of this machine.
  Long_text& add_bytes(std::uint8_t number) { return *this << static_cast<char>(number); }
  Long_text& add_bytes(std::uint32_t number) { return add_bytes_of(number); }
  Long_text& add_bytes(double number)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return add_bytes_of(bits);
  }

  const std::string& string() const { return text_; }

  // Empties the text, and keeps its memory.
  void clear() { text_.clear(); }

private:
  Long_text& append(const char* first, const char* last)
  {
    text_.append(first, static_cast<std::size_t>(last - first));
    return *this;
  }
  template <class Bits>
  Long_text& add_bytes_of(Bits bits)
  {
    char bytes[sizeof(Bits)];
    for (std::size_t b = 0; b < sizeof(Bits); ++b)
      bytes[b] = static_cast<char>(bits >> 8 * b & 0xff);
    return append(bytes, bytes + sizeof(Bits));
  }

  std::string text_;
};

constexpr std::size_t elements_of_block = std::size_t(1) << 14;

// Writes the text of the elements from 0 to n, in their order. Several threads work on it; only a few blocks of
// elements are in memory at a time.
// \param format is called as format(text, first, last) for blocks of elements, by any thread, and appends them to an
//   empty text
void write_blocks(std::ostream& os, std::size_t n,
                  const std::function<void(Long_text&, std::size_t, std::size_t)>& format);

// The same with a function for a single element, format(text, i).
template <class Format>
void write_elements(std::ostream& os, std::size_t n, const Format& format)
{
  write_blocks(os, n, [&format](Long_text& text, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      format(text, i);
  });
}

} // namespace idt

#endif // IDT_LONG_TEXT_H
