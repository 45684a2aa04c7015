// What the effects of a scene file refer to: its model, points, parameters and expressions.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "description/scene_fields.hpp"
#include "description/scene_reader.hpp"
#include "expressions/read_expression.hpp"
#include "model/scene.hpp"

namespace treedyn::description {

/// Names and numbers of one scene file; points enter `scene` in the order of their first use.
class SceneContext {
 public:
  /// \param scene  its tree is complete; it outlives the object
  /// \param at_run_time  makes numbers of parameters that are known at run time only; empty: they
  /// are numbers like others
  SceneContext(const std::string& file, model::Scene& scene, AtRunTime at_run_time)
      : file_(file), scene_(scene), at_run_time_(std::move(at_run_time)) {}

  [[nodiscard]] SceneFields fields(const Node& node, const std::string& what,
                                   const Keys& keys) const {
    return {file_, node, what, keys, constants_};
  }
  [[nodiscard]] const std::string& file() const { return file_; }
  model::Scene& scene() { return scene_; }

  /// \param run_time  names of those that are known at run time only
  void define_parameters(const Node* node, const std::vector<Text>& run_time);
  /// The points of the scene, in file order.
  void define_points(const SceneFields& root);

  /// The coordinate of the joint that `fields` names. \throws InputError
  [[nodiscard]] int joint(const SceneFields& fields) const {
    return joint(fields, fields.text("joint"));
  }
  [[nodiscard]] int joint(const Fields& fields, const Text& name) const;
  /// The point that `key` names: of the scene, of the model, or the origin of a link.
  int point(const SceneFields& fields, std::string_view key = "point");
  /// The same under `point`. \throws InputError if it is fixed to the ground
  int moving_point(const SceneFields& fields);

  enum class Of { kState, kTime, kPoint, kDepth };
  /// An expression of t, q, qd; t alone; these and the motion of a point; depth and normal speed.
  [[nodiscard]] model::Expression expression(const SceneFields& fields, const Node& node,
                                             Of kind) const;
  /// Of time, with its derivatives.
  [[nodiscard]] std::array<model::Expression, 3> motion(const SceneFields& fields,
                                                        const Node& node) const;

 private:
  template <class Read>
  auto guarded(const SceneFields& fields, const Node& node, const Read& read) const;
  void define(const Node& item, const std::string& what, bool run_time);
  [[nodiscard]] expressions::VariableNames variables(Of kind, const SceneFields& fields) const;
  [[nodiscard]] std::optional<int> coordinate(std::string_view name) const;
  [[nodiscard]] std::optional<model::Point> of_model(const std::string& name) const;
  int add(const Fields& fields, const Place& where, model::Point point);

  const std::string& file_;
  model::Scene& scene_;
  AtRunTime at_run_time_;
  expressions::Constants constants_;
};

}  // namespace treedyn::description
