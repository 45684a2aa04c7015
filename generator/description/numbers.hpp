// The numbers of a RawTree: decimals, and in tree descriptions constant expressions.
#pragma once

#include <string>

#include "common/real.hpp"
#include "description/raw_tree.hpp"
#include "expressions/constant.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// True for what xacro replaces.
bool is_xacro(const std::string& text);
/// What is said of it.
std::string of_xacro(const std::string& text);

/// Evaluates numbers. `what` names the value in messages: "joint 'elbow': axis".
class NumberReader {
 public:
  /// Defines the parameters of the file. \throws InputError
  explicit NumberReader(const RawTree& raw);

  /// \throws InputError
  [[nodiscard]] Real number(const Text& text, const std::string& what) const;
  /// Exactly three numbers; zeros if they are missing. \throws InputError
  [[nodiscard]] model::Vector3 vector(const std::optional<Numbers>& numbers,
                                      const std::string& what) const;
  /// Exactly nine numbers. \throws InputError
  [[nodiscard]] model::Matrix3 matrix(const Numbers& numbers, const std::string& what) const;
  /// Six numbers ixx ixy ixz iyy iyz izz as a symmetric matrix. \throws InputError
  [[nodiscard]] model::Matrix3 tensor(const Numbers& numbers, const std::string& what) const;

  /// Bound of the rounding in what `text` writes: half a unit of the last digit of a decimal, at
  /// most 0.1 % of `scale`; 0 for a plain 0 and for expressions.
  [[nodiscard]] static Real rounding(const Text& text, const Real& scale);

 private:
  template <std::size_t size>
  std::array<Real, size> list(const Numbers& numbers, const std::string& what) const;

  const RawTree& raw_;
  expressions::Constants constants_;
};

}  // namespace treedyn::description
