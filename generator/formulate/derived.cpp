#include "formulate/derived.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "derive/derive.hpp"
#include "derive/words.hpp"
#include "equations/table.hpp"
#include "formulate/lowering.hpp"
#include "formulate/stand_ins.hpp"
#include "program/rounding.hpp"

namespace treedyn::formulate {
namespace {

using block::Set;
using Matrix = std::vector<std::vector<Expr>>;

int count(const block::Side& side, int links, int points) {
  return side.size * (side.set == Set::kLinks ? links : side.set == Set::kPoints ? points : 1);
}

/// Rows of joints (numbers of links) become rows of the independent coordinates: those of joints
/// that move together add up. Of vectors of links those of independent joints remain.
Matrix in_coordinates(const Task& task, const Matrix& rows, const block::Side& side, bool picked) {
  const model::Tree& tree = task.tree;
  Graph& graph = task.kinematics.graph();
  if (side.set != Set::kLinks) {
    return rows;
  }
  const std::size_t width = rows.front().size();
  Matrix result(to_index(tree.dof() * side.size), std::vector<Expr>(width));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int link = static_cast<int>(k) / side.size;
    const model::Drive& drive = tree.drives[to_index(link)];
    if (picked && tree.coordinates[to_index(drive.coordinate)] != link) {
      continue;
    }
    std::vector<Expr>& sum =
        result[to_index(drive.coordinate * side.size) + k % to_index(side.size)];
    for (std::size_t j = 0; j < width; ++j) {
      sum[j] += picked ? rows[k][j] : constant(graph, drive.multiplier) * rows[k][j];
    }
  }
  return result;
}

Matrix transposed(const Matrix& m) {
  Matrix result(m.empty() ? 0 : m.front().size(), std::vector<Expr>(m.size()));
  for (std::size_t i = 0; i < m.size(); ++i) {
    for (std::size_t j = 0; j < m[i].size(); ++j) {
      result[j][i] = m[i][j];
    }
  }
  return result;
}

/// Entries `first`, `first` + `stride` and so on.
std::vector<Expr> every_nth(const std::vector<Expr>& entries, std::size_t first,
                            std::size_t stride) {
  std::vector<Expr> result;
  for (std::size_t e = first; e < entries.size(); e += stride) {
    result.push_back(entries[e]);
  }
  return result;
}

/// The rows of what is derived, vectors in a frame.
Matrix written(Lowering& lowering, int frame) {
  const derive::Derivation& derivation = lowering.derivation();
  const auto& [rows, cols] = derivation.shape;
  const block::Side& counted = derivation.by_rows ? rows : cols;
  const block::Side& along = derivation.by_rows ? cols : rows;
  const std::size_t stride = derivation.wide ? 3 : 1;
  Matrix result;
  for (int place = 0; place < lowering.count(counted.set); ++place) {
    for (int k = 0; k < counted.size; k += static_cast<int>(stride)) {
      if (derivation.by_units) {
        lowering.ask_for(place, k);
      }
      const std::vector<Expr> entries =
          lowering.written(derivation.by_units ? 0 : k, along.set, frame);
      for (std::size_t n = 0; n < stride; ++n) {
        result.push_back(every_nth(entries, n, stride));
      }
    }
  }
  return derivation.by_rows ? result : transposed(result);
}

/// Column j of a symmetric matrix, the rows from link j up.
void add_column(const Kinematics& k, Lowering& lowering, int j, SparseSymmetric& a) {
  lowering.ask_for(j, 0);
  for (int i = j; i != kBase; i = k.link(i).father) {
    if (const Expr entry = lowering.entry(i); !entry.is_zero()) {
      a[{j, i}] = entry;
    }
  }
}

/// Row-major, of the degrees of freedom: T^T A T for reduced mimic joints (q = T u + q0).
std::vector<Expr> dense(const Task& task, const SparseSymmetric& a) {
  const auto n = to_index(task.tree.dof());
  std::vector<Expr> result(n * n);
  for (const auto& [place, entry] : a) {
    const model::Drive& row = task.tree.drives[to_index(place.first)];
    const model::Drive& column = task.tree.drives[to_index(place.second)];
    const Expr scaled =
        constant(task.kinematics.graph(), row.multiplier * column.multiplier) * entry;
    const auto i = to_index(row.coordinate);
    const auto j = to_index(column.coordinate);
    result[i * n + j] += scaled;
    if (place.first != place.second) {
      result[j * n + i] += scaled;
    }
  }
  return result;
}

template <class Fits>
bool any_needed(const derive::Derivation& derivation, Fits fits) {
  const std::vector<int> needed = derivation.values.needed(derivation.roots);
  return std::ranges::any_of(needed, [&](int id) { return fits(derivation.values[id]); });
}

/// Regrouped parameters have no centres of mass.
bool needs_centres(const derive::Derivation& derivation) {
  return any_needed(derivation,
                    [](const derive::Value& v) { return v.name == "c^d" || v.name == "J_c^d"; });
}

bool has_turnings(const derive::Derivation& derivation) {
  const std::vector<int> needed = derivation.values.needed(derivation.roots);
  return !derive::turnings_about_axes(derivation.values, needed).empty();
}

bool has_inertia(const derive::Derivation& derivation) {
  return any_needed(derivation, [](const derive::Value& v) {
    return v.name == "m^d" || v.name == "h^d" || v.name == "I^d";
  });
}

bool has_composites(const derive::Derivation& derivation) {
  return any_needed(derivation,
                    [](const derive::Value& v) { return v.op == derive::Op::kComposite; });
}

/// Vectors of links against joints: (6) and (7).
bool is_picked(const block::Shape& shape) {
  return shape.rows.size == 3 && shape.rows.set == Set::kLinks;
}

/// Row-major, of the degrees of freedom; column by column where columns are asked for.
std::vector<Expr> expressions(const Task& task, Lowering& lowering, int frame) {
  const auto& [rows, cols] = lowering.derivation().shape;
  if (lowering.derivation().symmetric) {
    SparseSymmetric a;
    for (int j = task.tree.size() - 1; j >= 0; --j) {
      add_column(task.kinematics, lowering, j, a);
    }
    return dense(task, a);
  }
  Matrix m = written(lowering, frame);
  if (m.empty()) {
    return {};
  }
  const bool picked = is_picked(lowering.derivation().shape);
  m = in_coordinates(task, m, rows, picked);
  m = transposed(in_coordinates(task, transposed(m), cols, picked));
  std::vector<Expr> result;
  for (const std::vector<Expr>& row : m) {
    result.insert(result.end(), row.begin(), row.end());
  }
  return result;
}

bool takes_q(const Derived& function) {
  return std::ranges::any_of(function.equation.arguments,
                             [](const auto& argument) { return argument.name == "q"; });
}

/// Of one of our functions, or of a user's.
Recipe recipe_for(const std::shared_ptr<const Derived>& function) {
  for (const Recipe& recipe : recipes()) {
    if (recipe.name == function->equation.name) {
      return recipe;
    }
  }
  return derived_recipe(function);
}

/// The rate of a matrix that derives to composites; nothing for others.
std::optional<Derived> rate_of_symmetric(const equations::UserEquation& equation) {
  const block::Expression& matrix = *equation.rate_of;
  const derive::Derivation derivation =
      derive::derive(matrix, false, derive::refers_to_places(matrix));
  std::optional<derive::Derivation> rate;
  if (derivation.symmetric) {
    rate = derive::rate(derivation);
  }
  return rate ? std::optional(Derived{equation, *std::move(rate), std::nullopt}) : std::nullopt;
}

}  // namespace

std::shared_ptr<const Derived> derived(const equations::UserEquation& equation, int links,
                                       int points) {
  const block::Shape& shape = equation.expression.shape();
  const bool keeps_joints = equation.names_places || derive::refers_to_places(equation.expression);
  const bool by_rows = count(shape.rows, links, points) < count(shape.cols, links, points);
  if (equation.rate_of && !equation.names_places) {
    if (std::optional<Derived> rate = rate_of_symmetric(equation)) {
      return std::make_shared<const Derived>(*std::move(rate));
    }
  }
  Derived result{equation, derive::derive(equation.expression, by_rows, keeps_joints), std::nullopt,
                 keeps_joints};
  if (shape.rows.set == Set::kPoints && shape.cols == block::Side{}) {
    result.to_root = derive::derive_rows(equation.expression, keeps_joints);
  }
  return std::make_shared<const Derived>(std::move(result));
}

std::shared_ptr<const Derived> regrouped(const model::Tree& tree,
                                         const std::shared_ptr<const Derived>& function,
                                         const Options& options) {
  if (function->regroups || !options.has(Pass::kRegrouping) ||
      needs_centres(function->derivation) || !has_inertia(function->derivation)) {
    return function;
  }
  auto result = std::make_shared<Derived>(*function);
  result->regroups = true;
  const Seen own = with_stand_ins(tree, options);
  const Seen seen = stand_ins_alone(own.tree, own.options);
  const auto formulated = [&](const std::shared_ptr<const Derived>& f, int unit_length) {
    const Recipe recipe = derived_recipe(f);
    Variant variant = plain_variant(tree);
    variant.way = recipe.freedom.way;
    variant.unit_length = unit_length;
    return build(seen.tree, recipe, seen.options, variant);
  };
  const program::Function before = formulated(function, 0);
  if (!program::same_results(formulated(result, 0), before)) {
    return function;
  }
  result->fixed_length =
      unit_lengths(seen.tree).empty() || !program::same_results(formulated(result, 1), before);
  return result;
}

Derived solved(const Derived& system, const std::string& unknown) {
  std::optional<derive::Derivation> solution = derive::solved(system.derivation, unknown);
  if (!solution) {
    throw std::domain_error("R9 does not solve " + system.equation.name);
  }
  Derived result = system;
  result.derivation = *std::move(solution);
  return result;
}

/// Our equations hold for every tree, and so does what is derived from them.
std::shared_ptr<const Derived> derived(const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const Derived>> known;
  const std::scoped_lock lock(mutex);
  std::shared_ptr<const Derived>& function = known[name];
  if (!function) {
    const equations::Equation& equation = *equations::find_solved(name);
    const Derived made = *derived_part(name, *equation.expression);
    function = std::make_shared<const Derived>(
        equation.unknown.empty() ? made : solved(made, std::string(equation.unknown)));
  }
  return function;
}

std::shared_ptr<const Derived> derived_part(const std::string& name,
                                            const block::Expression& expression) {
  Derived made = *derived(equations::equation_of(name, expression), 1, 1);
  made.regroups = !needs_centres(made.derivation);
  return std::make_shared<const Derived>(std::move(made));
}

std::vector<Expr> build_derived(const Task& task, const Derived& function, Way way, int frame) {
  Lowering lowering(task, function, way);
  return expressions(task, lowering, frame);
}

std::vector<Expr> build_equation(const Task& task, const std::string& name) {
  return build_derived(task, *derived(name), task.kinematics.variant().way);
}

std::vector<Expr> values_at(const Task& task, const std::string& name,
                            const std::vector<model::Point>& points, Way way, int frame) {
  Options options;
  options.gravity = task.options.gravity;
  options.points = points;
  return build_derived({task.tree, task.normal, options, task.kinematics}, *derived(name), way,
                       frame);
}

std::vector<Expr> build_loaded(const Task& task, const Derived& function, const PointLoads& loads,
                               Way way) {
  Options options = task.options;
  options.points = loads.points;
  const Kinematics kinematics = task.kinematics.with_loads(loads);
  return build_derived({task.tree, task.normal, options, kinematics}, function, way);
}

Vec3 angular_bias(const Task& task, const model::Point& point) {
  Options options;
  options.points = {point};
  const Task at{task.tree, task.normal, options, task.kinematics};
  return Lowering(at, *derived("point_bias_acceleration"), Way::kInLinks).alpha(point.link);
}

std::vector<program::Cost> costs_of_values(const model::Tree& tree,
                                           const std::shared_ptr<const Derived>& function,
                                           const Options& options) {
  std::vector<program::Cost> result;
  Recipe recipe = recipe_for(function);
  recipe.build = [&](const Task& task) {
    Lowering lowering(task, *function, takes_q(*function) ? Way::kInLinks : Way::kInBase);
    std::vector<Expr> outputs = expressions(task, lowering, kBase);
    result = lowering.costs(outputs);
    return outputs;
  };
  build(tree, recipe, options, plain_variant(tree));
  return result;
}

Recipe derived_recipe(const std::shared_ptr<const Derived>& function) {
  const std::vector<std::string_view> inputs =
      transformed<std::string_view>(function->equation.arguments, &equations::UserArgument::name);
  const bool turns = takes_q(*function);  // else nothing is known of frames but the base's
  return {places_of(inputs),
          {.regrouping = function->regroups,
           .moment_form = has_turnings(function->derivation),
           .tensor_form = has_composites(function->derivation),
           .trunk = function->derivation.symmetric,
           .any_way = turns,
           .way = turns ? Way::kToRoot : Way::kInBase,
           .open_way = turns,
           .fixed_frames = function->equation.names_places,
           .fixed_length = function->fixed_length,
           .own_code = true},
          [function, turns](const Task& task) {
            return build_derived(task, *function,
                                 turns ? task.kinematics.variant().way : Way::kInBase);
          },
          function->equation.name};
}

}  // namespace treedyn::formulate
