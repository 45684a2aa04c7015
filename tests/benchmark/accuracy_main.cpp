// benchmark_accuracy MODELS URDF STATES -o DIR: rounding errors of every pass and of both kinds of
// forward dynamics, against 50 digits. Writes accuracy.md.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>

#include "benchmark/accuracy.hpp"
#include "benchmark/command.hpp"
#include "benchmark/growing.hpp"
#include "description/read.hpp"
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

namespace fs = std::filesystem;

constexpr double kDouble = 0x1p-53;
constexpr double kFloat = 0x1p-24;

model::Tree read(const fs::path& file, description::Base base) {
  description::ReadOptions options;
  options.base = base;
  return description::read_model(file.string(), options);
}

Subject chain(int size, std::size_t states) {
  return {fmt::format("chain of {}", size),
          description::parse_model(growing_robot(true, size), "chain.yaml", {}), states, 0};
}

std::string shown(const Errors& errors) {
  const auto& e = errors.scaled;
  return fmt::format("{:.1e} | {:.1e} | {:.1e}", e[0], e[1], e[2]);
}

/// The factors by which `a` is less accurate than `b`, the larger of double and float: usual and
/// singular, large angles, all of them conditioned.
std::string cost(const Accuracy& a, const Accuracy& b) {
  const Errors in_double = factors(a.in_double, b.in_double, kDouble);
  const Errors in_float = factors(a.in_float, b.in_float, kFloat);
  std::array<double, 3> scaled{};
  double conditioned = 0;
  for (std::size_t k = 0; k < kRegions.size(); ++k) {
    scaled[k] = std::max(in_double.scaled[k], in_float.scaled[k]);
    conditioned = std::max({conditioned, in_double.conditioned[k], in_float.conditioned[k]});
  }
  return fmt::format("{:.1f} | {:.1f} | {:.1f}", std::max(scaled[0], scaled[1]), scaled[2],
                     conditioned);
}

constexpr const char* kHead =
    "| robot | function | formulation | operations | double: usual | singular | large | float: "
    "usual | singular | large |";

std::string row(const Accuracy& accuracy) {
  return fmt::format("| {} | {} | {} | {} | {} | {} |", accuracy.robot, accuracy.function,
                     accuracy.formulation.name, accuracy.operations, shown(accuracy.in_double),
                     shown(accuracy.in_float));
}

/// One row a formulation; what a pass costs is the error with it over that without it.
std::string table_of_passes(const std::vector<Subject>& subjects) {
  std::string text = fmt::format(
      "{} a pass costs: usual, singular | large | conditioned |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      kHead);
  for (const Subject& subject : subjects) {
    for (const char* function :
         {"mass_matrix", "bias_force", "gravity_force", "inverse_dynamics", "forward_dynamics"}) {
      const std::vector<Accuracy> rows = accuracy(subject, function, formulations_by_pass());
      for (const Accuracy& each : rows) {
        const std::string factor =
            &each == &rows.front() ? " | | " : cost(rows[each.formulation.with], each);
        text += fmt::format("{} {} |\n", row(each), factor);
      }
      std::cerr << subject.name << ' ' << function << '\n';
    }
  }
  return text;
}

std::string table_of_forward_dynamics(const std::vector<Subject>& subjects) {
  std::string text = fmt::format("{}\n|---|---|---|---|---|---|---|---|---|---|\n", kHead);
  for (const Subject& subject : subjects) {
    for (const Accuracy& each :
         accuracy(subject, "forward_dynamics", formulations_of_forward_dynamics())) {
      text += fmt::format("{}\n", row(each));
    }
    std::cerr << subject.name << " forward dynamics\n";
  }
  return text;
}

void run(const fs::path& models, const fs::path& urdf, std::size_t states, const fs::path& output) {
  using description::Base;
  const int effort = formulate::Options{}.effort;
  const Subject puma{"puma560", read(models / "puma560.yaml", Base::kFixed), states, effort};
  std::vector<Subject> arms{puma};
  std::vector<Subject> solved{puma, chain(20, states / 4), chain(40, states / 4)};
  if (fs::exists(urdf)) {
    const Subject ur5{"ur5", read(urdf / "ur5_robot.urdf", Base::kFixed), states, effort};
    const Subject hyq{"hyq_axes", read(urdf / "hyq_no_sensors.urdf", Base::kAxes), states, effort};
    arms.insert(arms.end(), {ur5, hyq});
    solved.insert(solved.end(), {ur5,
                                 hyq,
                                 {"humanoid_axes", read(urdf / "simple_humanoid.urdf", Base::kAxes),
                                  states / 4, 0}});
  }
  const std::string text = fmt::format(
      "Largest error, relative to the natural scale of the value, {} states a region (chains and "
      "humanoid: {}).\n\n"
      "{}\nForward dynamics both ways (chains and humanoid: `--effort 0`):\n\n{}",
      states, states / 4, table_of_passes(arms), table_of_forward_dynamics(solved));
  fs::create_directories(output);
  support::write_file(output / "accuracy.md", text);
  std::cout << text;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(
      argc, argv, "benchmark_accuracy", {"MODELS", "URDF", "STATES", "-o", "DIR"},
      [](const Words& words) { run(words[0], words[1], std::stoul(words[2]), words[4]); });
}
