#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "accuracy/core.hpp"
#include "emit/layout.hpp"
#include "formulate/derived.hpp"
#include "formulate/functions.hpp"
#include "formulate/stand_ins.hpp"
#include "stages/function_accuracy.hpp"
#include "stages/stages.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

/// The places of a matrix that are not zero in every state, whatever search and passes make of it.
program::Packing packing_of(const Model& model, const Request& request,
                            const formulate::Recipe& recipe, std::pair<int, int> size) {
  formulate::Options options = formulate_options(model, request);
  options.without.clear();
  options.share_limbs = false;
  const formulate::Seen seen = formulate::with_stand_ins(model.tree, options);
  return program::stored_entries(
      formulate::build(seen.tree, recipe, seen.options, formulate::plain_variant(seen.tree)),
      size.first, size.second);
}

/// Names of constants begin so: kMassMatrix for mass_matrix.
std::string constants_of(const std::string& function) { return "k" + emit::camel_case(function); }

bool has_mass_matrix(const program::Function& function) {
  return std::ranges::find(function.signature.outputs, "A", &program::Array::name) !=
         function.signature.outputs.end();
}

/// A, if a function has it, and the matrices of users with more than one row and column.
/// \throws InputError for two of which tables would have one name
std::vector<emit::PackedMatrix> packed_matrices(const Model& model, const Request& request,
                                                const std::vector<program::Function>& functions) {
  const int dof = model.tree.dof();
  std::vector<emit::PackedMatrix> result;
  if (std::ranges::any_of(functions, has_mass_matrix)) {
    result.push_back({"A", constants_of("mass_matrix"),
                      packing_of(model, request, formulate::recipe_of("mass_matrix"), {dof, dof})});
  }
  std::set<std::string> names = {constants_of("mass_matrix")};
  for (const auto& function : model.equations) {
    const auto [rows, columns] = size_of(*function, dof, static_cast<int>(model.points.size()));
    if (rows == 1 || columns == 1) {
      continue;
    }
    const std::string& name = function->equation.name;
    if (!names.insert(constants_of(name)).second) {
      throw InputError(function->equation.where,
                       fmt::format("equation '{}': with --layout packed another matrix has a table "
                                   "{}Row, too; expected another name",
                                   name, constants_of(name)));
    }
    result.push_back(
        {name, constants_of(name),
         packing_of(model, request, formulate::derived_recipe(function), {rows, columns})});
  }
  return result;
}

/// The length of a step as a number of full precision in the scalar.
void require_length(const Real& step, const Request& request) {
  const bool single = request.target.scalar == emit::Scalar::kFloat;
  const double least = single ? static_cast<double>(std::numeric_limits<float>::min())
                              : std::numeric_limits<double>::min();
  if (step < least) {
    throw InputError(
        {request.scene.value_or(request.model), 0, 0},
        fmt::format("a step of {} s has no digits in {}; expected {} s or more",
                    emit::decimal(step), emit::type_name(request.target.scalar), least));
  }
}

/// How to compile for a processor, and what calls cost there by its table.
emit::Processor processor_of(const accuracy::Core& core, const emit::Unit& unit) {
  accuracy::Build build{unit.target.scalar == emit::Scalar::kFloat, unit.target.takes_libm()};
  if (unit.target.takes_vectors() && !core.has_flash()) {
    build.angles = build.is_float ? 4 : 2;  // in vectors that every desktop core has
  }
  const program::Cost all = emit::total_cost(unit);
  const double separate = accuracy::cycles(all, core, build);
  build.contracted = true;
  build.contracted = accuracy::cycles(all, core, build) < separate;
  emit::Processor result{
      std::string(core.brief),
      fmt::format("{}{}-ffp-contract={}{}", fmt::join(core.options, " "),
                  core.options.empty() ? "" : " ", build.contracted ? "fast" : "off",
                  all.sqrt > 0 ? " -fno-math-errno" : ""),  // else sqrt is a call
      core.in_order,
      {}};
  if (unit.target.lanes > 1 || unit.target.limb_lanes) {
    return result;  // the table is of scalars
  }
  const auto add = [&](const program::Signature& signature, const program::Cost& cost) {
    result.cycles.emplace_back(signature.name, accuracy::cycles(cost, core, build));
  };
  emit::each_cost(unit, unit.checked, add);
  return result;
}

/// \throws UsageError for a self-test of nothing
void require_tested(const emit::Unit& unit) {
  if (unit.self_test && unit.functions.empty()) {
    throw UsageError("--self-test: tests functions of the model; expected some among --functions");
  }
}

/// Packs the matrices of the functions.
void pack(const Model& model, const Request& request, emit::Unit& unit) {
  unit.packed = packed_matrices(model, request, unit.functions);
  for (program::Function& function : unit.functions) {
    const bool mass_matrix = has_mass_matrix(function);
    const auto matrix = std::ranges::find(unit.packed, mass_matrix ? "A" : function.signature.name,
                                          &emit::PackedMatrix::what);
    if (matrix != unit.packed.end()) {
      function = program::packed(std::move(function), mass_matrix ? "A" : "value", matrix->packing);
    }
  }
}

}  // namespace

std::vector<emit::File> emit_files(const Model& model, const Request& request,
                                   program::Programs programs) {
  programs = in_scalar(std::move(programs), model, request.target.scalar);
  emit::Unit unit;
  unit.name = model.name;
  unit.language = request.language;
  unit.given_space = request.space.value_or("");
  unit.given_prefix = request.prefix.value_or("");
  unit.section = request.section;
  unit.tree = &model.tree;
  unit.gravity = decided_request(model, request).gravity;
  unit.points = model.points;
  unit.functions = std::move(programs.functions);
  if (programs.update) {
    unit.functions.insert(unit.functions.begin(), std::move(*programs.update));
  }
  unit.derived = std::move(programs.derived);
  unit.staged = std::move(programs.staged);
  unit.steppers = std::move(programs.steppers);
  unit.target = request.target;
  for (const program::Stepper& stepper : unit.steppers) {
    require_length(stepper.step, request);
  }
  unit.self_test = request.self_test;
  require_tested(unit);
  if (request.accuracy_samples > 0) {
    unit.errors = measured_errors(model, request, unit.functions);
  }
  if (request.target.packed) {
    pack(model, request, unit);
  }
  if (request.checked) {
    unit.checked = checked_siblings(model, unit.functions);
  }
  if (const accuracy::Core* const core = accuracy::find_core(request.core)) {
    unit.processor = processor_of(*core, unit);
  }
  unit.command = generate_command(request, Paths::kBaseNames);
  unit.tool = fmt::format("treedyn {}", kVersion);
  unit.model_file = model.source.file;
  unit.model_sha256 = model.source.sha256;
  unit.options = manifest_options(decided_request(model, request));
  try {
    return emit::emit_files(unit);
  } catch (const std::range_error& error) {
    throw InputError({request.scene.value_or(request.model), 0, 0}, error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

}  // namespace treedyn
