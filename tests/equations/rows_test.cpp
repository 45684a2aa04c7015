// Rows of reactions, EQUATIONS.md 6.2.
#include <gtest/gtest.h>

#include "block/evaluate.hpp"
#include "engine/eigen_real.hpp"
#include "equations/equations.hpp"
#include "equations/kinematics.hpp"
#include "support/golden_tree.hpp"
#include "support/random_tree.hpp"

namespace treedyn::equations {
namespace {

using Vector3r = Vector3<Real>;
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// One row between points: sums over its parts.
struct Part {
  int point = 0;
  bool moment = false;
  Vector3r direction, rate;  ///< base frame
};

/// A tree with rows at one state: puts numbers into the block expressions.
class Rows {
 public:
  Rows(const model::Tree& tree, const std::vector<model::Point>& points,
       const std::vector<std::vector<Part>>& rows)
      : constants_(constants_of<Real>(tree, points, [](const Real& x) { return x; })),
        rows_(rows),
        plan_(index(tree, points)),
        jacobian_(plan_.add(reaction_jacobian_transpose())),
        bias_(plan_.add(reaction_bias_acceleration())),
        poses_(tree.links.size()),
        evaluation_(plan_) {}

  void set(const VectorX& q, const VectorX& qd, const VectorX& creeping) {
    const VectorX sine = q.array().sin();
    const VectorX cosine = q.array().cos();
    compute_poses<Real>(constants_, {view(sine), view(cosine), view(q)}, poses_);
    LeafWriter<Real>(evaluation_).write(constants_, poses_);
    copy(qd, evaluation_.leaf("q̇"));
    copy(qd, evaluation_.leaf("q̇^d"));
    copy(creeping, evaluation_.leaf("u"));
    write_directions();
  }

  VectorX gamma() { return value(bias_, reaction_bias_acceleration().shape()).col(0); }
  /// J, r x N.
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> J() {
    return value(jacobian_, reaction_jacobian_transpose().shape()).transpose();
  }
  [[nodiscard]] const Poses<Real>& poses() const { return poses_; }
  [[nodiscard]] Constants<Real>& constants() { return constants_; }
  [[nodiscard]] std::vector<std::vector<Part>>& rows() { return rows_; }

 private:
  using Dense = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  block::Index index(const model::Tree& tree, const std::vector<model::Point>& points) const {
    block::Index result = index_of(tree, points);
    for (const std::vector<Part>& row : rows_) {
      result.row_points.emplace_back();
      for (const Part& part : row) {
        result.row_points.back().push_back(part.point);
      }
    }
    return result;
  }

  // Blocks of S stand point by point, those of a point row by row.
  void write_directions() {
    std::size_t block = 0;
    for (int p = 0; p < plan_.index().points(); ++p) {
      for (const std::vector<Part>& row : rows_) {
        for (const Part& part : row) {
          if (part.point == p) {
            write_block("S_f", block, part.direction, !part.moment);
            write_block("S_n", block, part.direction, part.moment);
            write_block("Ṡ_f", block, part.rate, !part.moment);
            write_block("Ṡ_n", block++, part.rate, part.moment);
          }
        }
      }
    }
  }

  void write_block(const char* leaf, std::size_t block, const Vector3r& value, bool wanted) {
    for (std::size_t n = 0; n < 3; ++n) {
      evaluation_.leaf(leaf)[3 * block + n] = wanted ? value(static_cast<int>(n)) : Real(0);
    }
  }

  static std::span<const Real> view(const VectorX& x) {
    return {x.data(), static_cast<std::size_t>(x.size())};
  }
  static void copy(const VectorX& x, std::span<Real> leaf) {
    std::copy(x.data(), x.data() + x.size(), leaf.begin());
  }

  Dense value(int step, const block::Shape& shape) {
    evaluation_.run(plan_.needed({step}));
    const block::Pattern& blocks = plan_.step(step).pattern;
    Dense out(blocks.rows() * shape.rows.size, blocks.cols() * shape.cols.size);
    evaluation_.write(step, shape, {out.data(), static_cast<std::size_t>(out.size())});
    return out;
  }

  Constants<Real> constants_;
  std::vector<std::vector<Part>> rows_;
  block::Plan plan_;
  int jacobian_;
  int bias_;
  Poses<Real> poses_;
  block::Evaluation<Real> evaluation_;
};

VectorX cast(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
      .cast<Real>();
}

Vector3r cast(const model::Vector3& a) { return {a[0], a[1], a[2]}; }

TEST(ReactionRows, ReproduceGoldenCases) {
  int cases = 0;
  for (const std::string& file : support::golden_files()) {
    const support::GoldenCase golden = support::read_golden(file);
    if (golden.rows.empty()) {
      continue;
    }
    ++cases;
    std::vector<model::Point> points;
    std::vector<std::vector<Part>> rows;
    for (const support::GoldenRow& row : golden.rows) {
      rows.push_back(
          {{static_cast<int>(points.size()), row.moment, cast(row.direction), Vector3r::Zero()}});
      points.push_back(row.point);
    }
    Rows blocks(golden.tree, points, rows);
    const auto r = static_cast<Eigen::Index>(rows.size());
    blocks.set(cast(golden.q), cast(golden.qd), VectorX::Zero(3 * r));
    const Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> J = blocks.J();
    const VectorX gamma = blocks.gamma();
    EXPECT_LE(support::golden_error(std::vector<Real>(J.data(), J.data() + J.size()),
                                    golden.expected.at("J")),
              1e-13)
        << golden.name;
    EXPECT_LE(support::golden_error(std::vector<Real>(gamma.data(), gamma.data() + gamma.size()),
                                    golden.expected.at("gamma")),
              1e-13)
        << golden.name;
  }
  EXPECT_EQ(cases, 6);
}

/// A row between link 2 and link 3 of a forest whose direction is fixed in link 1, and whose point
/// on link 2 creeps: everything in its place at time t.
class MovingRow : public testing::Test {
 protected:
  MovingRow() : dice_(4), tree_(support::random_tree({{-1, 0, 1, -1}, "RPRR"}, dice_)) {
    points_ = support::random_points(tree_, 2, dice_);
    points_[0].link = 2;
    points_[1].link = 3;
    q_ = cast(dice_.numbers(4, 1));
    qd_ = cast(dice_.numbers(4, 1));
  }

  /// The velocity along the row at q + t qd, at its rates; its bias if asked for.
  Real velocity(const Real& t, Real* bias) {
    std::vector<model::Point> points = points_;
    for (std::size_t n = 0; n < 3; ++n) {
      points[0].at[n] += t * creeping_(static_cast<int>(n));
    }
    const std::vector<std::vector<Part>> none{{{0, false, {}, {}}, {1, false, {}, {}}}};
    Rows rows(tree_, points, none);
    rows.set(q_ + t * qd_, qd_, VectorX::Zero(6));
    const Poses<Real> poses = rows.poses();
    const Vector3r d = poses.R[1] * fixed_;
    const Vector3r omega = qd_(0) * poses.z[0];  // link 1 slides on link 0
    const Vector3r rate{omega(1) * d(2) - omega(2) * d(1), omega(2) * d(0) - omega(0) * d(2),
                        omega(0) * d(1) - omega(1) * d(0)};
    rows.rows() = {{{0, false, d, rate}, {1, false, -d, -rate}}};
    VectorX creeping = VectorX::Zero(6);
    creeping.head(3) = poses.R[2] * creeping_;
    rows.set(q_ + t * qd_, qd_, creeping);
    *bias = rows.gamma()(0);
    return (rows.J() * qd_)(0);
  }

  support::Dice dice_;
  model::Tree tree_;
  std::vector<model::Point> points_;
  VectorX q_, qd_;
  Vector3r fixed_{Real(0.5), Real(-1), Real(2)};        // link 1
  Vector3r creeping_{Real(1), Real(0.25), Real(-0.5)};  // link 2
};

TEST_F(MovingRow, HasBiasThatIsSlopeOfItsVelocity) {
  const Real h("1e-12");
  Real gamma = 0;
  Real unused = 0;
  velocity(Real(0), &gamma);
  const Real slope = (velocity(h, &unused) - velocity(-h, &unused)) / (2 * h);
  EXPECT_GT(abs(gamma), Real(0.01));
  EXPECT_LE(abs(slope - gamma), Real("1e-20"));  // third derivative below 1e4, times h^2
}

}  // namespace
}  // namespace treedyn::equations
