#include "emit/unit.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "emit/body.hpp"
#include "emit/c99.hpp"
#include "emit/definitions.hpp"
#include "emit/header.hpp"
#include "emit/limb_text.hpp"
#include "emit/manifest.hpp"
#include "emit/parts.hpp"
#include "emit/sha256.hpp"
#include "emit/source.hpp"
#include "emit/staged_text.hpp"
#include "program/limb_code.hpp"

namespace treedyn::emit {

std::string cycles_text(double cycles) {
  double unit = 1;
  while (cycles >= 100 * unit) {
    unit *= 10;
  }
  return fmt::format("{:.0f}", std::round(cycles / unit) * unit);
}

program::Cost total_cost(const Unit& unit) {
  program::Cost total;
  for (const program::Function& function : unit.functions) {
    total = total + program::cost(function);
  }
  for (const program::Staged& staged : unit.staged) {
    total = total + program::worst_cost(staged);
  }
  for (const program::Stepper& stepper : unit.steppers) {
    total = total + program::worst_step_cost(stepper);
  }
  return total;
}

std::vector<std::string> file_names(const std::string& name, Language language) {
  const bool c = language == Language::kC99;
  return {name + (c ? ".h" : ".hpp"), name + (c ? ".c" : ".cpp"), name + ".json"};
}

namespace {

/// Writes the digest of both texts into each.
void sign(std::string& header, std::string& source) {
  const std::string digest = "0x" + sha256(header + source).substr(0, 16) + "ULL";
  for (std::string* const text : {&header, &source}) {
    text->replace(text->find(kNoDigest), digest.size(), digest);
  }
}

/// The parts that the text of a function has, and the numbers of its tables.
void add_code(const program::Function& function, std::vector<const program::Function*>& functions,
              std::vector<Real>& numbers) {
  if (!function.limb_code) {
    functions.push_back(&function);
    return;
  }
  functions.push_back(&function.limb_code->trunk);
  for (const program::LimbPhase& phase : function.limb_code->phases) {
    functions.push_back(&phase.function);
  }
  for (const program::LimbClass& limb_class : function.limb_code->limbs) {
    for (const std::vector<Real>& column : limb_class.columns) {
      numbers.insert(numbers.end(), column.begin(), column.end());
    }
  }
}

/// With names for the numbers of the model.
Vocabulary words_of(const Unit& unit) {
  Vocabulary words = vocabulary(*unit.tree);
  std::vector<const program::Function*> functions;
  std::set<std::string> taken = {"self_test", "compare"};
  const auto take = [&](const program::Signature& signature) {
    taken.insert(signature.name);
    for (const program::Array& array : signature.arrays()) {
      taken.insert(array.name);
      taken.insert("known_" + array.name);  // of the self-test
    }
  };
  for (const DescribedNumber& field : described(unit.derived, words)) {
    taken.insert(field.name);
  }
  std::vector<Real> of_tables;
  for (const program::Function& function : unit.functions) {
    take(function.signature);
    add_code(function, functions, of_tables);
  }
  for (const Checked& checked : unit.checked) {
    take(checked.signature);
    functions.push_back(&checked.function);
  }
  const auto take_staged = [&](const program::Staged& staged) {
    take(staged.signature);
    for (const program::Staged& contact : staged.contacts) {
      take(contact.signature);
      functions.push_back(&contact.function);
    }
    functions.push_back(&staged.function);
  };
  std::ranges::for_each(unit.staged, take_staged);
  for (const program::Stepper& stepper : unit.steppers) {
    take(stepper.signature);
    for (const program::StepPhase& phase : stepper.phases) {
      std::ranges::for_each(phase.guards, take_staged);
      std::ranges::for_each(phase.approaches, take_staged);
    }
    std::ranges::for_each(stepper.anchors, take_staged);
  }
  words.stems = stems_of_parts(taken);
  words.constants =
      std::make_shared<const ConstantNames>(functions, of_tables, words, std::move(taken));
  return words;
}

/// Outside of comments.
bool has_word_of_code(const std::string& text, std::string_view word) {
  return std::ranges::any_of(lines_of(text), [&](const std::string& line) {
    return has_word(std::string_view(line).substr(0, line.find("//")), word);
  });
}

/// The build defines a macro for what it compiles, the header included.
void require_free(const std::string& macro, const std::vector<const std::string*>& texts) {
  if (std::ranges::any_of(
          texts, [&](const std::string* text) { return has_word_of_code(*text, macro); })) {
    throw std::invalid_argument(
        fmt::format("--section: {} is a name in the generated code; expected another", macro));
  }
}

}  // namespace

std::vector<File> emit_files(const Unit& unit) {
  const Vocabulary words = words_of(unit);
  Target target = unit.target;
  target.zeros_apart = target.lanes == 1 && !(unit.processor && unit.processor->in_order);
  std::vector<Body> bodies;
  bodies.reserve(unit.functions.size() + unit.checked.size() + unit.staged.size());
  for (const program::Function& function : unit.functions) {
    bodies.push_back(function.limb_code ? limb_body(function, words, target)
                                        : body(function, words, target));
  }
  for (const Checked& checked : unit.checked) {
    bodies.push_back(body(checked.function, words, unit.target));
  }
  for (const program::Staged& staged : unit.staged) {
    bodies.push_back(staged_body(staged, words, unit.target));
  }
  const std::vector<std::string> names = file_names(unit.name, unit.language);
  std::string header = header_text(unit);
  std::string source = source_text(unit, bodies, words);
  if (unit.language == Language::kC99) {
    std::tie(header, source) = in_c99(unit, header, source);
  }
  if (!unit.section.empty()) {
    require_free(unit.section, {&header, &source});
    source = placed(source, unit.section);
  }
  sign(header, source);
  return {{names[0], std::move(header)},
          {names[1], std::move(source)},
          {names[2], manifest_text(unit, bodies)}};
}

}  // namespace treedyn::emit
