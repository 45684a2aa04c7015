#include "equations/reading.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include <fmt/format.h>

#include "block/print.hpp"
#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"
#include "equations/energy.hpp"
#include "equations/kinematics.hpp"
#include "equations/number_of_tree.hpp"
#include "equations/symbol_names.hpp"

namespace treedyn::equations {
namespace {

/// Functions that texts call, and constants.
constexpr const char* kTaken[] = {"T",     "Lam",      "LamT", "diagb", "dot",  "at",  "under",
                                  "above", "at_point", "R",    "sqrt",  "sin",  "cos", "tan",
                                  "pi",    "q",        "f",    "n",     "value"};

struct ArgumentRow {
  const char* name;
  std::vector<const char*> leaves;
  block::Side side;
  const char* unit;
};
const std::vector<ArgumentRow>& argument_rows() {
  static const std::vector<ArgumentRow> kRows = {
      {"q", {"z^d", "s^d", "l^d", "c^d", "t^d", "J_c^d"}, kLinks, "rad|m"},
      {"qd", {"q̇", "q̇^d"}, kLinks, "rad/s|m/s"},
      {"qdd", {"q̈"}, kLinks, "rad/s^2|m/s^2"},
      {"tau", {"τ"}, kLinks, "N m|N"},
      {"f", {"f_b"}, kPoints3, "N"},
      {"n", {"n_b"}, kPoints3, "N m"},
  };
  return kRows;
}

void collect_leaves(const Expression& e, std::set<std::string>& names) {
  if (e.kind() == block::Kind::kLeaf) {
    names.insert(e.node().name);
  }
  for (const Expression& operand : e.operands()) {
    collect_leaves(operand, names);
  }
}

block::Side side_of(const model::InputText& input) {
  return {input.per == "link"    ? block::Set::kLinks
          : input.per == "point" ? block::Set::kPoints
                                 : block::Set::kOne,
          input.size};
}

JointKinds kinds_of(const model::Tree& tree) {
  if (tree.links.empty()) {  // for every tree
    return {true, true};
  }
  JointKinds kinds{false, false};
  for (const model::Link& link : tree.links) {
    (link.joint.turns() ? kinds.revolute : kinds.prismatic) = true;
  }
  return kinds;
}

}  // namespace

bool is_taken(const std::string& name) {
  const std::vector<std::string_view> known = known_names();
  return std::ranges::find(known, name) != known.end() ||
         std::find(std::begin(kTaken), std::end(kTaken), name) != std::end(kTaken);
}

Reading::Reading(const model::Tree& tree, std::span<const model::Point> points)
    : tree_(tree), points_(points), units_(kinds_of(tree)) {}

void Reading::add_input(const model::InputText& input) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(input.where, fmt::format("equation '{}': input '{}' {}", made.name,
                                              shown(input.name), problem));
  };
  if (to_identifier(input.name) != input.name || is_taken(input.name) || input.name == made.name) {
    fail("has a name that is taken or no identifier; expected another one");
  }
  if (inputs_.count(input.name) > 0) {
    fail("stands there twice");
  }
  const block::Side side = side_of(input);
  const Expression e = block::leaf(input.name, block::Structure::kFull, {side, kOne});
  Units units;
  units[0][0] = unit_of_input(inputs_.size(), 0);
  units[1][0] = unit_of_input(inputs_.size(), 1);
  inputs_.emplace(input.name, e);
  if (side.set != block::Set::kLinks) {
    units[1][0] = std::nullopt;
  }
  units_.define(input.name, units);
  made.arguments.push_back({input.name, input.name, side, ""});
}

void Reading::add_used_input(const model::InputText& input) {
  const auto known = inputs_.find(input.name);
  if (known == inputs_.end()) {
    add_input(input);
  } else if (known->second.shape().rows != side_of(input)) {
    throw std::runtime_error(fmt::format(
        "uses an equation with an input '{}' of another shape; expected one array of that name",
        shown(input.name)));
  }
}

std::optional<Expression> Reading::input(const std::string& name) const {
  const auto found = inputs_.find(name);
  return found == inputs_.end() ? std::nullopt : std::optional(found->second);
}

Expression Reading::constant(const std::string& name, block::Structure structure,
                             const block::Shape& shape, const std::vector<Real>& values) {
  made.constants[name] = values;
  rates.emplace(name, std::nullopt);
  return block::leaf(name, structure, shape);
}

Expression Reading::number(const Real& value) {
  const std::string name = value.str(12);
  const auto known = made.constants.find(name);
  const bool is_other = known != made.constants.end() && known->second.front() != value;
  return constant(is_other ? value.str(45) : name, block::Structure::kFull, {kOne, kOne}, {value});
}

/// Masses and counts of links are numbers before any state is known.
Expression Reading::reciprocal(const Expression& e) {
  std::set<std::string> leaves;
  collect_leaves(e, leaves);
  const bool constant_leaves = std::ranges::all_of(leaves, [&](const auto& name) {
    const bool of_tree = name == "D" || name == "E" || name == "σ" || name == "W" ||
                         name == "1_N" || name == "1_P" || name == "m^d";
    return of_tree || made.constants.count(name) > 0 || made.reciprocals.count(name) > 0;
  });
  if (e.shape() != block::Shape{kOne, kOne} || !constant_leaves) {
    throw std::runtime_error(
        "divides by a block expression; expected a constant, or a number that the tree decides");
  }
  std::vector<Real> masses;
  std::ranges::transform(tree_.links, std::back_inserter(masses),
                         [](const model::Link& link) { return link.inertia.mass; });
  if (number_of_tree<Real>(made, e, index_of(tree_, points_), masses, std::identity()) == 0) {
    throw std::runtime_error("divides by zero; expected a divisor that is not zero");
  }
  Units units = units_.of(e);
  const Unit unit = units[0][0].value_or(Unit{});
  const std::string name = fmt::format("({})^-1", block::print(e));
  units[0][0] = Unit{-unit.kg, -unit.m, -unit.s, unit.any};
  units_.define(name, units);
  made.reciprocals.insert_or_assign(name, e);
  rates.emplace(name, std::nullopt);
  return block::leaf(name, block::Structure::kFull, {kOne, kOne});
}

const model::Frame& Reading::frame(const std::string& name) const {
  for (const model::Frame& frame : tree_.frames) {
    if (frame.name == name) {
      return frame;
    }
  }
  std::vector<std::string_view> known = names_of(tree_.frames);
  for (const model::Link& link : tree_.links) {
    known.push_back(link.joint.name);
  }
  const bool is_point = std::ranges::find(points_, name, &model::Point::name) != points_.end();
  throw std::runtime_error(
      fmt::format("there is no link or joint '{}'{}; expected one of the model", shown(name),
                  is_point ? " (of points: at_point)" : did_you_mean(name, known)));
}

/// The moving link that is called so, or carries the link that is; else that of the joint.
int Reading::link(const std::string& name) const {
  const auto is_link = [&](const model::Link& link) {
    return link.name == name;
  };
  const auto is_joint = [&](const model::Link& link) {
    return link.joint.name == name || link.joint.identifier == name;
  };
  auto found = std::ranges::find_if(tree_.links, is_link);
  const bool is_frame = std::ranges::count(tree_.frames, name, &model::Frame::name) > 0;
  if (found == tree_.links.end() && !is_frame) {
    found = std::ranges::find_if(tree_.links, is_joint);
  }
  const int i =
      found == tree_.links.end() ? frame(name).link : static_cast<int>(found - tree_.links.begin());
  if (i == model::kGround) {
    throw std::runtime_error(
        fmt::format("link '{}' does not move; expected a link that does", shown(name)));
  }
  return i;
}

Expression Reading::at(const std::string& name, int i) {
  std::vector<Real> values(size());
  values[to_index(i)] = 1;
  const bool prismatic = tree_.links[to_index(i)].joint.type == model::JointType::kPrismatic;
  Units units;
  units[prismatic ? 1 : 0][0] = Unit{};
  units_.define(name, units);
  return constant(name, block::Structure::kFull, {kLinks, kOne}, values);
}

Expression Reading::of_point(const std::string& name) {
  std::vector<Real> values(points_.size());
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (points_[p].name == name || points_[p].identifier == name) {
      values[p] = 1;
      return constant(fmt::format("at_point({})", name), block::Structure::kFull, {kPoints, kOne},
                      values);
    }
  }
  throw std::runtime_error(
      fmt::format("there is no point '{}'{}; expected one of the points asked for", shown(name),
                  did_you_mean(name, names_of(points_))));
}

/// The rate of a rotation is Λ(ω) R.
Expression Reading::orientation(const std::string& name) {
  const std::string leaf = fmt::format("R({})", name);
  Expression R =
      block::leaf(leaf, block::Structure::kFull, {{block::Set::kOne, 3}, {block::Set::kOne, 3}});
  const auto fixed = std::ranges::find(tree_.frames, name, &model::Frame::name);
  const bool is_fixed =
      fixed != tree_.frames.end() && std::ranges::count(tree_.links, name, &model::Link::name) == 0;
  const model::Matrix3 rotation =
      is_fixed ? fixed->rotation : model::Matrix3{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const int carrier = is_fixed ? fixed->link : link(name);
  made.frames[leaf] = {carrier, rotation};
  rates.emplace(leaf, std::nullopt);
  if (carrier != model::kGround) {
    const Expression omega =
        block::transpose(at(fmt::format("at({})", name), carrier)) * (D * z_d * sigma * qd);
    rates[leaf] = block::skew(omega) * R;
  }
  return R;
}

Expression Reading::of(const std::string& function, const std::string& argument) {
  if (function == "at_point") {
    return of_point(argument);
  }
  if (function == "R") {
    return orientation(argument);
  }
  const std::string name = fmt::format("{}({})", function, argument);
  const int i = link(argument);
  if (function == "at") {
    return at(name, i);
  }
  std::vector<Real> values(size());
  for (int k = 0; k < tree_.size(); ++k) {
    const bool one =
        function == "under" ? model::reaches(tree_, k, i) : model::reaches(tree_, i, k);
    values[to_index(k)] = one ? 1 : 0;
  }
  return constant(name, block::Structure::kDiagonal, {kLinks, kLinks}, values);
}

/// The arrays that the function takes: the symbols that occur, then the user's own.
void Reading::finish(const Expression& e) {
  made.expression = e;
  const std::string unit = to_string(units_.of(e));
  const bool is_energy =
      unit == "N m" && e.shape() == block::Shape{kOne, kOne} && has_form_of_energy(e);
  made.unit = is_energy ? std::string("J") : unit;
  std::set<std::string> leaves;
  collect_leaves(e, leaves);
  std::vector<UserArgument> arguments;
  for (const ArgumentRow& row : argument_rows()) {
    const bool turned = std::string_view(row.name) == "q" && !made.frames.empty();
    const auto found =
        std::ranges::find_if(row.leaves, [&](const char* name) { return leaves.count(name) > 0; });
    if (found != row.leaves.end() || turned) {
      arguments.push_back({row.name, found == row.leaves.end() ? "" : *found, row.side, row.unit});
    }
  }
  arguments.insert(arguments.end(), made.arguments.begin(), made.arguments.end());
  made.arguments = std::move(arguments);
}

}  // namespace treedyn::equations
