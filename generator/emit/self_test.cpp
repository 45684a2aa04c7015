#include "emit/self_test.hpp"

#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "emit/layout.hpp"
#include "emit/literal.hpp"
#include "emit/template_file.hpp"
#include "program/rounding.hpp"

namespace treedyn::emit {

namespace {

constexpr int kStates = 2;

std::string head() { return fmt::format("int {}", kSelfTest); }

std::vector<std::string> arguments() { return {"int place[2]", "Scalar error[1]"}; }

/// Tables of numbers, each once.
class Tables {
 public:
  explicit Tables(Scalar scalar) : scalar_(scalar) {}

  /// The name of the table with these values: `stem`, with a number if another has that name.
  std::string name_of(const std::string& stem, const std::vector<double>& values) {
    std::string list;
    for (std::size_t k = 0; k < values.size(); ++k) {
      list += fmt::format("{}{}", k == 0 ? "" : ", ", literal(Real(values[k]), scalar_));
    }
    auto& known = names_[stem];
    if (const auto found = known.find(list); found != known.end()) {
      return found->second;
    }
    std::string name = stem;
    for (int n = 2; !taken_.insert(name).second; ++n) {
      name = fmt::format("{}_{}", stem, n);
    }
    known.emplace(list, name);
    std::string lines = wrapped(list + "};", "    ");
    lines.pop_back();
    text_ += fmt::format("static const Scalar {}[{}] = {{\n{}\n", name, values.size(), lines);
    return name;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Scalar scalar_;
  std::map<std::string, std::map<std::string, std::string>> names_;  ///< by stem and list
  std::set<std::string> taken_;
  std::string text_;
};

/// A bound that is a number above zero, where every value is zero too.
std::string bound_text(double bound, Scalar scalar) {
  const double least = scalar == Scalar::kFloat
                           ? static_cast<double>(std::numeric_limits<float>::min())
                           : std::numeric_limits<double>::min();
  return literal(Real(fmt::format("{:.2g}", std::max(bound, least * 2))), scalar);
}

/// What calls a function. Its name alone may be that of a variable there.
std::string called(const program::Signature& signature, const Unit& unit) {
  static const std::set<std::string> kVariables = {"state", "wrong", "place", "error"};
  const bool hidden = unit.language == Language::kCpp && kVariables.contains(signature.name);
  return (hidden ? unit.space() + "::" : "") + signature.name;
}

/// The call of one function at a state and the comparison of its outputs, the first of which has
/// `number`.
std::string comparison(const program::Function& function, int number, const Unit& unit,
                       Tables& tables) {
  const Scalar scalar = unit.target.scalar;
  const program::Signature& signature = function.signature;
  const program::KnownAnswers known =
      program::known_answers(function, kStates, scalar == Scalar::kFloat);
  std::string text;
  std::vector<std::string> passed;
  for (std::size_t k = 0; k < signature.inputs.size(); ++k) {
    passed.push_back(fmt::format(
        "{} + {} * state", tables.name_of("known_" + signature.inputs[k].name, known.inputs[k]),
        signature.inputs[k].size));
  }
  std::string compared;
  for (std::size_t k = 0; k < signature.outputs.size(); ++k) {
    const program::Array& array = signature.outputs[k];
    text += fmt::format("      Scalar {}[{}];\n", array.name, array.size);
    passed.push_back(array.name);
    const std::string table =
        tables.name_of(fmt::format("known_{}_{}", signature.name, array.name), known.outputs[k]);
    compared += "      " +
                declaration("wrong += compare",
                            {array.name, fmt::format("{} + {} * state", table, array.size),
                             std::to_string(array.size), bound_text(known.bounds[k], scalar),
                             std::to_string(number + static_cast<int>(k)), "place", "error"},
                            ";") +
                "\n";
  }
  return fmt::format("    {{\n{}      {}\n{}    }}\n", text,
                     declaration(called(signature, unit), passed, ";"), compared);
}

}  // namespace

std::string self_test_declaration(const Unit& unit) {
  std::string numbers;
  int number = 1;
  for (const program::Function& function : unit.functions) {
    for (const program::Array& array : function.signature.outputs) {
      numbers += fmt::format("{}{} {}.{}", number == 1 ? "" : ", ", number, function.signature.name,
                             array.name);
      ++number;
    }
  }
  return "\n/// Calls every function above that takes no scene at two states and compares with\n"
         "/// results of 50 digits.\n///\n"
         "/// \\param[out] place  2, the worst value: number of its output, index there\n"
         "/// \\param[out] error  1, its error as a part of what is allowed: twice what the same\n"
         "///                    operations, half of them a last digit off by chance, lose in "
         "that\n"
         "///                    value of the output that loses most, and eight roundings more\n"
         "/// \\return how many values are wrong\n" +
         wrapped(fmt::format("Outputs: {}.", numbers), "/// ") +
         declaration(head(), arguments(), " noexcept;") + "\n";
}

std::string self_test_text(const Unit& unit) {
  Tables tables(unit.target.scalar);
  std::string calls;
  int number = 1;
  for (const program::Function& function : unit.functions) {
    calls += comparison(function, number, unit, tables);
    number += static_cast<int>(function.signature.outputs.size());
  }
  return fill(template_text("self_test.cpp"),
              {{"tables", tables.text()},
               {"declaration", declaration(head(), arguments(), " noexcept {")},
               {"states", std::to_string(kStates)},
               {"calls", calls}});
}

}  // namespace treedyn::emit
