#include "hard/code.hpp"

#include "common/index.hpp"
#include "formulate/scene_drift.hpp"
#include "model/scene_facts.hpp"
#include "pipeline.hpp"
#include "simulation/forces.hpp"
#include "simulation/pose.hpp"
#include "simulation/state.hpp"
#include "support/process.hpp"

namespace treedyn::hard {

namespace {

Model model_of(const model::Scene& scene, const std::vector<std::string>& functions) {
  Model result;
  result.source = {scene.name, ""};
  result.name = "generated";
  result.scene = scene;
  result.tree = scene.tree;
  result.points = scene.points;
  result.scene_functions = functions;
  return result;
}

}  // namespace

Code::Code(const model::Scene& scene, const std::string& scalar,
           const std::vector<std::string>& functions)
    : states_(formulate::phase_states(scene, model::step_method(scene).has_value())) {
  Request request;
  request.scene = scene.name;
  request.functions = functions;
  request.effort = 0;
  request.target.scalar = scalar == "float" ? emit::Scalar::kFloat : emit::Scalar::kDouble;
  const support::TemporaryFolder folder;
  const auto silent = [](const std::string&) {
  };
  for (const emit::File& file :
       generate(model_of(scene, functions), request, silent, [](const Warning&) {})) {
    support::write_file(folder.path() / file.name, file.text);
  }
  compiled_ = std::make_unique<support::CompiledModel>(folder.path(), "generated");
}

Arrays Code::call(const std::string& function, const Arrays& inputs) const {
  const support::FunctionInfo& info = compiled_->manifest().function(function);
  support::CompiledModel::Inputs arguments;
  for (const std::string& name : info.arguments) {
    arguments.push_back(inputs.at(name));
  }
  const Numbers values = compiled_->call(function, arguments);
  Arrays result;
  auto from = values.begin();
  for (std::size_t k = 0; k < info.outputs.size(); ++k) {
    result[info.results[k]] = Numbers(from, from + info.outputs[k]);
    from += info.outputs[k];
  }
  return result;
}

long Code::operations(const std::string& function) const {
  const auto& counts = compiled_->manifest().function(function).operations;
  return counts[0] + counts[1] + counts[2];
}

Numbers anchors_at(const model::Scene& scene, const Vector& q, double t) {
  Numbers result;
  simulation::Pose pose(scene.tree, scene.gravity);
  pose.update(q, Vector::Zero(q.size()));
  for (std::size_t c = 0; c < scene.constraints.size(); ++c) {
    const model::Constraint& constraint = scene.constraints[c];
    const int size = model::anchor_size(scene, static_cast<int>(c));
    const Eigen::Vector3d curve = simulation::VectorValue(constraint.curve.position).at(t);
    if (!constraint.pinned && size < 9) {
      result.insert(result.end(), to_index(size), 0);
    } else if (size == 1) {
      result.push_back(q[constraint.joint] - curve[0]);
    } else if (size == 3) {
      const model::Point& point = scene.points[to_index(constraint.point)];
      const Eigen::Vector3d p = pose.point(point.link, simulation::vector_of(point.at)) - curve;
      result.insert(result.end(), p.begin(), p.end());
    } else if (size == 9) {
      const int link = scene.points[to_index(constraint.point)].link;
      const Eigen::Matrix3d R =
          link < 0 ? Eigen::Matrix3d::Identity() : pose.links()[to_index(link)].R;
      for (int k = 0; k < 9; ++k) {
        result.push_back(R(k / 3, k % 3));
      }
    }
  }
  return result;
}

}  // namespace treedyn::hard
