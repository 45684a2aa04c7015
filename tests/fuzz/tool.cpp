// fuzz_tool TOOL MODELS RUNS SEED [KEEP]: the tool itself on models and scenes of the folder MODELS
// whose structure was changed. Every run has to end with status 0, or 1 and one clear message, in
// bounded time, and leaves nothing half written. Inputs for which this is not so are printed, and
// kept in the folder KEEP.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

#include <fmt/format.h>

#include "fuzz/nodes.hpp"
#include "support/process.hpp"

namespace treedyn::fuzz {
namespace {

namespace fs = std::filesystem;
using support::Outcome;

constexpr const char* kLongest = "300";  ///< s, of one run: beyond it hangs, under sanitizers too

/// A file of models/ that others do not depend on; scenes lie in a folder of their own.
struct Seed {
  std::string path;
  bool is_scene = false;
};

std::vector<Seed> seeds() {
  return {{"two_link.yaml"},
          {"polar.yaml"},
          {"arm.urdf"},
          {"puma560.yaml"},
          {"compass_walker.yaml"},
          {"scenes/arm_circle.yaml", true},
          {"scenes/drop.yaml", true},
          {"scenes/four_bar.yaml", true},
          {"scenes/pendulum.yaml", true},
          {"scenes/compass_walk.yaml", true},
          {"scenes/double_pendulum.yaml", true}};
}

/// The model beside or above a scene.
std::string model_of(const std::string& scene) {
  const std::string text = support::read_file(scene);
  const std::string key = "\nmodel: ";
  const std::size_t begin = text.find(key) + key.size();
  return (fs::path(scene).parent_path() / text.substr(begin, text.find('\n', begin) - begin))
      .string();
}

std::vector<std::vector<std::string>> commands(const Seed& seed, const std::string& file,
                                               const std::string& out, std::size_t dice) {
  const std::vector<std::string> of =
      seed.is_scene ? std::vector<std::string>{"--scene", file} : std::vector<std::string>{file};
  const auto with = [&](std::vector<std::string> words, const std::vector<std::string>& rest) {
    words.insert(words.end(), of.begin(), of.end());
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  };
  std::vector<std::vector<std::string>> result = {with({"generate"}, {"--effort", "0", "-o", out}),
                                                  with({"check"}, {"--effort", "0", "-o", out})};
  if (dice % 2 == 0) {
    result.back() = with({"info"}, {"--effort", "0"});
  }
  if (!seed.is_scene) {
    result.push_back({"vet", file});
    return result;
  }
  result.front() = {"simulate",    file,  "--duration", "1e-4",
                    "--max-steps", "1e4", "-o",         out + "-motion"};
  result.push_back(with({"generate"}, {"--effort", "0", "-o", out}));
  if (dice % 8 == 1) {
    result.push_back({"simulate", file, "--as-generated", "--integrator", "rk4", "--step", "1e-3",
                      "--duration", "0.02", "--max-steps", "1e4"});
  }
  return result;
}

/// What is wrong with an end; empty: nothing.
std::string complaint(const std::string& command, const Outcome& outcome) {
  for (const char* const word :
       {"Sanitizer", "runtime error", "internal error", "broken invariant", "terminate called"}) {
    if (outcome.err.find(word) != std::string::npos) {
      return word;
    }
  }
  if (outcome.status != 0 && outcome.status != 1) {
    return fmt::format("status {}", outcome.status);
  }
  std::istringstream lines(outcome.err);
  int errors = 0;
  for (std::string line; std::getline(lines, line);) {
    errors += line.find(": warning: ") == std::string::npos ? 1 : 0;
  }
  const bool says_why = command == "vet" || command == "check" ? errors <= 1
                        : command == "simulate"                ? errors >= 1
                                                               : errors == 1;
  return outcome.status == 1 && !says_why ? "no clear message" : "";
}

/// Files that should not be there behind a run that failed.
std::string left_behind(const std::string& out) {
  std::string result;
  if (fs::exists(out)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(out)) {
      result += " " + entry.path().filename().string();
    }
  }
  return result;
}

class Run {
 public:
  Run(std::string tool, const fs::path& models, unsigned seed)
      : tool_(std::move(tool)), models_(models), mutator_(seed) {}

  /// True if nothing is wrong.
  bool run(const Seed& seed, const std::string& keep) {
    const support::TemporaryFolder folder;
    const fs::path copy = folder.path() / "models";
    fs::copy(models_, copy, fs::copy_options::recursive);
    fs::copy_file(models_ / "../tests/fuzz/seeds/urdf/arm.urdf", copy / "arm.urdf");
    const std::string file = copy / seed.path;
    const bool model_instead = seed.is_scene && mutator_.below(4) == 0;
    mutate(model_instead ? model_of(file) : file);
    const std::string out = folder.path() / "out";
    for (const auto& arguments : commands(seed, file, out, mutator_.below(16))) {
      std::vector<std::string> command = {"timeout", kLongest, tool_};
      command.insert(command.end(), arguments.begin(), arguments.end());
      const Outcome outcome = support::run(command);
      std::string what = complaint(arguments.front(), outcome);
      if (what.empty() && arguments.front() == "generate" && outcome.status != 0) {
        const std::string left = left_behind(out);
        what = left.empty() ? "" : "left behind:" + left;
      }
      if (!what.empty()) {
        std::cout << fmt::format("{}: {}\n{}\n", fmt::join(arguments, " "), what,
                                 outcome.err.substr(0, 2000));
        if (!keep.empty()) {
          fs::copy(copy, fs::path(keep) / fmt::format("{}", kept_++),
                   fs::copy_options::recursive | fs::copy_options::overwrite_existing);
        }
        return false;
      }
      ++ends_[outcome.status == 0 ? 0 : 1];
    }
    return true;
  }

  [[nodiscard]] int right() const { return ends_[0]; }
  [[nodiscard]] int refused() const { return ends_[1]; }

 private:
  void mutate(const std::string& file) {
    const bool is_xml = file.ends_with(".urdf");
    description::Node root = read_nodes(support::read_file(file), is_xml);
    for (std::size_t changes = mutator_.below(3) == 0 ? 3 : 1; changes > 0; --changes) {
      mutator_.change(root);
    }
    support::write_file(file, written(root, is_xml));
  }

  std::string tool_;
  fs::path models_;
  Mutator mutator_;
  int kept_ = 0;
  std::array<int, 2> ends_{};
};

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: fuzz_tool TOOL MODELS RUNS SEED [KEEP]\n";
    return 2;
  }
  Run runs(argv[1], argv[2], static_cast<unsigned>(std::atoi(argv[4])));
  const std::vector<Seed> all = seeds();
  int wrong = 0;
  for (int k = 0; k < std::atoi(argv[3]); ++k) {
    wrong +=
        runs.run(all[static_cast<std::size_t>(k) % all.size()], argc > 5 ? argv[5] : "") ? 0 : 1;
  }
  std::cout << fmt::format("{} mutants, {} wrong; commands that succeed: {}, that refuse: {}\n",
                           argv[3], wrong, runs.right(), runs.refused());
  return wrong > 0 ? 1 : 0;
}

}  // namespace
}  // namespace treedyn::fuzz

int main(int argc, char** argv) { return treedyn::fuzz::main(argc, argv); }
