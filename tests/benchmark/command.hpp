// The main function of a program that measures.
#pragma once

#include <exception>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace treedyn::benchmark {

using Words = std::vector<std::string>;

/// Runs the program if it was called with `usage.size()` words of which the last but one is `-o`;
/// 2 after a wrong call, 1 after an error, else 0.
inline int run_command(int argc, char** argv, const std::string& name, const Words& usage,
                       const std::function<void(const Words&)>& run) {
  const Words words(argv + 1, argv + argc);
  if (words.size() != usage.size() || words[words.size() - 2] != "-o") {
    std::cerr << "usage: " << name;
    for (const std::string& word : usage) {
      std::cerr << ' ' << word;
    }
    std::cerr << '\n';
    return 2;
  }
  try {
    run(words);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}

}  // namespace treedyn::benchmark
