#include "equations/user.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "block/print.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "equations/reading.hpp"
#include "equations/symbol_names.hpp"
#include "equations/text.hpp"

namespace treedyn::equations {
namespace {

constexpr int kMostNestedUses = 50;  // equations that use each other

class Reader {
 public:
  Reader(const std::vector<model::EquationText>& texts, const model::Tree& tree,
         std::span<const model::Point> points)
      : texts_(texts), tree_(tree), points_(points) {}

  std::vector<UserEquation> run() {
    check_names();
    std::vector<UserEquation> result;
    for (const model::EquationText& text : texts_) {
      result.push_back(read(text));
    }
    return result;
  }

 private:
  void check_names() const;
  void check_mimic(const model::EquationText& text, const UserEquation& equation) const;
  UserEquation read(const model::EquationText& text);
  Expression expand(const model::EquationText& text, Reading& reading);
  Term name(const std::string& name, const model::EquationText& text, Reading& reading);

  const std::vector<model::EquationText>& texts_;
  const model::Tree& tree_;
  std::span<const model::Point> points_;
  std::vector<const model::EquationText*> open_;  ///< that are being read
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
}

/// Joints that mimic others are no coordinates.
void Reader::check_mimic(const model::EquationText& text, const UserEquation& equation) const {
  if (tree_.dof() == tree_.size()) {
    return;
  }
  const block::Shape& shape = equation.expression.shape();
  const auto of_links = [](const block::Side& side) {
    return side.set == block::Set::kLinks;
  };
  const bool takes = std::any_of(equation.arguments.begin(), equation.arguments.end(),
                                 [&](const UserArgument& argument) {
                                   return of_links(argument.side) && argument.name != "q" &&
                                          argument.name != "qd" && argument.name != "qdd";
                                 });
  if (of_links(shape.rows) || of_links(shape.cols) || takes) {
    throw InputError(text.where,
                     fmt::format("equation '{}' has rows, columns or inputs of joints and some "
                                 "joints mimic others; expected --mimic independent",
                                 shown(text.name)));
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
  const Expression e = expand(text, reading);
  reading.finish(e);
  check_mimic(text, reading.made);
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
    Location where = text.value_where;
    where.column += static_cast<int>(error.offset());
    throw InputError(where, fmt::format("equation '{}': {}", shown(text.name), error.what()));
  }
}

/// The user's inputs, parameters of the file, the symbols of EQUATIONS.md, other equations.
Term Reader::name(const std::string& name, const model::EquationText& text, Reading& reading) {
  if (const auto input = reading.input(name)) {
    return *input;
  }
  if (name == "pi") {
    return Number{pi(), std::nullopt};
  }
  if (const auto known = find_name(name)) {
    return *known;
  }
  for (const auto& [parameter, value] : text.parameters) {
    if (parameter == name) {
      return Number{value, std::nullopt};
    }
  }
  for (const model::EquationText& other : texts_) {
    if (other.name != name) {
      continue;
    }
    if (std::find(open_.begin(), open_.end(), &other) != open_.end()) {
      throw std::runtime_error(fmt::format("equation '{}' uses itself", shown(name)));
    }
    if (open_.size() > kMostNestedUses) {
      throw std::runtime_error("equations use each other too deeply");
    }
    for (const model::InputText& input : other.inputs) {
      if (!reading.input(input.name)) {
        reading.add_input(input);
      }
    }
    return block::named(name, expand(other, reading));
  }
  throw std::runtime_error(
      fmt::format("there is no symbol '{}'; expected one of {}, an input or an equation",
                  shown(name), fmt::join(known_names(), " ")));
}

}  // namespace

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
