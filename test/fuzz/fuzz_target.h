// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fuzz target: a function of bytes that must return, initial inputs, and a way to report violations.

#ifndef IDT_TEST_FUZZ_TARGET_H
#define IDT_TEST_FUZZ_TARGET_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// The name and the type that libFuzzer requires.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

// Inputs that reach much of the code, for the linked target.
std::vector<std::string> seed_inputs();

// Ends the program, as a sanitizer would, if a property does not hold.
inline void require(bool condition, const std::string& property)
{
  if (condition)
    return;
  std::fprintf(stderr, "not true: %s\n", property.c_str());
  std::abort();
}

// The bytes of an input in order, and zeros after its end.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool is_at_end() const { return size_ == 0; }
  std::uint8_t next()
  {
    if (size_ == 0)
      return 0;
    --size_;
    return *data_++;
  }
  // A number below n, for n up to 256.
  unsigned below(unsigned n) { return next() % n; }
  // A number from -128 to 127.
  int signed_next() { return int(next()) - 128; }

private:
  const std::uint8_t* data_;
  std::size_t size_;
};

} // namespace fuzz

#endif // IDT_TEST_FUZZ_TARGET_H
