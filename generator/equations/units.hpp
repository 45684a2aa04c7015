// Units of block expressions, worked out from those of the leaves.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "block/block.hpp"

namespace treedyn::equations {

/// Powers of kilogram, metre and second; a radian is a 1.
struct Unit {
  int kg = 0;
  int m = 0;
  int s = 0;
  bool any = false;                      ///< of a zero, or not known: fits everything
  std::array<std::int8_t, 16> inputs{};  ///< powers of the units of inputs, which users know
  friend bool operator==(const Unit&, const Unit&) = default;
};
Unit operator*(const Unit& a, const Unit& b);
/// "N m", "kg m^2/s", "1"; empty where inputs decide.
std::string to_string(const Unit& unit);
/// Of input number k in rows of a kind of joints (0 revolute, 1 prismatic).
Unit unit_of_input(std::size_t k, std::size_t kind);

/// Units of the blocks of a matrix by the kind of joint (revolute, prismatic) that its row and its
/// column belong to; sides that do not count links have the first kind only. Nothing: such blocks
/// are zero, or the tree has no such joint.
using Units = std::array<std::array<std::optional<Unit>, 2>, 2>;
/// "N m|N": the different ones.
std::string to_string(const Units& units);

/// Terms of a sum that differ: "adds N m to N".
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Which kinds of joints a tree has.
struct JointKinds {
  bool revolute = true;
  bool prismatic = true;
  [[nodiscard]] bool has(int kind) const { return kind == 0 ? revolute : prismatic; }
};

class UnitReader {
 public:
  explicit UnitReader(const JointKinds& kinds) : kinds_(kinds) {}

  /// Units of a leaf that equations/symbols.hpp does not know.
  void define(const std::string& leaf, const Units& units) { leaves_[leaf] = units; }
  /// \throws UnitError
  Units of(const block::Expression& e);

 private:
  [[nodiscard]] Units of_leaf(const block::Expression& e) const;
  Units of_sum(const block::Expression& e);
  [[nodiscard]] Units uniform(const block::Expression& e, const Unit& unit) const;

  JointKinds kinds_;
  std::map<std::string, Units> leaves_;
  std::map<const block::Node*, std::pair<block::Expression, Units>> known_;  // never iterated
};

}  // namespace treedyn::equations
