// benchmark_throughput ROUNDS -o DIR: states a second on one core with --lanes 2, 4, 8, 16,
// relative to one state at a time, which takes the sines of all its angles at once, and those of 8
// lanes relative to one state without any vector (--sincos pair), in one interleaved run. Writes
// lanes.md.
#include "benchmark/lanes.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {

std::vector<const LanesCode*> lanes_codes();

namespace {

namespace fs = std::filesystem;

constexpr const char* kFunctions[] = {"mass_matrix", "bias_force", "gravity_force",
                                      "inverse_dynamics", "forward_dynamics"};
constexpr int kFunctionCount = 5;
constexpr double kRoundings = 4e5;

/// \throws std::runtime_error if a lane differs from the code for one state by more than the
/// contraction of other multiply-adds explains.
void check(const LanesCode& one, const LanesCode& many, int function) {
  for (int state = 0; state < 8; ++state) {
    const std::vector<double> x = many.values(function, state);
    const std::vector<double> y = one.values(function, state);
    double scale = 0;
    for (const double value : y) {
      scale = std::max(scale, std::fabs(value));
    }
    for (std::size_t k = 0; k < x.size(); ++k) {
      // Forward dynamics multiplies the some hundred roundings of the others by the condition of A,
      // up to 1e3 here.
      if (!(std::fabs(x[k] - y[k / static_cast<std::size_t>(many.lanes)]) <=
            kRoundings * many.epsilon * scale)) {
        throw std::runtime_error(fmt::format("{} in {} with {} lanes: {} differs", many.robot,
                                             many.scalar, many.lanes, kFunctions[function]));
      }
    }
  }
}

/// One row a robot, function and compiler. \pre of a robot the code for one lane comes first, then
/// the one without vectors
std::string table(const std::vector<const LanesCode*>& codes, int rounds) {
  std::vector<Repeated> functions;
  for (const LanesCode* code : codes) {
    code->prepare();
    for (int k = 0; k < kFunctionCount; ++k) {
      functions.emplace_back([code, k](Turn turn) { code->run(k, turn); });
    }
  }
  const std::vector<Time> times = measure(functions, rounds);
  std::string text;
  const LanesCode* one = nullptr;
  for (int k = 0; k < kFunctionCount; ++k) {
    double alone = 0;
    double scalar = 0;
    std::string eight;
    for (std::size_t c = 0; c < codes.size(); ++c) {
      const double time = times[kFunctionCount * c + static_cast<std::size_t>(k)].median;
      const LanesCode& code = *codes[c];
      if (code.lanes == 1 && code.has_vectors) {
        one = &code;
        alone = time;
        text += fmt::format("\n| {} | {} | {} | {} |", code.robot, kFunctions[k], code.scalar,
                            code.compiler);
        continue;
      }
      check(*one, code, k);
      if (!code.has_vectors) {
        scalar = time;
        continue;
      }
      text += fmt::format(" {:.1f} |", alone * code.lanes / time);
      if (code.lanes == 8) {
        eight = fmt::format(" {:.1f} |", scalar * code.lanes / time);
      }
      text += code.lanes == 16 ? eight : "";
    }
  }
  return fmt::format(
      "States a second on one core, relative to the code for one state with default options, by "
      "medians:\n\n"
      "| robot | function | scalar | compiler | 2 lanes | 4 lanes | 8 lanes | 16 lanes "
      "| 8 lanes to one state without vectors |\n|---|---|---|---|---|---|---|---|---|{}\n",
      text);
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(
      argc, argv, "benchmark_throughput", {"ROUNDS", "-o", "DIR"}, [](const Words& words) {
        const std::string text = table(lanes_codes(), std::stoi(words[0]));
        std::filesystem::create_directories(words[2]);
        treedyn::support::write_file(std::filesystem::path(words[2]) / "lanes.md", text);
        std::cout << text;
      });
}
