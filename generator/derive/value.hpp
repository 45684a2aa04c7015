// Columns of blocks as a graph: every value exists once, operands before their users.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "block/block.hpp"
#include "common/index.hpp"
#include "derive/rules.hpp"

namespace treedyn::derive {

using block::add;
using block::multiply;
using block::Ratio;

inline constexpr Ratio kPlus{1, 1};
inline constexpr Ratio kMinus{-1, 1};

inline bool is_vector(const block::Expression& f) {
  return f.shape().rows.size == 3 && f.shape().cols.size == 1;
}
using block::Set;

enum class Type { kScalar, kVector, kTensor };

/// How a value comes from its operands; a value has one block for every link (or point, or one).
enum class Op {
  kZero,
  kOnes,            ///< the number 1
  kIdentity,        ///< the 3x3 unit matrix
  kUnit,            ///< the column of a matrix that is asked for: 1 or a unit vector at one place
  kLeaf,            ///< a symbol: column, or diagonal of its blocks
  kLinear,          ///< Σ factor * operand
  kScale,           ///< numbers times the last operand
  kDot,             ///< a·b
  kCross,           ///< a×b
  kSkew,            ///< Λ(a)
  kSkewProduct,     ///< Λ(a) Λ(b)
  kProduct,         ///< S T of blocks
  kApply,           ///< S v; of a matrix of numbers and a column
  kApplyTranspose,  ///< S^T v
  kComposite,       ///< D^T I - N^T (Λ(h)Λ(s) + Λ(s)Λ(h + m s)) of m, h, s
  kMoment,          ///< vee(Ω Ψ) of Ω, α, ω: I α + ω×I ω by the second moments Ψ
  kSquare,          ///< -tr(Λ(ω)² Ψ) of ω: ω·(I ω) by the second moments Ψ
  kPseudo,          ///< the second moments Ψ of I = tr(Ψ) E_3 - Ψ
  kPath,            ///< D x, or a + D x where a second operand a is the same for all links
  kPathStrict,      ///< N x
  kSubtree,         ///< D^T x
  kSubtreeStrict,   ///< N^T x
  kBackward,        ///< D^T a + N^T b, one recursion
  kFather,          ///< Π x
  kSons,            ///< Π^T x
  kGather,          ///< W x: links from their points
  kPick,            ///< W^T x: points from their links
  kSpread,          ///< 1 x: to every link or point
  kCollect,         ///< 1^T x: over all links or points
  kComponent,       ///< one component in the base frame
  kAssemble,        ///< a vector of three components in the base frame
  kTravelling,  ///< a state of R9 or R12 at this link (I^A, α, L'): `definitions` says how it is
                ///< made, of itself at the sons or at the father
  kFold,        ///< a + Π^T b, b made of the sum
  kAtLink,      ///< x, kept for the link under a name: ζ; u, with 1/d as a second operand
  kReciprocal,  ///< 1 / x
  kLever,       ///< Λ(a) S of a, S; symmetric Λ(a) S^T - T Λ(a) of a, S, T
  kAcross,      ///< K - U V^T, whose products with b and a^T are zero, of K, U, V, a, b
  kAlong,       ///< x with a·x = y, of x, a, y
  kEliminated,  ///< the lower half of a = A - L'^T a, of A, L'
  kFromLeaves,  ///< x = r - L'^T x, of r, L'
  kFromRoot,    ///< x = r - L' x, of r, L'
  kDiagonal,    ///< the diagonal of a matrix of numbers
  kTransposed,  ///< the transpose of a matrix of numbers
  kCongruence,  ///< Y d Y^T of Y, d; Y Y^T of Y
};

struct Value {
  Op op = Op::kZero;
  Set set = Set::kOne;
  Type type = Type::kScalar;
  std::string name;   ///< kLeaf
  int component = 0;  ///< kComponent
  std::vector<int> operands;
  std::vector<Ratio> factors;  ///< kLinear
};

using Terms = std::vector<std::pair<Ratio, int>>;

/// Those of a sum, and a sum of some, as they stand.
Terms terms_in(const Value& sum);
Value plain_sum(const Terms& terms, Set set, Type type);

/// What the equations leave open.
struct Choices {
  bool keeps_joints = true;   ///< P_i of a sliding joint keeps its place: l has the slide, not s
  bool common_leaves = true;  ///< R3' takes what all links have in common out of sums
  bool composites = false;    ///< R7 takes sums over subtrees out of sums along paths
};

/// The values that a function is made of, and the rules that made them.
class Values {
 public:
  explicit Values(const Choices& choices = {}, std::set<Rule> acted = {})
      : choices_(choices), acted_(std::move(acted)) {}
  [[nodiscard]] const Choices& choices() const { return choices_; }

  int intern(Value value);
  [[nodiscard]] const Value& operator[](int id) const { return values_[to_index(id)]; }
  [[nodiscard]] int size() const { return static_cast<int>(values_.size()); }

  /// What a travelling value is.
  void define(int travelling, int value) { definitions_[travelling] = value; }
  [[nodiscard]] const std::map<int, int>& definitions() const { return definitions_; }

  /// True for what depends on the column that is asked for.
  [[nodiscard]] bool of_unit(int id) const { return of_unit_[to_index(id)]; }

  /// The rules that acted, also those that left nothing where they did.
  [[nodiscard]] const std::set<Rule>& acted() const { return acted_; }
  /// Those that made the value, or a value that is a part of it.
  [[nodiscard]] const std::set<Rule>& made_by(int id) const { return made_by_[to_index(id)]; }
  /// \return the value that the rule made
  int note(Rule rule, int id);
  void note(const std::set<Rule>& rules, int id);

  /// The values that `roots` are computed from, themselves included, ascending.
  [[nodiscard]] std::vector<int> needed(const std::vector<int>& roots) const;

 private:
  Choices choices_;
  std::vector<Value> values_;
  std::vector<bool> of_unit_;
  std::vector<std::set<Rule>> made_by_;
  std::map<std::string, int> known_;
  int asked_ = 0;  ///< calls of `intern`, which bound the work of a derivation
  std::map<int, int> definitions_;
  std::set<Rule> acted_;
};

/// Makes what `roots` need anew, operands before their users; `roots` follow, and so do the rules
/// that made a value.
/// \param made  adds a value with its new operands to `anew`
void remake(const Values& values, Values& anew, std::vector<int>& roots,
            const std::function<int(Value)>& made);

}  // namespace treedyn::derive
