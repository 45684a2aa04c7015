// One equation of a user while it is read: its inputs, numbers and what it calls.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "equations/dot.hpp"
#include "equations/symbols.hpp"
#include "equations/units.hpp"
#include "equations/user.hpp"

namespace treedyn::equations {

/// A symbol of EQUATIONS.md, a function of texts or an argument that every function may have.
bool is_taken(const std::string& name);

/// One equation while it is read.
class Reading {
 public:
  Reading(const model::Tree& tree, std::span<const model::Point> points);

  UserEquation made;
  Rates rates;

  UnitReader& units() { return units_; }
  void add_input(const model::InputText& input);
  /// Of an equation that this one uses: the same array as an input of that name, if there is one.
  void add_used_input(const model::InputText& input);
  Expression number(const Real& value);
  Expression reciprocal(const Expression& e);
  Expression of(const std::string& function, const std::string& argument);
  [[nodiscard]] std::optional<Expression> input(const std::string& name) const;
  void finish(const Expression& e);

 private:
  [[nodiscard]] std::size_t size() const { return tree_.links.size(); }
  [[nodiscard]] const model::Frame& frame(const std::string& name) const;
  [[nodiscard]] int link(const std::string& name) const;
  Expression constant(const std::string& name, block::Structure structure,
                      const block::Shape& shape, const std::vector<Real>& values);
  Expression at(const std::string& name, int i);
  Expression of_point(const std::string& name);
  Expression orientation(const std::string& name);

  const model::Tree& tree_;
  std::span<const model::Point> points_;
  UnitReader units_;
  std::map<std::string, Expression> inputs_;
};

}  // namespace treedyn::equations
