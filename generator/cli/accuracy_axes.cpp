#include "cli/accuracy_axes.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "emit/definitions.hpp"
#include "formulate/constrained.hpp"
#include "formulate/scene_phases.hpp"
#include "formulate/scene_system.hpp"
#include "model/effects.hpp"

namespace treedyn {

namespace {

using accuracy::Variant;

struct Axis {
  const char* option;
  std::string Variant::*choice;
  const std::vector<std::string>* words;
  std::vector<std::string> probes;  ///< differ where the scene has what is varied
  std::string lacks;
};

/// The step that has one method for forward dynamics only.
std::string with_one_method(const model::Scene& scene) {
  if (!scene.armatures.empty()) {
    return "with armatures";
  }
  if (!formulate::can_be_articulated(scene)) {
    return "with joints that follow others";
  }
  const std::vector<formulate::PhaseState> states = formulate::phase_states(scene, true);
  const bool is_free = std::ranges::any_of(states, [&](const formulate::PhaseState& state) {
    return formulate::rows_of(scene, state.active) == 0;
  });
  return is_free ? "whose equations both methods solve alike, as of a single joint"
                 : "with constraints";
}

/// The statements of a step: comments name the options, on as many lines as these need; of them the
/// digest is, too.
std::string statements(const Subject& subject, const std::string& integrator,
                       const Variant& variant, StepWriter& writer) {
  const Stepped how{integrator, 1, emit::Scalar::kDouble, false, variant};
  std::string result;
  for (const emit::File& file : stepped_files(subject, how, writer, false).files) {
    const bool is_code = !file.name.ends_with(".json");
    for (const std::string& line : emit::lines_of(is_code ? file.text : "")) {
      const bool is_digest = line.find("kDigest") != std::string::npos;
      const std::string code = line.substr(0, line.find("//"));
      const bool is_empty = code.find_first_not_of(' ') == std::string::npos;
      result += is_digest || is_empty ? "" : code + "\n";
    }
  }
  return result;
}

/// \throws UsageError if words give the same step
void require_difference(const Axis& axis, const Subject& subject, const std::string& integrator,
                        StepWriter& writer) {
  const auto of = [&](const std::string& word) {
    Variant variant;
    variant.*axis.choice = word;
    return statements(subject, integrator, variant, writer);
  };
  const std::string least = of(axis.probes[0]);
  if (least == of(axis.probes[1])) {
    throw UsageError(fmt::format(
        "{}: makes no difference in a step {}; expected a scene that has what is varied",
        axis.option, axis.lacks));
  }
  std::vector<std::string> steps;
  for (const std::string& word : *axis.words) {
    steps.push_back(of(word));
    if (steps.back() == least && word != axis.probes[0]) {
      throw UsageError(fmt::format("{}: {} gives the step of {}; expected that, or another",
                                   axis.option, word, axis.probes[0]));
    }
    const auto same = std::ranges::find(steps, steps.back()) - steps.begin();
    if (static_cast<std::size_t>(same) + 1 < steps.size()) {
      throw UsageError(fmt::format("{}: {} and {} give the same step; expected one of them",
                                   axis.option, (*axis.words)[static_cast<std::size_t>(same)],
                                   word));
    }
  }
}

/// \throws UsageError for an effect that the scene does not name, that changes no statement, or
/// that decides which events and constraints there are: nothing could be compared
void require_removable(const Subject& subject, const std::string& effect,
                       const std::string& integrator, StepWriter& writer) {
  const model::Scene& scene = subject.scene;
  if (model::entries_of(scene, effect) == 0) {
    throw UsageError(fmt::format("--without: the scene has no {}; expected an effect of the scene",
                                 shown(effect)));
  }
  const bool sticks = effect == "coulomb_friction" && !scene.frictions.empty();
  if (sticks || model::effect_named(effect).decides_rows) {
    throw UsageError(
        fmt::format("--without: {} decides which rows and events the step has; expected an effect "
                    "that adds a term",
                    effect));
  }
  Variant variant;
  variant.without = effect;
  if (statements(subject, integrator, variant, writer) ==
      statements(subject, integrator, {}, writer)) {
    throw UsageError(fmt::format(
        "--without: the step is the same without {}; expected an effect that adds a term", effect));
  }
}

}  // namespace

std::vector<Variant> variants_of(const AccuracyAxes& axes, const Subject& subject,
                                 const std::string& integrator, StepWriter& writer) {
  const Axis all[] = {
      {"--sincos", &Variant::sincos, &axes.sincos, {"pair", "libm"}, "that takes no sine"},
      {"--forward-dynamics",
       &Variant::forward_dynamics,
       &axes.forward_dynamics,
       {"factor", "articulated"},
       with_one_method(subject.scene)},
      {"--stabilisation",
       &Variant::stabilisation,
       &axes.stabilisation,
       {"none", "baumgarte"},
       "without constraints"},
      {"--cuts", &Variant::cuts, &axes.cuts, {"0", "3"}, "that looks for no event"}};
  std::vector<Variant> result = {{}};
  for (const Axis& axis : all) {
    if (axis.words->empty()) {
      continue;
    }
    require_difference(axis, subject, integrator, writer);
    std::vector<Variant> varied;
    for (const std::string& word : *axis.words) {
      for (Variant variant : result) {  // NOLINT(performance-for-range-copy): to be changed
        variant.*axis.choice = word;
        varied.push_back(variant);
      }
    }
    result = varied;
  }
  const std::vector<Variant> whole = result;
  for (const std::string& effect : axes.without) {
    require_removable(subject, effect, integrator, writer);
    for (Variant variant : whole) {
      variant.without = effect;
      result.push_back(variant);
    }
  }
  return result;
}

}  // namespace treedyn
