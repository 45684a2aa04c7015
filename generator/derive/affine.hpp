// Values as sums of blocks times what unknown numbers of links decide.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "derive/algebra.hpp"

namespace treedyn::derive {

/// The unknowns, a sum along the tree that they decide, or what the father has of it.
using Atom = std::pair<int, bool>;

/// Σ block * atom + rest. Blocks as in Algebra::step; of numbers: rows; of tensors Λ(a) + T: of a.
struct Affine {
  std::map<Atom, int> blocks;
  Terms rest;

  /// -1: zero.
  [[nodiscard]] int block(const Atom& atom) const {
    const auto found = blocks.find(atom);
    return found == blocks.end() ? -1 : found->second;
  }
};

class Opening {
 public:
  /// \param unknown  the name of a leaf
  Opening(Values& values, std::string unknown)
      : values_(values), algebra_(values), unknown_(std::move(unknown)) {}

  /// What it is made of has the rules that made x.
  /// \throws NoComposites for products of unknowns and what has no such blocks
  Affine open(int x);
  [[nodiscard]] bool depends(int x) const;
  int rest(const Affine& a, Type type);
  Algebra& algebra() { return algebra_; }

 private:
  template <class Block, class Rest>
  Affine mapped(const Affine& a, Block block, Rest rest);
  Affine times(int X, const Affine& a);
  Affine parts(int x);
  Affine sum(const Value& v);
  Affine scaled(const Value& v);
  Affine product(const Value& v);
  Affine applied(const Value& v);
  Affine moment(const Value& v);
  int number(int a, int b);

  Values& values_;
  Algebra algebra_;
  std::string unknown_;
};

}  // namespace treedyn::derive
