// A function to be generated: its signature and, for every output element, an expression of the
// inputs.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "program/graph.hpp"

namespace treedyn::program {

/// An argument of a generated function: `const Scalar name[size]` or `Scalar name[size]`.
struct Array {
  std::string name;
  int size = 0;
  std::string unit;                      ///< "rad|m"
  bool integer = false;                  ///< int instead of Scalar
  std::string type = {};                 ///< a struct of the header; empty: an array
  std::vector<std::string> fields = {};  ///< of the struct; empty: one array `value`
  std::string number = {};               ///< type of an element; empty: Scalar
  int lane = -1;                         ///< elements are vectors, of which this lane; -1: numbers
  int rows = 0;  ///< of a matrix of a user, as it is when dense; 0: not said
  int columns = 0;
};

/// True if one of the arrays is called so.
bool has(const std::vector<Array>& arrays, std::string_view name);

/// What the header, the manifest and `treedyn list` say of a function.
struct Signature {
  std::string name;      ///< mass_matrix
  std::string equation;  ///< (2)
  std::string brief;     ///< "Joint-space inertia matrix A(q), row-major, symmetric."
  std::vector<Array> inputs;
  std::vector<Array> outputs;
  bool status = false;  ///< returns an int, the bits of namespace status; else nothing
  std::vector<std::string> rows = {};  ///< what the rows of constraints are, for the reader
  /// Inputs, then outputs.
  [[nodiscard]] std::vector<Array> arrays() const;
};

/// What rounding costs in a function: bounds of its errors, as quotients of those of the same
/// function before any pass, at their largest (`amplification` in rounding.hpp).
struct Rounding {
  double amplification = 0;           ///< 0: not known
  double refused = 0;                 ///< with all passes, if that was too much; otherwise 0
  std::vector<std::string> left_out;  ///< the passes that were not used therefore
};

/// The unit of length of the values between arguments and results, which are in SI units.
struct LengthUnit {
  Real metres = 1;
  int link = -1;  ///< whose joint's distance from the father's it is; -1: the metre
};

struct LimbCode;  // limb_code.hpp

/// \invariant `outputs` holds one value for each element of all output arrays, in order.
struct Function {
  Signature signature;
  Graph graph;
  std::vector<Ref> outputs;
  /// The same function as code that equal limbs share; null: every limb has its own.
  std::shared_ptr<const LimbCode> limb_code = nullptr;
  Rounding rounding = {};
  LengthUnit unit = {};
};

/// Operations that one call executes, INTERFACE.md 5: a negation or a copy costs nothing.
struct Cost {
  int add = 0;
  int mul = 0;
  int div = 0;
  int sqrt = 0;
  int sin = 0;
  int cos = 0;
  /// Of the multiplications: those that a machine with fused multiply-add executes together with
  /// the addition that takes them in. Such a product stands in the expression of its sum
  /// (`schedule`), where compilers contract the two.
  int fused = 0;
  /// Angles whose sine or cosine is taken: each has both computed. And vectors of two and of four
  /// of them, those of one function.
  int angles = 0;
  int twos = 0;
  int fours = 0;

  /// add + mul + div, the number that tests/benchmark/README.md compares.
  [[nodiscard]] int total() const { return add + mul + div; }
  bool operator==(const Cost&) const = default;
};

/// Every reachable node counts once. O(size of the graph).
Cost cost(const Graph& graph, std::span<const Ref> outputs);
/// Of the code of the function: every call of a limb's code counts.
Cost cost(const Function& function);
/// `operation` on the counts of both, one by one.
template <class Operation>
Cost by_count(Cost a, const Cost& b, Operation operation) {
  for (int Cost::*const count :
       {&Cost::add, &Cost::mul, &Cost::div, &Cost::sqrt, &Cost::sin, &Cost::cos, &Cost::fused,
        &Cost::angles, &Cost::twos, &Cost::fours}) {
    a.*count = operation(a.*count, b.*count);
  }
  return a;
}

Cost operator+(const Cost& a, const Cost& b);
Cost operator*(int times, const Cost& cost);

}  // namespace treedyn::program
