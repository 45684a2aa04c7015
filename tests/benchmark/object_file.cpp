#include "benchmark/object_file.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <vector>

#include "support/process.hpp"

namespace treedyn::benchmark {

namespace fs = std::filesystem;

namespace {

long number(const std::string& word) {
  long value = 0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

/// Bytes of all sections whose names begin so.
long section_bytes(const std::string& size_program, const fs::path& object,
                   const std::string& beginning) {
  std::istringstream lines(support::run({size_program, "-A", object.string()}).out);
  long sum = 0;
  std::string name;
  std::string size;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    if (words >> name >> size && name.rfind(beginning, 0) == 0) {
      sum += number(size);
    }
  }
  return sum;
}

}  // namespace

long code_bytes(const std::string& size_program, const fs::path& object) {
  return section_bytes(size_program, object, ".text");
}

long flash_bytes(const std::string& size_program, const fs::path& object) {
  return code_bytes(size_program, object) + section_bytes(size_program, object, ".rodata");
}

long stack_bytes(const fs::path& usage) {
  std::istringstream lines(support::read_file(usage));
  std::vector<long> frames{0, 0};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    frames.push_back(number(line.substr(tab + 1)));
  }
  std::sort(frames.rbegin(), frames.rend());
  return frames[0] + frames[1];
}

long instructions(const std::string& objdump, const fs::path& object) {
  std::istringstream lines(
      support::run({objdump, "-d", "--no-show-raw-insn", object.string()}).out);
  long count = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');  // "   4:\tvmul.f32 ..."; a table is .word
    if (tab != std::string::npos && line[tab - 1] == ':' && line.compare(tab + 1, 1, ".") != 0) {
      ++count;
    }
  }
  return count;
}

}  // namespace treedyn::benchmark
