#include "request/user_equations.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "description/equation_list.hpp"
#include "description/read.hpp"
#include "emit/names.hpp"
#include "emit/run_time.hpp"
#include "emit/self_test.hpp"
#include "emit/taken_names.hpp"
#include "equations/joint_sums.hpp"
#include "equations/scene_table.hpp"
#include "equations/table.hpp"

namespace treedyn {
namespace {

constexpr std::size_t kLongestText = 400;  // of an equation in a comment

/// The functions of generated code but for those of users, whether they were asked for or not.
const std::vector<std::string>& our_functions() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names = {emit::kUpdate, emit::kSelfTest};
    for (const std::string& name : formulate::function_names()) {
      names.push_back(name);
      if (equations::divides_by_pivots(name)) {
        names.push_back(name + "_checked");
      }
    }
    for (const equations::SceneFunctionInfo& info : equations::scene_function_infos()) {
      names.emplace_back(info.name);
    }
    return names;
  }();
  return kNames;
}

/// Functions of a phase, or of one contact of several: `impact_landing`.
bool is_of_scene(std::string_view name) {
  return std::ranges::any_of(equations::scene_function_infos(), [&](const auto& info) {
    return info.name != "step" && name.starts_with(fmt::format("{}_", info.name));
  });
}

/// What C99 calls the indices of joints and points: `joint_elbow` behind the prefix.
bool is_index(std::string_view name, const model::Tree& tree,
              const std::vector<model::Point>& points) {
  return std::ranges::any_of(
             tree.links,
             [&](const model::Link& link) { return name == "joint_" + link.joint.identifier; }) ||
         std::ranges::any_of(points, [&](const model::Point& point) {
           return name == "point_" + point.identifier;
         });
}

bool is_function(const std::string& name) {
  const std::vector<std::string>& names = formulate::function_names();
  return equations::is_scene_function(name) || std::ranges::find(names, name) != names.end();
}

/// Names of generated code, which of them there are depends on options.
bool is_ours(const std::string& name) {
  return is_reserved(name) || emit::is_own_name(name) || is_of_scene(name) ||
         std::ranges::any_of(our_functions(), [&](const std::string& function) {
           return name == function || emit::is_part_of(name, function);
         });
}

/// In generated code names of equations and inputs stand beside others, or hide them.
void check_names(const std::vector<model::EquationText>& texts, const model::Tree& tree,
                 const std::vector<model::Point>& points) {
  const auto require_free = [&](const char* what, const std::string& name, const Location& where) {
    const bool is_part = std::ranges::any_of(
        texts, [&](const model::EquationText& text) { return emit::is_part_of(name, text.name); });
    if (is_part || is_ours(name) || is_index(name, tree, points)) {
      throw InputError(where, fmt::format("{} '{}' has a name that is taken; expected another one",
                                          what, shown(name)));
    }
  };
  for (const model::EquationText& text : texts) {
    require_free("equation", text.name, text.where);
    for (const model::InputText& input : text.inputs) {
      require_free("input", input.name, input.where);
    }
  }
}

int count_of(const block::Side& side, int links, int points) {
  return side.size * (side.set == block::Set::kLinks    ? links
                      : side.set == block::Set::kPoints ? points
                                                        : 1);
}

/// Arrays over no points have no size.
void check_points(const equations::UserEquation& equation, bool no_points) {
  const auto counts = [](const block::Side& side) {
    return side.set == block::Set::kPoints;
  };
  const bool arguments =
      std::any_of(equation.arguments.begin(), equation.arguments.end(),
                  [&](const equations::UserArgument& argument) { return counts(argument.side); });
  const std::function<bool(const block::Expression&)> uses = [&](const block::Expression& e) {
    return counts(e.shape().rows) || counts(e.shape().cols) ||
           std::ranges::any_of(e.operands(), uses);
  };
  if (no_points && (arguments || uses(equation.expression))) {
    throw InputError(equation.where, fmt::format("equation '{}' needs points and the model has "
                                                 "none; expected --points",
                                                 equation.name));
  }
}

/// Joints that mimic others are no coordinates.
void check_mimic(const equations::UserEquation& equation) {
  const bool counts = equations::counts_joints(equation);
  if (counts || equations::picks_joints(equation.expression)) {
    throw InputError(
        equation.where,
        fmt::format("equation '{}' {} and some joints mimic others; expected --mimic independent",
                    equation.name,
                    counts
                        ? "has rows, columns or inputs (but q, qd, qdd) of joints"
                        : "takes forces on single joints, or sums of them, or columns of joints"));
  }
}

/// "A qdd" for "A * qdd": a star is no matter for comments.
std::string without_stars(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const char kept = c == '*' || c == '\n' ? ' ' : c;
    if (kept != ' ' || !result.ends_with(' ')) {
      result += kept;
    }
  }
  return result;
}

}  // namespace

UserFunctions read_user_equations(const Request& request, const std::string& tree_file,
                                  const std::string& tree_text, const model::Tree& tree,
                                  const std::vector<model::Point>& points) {
  std::vector<model::EquationText> texts;
  if (!tree_file.empty() && !description::is_urdf(tree_file)) {
    texts = description::equations_of_tree(tree_text, tree_file);
  }
  for (const std::string& file : request.equations) {
    const auto more = description::equations_of_file(description::read_text(file), file);
    texts.insert(texts.end(), more.begin(), more.end());
  }
  check_names(texts, tree, points);
  UserFunctions result;
  for (const equations::UserEquation& equation : equations::read_equations(texts, tree, points)) {
    check_points(equation, points.empty());
    try {
      result.push_back(formulate::derived(equation, tree.size(), static_cast<int>(points.size())));
    } catch (const TooLarge& error) {
      throw InputError(equation.where,
                       fmt::format("equation '{}': {}", equation.name, error.what()));
    } catch (const std::logic_error& error) {  // a mistake of ours: it says at least of what
      throw std::logic_error(fmt::format("{}: equation '{}': {}", to_string(equation.where),
                                         equation.name, error.what()));
    }
  }
  return result;
}

UserFunctions chosen(const UserFunctions& all, const std::vector<std::string>& wanted,
                     const model::Tree& tree) {
  for (const std::string& name : wanted) {
    const bool known = is_function(name) || std::ranges::any_of(all, [&](const auto& f) {
                         return f->equation.name == name;
                       });
    if (!known) {
      std::vector<std::string> names = formulate::function_names();
      for (const auto& function : all) {
        names.push_back(function->equation.name);
      }
      const std::vector<std::string_view> known_names(names.begin(), names.end());
      throw UsageError(fmt::format("--functions: there is no function '{}'{}; expected some of {}",
                                   shown(name), did_you_mean(name, known_names),
                                   fmt::join(names, ",")));
    }
  }
  UserFunctions result;
  std::ranges::copy_if(all, std::back_inserter(result), [&](const auto& function) {
    return wanted.empty() || std::ranges::find(wanted, function->equation.name) != wanted.end();
  });
  for (const auto& function : result) {
    if (tree.mimics() > 0) {
      check_mimic(function->equation);
    }
  }
  return result;
}

program::Signature signature_of(const formulate::Derived& function, int dof, int points) {
  const equations::UserEquation& equation = function.equation;
  const block::Shape& shape = equation.expression.shape();
  const auto [rows, columns] = size_of(function, dof, points);
  program::Signature signature;
  signature.name = equation.name;
  signature.equation = emit::for_comment(without_stars(equation.text), kLongestText);
  const std::string what = equation.doc.empty() ? "An equation of the user."
                                                : emit::for_comment(equation.doc, kLongestText);
  signature.brief = fmt::format("{}{} value: {} x {}{}.", what, what.ends_with('.') ? "" : ".",
                                rows, columns, shape.cols == block::Side{} ? "" : ", row-major");
  for (const equations::UserArgument& argument : equation.arguments) {
    signature.inputs.push_back(
        {argument.name, count_of(argument.side, dof, points), argument.unit});
  }
  signature.outputs = {{"value", rows * columns, equation.unit}};
  signature.outputs.front().rows = rows;
  signature.outputs.front().columns = columns;
  return signature;
}

std::pair<int, int> size_of(const formulate::Derived& function, int dof, int points) {
  const block::Shape& shape = function.equation.expression.shape();
  return {count_of(shape.rows, dof, points), count_of(shape.cols, dof, points)};
}

}  // namespace treedyn
