// Values of a derivation to expressions: link by link, each in the frame where it is cheap.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "common/index.hpp"
#include "derive/forms.hpp"
#include "formulate/blocks.hpp"
#include "formulate/derived.hpp"
#include "program/function.hpp"

namespace treedyn::formulate {

class Lowering {
 public:
  Lowering(const Task& task, const Derived& function, Way way);

  [[nodiscard]] const derive::Derivation& derivation() const { return derivation_; }

  /// The column that is asked for, of a symmetric matrix its rows on the way to the root, is
  /// `place`, component `component`.
  void ask_for(int place, int component);

  /// Column `k` of what the function derives to, a block for every element of its rows: vectors in
  /// `frame`, numbers as they are, one behind the other.
  [[nodiscard]] std::vector<Expr> written(int k, block::Set set, int frame);
  [[nodiscard]] int count(block::Set set) const;
  /// Entry (i, place) of a symmetric matrix. \pre i is `place` or above
  [[nodiscard]] Expr entry(int i) const { return of(derivation_.roots.front(), i).number; }

  /// α of a link, base frame. \pre bodies turn
  [[nodiscard]] Vec3 alpha(int i) const {
    return frames_.in(of(turnings_.front().alpha, i).vector, kBase);
  }

  /// Operations of `outputs` by the number of the value, in the derivation, for which they are
  /// written; the last: for none.
  [[nodiscard]] std::vector<program::Cost> costs(const std::vector<Expr>& outputs) const;

 private:
  using Value = derive::Value;
  /// Values that are computed together: one behind the other, or all of a link before the next.
  /// Stages come in threes, each number modulo 3 has its walk: 0 kWhole, 1 kToSons, 2 kToFathers,
  /// 3 kWhole, ..; those that no value needs are empty.
  enum class Walk { kWhole, kToSons, kToFathers };
  struct Stage {
    std::vector<int> sums;  ///< sums along the tree, and what they need
    std::vector<int> rest;
  };
  struct Sum {
    Block block;
    bool begun = false;
    bool has_own = false;  ///< the link's own block is in
  };
  /// What the entries of Ω share.
  struct Squares {
    Expr xx;     ///< omega_x^2, shared along a run of parallel axes
    Expr yy;     ///< omega_y^2
    Expr xx_zz;  ///< omega_x^2 - omega_z^2 = Omega_xx - Omega_zz
  };

  /// The entries of a symmetric tensor as lists of terms, so that constants add up first.
  using TensorTerms = std::array<std::array<std::vector<Expr>, 3>, 3>;

  [[nodiscard]] Walk walk_of(int stage) const { return static_cast<Walk>(stage % 3); }
  [[nodiscard]] int stage_of(int id) const;
  void arrange();
  void run(bool of_unit);
  void run(const std::vector<int>& ids, int e, bool of_unit);
  [[nodiscard]] bool is_asked(int e, bool of_unit) const;
  /// Block e of a value, if it is not known yet, and those of its operands.
  void need(int id, int e);
  void name_sums(int e);
  /// The nodes from number `first` on that are no value's yet are written for this one.
  void own(std::size_t first, int id);

  [[nodiscard]] const char* symbol(int id) const;
  Block made(int id, const Value& v, int e);
  [[nodiscard]] Block unit(const Value& v, int e) const;
  [[nodiscard]] Block leaf(const Value& v, int e) const;
  [[nodiscard]] Block link_leaf(const Value& v, int e) const;
  [[nodiscard]] Mat3 tensor_about_joint(int e) const;
  [[nodiscard]] Mat3 second_moments(int e) const;
  [[nodiscard]] Block input(const Value& v, const equations::UserArgument& argument, int array,
                            int e) const;
  [[nodiscard]] Block orientation(const equations::UserFrame& frame) const;
  [[nodiscard]] Real reciprocal(const block::Expression& divisor) const;
  [[nodiscard]] Block linear(const Value& v, int e) const;
  [[nodiscard]] Block scale(const Value& v, int e) const;
  [[nodiscard]] Block product(const Value& v, int e) const;
  [[nodiscard]] Block tensor_product(const Value& v, int e) const;
  [[nodiscard]] Block applied(const Value& v, int e) const;
  [[nodiscard]] Block moment(const Value& v, int e) const;
  [[nodiscard]] Block pseudo(const Value& v, int e) const;
  [[nodiscard]] Block square(const Value& v, int e) const;
  Block composite(int id, const Value& v, int i);
  [[nodiscard]] Block components(const Value& v, int e) const;
  Block path(int id, const Value& v, int i);
  void begin(int id, const Value& v, int i);
  Block subtree(int id, const Value& v, int i);
  [[nodiscard]] Block shifted(const Value& v, int i) const;
  Block folded(int id, const Value& v, int i);
  void hand_on(const std::vector<int>& ids, int i);
  [[nodiscard]] bool is_absent(int id, int e) const;
  [[nodiscard]] Block once(const Value& v, int e) const;
  [[nodiscard]] Block along(const Value& v, int e) const;
  [[nodiscard]] Block across(const Value& v, int e) const;
  [[nodiscard]] Block lever(const Value& v, int e) const;
  [[nodiscard]] Vec3 direction(int id, int e) const;
  [[nodiscard]] Block at_points(const Value& v, int e) const;
  Block spread(int id, const Value& v, int e);
  [[nodiscard]] Block collect(const Value& v) const;
  void turn(const derive::Turning& turning, int i);
  Mat3 turned_by_column(int i, const Vec3& omega, const Vec3& third, const Squares& father,
                        Vec3& alpha, Squares& squares) const;

  [[nodiscard]] const Block& of(int id, int e) const { return memo_[to_index(id)][to_index(e)]; }
  [[nodiscard]] const Value& value(int id) const { return derivation_.values[id]; }
  [[nodiscard]] Block zero(const Value& v, int e) const;
  void add(const Value& v, Block& sum, const Block& x, Expr factor) const;
  [[nodiscard]] Block moved(const Value& v, const Block& x, int from, int to) const;
  [[nodiscard]] std::vector<std::pair<Expr, int>> terms(int id) const;
  [[nodiscard]] int home(block::Set set, int e) const;
  [[nodiscard]] int father(int i) const { return task_.kinematics.link(i).father; }
  TensorTerms& composite_terms(int id, int i);
  void hand_on(TensorTerms& father, Expr mass, const Vec3& h, const Vec3& s,
               const Mat3& tensor) const;
  [[nodiscard]] bool has_tensors() const { return task_.kinematics.variant().inertia_tensor; }
  [[nodiscard]] int meeting(const Value& v, int e) const;
  [[nodiscard]] Expr number(const Real& x) const;
  [[nodiscard]] Graph& graph() const { return task_.kinematics.graph(); }

  const Task& task_;
  const Derived& function_;
  const derive::Derivation& derivation_;
  bool trunk_;  ///< of a free base: its turning links are at home in the trunk's frame
  FrameChanges frames_;
  std::vector<int> needed_;
  std::vector<derive::Turning> turnings_;  ///< whose joints turn about frame axes
  std::vector<int> stage_;
  std::vector<Stage> stages_;
  std::vector<bool> of_unit_;  ///< depends on the column that is asked for
  std::vector<Blocks> memo_;
  std::vector<std::vector<bool>> known_;
  std::map<int, Blocks> totals_;                     ///< D x or D^T x, by value
  std::map<int, std::vector<Sum>> sums_;             ///< what the sons hand on, by value
  std::map<int, std::vector<TensorTerms>> tensors_;  ///< of composites, by value
  std::map<int, std::vector<Mat3>> pseudo_;          ///< second moments of composites, by value
  std::map<int, std::vector<Squares>> squares_;      ///< of turnings, by Ω
  std::vector<int> named_;                           ///< sums of the link that have no names yet
  std::vector<int> owners_;  ///< by node of the graph: the value for which it is written, or none
  int place_ = 0;
  int component_ = 0;
};

}  // namespace treedyn::formulate
