// benchmark_compilers TREEDYN URDF CODE PASSES -o DIR: time of generated code by the options that
// compile it.
//
// UR5 and HyQ on axes of the folder URDF with default options, by g++ and clang++ in several ways:
// mass_matrix, inverse_dynamics and forward_dynamics relative to the same compiler's `-O3
// -march=native`, medians of PASSES interleaved passes, every pass with fresh copies of all
// programs. CODE is flags_code.cpp. Every value is checked. Writes flags.md.
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "benchmark/clock.hpp"
#include "benchmark/code.hpp"
#include "benchmark/command.hpp"
#include "support/manifest.hpp"
#include "support/process.hpp"
#include "support/states.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 100;
constexpr std::size_t kStates = 256;

struct Robot {
  const char* name;
  const char* file;
  const char* base;
};
constexpr Robot kRobots[] = {{"UR5", "ur5_robot.urdf", "fixed"},
                             {"HyQ, axes", "hyq_no_sensors.urdf", "axes"}};

constexpr const char* kFunctions[] = {"mass_matrix", "inverse_dynamics", "forward_dynamics"};

/// A compiler with options; `slp`: without the line of the source that forbids g++ to gather
/// scalars into vectors.
struct Way {
  const char* compiler;
  std::vector<std::string> flags;
  bool slp = false;
};
const std::vector<std::string> kNative{"-O3", "-march=native"};
const std::vector<Way> kWays = {
    {"g++", kNative},  // the first of a compiler is what its others are compared with
    {"g++", {"-O3", "-march=native", "-ffp-contract=off"}},
    {"g++", {"-O3", "-march=native", "-fno-math-errno"}},
    {"g++", kNative, true},
    {"g++", {"-O2", "-march=native"}},
    {"g++", {"-O3", "-march=x86-64-v3"}},
    {"g++", {"-O2"}},
    {"g++", {"-O3"}},
    {"clang++", kNative},
    {"clang++", {"-O3", "-march=native", "-ffp-contract=off"}},
    {"clang++", {"-O3", "-march=native", "-ffp-contract=fast"}},
    {"clang++", {"-O3", "-march=native", "-fno-math-errno"}},
    {"clang++", {"-O3", "-march=native", "-fno-slp-vectorize"}},
    {"clang++", {"-O2", "-march=native"}},
    {"clang++", {"-O3", "-march=x86-64-v3"}},
    {"clang++", {"-O2"}},
    {"clang++", {"-O3"}},
};

/// The source without the line that begins with `#pragma GCC optimize`.
std::string with_slp(std::string source) {
  const std::size_t begin = source.find("#pragma GCC optimize");
  if (begin == std::string::npos) {
    throw std::runtime_error("the generated source has no line '#pragma GCC optimize'");
  }
  return source.erase(begin, source.find('\n', begin) - begin);
}

fs::path object_of(const fs::path& folder, std::size_t way) {
  return folder / fmt::format("way{}.so", way);
}

/// Writes generated.* and an object a way into a folder.
void build(const std::string& treedyn, const fs::path& model, const Robot& robot,
           const fs::path& code, const fs::path& folder) {
  support::run_checked({treedyn, "generate", model, "--base", robot.base, "--name", "generated",
                        "--functions", "mass_matrix,inverse_dynamics,forward_dynamics", "-q", "-o",
                        folder});
  support::write_file(folder / "slp.cpp", with_slp(support::read_file(folder / "generated.cpp")));
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    std::vector<std::string> command{kWays[k].compiler, "-std=c++20", "-fPIC", "-shared"};
    command.insert(command.end(), kWays[k].flags.begin(), kWays[k].flags.end());
    command.insert(command.end(), {"-I", folder, "-I", code.parent_path().parent_path(), code,
                                   folder / (kWays[k].slp ? "slp.cpp" : "generated.cpp"), "-o",
                                   object_of(folder, k)});
    support::run_checked(command);
  }
}

struct State {
  std::vector<double> q, qd, x;
};

/// Angles up to pi, the pitch of a base on axes up to 72 degrees.
std::vector<State> random_states(const support::Manifest& manifest) {
  const auto dof = static_cast<std::size_t>(manifest.dof);
  support::Random random(5);
  std::vector<State> states(kStates);
  for (State& state : states) {
    state = {random.list(dof, std::numbers::pi), random.list(dof), random.list(dof)};
    for (std::size_t i = 0; i < dof; ++i) {
      state.q[i] *= manifest.joints[i] == "base_ry" ? 0.4 : 1;
    }
  }
  return states;
}

/// Generated code of one way, in a copy of its file.
class Program {
 public:
  Program(const fs::path& object, const fs::path& copy, const std::vector<State>& states)
      : states_(states) {
    fs::copy_file(object, copy, fs::copy_options::overwrite_existing);
    void* handle = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
      throw std::runtime_error(dlerror());
    }
    library_ = std::shared_ptr<void>(handle, [](void* library) { dlclose(library); });
    code_ = static_cast<const Code*>(dlsym(handle, "code"));
    const auto dof = static_cast<std::size_t>(code_->dof);
    out_.resize(dof * dof);
  }

  void call(std::size_t function, const State& s) {
    switch (function) {
      case 0:
        return code_->mass_matrix(s.q.data(), out_.data());
      case 1:
        return code_->inverse_dynamics(s.q.data(), s.qd.data(), s.x.data(), out_.data());
      default:
        return code_->forward_dynamics(s.q.data(), s.qd.data(), s.x.data(), out_.data());
    }
  }
  void run(std::size_t function, Turn turn) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(turn.calls); ++k) {
      call(function, states_[(turn.first + k) % kStates]);
    }
  }
  std::vector<double> values(std::size_t function, const State& state) {
    std::fill(out_.begin(), out_.end(), std::nan(""));
    call(function, state);
    const auto dof = static_cast<std::ptrdiff_t>(code_->dof);
    return {out_.begin(), function == 0 ? out_.end() : out_.begin() + dof};
  }

 private:
  std::shared_ptr<void> library_;
  const Code* code_ = nullptr;
  const std::vector<State>& states_;
  std::vector<double> out_;
};

/// All ways of one robot, compiled.
struct Compiled {
  support::TemporaryFolder folder;
  std::vector<State> states;

  [[nodiscard]] std::vector<Program> load(int pass) const {
    std::vector<Program> result;
    for (std::size_t k = 0; k < kWays.size(); ++k) {
      result.emplace_back(object_of(folder.path(), k),
                          folder.path() / fmt::format("copy{}_{}.so", k, pass), states);
    }
    return result;
  }
};

/// \throws std::runtime_error if a way computes anything that rounding does not explain.
void check(const Robot& robot, const Compiled& compiled) {
  std::vector<Program> programs = compiled.load(-1);
  for (std::size_t way = 1; way < programs.size(); ++way) {
    for (std::size_t function = 0; function < std::size(kFunctions); ++function) {
      // Forward dynamics multiplies the roundings of the others by the condition of A.
      const double allowed = function == 2 ? 1e-10 : 1e-13;
      for (const State& state : compiled.states) {
        const std::vector<double> x = programs[way].values(function, state);
        const std::vector<double> y = programs[0].values(function, state);
        double scale = 0;
        double difference = 0;
        for (std::size_t k = 0; k < y.size(); ++k) {
          scale = std::max(scale, std::fabs(y[k]));
          difference = std::isnan(x[k]) ? HUGE_VAL : std::max(difference, std::fabs(x[k] - y[k]));
        }
        if (!(difference <= allowed * scale)) {
          throw std::runtime_error(fmt::format(
              "{}, {}: {} {} differs by {} of {}", robot.name, kFunctions[function],
              kWays[way].compiler, fmt::join(kWays[way].flags, " "), difference, scale));
        }
      }
    }
  }
}

/// Times of all passes, ns: of robot, way and function in turn.
using Times = std::vector<std::vector<double>>;

std::size_t index_of(std::size_t robot, std::size_t way, std::size_t function) {
  return (robot * kWays.size() + way) * std::size(kFunctions) + function;
}

void add_pass(const std::vector<Compiled>& robots, int pass, Times& times) {
  std::vector<std::vector<Program>> programs;
  std::vector<Repeated> functions;
  for (const Compiled& robot : robots) {
    programs.push_back(robot.load(pass));
    for (Program& program : programs.back()) {
      for (std::size_t k = 0; k < std::size(kFunctions); ++k) {
        functions.emplace_back([&program, k](Turn turn) { program.run(k, turn); });
      }
    }
  }
  const std::vector<Time> measured = measure(functions, kRounds);
  times.resize(measured.size());
  for (std::size_t k = 0; k < measured.size(); ++k) {
    times[k].push_back(measured[k].least);
  }
}

/// The median of the ratios of all passes.
double ratio(const std::vector<double>& times, const std::vector<double>& others) {
  std::vector<double> ratios;
  std::transform(times.begin(), times.end(), others.begin(), std::back_inserter(ratios),
                 std::divides<>());
  return median(ratios);
}

std::string table(const Times& times) {
  std::string text = "| compiler | options |";
  std::string line = "\n|---|---|";
  for (const Robot& robot : kRobots) {
    for (const char* function : kFunctions) {
      text += fmt::format(" {}: {} |", robot.name, function);
      line += "---|";
    }
  }
  text += line + "\n";
  std::size_t first = 0;
  for (std::size_t way = 0; way < kWays.size(); ++way) {
    const Way& w = kWays[way];
    first = std::string(w.compiler) == kWays[first].compiler ? first : way;
    text += fmt::format("| {} | `{}`{} |", w.compiler, fmt::join(w.flags, " "),
                        w.slp ? ", SLP vectorizer on" : "");
    for (std::size_t robot = 0; robot < std::size(kRobots); ++robot) {
      for (std::size_t k = 0; k < std::size(kFunctions); ++k) {
        const std::vector<double>& own = times[index_of(robot, way, k)];
        text += way == first
                    ? fmt::format(" 1 ({:.0f} ns) |", median(own))
                    : fmt::format(" {:.2f} |", ratio(own, times[index_of(robot, first, k)]));
      }
    }
    text += "\n";
  }
  return text;
}

void run(const std::string& treedyn, const fs::path& urdf, const fs::path& code, int passes,
         const fs::path& output) {
  std::vector<Compiled> robots(std::size(kRobots));
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const fs::path& folder = robots[k].folder.path();
    build(treedyn, urdf / kRobots[k].file, kRobots[k], code, folder);
    robots[k].states = random_states(support::read_manifest(folder / "generated.json"));
    check(kRobots[k], robots[k]);
  }
  Times times;
  for (int pass = 0; pass < passes; ++pass) {
    add_pass(robots, pass, times);
  }
  const std::string text = fmt::format(
      "Time of a call relative to the same compiler's `-O3 -march=native`, medians of {} "
      "interleaved passes on a shared machine, default options of treedyn, double. The generated "
      "source forbids g++'s SLP vectorizer by a pragma; one row is without it.\n\n{}",
      passes, table(times));
  fs::create_directories(output);
  support::write_file(output / "flags.md", text);
  std::cout << text;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(
      argc, argv, "benchmark_compilers", {"TREEDYN", "URDF", "CODE", "PASSES", "-o", "DIR"},
      [](const Words& words) { run(words[0], words[1], words[2], std::stoi(words[3]), words[5]); });
}
