// robot_cases DIR...: the executable on published URDF files, against values of another engine.
//
// The case files, the order of their joints and the tolerances: README.md of the data folder.

#include <algorithm>
#include <thread>

#include <fmt/format.h>

#include "support/cases.hpp"
#include "support/compiled.hpp"

namespace treedyn {
namespace {

using support::CompiledModel;
using support::Json;
using support::Report;
using support::Tolerance;
using Vector = std::vector<double>;

constexpr Tolerance kTolerance{1e-9, 1e-12, 1e-9};

/// One robot generated with one snapping, and where its joints stand in the case file.
struct Robot {
  std::string source;
  CompiledModel code;
  std::vector<std::size_t> place;  ///< generated joint -> joint of the case file
  bool snapped = false;
};

std::vector<std::size_t> places(const std::vector<std::string>& joints, const Json& data) {
  const auto names = data.at("joint_names").get<std::vector<std::string>>();
  if (joints.size() != names.size()) {
    throw std::runtime_error(fmt::format("{} joints, expected {}", joints.size(), names.size()));
  }
  std::vector<std::size_t> result;
  for (const std::string& joint : joints) {
    const auto found = std::find(names.begin(), names.end(), joint);
    if (found == names.end()) {
      throw std::runtime_error("the case file has no joint " + joint);
    }
    result.push_back(static_cast<std::size_t>(found - names.begin()));
  }
  return result;
}

/// Robots on a fixed base of more joints are searched for as short as free ones.
constexpr std::size_t kMostSearched = 12;

/// \param snapped  the robot on a fixed base is searched as users do, other runs are short
Robot make_robot(const std::filesystem::path& file, const Json& data, bool snapped) {
  const bool fixed = data.at("base").get<std::string>() == "fixed";
  const std::vector<double> g = support::flat(data.at("gravity"));
  std::string points;
  for (const Json& frame : data.at("frames")) {
    points += (points.empty() ? "" : ",") + frame.at("name").get<std::string>();
  }
  std::vector<std::string> options{"--mimic",   "independent",
                                   "--gravity", fmt::format("{},{},{}", g[0], g[1], g[2]),
                                   "--base",    fixed ? "fixed" : "axes"};
  std::string functions = "mass_matrix,bias_force,gravity_force,inverse_dynamics,forward_dynamics";
  if (!points.empty()) {
    functions +=
        ",point_positions,point_rotations,force_jacobian_transpose,moment_jacobian_transpose,"
        "point_bias_acceleration,angular_bias_acceleration";
    options.insert(options.end(), {"--points", points});
  }
  options.insert(options.end(), {"--functions", functions});
  if (!snapped) {
    options.insert(options.end(), {"--snap", "0"});
  }
  if (!snapped || !fixed || data.at("joint_names").size() > kMostSearched) {
    options.insert(options.end(), {"--effort", "100"});
  }
  CompiledModel code = support::generate_and_compile(
      file.parent_path() / data.at("urdf").get<std::string>(), options);
  std::vector<std::size_t> place = places(code.manifest().joints, data);
  return {snapped ? "snapped" : "exact", std::move(code), std::move(place), snapped};
}

Vector ordered(const Robot& robot, const Json& list) {
  const Vector values = support::flat(list);
  Vector result;
  for (const std::size_t k : robot.place) {
    result.push_back(values.at(k));
  }
  return result;
}

Vector ordered_matrix(const Robot& robot, const Json& rows) {
  Vector result;
  for (const std::size_t k : robot.place) {
    const Vector row = ordered(robot, rows.at(k));
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

void check_forward_dynamics(const Robot& robot, const Json& sample, const Vector& qdd,
                            Report& report) {
  if (!robot.snapped) {
    report.compare(robot.source, "aba", qdd, ordered(robot, sample.at("aba")), kTolerance);
    return;
  }
  const Vector A = ordered_matrix(robot, sample.at("A"));
  const Vector B = ordered(robot, sample.at("nle"));
  const Vector G = ordered(robot, sample.at("g"));
  const Vector tau = ordered(robot, sample.at("tau"));
  const std::size_t n = qdd.size();
  double residual = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = B[i] + G[i] - tau[i];
    for (std::size_t j = 0; j < n; ++j) {
      sum += A[i * n + j] * qdd[j];
    }
    residual = std::max(residual, std::isfinite(sum) ? std::fabs(sum) : HUGE_VAL);
  }
  const double scale = std::max(support::max_abs(A) * support::max_abs(qdd), 1.0);
  report.note(robot.source, "residual", residual / scale, 1e-9);
}

void check_joint_space(const Robot& robot, const Json& sample, Report& report) {
  const Vector q = ordered(robot, sample.at("q"));
  const Vector qd = ordered(robot, sample.at("qd"));
  const auto compare = [&](const char* quantity, const Vector& x, const Vector& expected) {
    report.compare(robot.source, quantity, x, expected, kTolerance);
  };
  compare("A", robot.code.call("mass_matrix", {q}), ordered_matrix(robot, sample.at("A")));
  compare("B", robot.code.call("bias_force", {q, qd}), ordered(robot, sample.at("nle")));
  compare("G", robot.code.call("gravity_force", {q}), ordered(robot, sample.at("g")));
  compare("tau", robot.code.call("inverse_dynamics", {q, qd, ordered(robot, sample.at("qdd"))}),
          ordered(robot, sample.at("rnea")));
  check_forward_dynamics(
      robot, sample, robot.code.call("forward_dynamics", {q, qd, ordered(robot, sample.at("tau"))}),
      report);
}

/// Rows first..first+2 of the 6 x N Jacobian of every frame as C or H: N x 3P.
Vector transposed_jacobians(const Robot& robot, const Json& frames, std::size_t first) {
  const std::size_t points = frames.size();
  Vector result(robot.place.size() * 3 * points);
  for (std::size_t p = 0; p < points; ++p) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Vector row = ordered(robot, frames.at(p).at("J").at(first + axis));
      for (std::size_t i = 0; i < row.size(); ++i) {
        result[(i * points + p) * 3 + axis] = row[i];
      }
    }
  }
  return result;
}

Vector gathered(const Json& frames, const char* field, std::size_t first, std::size_t count) {
  Vector result;
  for (const Json& frame : frames) {
    const Vector values = support::flat(frame.at(field));
    for (std::size_t k = first; k < first + count; ++k) {
      result.push_back(values.at(k));
    }
  }
  return result;
}

void check_frames(const Robot& robot, const Json& sample, Report& report) {
  const Json& frames = sample.at("frames");
  const Vector q = ordered(robot, sample.at("q"));
  const Vector qd = ordered(robot, sample.at("qd"));
  const auto compare = [&](const char* quantity, const char* function,
                           const CompiledModel::Inputs& inputs, const Vector& expected) {
    report.compare(robot.source, quantity, robot.code.call(function, inputs), expected, kTolerance);
  };
  compare("p", "point_positions", {q}, gathered(frames, "position", 0, 3));
  compare("R", "point_rotations", {q}, gathered(frames, "rotation_rowmajor", 0, 9));
  compare("C", "force_jacobian_transpose", {q}, transposed_jacobians(robot, frames, 0));
  compare("H", "moment_jacobian_transpose", {q}, transposed_jacobians(robot, frames, 3));
  compare("gamma_f", "point_bias_acceleration", {q, qd}, gathered(frames, "Jdqd", 0, 3));
  compare("gamma_n", "angular_bias_acceleration", {q, qd}, gathered(frames, "Jdqd", 3, 3));
}

void check(const std::filesystem::path& file, const Json& data, Report& report) {
  for (const bool snapped : {false, true}) {
    const Robot robot = make_robot(file, data, snapped);
    for (const Json& sample : data.at("samples")) {
      check_joint_space(robot, sample, report);
      if (!sample.at("frames").empty()) {
        check_frames(robot, sample, report);
      }
    }
  }
}

}  // namespace
}  // namespace treedyn

int main(int argc, char** argv) {
  const std::vector<std::string> folders(argv + 1, argv + argc);
  const unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  return treedyn::support::run_cases(folders, treedyn::check, jobs);
}
