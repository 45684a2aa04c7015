#include "dynamics/scene_dynamics.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "common/transformed.hpp"
#include "engine/engine.hpp"
#include "formulate/functions.hpp"
#include "program/combine.hpp"
#include "program/tape.hpp"

namespace treedyn {

namespace {

program::Function combined(const model::Scene& scene, const std::vector<std::string>& names,
                           const std::vector<std::string>& inputs) {
  const std::vector<program::Function> functions = transformed(
      names, [&](const std::string& name) { return formulate::plain_function(scene, name); });
  const std::vector<program::Array> arrays = transformed(inputs, [&](const std::string& input) {
    return program::Array{input, scene.tree.dof(), ""};
  });
  return program::combine(functions, arrays);
}

std::span<const double> span_of(const simulation::Vector& x) {
  return {x.data(), static_cast<std::size_t>(x.size())};
}

/// A scene's own programs, interpreted.
class TapeDynamics final : public simulation::Dynamics {
 public:
  explicit TapeDynamics(const ScenePrograms& programs)
      : terms_(programs.terms),
        geometry_(programs.geometry),
        buffer_(programs.geometry.outputs.size()) {}

  void evaluate(const simulation::Vector& q, const simulation::Vector& qd,
                simulation::Terms& terms) override {
    const std::array<std::span<const double>, 2> inputs{span_of(q), span_of(qd)};
    terms_.evaluate(inputs, terms.values());
  }
  void evaluate_geometry(const simulation::Vector& q, simulation::Terms& terms) override {
    if (buffer_.empty()) {
      return;
    }
    const std::array<std::span<const double>, 1> inputs{span_of(q)};
    geometry_.evaluate(inputs, buffer_);
    terms.set_geometry(buffer_);
  }
  [[nodiscard]] std::optional<long> operations() const override {
    return static_cast<long>(terms_.instructions());
  }

 private:
  program::Tape terms_;
  program::Tape geometry_;
  std::vector<double> buffer_;
};

/// Evaluates the block equations themselves.
class EngineDynamics final : public simulation::Dynamics {
 public:
  explicit EngineDynamics(const model::Scene& scene)
      : engine_(scene.tree, scene.points, scene.gravity),
        zero_(simulation::Vector::Zero(scene.tree.dof())) {}

  void evaluate(const simulation::Vector& q, const simulation::Vector& qd,
                simulation::Terms& terms) override {
    run("mass_matrix", {q}, terms, 0);
    run("inverse_dynamics", {q, qd, zero_}, terms, 1);
    evaluate_geometry(q, terms);
    if (terms.needs().points) {
      run("point_bias_acceleration", {q, qd}, terms, 4);
    }
    if (terms.needs().rotations) {
      run("angular_bias_acceleration", {q, qd}, terms, 7);
    }
  }

  void evaluate_geometry(const simulation::Vector& q, simulation::Terms& terms) override {
    if (terms.needs().points) {
      run("point_positions", {q}, terms, 2);
      run("force_jacobian_transpose", {q}, terms, 3);
    }
    if (terms.needs().rotations) {
      run("point_rotations", {q}, terms, 5);
      run("moment_jacobian_transpose", {q}, terms, 6);
    }
  }

 private:
  void run(std::string_view function,
           std::initializer_list<std::reference_wrapper<const simulation::Vector>> inputs,
           simulation::Terms& terms, std::size_t array) {
    std::array<std::span<const double>, 3> spans;
    std::size_t count = 0;
    for (const simulation::Vector& input : inputs) {
      spans[count++] = span_of(input);
    }
    const std::span<const double> result =
        engine_.evaluate(function, std::span<const std::span<const double>>(spans.data(), count));
    std::ranges::copy(result,
                      terms.values().begin() + static_cast<std::ptrdiff_t>(terms.offset(array)));
  }

  engine::Engine<double> engine_;
  simulation::Vector zero_;
};

}  // namespace

ScenePrograms scene_programs(const model::Scene& scene) {
  std::vector<std::string> terms = {"mass_matrix", "inverse_dynamics"};
  std::vector<std::string> geometry;
  const simulation::Needs needs = simulation::needs_of(scene);
  if (needs.points) {
    terms.insert(terms.end(),
                 {"point_positions", "force_jacobian_transpose", "point_bias_acceleration"});
    geometry.insert(geometry.end(), {"point_positions", "force_jacobian_transpose"});
  }
  if (needs.rotations) {
    terms.insert(terms.end(),
                 {"point_rotations", "moment_jacobian_transpose", "angular_bias_acceleration"});
    geometry.insert(geometry.end(), {"point_rotations", "moment_jacobian_transpose"});
  }
  return {combined(scene, terms, {"q", "qd"}), combined(scene, geometry, {"q"})};
}

std::unique_ptr<simulation::Dynamics> program_dynamics(const model::Scene& scene) {
  return std::make_unique<TapeDynamics>(scene_programs(scene));
}

std::unique_ptr<simulation::Dynamics> engine_dynamics(const model::Scene& scene) {
  return std::make_unique<EngineDynamics>(scene);
}

}  // namespace treedyn
