// Block-matrix expressions: immutable data, no numbers, no equation and no tree.
//
// An expression is a matrix of blocks. Its rows (columns) run over the links, the points or a
// single index, and every block is 1 or 3 high (wide): D is links x links of 1x1 blocks, z^d links
// x links of 3x1 blocks. Values are cheap to copy; building one checks that the shapes fit.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace treedyn::block {

/// What the rows or columns of a block matrix count.
enum class Set { kOne, kLinks, kPoints, kRows, kPassive };

/// One side of a shape: `set` blocks, each `size` (1 or 3) numbers high or wide.
struct Side {
  Set set = Set::kOne;
  int size = 1;
  friend bool operator==(const Side&, const Side&) = default;
};

struct Shape {
  Side rows;
  Side cols;
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// "N×N", "3N×P", "3N×1": the shape in numbers, N links, P points, r rows.
std::string to_string(const Shape& shape);

/// Which blocks of a leaf may differ from zero, for any tree.
enum class Structure {
  kIdentity,      ///< E
  kReachability,  ///< D: block (i,j) iff j is i or an ancestor of i
  kFather,        ///< Π: block (i,j) iff j is the father of i
  kRevolute,      ///< sigma: block (i,i) iff joint i is revolute
  kCarrier,       ///< W: block (i,p) iff link i carries point p
  kOnes,          ///< a full column of ones
  kRowPoints,     ///< S: block (p,a) iff row a acts on point p; the values depend on the state
  kDiagonal,      ///< block (i,i); the values depend on the state
  kAlongPaths,    ///< where D has blocks; the values depend on the state
  kFull,          ///< every block; the values depend on the state
};

/// True if the values of such a leaf are zeros and ones that the tree alone decides.
constexpr bool is_constant(Structure structure) { return structure <= Structure::kOnes; }

enum class Kind {
  kLeaf,
  kNamed,  ///< another expression, by its name
  kSum,
  kProduct,
  kScaled,         ///< a rational number times an expression
  kTranspose,      ///< ordinary transpose: block positions swapped
  kSkew,           ///< Lambda(X): 3-vectors to skew 3x3 blocks, positions kept
  kSkewTranspose,  ///< Lambda^T(X): the same, every block transposed
  kDiagonal,       ///< diagb(x): a column of blocks on the block diagonal
};

struct Ratio {
  int numerator = 1;
  int denominator = 1;
  friend bool operator==(const Ratio&, const Ratio&) = default;
};

/// Both in lowest terms. \throws TooLarge beyond 31 bits
Ratio multiply(const Ratio& a, const Ratio& b);
Ratio add(const Ratio& a, const Ratio& b);

class Expression;

struct Node {
  Kind kind = Kind::kLeaf;
  Shape shape;
  std::string name;                            ///< leaves and named expressions
  Structure structure = Structure::kIdentity;  ///< leaves
  Ratio factor;                                ///< kScaled
  std::vector<Expression> operands;
};

/// A block-matrix expression. Size rule (EQUATIONS.md 2): a matrix of 1x1 blocks that stands where
/// 3x3 blocks are needed means its Kronecker product with the 3x3 unit matrix.
class Expression {
 public:
  explicit Expression(Node node);

  [[nodiscard]] const Node& node() const { return *node_; }
  [[nodiscard]] Kind kind() const { return node_->kind; }
  [[nodiscard]] const Shape& shape() const { return node_->shape; }
  [[nodiscard]] const std::vector<Expression>& operands() const { return node_->operands; }

 private:
  std::shared_ptr<const Node> node_;
};

/// A symbol: matrix or column whose values come from outside.
Expression leaf(const std::string& name, Structure structure, const Shape& shape);

/// `expression`, printed by its name from here on.
Expression named(const std::string& name, const Expression& expression);

/// \throws std::logic_error for shapes that do not fit, naming both (so do all below).
Expression operator+(const Expression& a, const Expression& b);
Expression operator-(const Expression& a, const Expression& b);
Expression operator*(const Expression& a, const Expression& b);
Expression operator*(int factor, const Expression& a);
Expression operator*(const Ratio& factor, const Expression& a);
Expression operator-(const Expression& a);

/// The ordinary transpose: block (i,j) becomes the transposed block (j,i).
Expression transpose(const Expression& a);

/// Lambda(X): every 3-vector a of X becomes the skew matrix of a, Lambda(a) b = a x b; positions
/// kept.
Expression skew(const Expression& a);

/// Lambda^T(X) = -Lambda(X): blockwise transpose, positions kept (erratum E11).
Expression skew_transpose(const Expression& a);

/// diagb(x): the blocks of the column x on a block diagonal.
Expression diagb(const Expression& x);

/// True for the same tree of operations on the same symbols; names of subexpressions do not count.
bool equal(const Expression& a, const Expression& b);

}  // namespace treedyn::block
