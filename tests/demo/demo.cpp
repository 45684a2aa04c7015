// biped_demo MODEL FOLDER: the biped's generated code, compiled into this program, against the
// generic engine on random states; prints what was made, what a call costs and how exact it is.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "biped.hpp"
#include "description/read.hpp"
#include "engine/engine.hpp"

namespace {

using Vector = std::vector<double>;
using Inputs = std::vector<Vector>;

constexpr std::size_t kN = biped::kDof;
constexpr std::size_t kP = biped::kPoints;
constexpr double kTolerance = 1e-12;  ///< largest error of an output relative to its largest entry

/// A generated function behind one face.
struct Function {
  const char* name;
  std::size_t inputs;
  std::size_t size;
  void (*call)(const Inputs& in, double* out);
};

const std::vector<Function>& functions() {
  static const std::vector<Function> result{
      {"mass_matrix", 1, kN * kN,
       [](const Inputs& x, double* y) {
         biped::mass_matrix(x[0].data(), y);
       }},
      {"bias_force", 2, kN,
       [](const Inputs& x, double* y) {
         biped::bias_force(x[0].data(), x[1].data(), y);
       }},
      {"gravity_force", 1, kN,
       [](const Inputs& x, double* y) {
         biped::gravity_force(x[0].data(), y);
       }},
      {"inverse_dynamics", 3, kN,
       [](const Inputs& x, double* y) {
         biped::inverse_dynamics(x[0].data(), x[1].data(), x[2].data(), y);
       }},
      {"forward_dynamics", 3, kN,
       [](const Inputs& x, double* y) {
         biped::forward_dynamics(x[0].data(), x[1].data(), x[2].data(), y);
       }},
      {"point_positions", 1, 3 * kP,
       [](const Inputs& x, double* y) {
         biped::point_positions(x[0].data(), y);
       }},
      {"force_jacobian_transpose", 1, 3 * kN * kP, [](const Inputs& x, double* y) {
         biped::force_jacobian_transpose(x[0].data(), y);
       }}};
  return result;
}

Inputs random_inputs(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  Inputs result(count, Vector(kN));
  for (Vector& input : result) {
    for (double& x : input) {
      x = uniform(random);
    }
  }
  return result;
}

/// Largest |x - y| relative to the largest |y|.
double relative_error(const Vector& x, const Vector& y) {
  double error = 0;
  double scale = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double difference = std::fabs(x[k] - y[k]);
    error = difference <= error ? error : std::isnan(difference) ? HUGE_VAL : difference;
    scale = std::max(scale, std::fabs(y[k]));
  }
  return error / scale;
}

double largest_error(const Function& function, treedyn::engine::Engine<double>& engine) {
  std::mt19937_64 random(1);
  double largest = 0;
  for (int k = 0; k < 200; ++k) {
    const Inputs inputs = random_inputs(random, function.inputs);
    Vector y(function.size, std::nan(""));
    function.call(inputs, y.data());
    largest = std::max(largest, relative_error(y, engine.evaluate(function.name, inputs)));
  }
  return largest;
}

double nanoseconds(const Function& function) {
  using Clock = std::chrono::steady_clock;
  std::mt19937_64 random(1);
  const Inputs inputs = random_inputs(random, function.inputs);
  Vector y(function.size);
  constexpr int kCalls = 20000;
  double best = HUGE_VAL;
  for (int run = 0; run < 10; ++run) {
    const auto start = Clock::now();
    for (int k = 0; k < kCalls; ++k) {
      function.call(inputs, y.data());
    }
    const std::chrono::duration<double, std::nano> time = Clock::now() - start;
    best = std::min(best, time.count() / kCalls);
  }
  return best;
}

/// "Cost: .." of every function, as the generated header states it.
std::map<std::string, std::string> costs(const std::filesystem::path& header) {
  std::ifstream file(header);
  std::map<std::string, std::string> result;
  std::string cost;
  for (std::string line; std::getline(file, line);) {
    if (const std::size_t at = line.find("Cost: "); at != std::string::npos) {
      cost = line.substr(at + 6, line.rfind('.') - at - 6);
    } else if (line.starts_with("void ")) {
      result[line.substr(5, line.find('(') - 5)] = cost;
    }
  }
  return result;
}

int run(const std::string& model, const std::filesystem::path& folder) {
  treedyn::description::ReadOptions options;
  options.base = treedyn::description::Base::kAxes;
  treedyn::engine::Engine<double> engine(treedyn::description::read_model(model, options));
  std::cout << fmt::format("\nThe biped: {} joints, {} foot points. Generated:\n", kN, kP);
  for (const char* name : {"biped.hpp", "biped.cpp", "biped.json"}) {
    std::cout << fmt::format("  {:<12}{:>8} bytes\n", name,
                             std::filesystem::file_size(folder / name));
  }
  const auto cost = costs(folder / "biped.hpp");
  std::cout << fmt::format("\n{:<26}{:>8}  {:>8}  {}\n", "function", "ns/call", "error", "cost");
  bool exact = true;
  for (const Function& function : functions()) {
    const double error = largest_error(function, engine);
    exact = exact && error <= kTolerance;
    std::cout << fmt::format("{:<26}{:>8.0f}  {:>8.1e}  {}\n", function.name, nanoseconds(function),
                             error, cost.at(function.name));
  }
  std::cout << fmt::format(
      "\nerror: the largest difference from the generic engine over 200 random states, relative to "
      "the\nlargest entry of the output. {}\n",
      exact ? "All are rounding." : "TOO LARGE.");
  return exact ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: biped_demo MODEL FOLDER\n";
    return 2;
  }
  return run(argv[1], argv[2]);
}
