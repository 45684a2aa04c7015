#include "emit/limb_text.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/index.hpp"
#include "emit/layout.hpp"
#include "emit/parts.hpp"
#include "emit/sincos.hpp"

namespace treedyn::emit {

using program::LimbClass;
using program::LimbCode;
using program::LimbPhase;

namespace {

/// Limbs are lanes of vectors: as the target wants, but for roots, which vectors do not have.
bool in_lanes(const program::Function& function, const Target& target) {
  return target.limb_lanes &&
         std::ranges::all_of(function.limb_code->phases, [](const LimbPhase& phase) {
           return program::cost(phase.function).sqrt == 0;
         });
}

/// The size of a vector of one value of every limb: a power of two. Behind the last limb it is
/// repeated.
int lanes(const LimbClass& limb_class) {
  return static_cast<int>(std::bit_ceil(to_index(limb_class.size())));
}

std::string vector_type(int lanes) { return fmt::format("Limbs{}", lanes); }

/// One for each lane.
template <class Text>
std::string in_braces(const LimbClass& limb_class, Text text) {
  std::vector<std::string> cells;
  for (int lane = 0; lane < lanes(limb_class); ++lane) {
    cells.push_back(text(std::min(lane, limb_class.size() - 1)));
  }
  return fmt::format("{{{}}}", fmt::join(cells, ", "));
}

std::string vector_array(int c) { return fmt::format("limbs_{}", c + 1); }

/// limb_left_hip: the values of a limb, by its first link.
std::string limb_array(const LimbClass& limb_class, int limb, const Vocabulary& words) {
  return "limb_" + words.bodies[to_index(limb_class.links[to_index(limb)].front())];
}

/// The trunk's code that reads the limbs' values from lanes, and does not write them.
program::Function trunk_of_lanes(const LimbCode& code) {
  program::Function trunk = code.trunk;
  auto place = to_index(code.arguments());
  for (std::size_t c = 0; c < code.limbs.size(); ++c) {
    for (int limb = 0; limb < code.limbs[c].size(); ++limb, ++place) {
      program::Array& array = trunk.signature.inputs[place];
      array.name = vector_array(static_cast<int>(c));
      array.number = vector_type(lanes(code.limbs[c]));
      array.lane = limb;
      trunk.outputs.resize(trunk.outputs.size() - to_index(trunk.signature.outputs.back().size));
      trunk.signature.outputs.pop_back();
    }
  }
  return trunk;
}

/// What the limbs get of the arguments: one vector for each of their joint values, and which
/// arguments that takes.
std::vector<std::string> gathered(const LimbCode& code, std::vector<bool>& uses) {
  std::vector<std::string> lines;
  const program::Function& trunk = code.trunk;
  std::size_t number = 0;
  for (const LimbClass& limb_class : code.limbs) {
    number += to_index(limb_class.size());
  }
  std::size_t array = trunk.signature.outputs.size() - number;
  std::size_t first = 0;
  for (std::size_t k = 0; k < array; ++k) {
    first += to_index(trunk.signature.outputs[k].size);
  }
  for (std::size_t c = 0; c < code.limbs.size(); ++c) {
    const LimbClass& limb_class = code.limbs[c];
    const auto count = to_index(trunk.signature.outputs[array].size);
    for (std::size_t k = 0; k < count; ++k) {
      const auto of_limb = [&](int limb) {
        const program::Ref value = trunk.outputs[first + to_index(limb) * count + k];
        const program::Node& node = trunk.graph.node(value);
        TREEDYN_EXPECT(node.kind == program::Kind::kInput);
        uses[to_index(node.a)] = true;
        return fmt::format("{}{}", value < 0 ? "-" : "",
                           element_text(trunk.signature.inputs[to_index(node.a)], node.b));
      };
      lines.push_back(fmt::format("{}[{}] = {}{};", vector_array(static_cast<int>(c)), k,
                                  vector_type(lanes(limb_class)), in_braces(limb_class, of_limb)));
    }
    first += to_index(limb_class.size()) * count;
    array += to_index(limb_class.size());
  }
  return lines;
}

/// The trunk's code with an array of its own name for every limb, which is input and output.
program::Function named_trunk(const LimbCode& code, const Vocabulary& words) {
  program::Function trunk = code.trunk;
  const auto first_input = to_index(code.arguments());
  std::size_t number = 0;
  for (const LimbClass& limb_class : code.limbs) {
    for (int limb = 0; limb < limb_class.size(); ++limb, ++number) {
      const std::size_t place = first_input + number;
      trunk.signature.inputs[place].name = limb_array(limb_class, limb, words);
    }
  }
  auto& outputs = trunk.signature.outputs;
  for (std::size_t k = 0; k < number; ++k) {
    outputs[outputs.size() - number + k].name = trunk.signature.inputs[first_input + k].name;
  }
  return trunk;
}

/// Names in the code of a class: what the links and joints of all limbs have in common.
Vocabulary limb_words(const LimbCode& code, int c, const Vocabulary& words) {
  const LimbClass& limb_class = code.limbs[to_index(c)];
  Vocabulary result = words;
  std::vector<std::string> bodies;
  std::vector<std::string> joints;
  for (std::size_t p = 0; p < limb_class.joints.front().size(); ++p) {
    std::vector<std::string> links;
    std::vector<std::string> coordinates;
    for (int limb = 0; limb < limb_class.size(); ++limb) {
      links.push_back(
          identifier_part(words.body_comments[to_index(limb_class.links[to_index(limb)][p])]));
      coordinates.push_back(
          words.joints[to_index(limb_class.joints[to_index(limb)][p].coordinate)]);
    }
    const std::string link = short_body(common_words(links));
    const std::string joint = common_words(coordinates);
    bodies.push_back(link.empty() ? fmt::format("link{}", p + 1) : link);
    joints.push_back(joint.empty() ? fmt::format("joint{}", p + 1) : joint);
  }
  for (std::size_t p = 0; p < bodies.size(); ++p) {
    const auto link = to_index(limb_class.links.front()[p]);
    const bool unique = std::ranges::count(bodies, bodies[p]) == 1 &&
                        std::ranges::count(words.bodies, bodies[p]) == 0;
    result.bodies[link] = unique ? bodies[p] : fmt::format("link{}", p + 1);
    result.body_comments[link] = result.bodies[link];
  }
  result.joints.clear();
  for (const LimbCode::Value& value : code.values[to_index(c)]) {
    if (value.stage < 0) {
      result.joints.push_back(joints[to_index(value.position)]);
    }
  }
  return result;
}

/// inverse_dynamics_limb_1; of several phases inverse_dynamics_limb_1_1, ..._2
std::string phase_name(const program::Function& function, const LimbPhase& phase) {
  const LimbCode& code = *function.limb_code;
  int count = 0;
  int number = 0;
  for (const LimbPhase& other : code.phases) {
    if (other.limb_class == phase.limb_class) {
      ++count;
      number += other.stage <= phase.stage ? 1 : 0;
    }
  }
  const std::string name = fmt::format("{}_limb_{}", function.signature.name, phase.limb_class + 1);
  return count == 1 ? name : fmt::format("{}_{}", name, number);
}

std::string table_name(const program::Function& function, int c) {
  return fmt::format("k{}Limb{}", camel_case(function.signature.name), c + 1);
}

/// One row a number, its value in every limb.
std::string table_of_lanes(const program::Function& function, int c, const Vocabulary& words,
                           const Target& target) {
  const LimbClass& limb_class = function.limb_code->limbs[to_index(c)];
  if (limb_class.columns.empty()) {
    return {};
  }
  std::string result = fmt::format("\nconst {} {}[{}] = {{\n", vector_type(lanes(limb_class)),
                                   table_name(function, c), limb_class.columns.size());
  for (std::size_t k = 0; k < limb_class.columns.size(); ++k) {
    result +=
        fmt::format("    {},  // {}\n",
                    in_braces(limb_class,
                              [&](int limb) {
                                return signed_number_text(
                                    words, limb_class.columns[k][to_index(limb)], target.scalar);
                              }),
                    k);
  }
  return result + "};\n";
}

/// One row a limb, under its first link; every number with its place, which keeps clang-format from
/// setting them in columns.
std::string table(const program::Function& function, int c, const Vocabulary& words,
                  const Target& target) {
  const LimbClass& limb_class = function.limb_code->limbs[to_index(c)];
  if (limb_class.columns.empty()) {
    return {};
  }
  if (in_lanes(function, target)) {
    return table_of_lanes(function, c, words, target);
  }
  std::string result = fmt::format("\nconst Scalar {}[{}][{}] = {{\n", table_name(function, c),
                                   limb_class.size(), limb_class.columns.size());
  for (int limb = 0; limb < limb_class.size(); ++limb) {
    const auto link = to_index(limb_class.links[to_index(limb)].front());
    result += fmt::format("    // {}\n    {{\n", words.body_comments[link]);
    std::vector<std::string> cells;
    for (const std::vector<Real>& column : limb_class.columns) {
      cells.push_back(signed_number_text(words, column[to_index(limb)], target.scalar) + ",");
    }
    const std::size_t width = std::ranges::max_element(cells, {}, &std::string::size)->size();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      result += fmt::format("        {:{}}  // {}\n", cells[k], width, k);
    }
    result += "    },\n";
  }
  return result + "};\n";
}

/// The code of a phase and what calls it.
struct PhaseText {
  std::string text;
  std::string name;
  std::vector<bool> uses;  ///< trunk, constants; the limb's values always
};

PhaseText phase_text(const program::Function& function, const LimbPhase& phase,
                     const Vocabulary& words, const Target& target) {
  PhaseText result;
  result.name = phase_name(function, phase);
  program::Function named = phase.function;
  named.signature.name = result.name;
  Target numbers = target;
  if (in_lanes(function, target)) {
    numbers.lanes = lanes(function.limb_code->limbs[to_index(phase.limb_class)]);
    numbers.number = vector_type(numbers.lanes);
    for (program::Array* const array : {&named.signature.inputs[1], &named.signature.inputs[2],
                                        &named.signature.outputs.front()}) {
      array->number = numbers.number;
    }
  }
  const Body text = body(named, limb_words(*function.limb_code, phase.limb_class, words), numbers);
  const WholeText whole = whole_text(named.signature, result.name, text);
  const std::vector<std::string> declared =
      parameters(named.signature, all_arrays(named.signature));
  result.uses = {whole.used[0], whole.used[1]};
  std::vector<std::string> arguments;
  for (std::size_t k = 0; k < 2; ++k) {
    if (result.uses[k]) {
      arguments.push_back(declared[k]);
    }
  }
  arguments.push_back(declared[3]);
  result.text = whole.parts + '\n' +
                declaration("[[gnu::noinline]] void " + result.name, arguments, " noexcept {") +
                block(whole.lines);
  return result;
}

/// The calls of the phases of a stage, limb after limb, or of all limbs of a class together.
std::vector<std::string> calls(const program::Function& function,
                               const std::vector<PhaseText>& phases, int stage,
                               const Vocabulary& words, bool together) {
  const LimbCode& code = *function.limb_code;
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    const LimbPhase& phase = code.phases[k];
    const LimbClass& limb_class = code.limbs[to_index(phase.limb_class)];
    const int count = together ? 1 : limb_class.size();
    for (int limb = 0; phase.stage == stage && limb < count; ++limb) {
      std::vector<std::string> arguments;
      append_if(arguments, phases[k].uses[0], program::kTrunkValues);
      if (phases[k].uses[1]) {
        const std::string name = table_name(function, phase.limb_class);
        arguments.push_back(together ? name : fmt::format("{}[{}]", name, limb));
      }
      arguments.push_back(together ? vector_array(phase.limb_class)
                                   : limb_array(limb_class, limb, words));
      lines.push_back(call_text(phases[k].name, arguments));
    }
  }
  return lines;
}

/// Declarations of the arrays that callers do not see.
std::vector<std::string> local_arrays(const program::Function& function, const Vocabulary& words,
                                      bool together) {
  const LimbCode& code = *function.limb_code;
  std::vector<std::string> lines;
  const program::Array& trunk = code.trunk.signature.outputs[function.signature.outputs.size()];
  append_if(lines, trunk.size > 0, fmt::format("Scalar {}[{}];", trunk.name, trunk.size));
  for (std::size_t c = 0; c < code.limbs.size(); ++c) {
    if (together && !code.values[c].empty()) {
      lines.push_back(fmt::format("{} {}[{}];", vector_type(lanes(code.limbs[c])),
                                  vector_array(static_cast<int>(c)), code.values[c].size()));
      continue;
    }
    for (int limb = 0; limb < code.limbs[c].size() && !code.values[c].empty(); ++limb) {
      lines.push_back(fmt::format("Scalar {}[{}];", limb_array(code.limbs[c], limb, words),
                                  code.values[c].size()));
    }
  }
  return lines;
}

/// Which arguments of the public function are used.
/// \param uses  those of the trunk's code \param passed  inputs that limbs get in lanes
std::vector<bool> outer_uses(const program::Signature& outer, const program::Signature& trunk,
                             const std::vector<bool>& uses, const std::vector<bool>& passed) {
  std::vector<bool> used(uses.begin(),
                         uses.begin() + static_cast<std::ptrdiff_t>(outer.inputs.size()));
  const auto first_output = static_cast<std::ptrdiff_t>(trunk.inputs.size());
  for (std::size_t k = 0; k < used.size(); ++k) {
    used[k] = used[k] || passed[k];
  }
  used.insert(used.end(), uses.begin() + first_output,
              uses.begin() + first_output + static_cast<std::ptrdiff_t>(outer.outputs.size()));
  return used;
}

/// The public function: trunk, limbs, trunk, ...
std::string trunk_text(const program::Function& function, const std::vector<PhaseText>& phases,
                       const Vocabulary& words, const Target& target) {
  const bool together = in_lanes(function, target);
  const program::Function trunk =
      together ? trunk_of_lanes(*function.limb_code) : named_trunk(*function.limb_code, words);
  const Body text = body(trunk, words, target, [&](int array, int element) {
    return function.limb_code->level(array, element);
  });
  const auto calls_before = [&](int stage) {
    return calls(function, phases, stage - 1, words, together);
  };
  const WholeText whole = whole_text(trunk.signature, trunk.signature.name, text, calls_before);
  std::vector<std::string> lines = local_arrays(function, words, together);
  std::vector<bool> passed(to_index(function.limb_code->arguments()), false);
  if (together) {
    append(lines, gathered(*function.limb_code, passed));
  }
  append(lines, whole.lines);
  for (int stage = whole.stages; stage <= function.limb_code->phases.back().stage; ++stage) {
    append(lines, calls_before(stage + 1));
  }
  std::vector<bool> uses = whole.used;
  if (const ZerosText zeros = zeros_text(trunk.signature, text); !zeros.call.empty()) {
    lines.push_back(zeros.call);
    unite(uses, text.zeros.uses);
  }
  const program::Signature& outer = function.signature;
  return definition(whole.parts, outer, outer_uses(outer, trunk.signature, uses, passed), lines);
}

}  // namespace

Body limb_body(const program::Function& function, const Vocabulary& words, const Target& target) {
  const LimbCode& code = *function.limb_code;
  const bool together = in_lanes(function, target);
  Target of_limbs = target;
  of_limbs.vectors = target.vectors && !together;
  Target of_trunk = target;
  of_trunk.zeros_apart = target.zeros_apart && together;
  const program::Function trunk = together ? trunk_of_lanes(code) : named_trunk(code, words);
  Body result = body(trunk, words, of_trunk);
  const std::vector<bool> none(to_index(code.arguments()), false);
  result.zeros.uses = outer_uses(function.signature, trunk.signature, result.zeros.uses, none);
  for (const LimbPhase& phase : code.phases) {
    result.statements += body(phase.function, words, of_limbs).statements;
  }
  result.structural_zeros = static_cast<int>(std::ranges::count(function.outputs, program::Ref{0}));
  return result;
}

bool has_angles_of_limbs_alone(const program::Function& function, const Target& target) {
  if (!function.limb_code || !in_lanes(function, target)) {
    return false;
  }
  const program::Cost cost = program::cost(function.limb_code->trunk);
  return cost.sin + cost.cos == 0;
}

std::string limb_vectors(const std::vector<program::Function>& functions, const Target& target,
                         const std::string& text) {
  std::map<int, bool> has_angles;
  for (const program::Function& function : functions) {
    if (!function.limb_code || !in_lanes(function, target)) {
      continue;
    }
    for (const LimbPhase& phase : function.limb_code->phases) {
      const program::Cost cost = program::cost(phase.function);
      has_angles[lanes(function.limb_code->limbs[to_index(phase.limb_class)])] |=
          cost.sin + cost.cos > 0;
    }
  }
  std::string result;
  for (const auto& [count, angles] : has_angles) {
    Target numbers = target;
    numbers.lanes = count;
    numbers.number = vector_type(count);
    result += fmt::format(
        "\n/// One value of {0} limbs that are equal but for their numbers.\n"
        "using {1} [[gnu::vector_size({0} * sizeof(Scalar))]] = Scalar;\n{2}",
        count, numbers.number, angles ? '\n' + sincos_of_limbs(numbers, text) : "");
  }
  return unnamed(result);
}

std::string limb_text(const program::Function& function, const Vocabulary& words,
                      const Target& target) {
  const LimbCode& code = *function.limb_code;
  std::string inner;
  for (int c = 0; c < static_cast<int>(code.limbs.size()); ++c) {
    inner += table(function, c, words, target);
  }
  std::vector<PhaseText> phases;
  for (const LimbPhase& phase : code.phases) {
    phases.push_back(phase_text(function, phase, words, target));
    inner += phases.back().text;
  }
  return unnamed(inner).substr(1) + '\n' + trunk_text(function, phases, words, target);
}

}  // namespace treedyn::emit
