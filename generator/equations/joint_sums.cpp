#include "equations/joint_sums.hpp"

#include <map>
#include <string>
#include <vector>

#include "block/rewrite.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {
namespace {

using block::Kind;

/// What a side that counts links stands for.
enum class Count {
  kLinks,   ///< or nothing that is known
  kJoints,  ///< forces on joints, or what takes their motions
  kMotion,  ///< q̇, q̈
  kEither,  ///< numbers of a diagonal: what is on the other side of it
};

struct Sides {
  Count rows = Count::kLinks;
  Count cols = Count::kLinks;
};

/// Sides by the symbols below; a product of joints with others is remembered.
class SideReader {
 public:
  Sides of(const Expression& e);
  [[nodiscard]] bool picks() const { return picks_; }

 private:
  Sides read(const Expression& e);
  Sides of_product(const std::vector<Expression>& factors);
  static Sides of_leaf(const Expression& e);

  std::map<const block::Node*, Sides> known_;
  bool picks_ = false;
};

bool counts_links(const block::Side& side) { return side.set == block::Set::kLinks; }

Sides SideReader::of_leaf(const Expression& e) {
  const std::string& name = e.node().name;
  if (name == z_d.node().name) {
    return {Count::kLinks, Count::kJoints};
  }
  if (name == tau.node().name) {
    return {Count::kJoints, Count::kLinks};
  }
  if (name == qd_d.node().name) {
    return {Count::kMotion, Count::kMotion};
  }
  if (name == qd.node().name || name == qdd.node().name) {
    return {Count::kMotion, Count::kLinks};
  }
  return block::is_diagonal_leaf(e) &&
                 e.shape() == block::Shape{equations::kLinks, equations::kLinks}
             ? Sides{Count::kEither, Count::kEither}
             : Sides{};
}

Count of_terms(Count a, Count b) {
  return a == Count::kJoints || b == Count::kJoints ? Count::kJoints : a == b ? a : Count::kLinks;
}

Sides SideReader::of_product(const std::vector<Expression>& factors) {
  Sides all = of(factors.front());
  block::Shape shape = factors.front().shape();
  for (auto f = factors.begin() + 1; f != factors.end(); ++f) {
    const Sides next = of(*f);
    if (!counts_links(shape.cols)) {  // a number, or a row that comes to an end
      all.rows = counts_links(shape.rows) ? all.rows : next.rows;
      all.cols = next.cols;
    } else if (counts_links(f->shape().rows)) {
      const bool joints = all.cols == Count::kJoints || next.rows == Count::kJoints;
      const bool free = all.cols == Count::kEither || next.rows == Count::kEither;
      const bool moves = all.cols == Count::kMotion || next.rows == Count::kMotion;
      picks_ = picks_ || (joints && !free && !moves);
      all.rows = all.rows == Count::kEither ? next.rows : all.rows;
      all.cols = next.cols == Count::kEither ? all.cols : next.cols;
    }
    shape = {counts_links(shape.rows) ? shape.rows : f->shape().rows, f->shape().cols};
  }
  return all;
}

Sides SideReader::read(const Expression& e) {
  const std::vector<Expression>& x = e.operands();
  switch (e.kind()) {
    case Kind::kLeaf:
      return of_leaf(e);
    case Kind::kProduct:
      return of_product(x);
    case Kind::kSum: {
      Sides all = of(x.front());
      for (const Expression& term : x) {
        const Sides next = of(term);
        all = {of_terms(all.rows, next.rows), of_terms(all.cols, next.cols)};
      }
      return all;
    }
    case Kind::kTranspose: {
      const Sides inner = of(x.front());
      return {inner.cols, inner.rows};
    }
    case Kind::kNamed:
    case Kind::kScaled:
      return of(x.front());
    case Kind::kDiagonal: {
      const Count counted = of(x.front()).rows;
      return counted == Count::kJoints  ? Sides{Count::kJoints, Count::kJoints}
             : counted == Count::kLinks ? Sides{}
                                        : Sides{Count::kEither, Count::kEither};
    }
    case Kind::kSkew:
    case Kind::kSkewTranspose:
      of(x.front());
      return {};
  }
  return {};
}

Sides SideReader::of(const Expression& e) {
  const auto found = known_.find(&e.node());
  return found != known_.end() ? found->second : known_.emplace(&e.node(), read(e)).first->second;
}

}  // namespace

bool picks_joints(const Expression& e) {
  SideReader sides;
  sides.of(e);
  return sides.picks();
}

}  // namespace treedyn::equations
