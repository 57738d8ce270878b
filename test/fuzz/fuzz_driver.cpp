// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a fuzz target with any compiler, without libFuzzer:
//
//   NAME_driver MUTATIONS       every seed, and that many mutations of seeds, always the same
//   NAME_driver --write FOLDER  writes the seeds as files, for libFuzzer to begin with
//   NAME_driver FILE...         those inputs, as libFuzzer leaves them when it finds something

#include "fuzz_target.h"

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

std::string in_progress;

// Prints the input for which a property does not hold, as bytes for printf.
void print_input(int)
{
  std::fputs("the input, as printf writes it: '", stderr);
  for (const char c : in_progress)
    std::fprintf(stderr, "\\%03o", unsigned(static_cast<unsigned char>(c)));
  std::fputs("'\n", stderr);
}

void run(const std::string& input)
{
  in_progress = input;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(in_progress.data()), in_progress.size());
}

// A few changes of the kinds that find most: bytes replaced, bits flipped, pieces removed,
// repeated, and taken from another seed. Only `random()` itself, whose numbers the standard fixes.
std::string mutated(std::string text, const std::vector<std::string>& seeds, std::mt19937& random)
{
  const auto below = [&random](std::size_t n) { return random() % n; };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size() + 1), length = 1 + below(8);
    switch (below(6)) {
    case 0:
      text.insert(at, 1, char(random()));
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, text.substr(at, length));
      break;
    case 3: {
      const std::string& other = seeds[below(seeds.size())];
      text = text.substr(0, at) + other.substr(below(other.size() + 1));
      break;
    }
    case 4:
      if (at < text.size())
        text[at] = char(text[at] ^ (1 << below(8)));
      break;
    default:
      if (at < text.size())
        text[at] = char(random());
    }
  }
  return text;
}

int write_seeds(const std::filesystem::path& folder)
{
  std::filesystem::create_directories(folder);
  std::size_t number = 0;
  for (const std::string& seed : fuzz::seed_inputs()) {
    std::ofstream out(folder / ("seed-" + std::to_string(number++)), std::ios::binary);
    if (!(out << seed).flush()) {
      std::cerr << "cannot write into " << folder << "\n";
      return EXIT_FAILURE;
    }
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv)
{
  std::signal(SIGABRT, print_input);
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 2 && arguments[0] == "--write")
    return write_seeds(arguments[1]);
  if (arguments.size() == 1 && !std::filesystem::exists(arguments[0])) {
    const std::vector<std::string> seeds = fuzz::seed_inputs();
    const int mutations = std::stoi(arguments[0]);
    for (const std::string& seed : seeds)
      run(seed);
    std::mt19937 random(1);
    for (int i = 0; i < mutations; ++i)
      run(mutated(seeds[random() % seeds.size()], seeds, random));
    std::cout << seeds.size() << " seeds and " << mutations << " mutations\n";
    return EXIT_SUCCESS;
  }
  for (const std::string& path : arguments) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
      std::cerr << path << " cannot be opened\n";
      return EXIT_FAILURE;
    }
    run({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
    std::cout << path << ": nothing is wrong\n";
  }
  return arguments.empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
