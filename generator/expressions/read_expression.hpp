// Expressions with variables: text to the programs of a scene, derivatives in time included.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "expressions/constant.hpp"
#include "model/expression.hpp"

namespace treedyn::expressions {

/// The variables that one expression may use.
struct VariableNames {
  /// `name`, or `name[index]`; nothing if it is unknown.
  std::function<std::optional<model::Variable>(std::string_view name,
                                               std::optional<std::string_view> index)>
      find;
  std::string expected;                 ///< ", t, q[joint], qd[joint]": for messages
  std::vector<std::string> known = {};  ///< "t", "q[elbow]", ..: for what a typo may have meant
  bool run_time = false;                ///< parameters too that are known at run time only
};

/// Reads an expression in the grammar of `Constants`, whose parameters it may use; a name of
/// `variables` hides nothing, for parameters come first.
///
/// The result does not depend on the order in which GiNaC keeps terms: sums and products are
/// sorted by their text. \throws TextError
model::Expression read_expression(const Constants& constants, std::string_view text,
                                  const VariableNames& variables);

/// The expression and its first and second derivatives in time. \pre its only variable is kTime
/// \throws TextError
std::array<model::Expression, 3> read_motion(const Constants& constants, std::string_view text,
                                             const VariableNames& variables);

}  // namespace treedyn::expressions
