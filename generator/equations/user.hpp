// Equations of users: texts to block expressions with shapes and units, INTERFACE.md 7.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "block/block.hpp"
#include "model/equation.hpp"
#include "model/tree.hpp"

namespace treedyn::equations {

/// An array that the function of an equation takes.
struct UserArgument {
  std::string name;  ///< q qd qdd tau f n, or the user's own
  std::string leaf;  ///< empty: q
  block::Side side;
  std::string unit;
};

/// R(LINK): the frame of a link that `link` carries.
struct UserFrame {
  int link = model::kGround;
  model::Matrix3 rotation{};  ///< frame -> frame of `link`
};

struct UserEquation {
  std::string name;
  std::string text;
  std::string doc;
  block::Expression expression = block::leaf("", block::Structure::kFull, {});
  std::string unit;  ///< "N m|N"
  std::vector<UserArgument> arguments;
  std::map<std::string, std::vector<Real>> constants;    ///< leaves of numbers: one a block
  std::map<std::string, block::Expression> reciprocals;  ///< leaves 1 / x: x, see number_of_tree
  std::map<std::string, UserFrame> frames;               ///< leaves R(LINK)
  std::map<std::string, block::Expression> rates;        ///< of leaves, where `dot` took them: R11
  bool names_places = false;  ///< the text names what has P_i in it, not Jacobians and A alone
  std::optional<block::Expression> rate_of;  ///< X where the whole text is dot(X)
  Location where;
};

/// True if the equation has rows, columns or inputs of joints.
bool counts_joints(const UserEquation& equation);

/// An equation of EQUATIONS.md as one that a user might have written.
UserEquation equation_of(const std::string& name, const block::Expression& expression);

/// Equations may use each other, in any order.
/// \throws InputError with line and column for what does not conform, mixes units, is unknown,
/// recursive or taken.
std::vector<UserEquation> read_equations(const std::vector<model::EquationText>& texts,
                                         const model::Tree& tree,
                                         std::span<const model::Point> points);

}  // namespace treedyn::equations
