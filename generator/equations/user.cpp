#include "equations/user.hpp"

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "block/plan.hpp"
#include "block/print.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/transformed.hpp"
#include "equations/kinematics.hpp"
#include "equations/reading.hpp"
#include "equations/symbol_names.hpp"
#include "equations/text.hpp"

namespace treedyn::equations {
namespace {

constexpr int kMostNestedUses = 50;  // equations that use each other
constexpr int kMostUses = 2000;      // of other equations in one, those within them included

/// True for what has P_i in it. Jacobians and what is made of them hold wherever on its axis P_i
/// is.
bool of_places(const std::string& name) {
  constexpr std::array<std::string_view, 8> kOfPlaces = {"s_d", "l_d",  "t_d",  "c_d",
                                                         "l_D", "c_fD", "t_fD", "K"};
  return std::ranges::find(kOfPlaces, name) != kOfPlaces.end();
}

class Reader {
 public:
  Reader(const std::vector<model::EquationText>& texts, const model::Tree& tree,
         std::span<const model::Point> points)
      : texts_(texts), tree_(tree), points_(points) {}

  std::vector<UserEquation> run() {
    check_names();
    return transformed(texts_, [&](const model::EquationText& text) { return read(text); });
  }

 private:
  void check_names() const;
  UserEquation read(const model::EquationText& text);
  Expression expand(const model::EquationText& text, Reading& reading);
  Term name(const std::string& name, const model::EquationText& text, Reading& reading);
  Expression used(const model::EquationText& other, Reading& reading);

  const std::vector<model::EquationText>& texts_;
  const model::Tree& tree_;
  std::span<const model::Point> points_;
  std::vector<const model::EquationText*> open_;                ///< that are being read
  int uses_ = 0;                                                ///< of other equations
  std::optional<std::pair<Expression, Expression>> last_rate_;  ///< X, dot(X)
};

void Reader::check_names() const {
  std::set<std::string> names;
  for (const model::EquationText& text : texts_) {
    if (to_identifier(text.name) != text.name || is_taken(text.name)) {
      throw InputError(text.where, fmt::format("equation '{}' has a name that is taken or no "
                                               "identifier; expected another one",
                                               shown(text.name)));
    }
    if (!names.insert(text.name).second) {
      throw InputError(text.where, fmt::format("equation '{}' stands there twice; expected "
                                               "different names",
                                               shown(text.name)));
    }
  }
  for (const model::EquationText& text : texts_) {
    for (const model::InputText& input : text.inputs) {
      if (names.contains(input.name)) {
        throw InputError(input.where,
                         fmt::format("input '{}' of equation '{}' has the name of an equation; "
                                     "expected another one",
                                     shown(input.name), text.name));
      }
    }
  }
}

UserEquation Reader::read(const model::EquationText& text) {
  Reading reading(tree_, points_);
  reading.made.name = text.name;
  reading.made.text = text.value;
  reading.made.doc = text.doc;
  reading.made.where = text.where;
  for (const model::InputText& input : text.inputs) {
    reading.add_input(input);
  }
  uses_ = 0;
  last_rate_.reset();
  const Expression e = expand(text, reading);
  if (last_rate_ && &last_rate_->second.node() == &e.node()) {
    reading.made.rate_of = last_rate_->first;
  }
  reading.finish(e);
  try {
    block::Plan(index_of(tree_, points_)).add(e);
  } catch (const TooLarge& error) {
    throw InputError(text.where, fmt::format("equation '{}': {}", shown(text.name), error.what()));
  }
  return reading.made;
}

Expression Reader::expand(const model::EquationText& text, Reading& reading) {
  open_.push_back(&text);
  Scope scope;
  scope.name = [&](const std::string& n) {
    return name(n, text, reading);
  };
  scope.of = [&](const std::string& function, const std::string& argument) {
    return reading.of(function, argument);
  };
  scope.number = [&](const Real& value) {
    return reading.number(value);
  };
  scope.dot = [&](const Expression& e) {
    Expression result = dot(e, reading.rates);
    reading.made.rates.merge(leaf_rates(e, reading.rates));
    last_rate_ = {e, result};
    return result;
  };
  scope.reciprocal = [&](const Expression& e) {
    return reading.reciprocal(e);
  };
  scope.check = [&](const Expression& e) {
    reading.units().of(e);
  };
  try {
    Expression result = parse(text.value, scope);
    open_.pop_back();
    return result;
  } catch (const TextError& error) {
    throw InputError(text.value_at ? text.value_at(error.offset()) : text.where,
                     fmt::format("equation '{}': {}", shown(text.name), error.what()));
  }
}

/// The user's inputs, parameters of the file, the symbols of EQUATIONS.md, other equations.
Term Reader::name(const std::string& name, const model::EquationText& text, Reading& reading) {
  const bool is_input = std::ranges::count(text.inputs, name, &model::InputText::name) > 0;
  const auto known = find_name(name);
  const auto other = std::ranges::find(texts_, name, &model::EquationText::name);
  const auto parameter =
      std::ranges::find(text.parameters, name, &std::pair<std::string, Real>::first);
  if (parameter != text.parameters.end()) {
    const char* const meaning = is_input                ? "an input"
                                : known || name == "pi" ? "a symbol"
                                : other != texts_.end() ? "an equation"
                                                        : nullptr;
    if (meaning != nullptr) {
      throw std::runtime_error(fmt::format("'{}' is a parameter and {}; expected different names",
                                           shown(name), meaning));
    }
    return Number{parameter->second, std::nullopt};
  }
  if (is_input) {
    return *reading.input(name);
  }
  if (name == "pi") {
    return Number{pi(), std::nullopt};
  }
  if (known) {
    reading.made.names_places |= of_places(name);
    return *known;
  }
  if (other == texts_.end()) {
    throw std::runtime_error(fmt::format(
        "there is no symbol '{}'{}; expected one of {}, an input or an equation", shown(name),
        name == "q"   ? " (positions of joints are an input per link)"
        : name == "T" ? " (a transpose is T(X))"
                      : "",
        fmt::join(known_names(), " ")));
  }
  return used(*other, reading);
}

/// Another equation, whose inputs become those of the function.
Expression Reader::used(const model::EquationText& other, Reading& reading) {
  if (std::ranges::find(open_, &other) != open_.end()) {
    throw std::runtime_error(
        fmt::format("equation '{}' uses itself; expected symbols, inputs and other equations",
                    shown(other.name)));
  }
  if (open_.size() > kMostNestedUses || ++uses_ > kMostUses) {
    const model::EquationText& read = *open_.front();
    throw InputError(read.where,
                     fmt::format("equation '{}' uses others too deeply or too often; expected at "
                                 "most {} levels and {} uses, those of others counted each time",
                                 shown(read.name), kMostNestedUses, kMostUses));
  }
  for (const model::InputText& input : other.inputs) {
    reading.add_used_input(input);
  }
  return block::named(other.name, expand(other, reading));
}

}  // namespace

bool counts_joints(const UserEquation& equation) {
  const auto of_links = [](const block::Side& side) {
    return side.set == block::Set::kLinks;
  };
  const block::Shape& shape = equation.expression.shape();
  return of_links(shape.rows) || of_links(shape.cols) ||
         std::ranges::any_of(equation.arguments, [&](const UserArgument& argument) {
           return of_links(argument.side) && argument.name != "q" && argument.name != "qd" &&
                  argument.name != "qdd";
         });
}

UserEquation equation_of(const std::string& name, const Expression& expression) {
  const model::Tree tree;  // our equations name no links
  Reading reading(tree, {});
  reading.made.name = name;
  reading.made.text = block::print(expression);
  reading.finish(expression);
  return reading.made;
}

std::vector<UserEquation> read_equations(const std::vector<model::EquationText>& texts,
                                         const model::Tree& tree,
                                         std::span<const model::Point> points) {
  return Reader(texts, tree, points).run();
}

}  // namespace treedyn::equations
