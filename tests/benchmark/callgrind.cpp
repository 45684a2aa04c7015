#include "benchmark/callgrind.hpp"

#include <charconv>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "support/process.hpp"

namespace treedyn::benchmark {

namespace {

namespace fs = std::filesystem;

bool take(const std::string& line, const std::string& prefix, std::string& rest) {
  if (line.rfind(prefix, 0) != 0) {
    return false;
  }
  rest = line.substr(prefix.size());
  return true;
}

/// Adds one dump: its label stands in a line "desc: Trigger:", its sum in "summary:".
void add_dump(const fs::path& file, std::map<std::string, long>& counts) {
  std::istringstream lines(support::read_file(file));
  std::string line;
  std::string label;
  std::string sum;
  while (std::getline(lines, line)) {
    take(line, "desc: Trigger: Client Request: ", label);
    if (take(line, "summary: ", sum) && !label.empty()) {
      long value = 0;
      std::from_chars(sum.data(), sum.data() + sum.size(), value);
      counts[label] = value;
    }
  }
}

bool has_valgrind() {
  try {
    return support::run({"valgrind", "--version"}).status == 0;
  } catch (const std::system_error&) {
    return false;
  }
}

}  // namespace

std::map<std::string, long> count_instructions(const std::vector<std::string>& command) {
  std::map<std::string, long> counts;
  if (!has_valgrind()) {
    return counts;
  }
  const support::TemporaryFolder folder;
  std::vector<std::string> words{"valgrind", "--tool=callgrind", "--instr-atstart=no",
                                 "--callgrind-out-file=" + (folder.path() / "out").string()};
  words.insert(words.end(), command.begin(), command.end());
  const support::Outcome outcome = support::run(words);
  if (outcome.status != 0) {
    throw std::runtime_error("valgrind: " + outcome.err);
  }
  for (const auto& file : fs::directory_iterator(folder.path())) {
    add_dump(file.path(), counts);
  }
  return counts;
}

}  // namespace treedyn::benchmark
