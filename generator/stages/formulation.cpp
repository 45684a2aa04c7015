#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <numeric>

#include <fmt/format.h>

#include "common/parallel.hpp"
#include "common/transformed.hpp"
#include "emit/layout.hpp"
#include "formulate/functions.hpp"
#include "formulate/scene_functions.hpp"
#include "request/limits.hpp"
#include "stages/stages.hpp"

namespace treedyn {

formulate::Options formulate_options(const Model& model, const Request& request) {
  formulate::Options options;
  options.gravity = decided_request(model, request).gravity;
  options.points = model.points;
  options.effort = request.effort;
  options.forward_dynamics = request.forward_dynamics;
  options.without = request.without;
  options.share_limbs = request.share_limbs;
  options.metres = request.metres;
  return options;
}

std::vector<std::string> pass_names() {
  return transformed<std::string>(formulate::passes(), &formulate::PassInfo::name);
}

namespace {

void report(const Trace& trace, const std::string& name, const program::Cost& cost,
            std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  trace(fmt::format("{}: {} ({:.1f} s)", name, emit::cost_text(cost), time.count()));
}

using Task = std::function<program::Function()>;

/// Forward dynamics takes longest: it begins first.
std::vector<program::Function> in_parallel(std::vector<std::pair<std::string, Task>> named,
                                           const Trace& trace) {
  std::vector<std::size_t> order(named.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_partition(order.begin(), order.end(),
                        [&](std::size_t k) { return named[k].first == "forward_dynamics"; });
  std::mutex writing;
  std::vector<program::Function> functions(named.size());
  std::vector<std::function<void()>> tasks;
  for (const std::size_t k : order) {
    tasks.emplace_back([&, k] {
      const auto start = std::chrono::steady_clock::now();
      functions[k] = named[k].second();
      const std::scoped_lock lock(writing);
      report(trace, named[k].first, program::cost(functions[k]), start);
    });
  }
  run_all(tasks);
  return functions;
}

/// \throws InputError for a function that was asked for and that the scene has no use for
void require_scene_functions(const Model& model, const program::Programs& programs,
                             const std::string& file) {
  const auto has = [](const auto& functions, const std::string& name) {
    return std::ranges::any_of(functions, [&](const auto& function) {
      const std::string& made = function.signature.name;
      return made == name || made.starts_with(name + "_");  // one of a phase, an impact of an event
    });
  };
  for (const std::string& name : model.scene_functions) {
    if (!has(programs.functions, name) && !has(programs.staged, name) &&
        !has(programs.steppers, name)) {
      throw InputError({file, 0, 0},
                       fmt::format("function '{}': the scene has nothing for it; expected "
                                   "--functions without it",
                                   name));
    }
  }
}

program::Programs formulated(const Model& model, const Request& request, const Trace& trace) {
  program::Programs programs;
  const formulate::Options options = formulate_options(model, request);
  std::vector<std::pair<std::string, Task>> tasks;
  for (const std::string& name : model.functions) {
    tasks.emplace_back(name, [&] { return formulate::formulated(model.tree, name, options); });
  }
  for (const auto& equation : model.equations) {
    const program::Signature signature =
        signature_of(*equation, model.tree.dof(), static_cast<int>(model.points.size()));
    tasks.emplace_back(signature.name, [&, signature] {
      program::Function function = formulate::formulated(model.tree, equation, options);
      function.signature = signature;
      return function;
    });
  }
  programs.functions = in_parallel(std::move(tasks), trace);
  if (model.scene && (request.functions.empty() || !model.scene_functions.empty())) {
    const auto start = std::chrono::steady_clock::now();
    formulate::SceneFunctions scene =
        formulate::scene_functions(*model.scene, options, model.scene_functions);
    for (program::Function& function : scene.plain) {
      report(trace, function.signature.name, program::cost(function), start);
      programs.functions.push_back(std::move(function));
    }
    for (program::Staged& staged : scene.staged) {
      report(trace, staged.signature.name, program::cost(staged), start);
      programs.staged.push_back(std::move(staged));
    }
    programs.steppers = std::move(scene.steppers);
    require_scene_functions(model, programs, *request.scene);
  }
  return programs;
}

}  // namespace

program::Programs formulate_model(const Model& model, const Request& request, const Trace& trace) {
  try {
    return formulated(model, request, trace);
  } catch (const std::range_error& error) {
    refuse_decades(model.tree, error.what());
  } catch (const InputError& error) {
    if (!request.scene || !error.where().file.empty()) {
      throw;
    }
    throw InputError({*request.scene, 0, 0}, error.message());
  }
}

}  // namespace treedyn
