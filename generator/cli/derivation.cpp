// How the code of a function comes about, as text.
#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "block/print.hpp"
#include "cli/dump.hpp"
#include "common/decimal.hpp"
#include "derive/derivation_text.hpp"
#include "derive/words.hpp"
#include "equations/scene_table.hpp"
#include "equations/table.hpp"
#include "formulate/factored.hpp"
#include "formulate/trunk.hpp"
#include "stages/stages.hpp"

namespace treedyn {
namespace {

constexpr std::size_t kMostWords = 60;

void define(const block::Expression& e, std::vector<std::string>& lines) {
  for (const block::Expression& operand : e.operands()) {
    define(operand, lines);
  }
  if (e.kind() == block::Kind::kNamed) {
    const std::string line = block::print_definition(e);
    if (std::ranges::find(lines, line) == lines.end()) {
      lines.push_back(line);
    }
  }
}

void collect_names(const block::Expression& e, std::set<std::string>& names) {
  if (e.kind() == block::Kind::kNamed) {
    names.insert(e.node().name);
  }
  for (const block::Expression& operand : e.operands()) {
    collect_names(operand, names);
  }
}

/// Those of the print that what stands in `equations` mends, in their order.
/// \param own  further ones
std::string errata_text(const std::vector<block::Expression>& equations, std::string_view own) {
  std::set<std::string> names;
  for (const block::Expression& equation : equations) {
    collect_names(equation, names);
  }
  std::string words(own);
  for (const equations::Equation& part : equations::table()) {
    if (names.contains(part.expression->node().name)) {
      words += fmt::format(" {}", part.errata);
    }
  }
  std::set<std::pair<std::size_t, std::string>> all;
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    all.emplace(word.size(), word);
  }
  std::string result;
  for (const auto& [size, word] : all) {
    result += (result.empty() ? "; errata of the print mended: " : " ") + word;
  }
  return result;
}

/// What has a name, and the equations. \param prefix  of equations without a name
std::string definitions(const std::vector<block::Expression>& equations,
                        const std::string& prefix = "") {
  std::vector<std::string> lines;
  for (const block::Expression& equation : equations) {
    define(equation, lines);
    if (equation.kind() != block::Kind::kNamed) {
      lines.push_back(prefix + block::print(equation));
    }
  }
  std::string result;
  for (const std::string& line : lines) {
    result += fmt::format("  {}\n", line);
  }
  return result;
}

/// Those of scenes that are derived.
std::vector<std::string_view> scene_functions() {
  std::vector<std::string_view> names;
  for (const equations::SceneFunctionInfo& info : equations::scene_function_infos()) {
    if (!info.equations.empty()) {
      names.emplace_back(info.name);
    }
  }
  return names;
}

/// \param ours  null: of the user
std::string equation_text(const std::string& name, const block::Expression& expression,
                          const equations::Equation* ours) {
  std::string result =
      fmt::format("{}: equation {}", name, ours != nullptr ? ours->number : "of the user");
  if (ours != nullptr && !ours->unknown.empty()) {
    result += fmt::format(" for {}, zero there", ours->unknown);
  }
  if (ours != nullptr) {
    result += errata_text({expression}, ours->errata);
  }
  return result + "\n" + definitions({expression}, name + " = ");
}

std::string words_text(const block::Expression& e) {
  const auto words = derive::words(e, kMostWords);
  if (!words) {
    return fmt::format("\nwords: more than {}\n", kMostWords);
  }
  std::string result = fmt::format("\nwords ({})\n", words->size());
  for (const derive::Word& word : *words) {
    result += fmt::format("  {}\n", derive::to_text(word));
  }
  return result;
}

using Rates = std::map<std::string, block::Expression>;

/// \param rates  of the symbols that R11 has met, where equations are read
std::string rules_text(std::set<derive::Rule> acted, const Rates& rates = {}) {
  std::string result = "\nrules that acted (N = D - E)\n";
  if (!rates.empty()) {
    acted.insert(derive::Rule::kRates);
  }
  for (const derive::Rule rule : acted) {
    result += fmt::format("  {:4} {}\n", derive::row_of(rule).name, derive::row_of(rule).text);
    for (const auto& [symbol, rate] : rule == derive::Rule::kRates ? rates : Rates{}) {
      result += fmt::format(
          "       dot({}) = {}\n", symbol,
          block::print(rate.kind() == block::Kind::kNamed ? rate.operands().front() : rate));
    }
  }
  return result;
}

/// The line, and behind it the rules that made it.
std::string with_rules(const derive::Line& line) {
  std::string names;
  for (const derive::Rule rule : line.rules) {
    names += fmt::format(" {}", derive::row_of(rule).name);
  }
  return names.empty() ? line.text : fmt::format("{}  <-{}", line.text, names);
}

std::string lines_text(const derive::Derivation& derivation,
                       const std::vector<program::Cost>& costs, const std::string& name = {}) {
  std::string result;
  for (const derive::Line& line : derive::lines(derivation, name)) {
    const std::string cost =
        costs.empty() ? "" : fmt::to_string(costs[static_cast<std::size_t>(line.id)].total());
    result += fmt::format("  {:>5}  {}\n", cost, with_rules(line));
  }
  return result;
}

std::string recursion_text(const formulate::Derived& function,
                           const std::vector<program::Cost>& costs, const std::string& name) {
  const std::string lines = lines_text(function.derivation, costs, name);
  if (lines.empty()) {
    return "\nrecursion: none, every value is zero\n";
  }
  std::string result =
      "\nrecursion: D and N from the root, D^T and N^T to it; operations of these lines, each link "
      "in a frame of its own, before regrouping and passes (the code's: info --passes)\n" +
      lines;
  if (const int others = costs.back().total(); others > 0) {
    result += fmt::format("  {:>5}  angles and places of joints\n", others);
  }
  if (function.to_root) {
    result += "\nor from one point E e_j to the root\n";
    for (const derive::Line& line : derive::lines(*function.to_root)) {
      result += fmt::format("         {}\n", with_rules(line));
    }
    result += rules_text(function.to_root->values.acted());
  }
  return result;
}

using Derived = std::shared_ptr<const formulate::Derived>;

/// True for the rate of what is derived, not of the text.
bool is_rate(const formulate::Derived& function) {
  return function.derivation.values.acted().contains(derive::Rule::kValueRates);
}

/// \param name  of the result; empty: it is one of the lines
std::string derived_text(const Model& model, const Request& request, const Derived& function,
                         const std::string& name = {}) {
  return rules_text(function->derivation.values.acted(),
                    is_rate(*function) ? Rates{} : function->equation.rates) +
         recursion_text(
             *function,
             formulate::costs_of_values(model.tree, function, formulate_options(model, request)),
             name);
}

/// Where multipliers come from: their K and b are what the derivation leaves.
std::string multipliers_text(const derive::Derivation& derivation) {
  const bool least = derivation.values.acted().contains(derive::Rule::kLeast);
  if (!least && !derivation.values.acted().contains(derive::Rule::kReactions)) {
    return "";
  }
  const int b = derivation.roots[1];
  std::string name = derivation.values[b].name;
  for (const derive::Line& line : derive::lines(derivation)) {
    if (line.id == b) {
      name = line.text.substr(0, line.text.find(" = "));
    }
  }
  return fmt::format("         {0} of K_{0} {0} = {1}  <- {2}\n", least ? "μ" : "λ", name,
                     derive::row_of(least ? derive::Rule::kLeast : derive::Rule::kReactions).name);
}

/// \param costs  empty: of rows, whose number a scene decides
std::string factored_text(const Model& model, const Request& request,
                          const formulate::FactoredFunction& function,
                          const std::vector<program::Cost>& costs) {
  std::string result = "\nnumbers of joints" + rules_text(function.derivation.values.acted()) +
                       "\nrecursion, row by row\n" + lines_text(function.derivation, costs) +
                       multipliers_text(function.derivation);
  for (const auto& [leaf, of] : function.given) {
    const std::string text = block::print(of->equation.expression);
    result += fmt::format("\n{}\n{}", text == leaf ? leaf : fmt::format("{} = {}", leaf, text),
                          derived_text(model, request, of));
  }
  return result;
}

/// What becomes of the unknowns before all else.
std::string trunk_text(const Model& model, const Request& request, bool impact = false) {
  std::string result =
      fmt::format("\ntrunk: {}, moved in every way by joints 1 to {}\n",
                  model.tree.links[formulate::kTrunkLink].name, formulate::kTrunkLink + 1) +
      rules_text({derive::Rule::kTrunk}) + "\nfor the trunk\n";
  for (const auto& [text, cost] :
       formulate::trunk_lines(model.tree, formulate_options(model, request), impact)) {
    result += fmt::format("  {:>5}  {}  <- {}\n", cost.total(), text,
                          derive::row_of(derive::Rule::kTrunk).name);
  }
  return result;
}

/// Those by which a function solves for its unknown.
struct Ways {
  bool articulated = false;
  bool factor = false;
  bool by_trunk = false;  ///< R13 before either
};

Ways ways_of(const model::Tree& tree, const Request& request, const std::string& name) {
  const bool two = formulate::recipe_of(name).freedom.articulated && tree.mimics() == 0;
  const formulate::ForwardDynamics asked = request.forward_dynamics;
  return {two && asked != formulate::ForwardDynamics::kFactor,
          !two || asked != formulate::ForwardDynamics::kArticulated,
          two && formulate::has_trunk(tree)};
}

std::string solved_text(const Model& model, const Request& request, const std::string& name) {
  const Ways ways = ways_of(model.tree, request, name);
  const formulate::Options options = formulate_options(model, request);
  std::string result;
  if (ways.by_trunk && options.has(formulate::Pass::kTrunk)) {
    result += trunk_text(model, request);
  }
  if (ways.articulated && ways.factor) {
    result +=
        "\ntwo ways: by articulated bodies, by the factor of A; the code takes the one that costs "
        "less (--forward-dynamics)\n";
  }
  if (ways.articulated) {
    result +=
        "\nby articulated bodies\n" + derived_text(model, request, formulate::derived(name), "q̈");
  }
  if (ways.factor) {
    result += (ways.articulated ? "\nby the factor of A\n" : "") +
              factored_text(model, request, formulate::factored(name),
                            formulate::costs_of_numbers(model.tree, name, options));
  }
  return result;
}

/// Of functions of scenes: what holds for all of them.
std::string scene_text(const Model& model, const Request& request, const std::string& name) {
  if (!equations::is_scene_function(name) ||
      equations::scene_function_info(name).equations.empty()) {
    throw UsageError(fmt::format(
        "--derivation: {} is no block equation; expected one of the equations, a "
        "function that `treedyn list functions` shows and that is not put together from "
        "others, or one of a scene, without the name of a phase: {}",
        shown(name), fmt::join(scene_functions(), ", ")));
  }
  const equations::SceneFunctionInfo& info = equations::scene_function_info(name);
  const formulate::FactoredFunction& function = formulate::factored(name);
  const bool solved = *info.unknown != '\0';
  const std::string unknowns =
      solved ? fmt::format(" for {} and λ, zero there", info.unknown)
      : *info.remainder != '\0'
          ? fmt::format(" for the least λ, zero there, and {}", info.remainder)
          : "";
  std::string result = fmt::format("{}: equation {}{}{}\n", name, info.equation, unknowns,
                                   errata_text(info.equations, "")) +
                       definitions(info.equations);
  if (solved && formulate::has_trunk(model.tree)) {
    result +=
        "\nwhere a scene acts on no link above it" + trunk_text(model, request, name == "impact");
  }
  return result + factored_text(model, request, function, {});
}

}  // namespace

std::string derivation_text(const Model& model, const Request& request, const std::string& name) {
  const auto own = std::ranges::find_if(model.equations,
                                        [&](const auto& f) { return f->equation.name == name; });
  const equations::Equation* const ours = equations::find_solved(name);
  if (own == model.equations.end() && ours == nullptr) {
    return scene_text(model, request, name);
  }
  require_solution(model.tree, name);
  const bool is_own = own != model.equations.end();
  const block::Expression& e = is_own ? (*own)->equation.expression : *ours->expression;
  const bool of_rate = is_own && is_rate(**own);
  std::string result =
      equation_text(name, e, is_own ? nullptr : ours) +
      (of_rate ? "\nof X in dot(X)" + words_text(*(*own)->equation.rate_of) : words_text(e));
  if (!is_own && !ours->unknown.empty()) {
    return result + solved_text(model, request, name);
  }
  return result + derived_text(model, request,
                               is_own ? formulate::regrouped(model.tree, *own,
                                                             formulate_options(model, request))
                                      : formulate::derived(name));
}

}  // namespace treedyn
