// Runs a fuzz target without libFuzzer: replay MUTATIONS SEED_FILE_OR_FOLDER...
// every seed as it is, then MUTATIONS inputs made from the seeds with a fixed random sequence.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

void run(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

std::vector<std::string> read_seeds(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    if (fs::is_directory(argument)) {
      std::copy(fs::directory_iterator(argument), fs::directory_iterator(),
                std::back_inserter(files));
    } else {
      files.emplace_back(argument);
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<std::string> seeds;
  for (const fs::path& file : files) {
    if (fs::is_regular_file(file)) {
      std::ifstream stream(file, std::ios::binary);
      std::ostringstream text;
      text << stream.rdbuf();
      seeds.push_back(text.str());
    }
  }
  return seeds;
}

/// Cuts, copies and overwrites pieces of the seeds.
class Mutator {
 public:
  explicit Mutator(const std::vector<std::string>& seeds) : seeds_(seeds) {}

  std::string next() {
    std::string text = seeds_[below(seeds_.size())];
    for (std::size_t step = 0; step <= below(4); ++step) {
      change(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return random_() % std::max<std::size_t>(limit, 1); }

  void change(std::string& text) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = std::min(below(20), text.size() - at);
    switch (below(5)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      case 3:
        text.replace(at, length, kWords[below(std::size(kWords))]);
        break;
      default: {
        const std::string& other = seeds_[below(seeds_.size())];
        text = text.substr(0, at) + other.substr(below(other.size()));
      }
    }
  }

  static constexpr const char* kWords[] = {"1e400", "-1",
                                           "0",     "pi",
                                           "[",     "]",
                                           "{",     "}",
                                           ":",     ",",
                                           "&a",    "*a",
                                           "!!x",   "ground",
                                           "fixed", "<!DOCTYPE a [",
                                           "&lt;",  "<link name=\"x\"/>",
                                           "</",    "/>",
                                           "nan",   "1/0",
                                           "\n- ",  "base_px",
                                           "class", "sqrt(",
                                           "^64",   "1e-9",
                                           "\"",    "'",
                                           "#",     "\\0"};
  const std::vector<std::string>& seeds_;
  std::mt19937 random_{20110602};
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: replay MUTATIONS SEED...\n", stderr);
    return 2;
  }
  const std::vector<std::string> seeds = read_seeds({argv + 2, argv + argc});
  if (seeds.empty()) {
    std::fputs("no seeds\n", stderr);
    return 1;
  }
  std::for_each(seeds.begin(), seeds.end(), run);
  Mutator mutator(seeds);
  const int mutations = std::atoi(argv[1]);
  for (int k = 0; k < mutations; ++k) {
    run(mutator.next());
  }
  std::printf("%zu seeds and %d mutations survived\n", seeds.size(), mutations);
  return 0;
}
