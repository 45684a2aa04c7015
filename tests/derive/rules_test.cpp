// The rules of the derivation, one by one.
#include <algorithm>
#include <functional>
#include <initializer_list>
#include <numeric>
#include <set>
#include <string>

#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include "block/print.hpp"
#include "block/rewrite.hpp"
#include "derive/derivation_text.hpp"
#include "derive/derive.hpp"
#include "derive/forms.hpp"
#include "derive/words.hpp"
#include "equations/dot.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"

namespace treedyn::derive {
namespace {

using block::Expression;
using block::skew;
using block::skew_transpose;
using block::transpose;
using namespace equations;  // the symbols

const Expression N = D - E;
const Expression w = z_d * sigma * qd;

/// The values that the column needs, by operation.
std::vector<Op> operations(const Expression& e) {
  const Derivation derivation = derive(e, false);
  std::vector<Op> result;
  for (const int id : derivation.values.needed(derivation.roots)) {
    result.push_back(derivation.values[id].op);
  }
  return result;
}
auto count(const Expression& e, Op op) {
  const std::vector<Op> all = operations(e);
  return std::count(all.begin(), all.end(), op);
}
bool acts(const Expression& e, Rule rule) {
  return derive(e, false).values.acted().count(rule) > 0;
}
std::vector<std::string> texts(const Expression& e) {
  std::vector<std::string> result;
  const std::vector<Word> all = words(e, 100).value();
  for (const Word& word : all) {
    result.push_back(to_text(word));
  }
  return result;
}

TEST(R0, DistributesAndPushesTransposesDown) {
  EXPECT_EQ(texts(transpose(D * (m_d + sigma)) * qd),
            (std::vector<std::string>{"m^dT D^T q̇", "σ^T D^T q̇"}));
}

TEST(R1, TurnsReachabilityIntoSumsAlongTheTree) {
  EXPECT_EQ(count(D * qd, Op::kPath), 1);
  EXPECT_EQ(count(N * qd, Op::kPathStrict), 1);
  EXPECT_EQ(count(transpose(D) * qd, Op::kSubtree), 1);
  EXPECT_EQ(count((transpose(D) - E) * qd, Op::kSubtreeStrict), 1);
}

TEST(R1, LetsPathsTakeOverFromSubtreesInSumsOverAllLinks) {
  EXPECT_EQ(count(kinetic_energy(), Op::kSubtree), 0);
  EXPECT_EQ(count(kinetic_energy(), Op::kBackward), 0);
  EXPECT_EQ(count(kinetic_energy(), Op::kPath), 2);  // ω and v
  EXPECT_TRUE(derive(kinetic_energy(), false).values.acted().contains(Rule::kTransposes));
}

/// Σ (P_i + c_i)×f_i: the moment about the base origin of a force on every centre of mass.
Expression moment_of(const Expression& forces) {
  return transpose(ones) * skew(block::diagb(D * s_d * ones + c_d * ones)) * forces;
}

TEST(R1, LetsSubtreesTakeOverFromPlacesInSumsOverAllLinks) {
  const Expression moment = moment_of(m_d * D * z_d * qd);
  EXPECT_TRUE(acts(moment, Rule::kTransposes));
  EXPECT_EQ(count(moment, Op::kSubtree), 1);
  EXPECT_EQ(count(moment, Op::kPath), 1);  // of z q̇, none of s
  const Expression others = transpose(ones) * skew(block::diagb(D * qd_d * s_d * ones)) * w;
  EXPECT_FALSE(acts(others, Rule::kTransposes));
}

TEST(R1, LeavesSubtreesInWhatIsNotLinearInThem) {
  const Expression x = transpose(D) * w;
  EXPECT_FALSE(acts(transpose(x) * x, Rule::kTransposes));
  EXPECT_EQ(count(transpose(x) * x, Op::kSubtree), 1);
  EXPECT_FALSE(acts(transpose(D) * w, Rule::kTransposes));
}

TEST(R2, LetsSkewPassReachability) {
  EXPECT_EQ(texts(skew(D * z_d * sigma)), (std::vector<std::string>{"D Λ(z^d) σ"}));
  EXPECT_TRUE(acts(skew(D * z_d * sigma) * g, Rule::kSkewPasses));
  EXPECT_EQ(count(skew(D * z_d * sigma) * g, Op::kCross), 1);
}

TEST(R2, TurnsTwiceByOneBlock) {
  const Expression turns = skew(block::diagb(D * w));
  for (const Expression& e : {turns * turns * c_d * qd, turns * (turns * c_d * qd + z_d * qdd)}) {
    EXPECT_TRUE(acts(e, Rule::kTwiceTurned));
    EXPECT_EQ(count(e, Op::kSkewProduct), 1);
  }
  EXPECT_FALSE(acts(skew(block::diagb(w)) * skew(block::diagb(w)) * c_d * qd, Rule::kTwiceTurned));
  EXPECT_FALSE(acts(turns * skew(block::diagb(N * w)) * c_d * qd, Rule::kTwiceTurned));
}

TEST(R3, MeltsSumsIntoOne) {
  EXPECT_EQ(count(D * m_d * qd + D * qdd, Op::kPath), 1);
  EXPECT_EQ(operations(D * qd - D * qd), (std::vector<Op>{Op::kZero}));
  const Expression both = transpose(D) * qd + (transpose(D) - E) * qdd;
  EXPECT_EQ(count(both, Op::kBackward), 1);
  EXPECT_EQ(count(both, Op::kSubtree), 0);
  EXPECT_EQ(count(skew(s_d) * w + skew(s_d) * g, Op::kCross), 1);
}

TEST(R3, LeavesBiasForceOneBackwardSweepOfForcesAndOneOfMoments) {
  EXPECT_EQ(count(bias_force(), Op::kSubtree), 1);
  EXPECT_EQ(count(bias_force(), Op::kBackward), 1);
}

TEST(R4, TakesCrossWordsByBlocksOfThree) {
  const Expression word =
      skew_transpose(skew_transpose(joint_to_com_vectors()) * z_d * sigma * qd_d * D) * w;
  EXPECT_TRUE(acts(word, Rule::kCrossWords));
  EXPECT_FALSE(acts(word, Rule::kComponents));
}

TEST(R4, TakesNumbersMadeOfVectorsTimesVectorsByComponents) {
  const Expression all = mass_matrix() * (D * w);
  EXPECT_TRUE(acts(all, Rule::kBlownUp));
  EXPECT_EQ(count(all, Op::kAssemble), 1);
  EXPECT_FALSE(acts(D * sigma * (D * w), Rule::kBlownUp));  // numbers made of numbers
}

TEST(R5, TelescopesTheCentripetalTerms) {
  const Expression a = bias_matrix(centres_of_mass()) * w;
  EXPECT_TRUE(acts(a, Rule::kTelescope));
  const Derivation derivation = derive(a, false);
  for (const int id : derivation.values.needed(derivation.roots)) {
    const Value& value = derivation.values[id];
    if (value.op == Op::kSkewProduct) {  // Λ(ω)² alone
      EXPECT_EQ(value.operands[0], value.operands[1]);
    }
  }
}

TEST(R5, DoesNotTelescopeWhatIsNoDifference) {
  const Expression c = joint_to_com_vectors();
  const Expression half =  // (3), T3, without the fathers' part
      skew_transpose(skew_transpose(c) * z_d * sigma * qd_d * D) * w;
  EXPECT_FALSE(acts(half, Rule::kTelescope));
}

/// Values of the rows of a column for one point.
std::vector<Value> of_rows(const Expression& column, Op op) {
  const Derivation rows = derive_rows(column).value();
  std::vector<Value> result;
  for (const int id : rows.values.needed(rows.roots)) {
    if (rows.values[id].op == op) {
      result.push_back(rows.values[id]);
    }
  }
  return result;
}

TEST(R6, LetsRowsAndColumnsMeet) {
  const Derivation rows = derive_rows(point_bias_acceleration()).value();
  for (const Rule rule : {Rule::kMeet, Rule::kJacobi, Rule::kTransposes, Rule::kTwice}) {
    EXPECT_TRUE(rows.values.acted().contains(rule)) << row_of(rule).name;
  }
  EXPECT_TRUE(of_rows(point_bias_acceleration(), Op::kPath).empty());  // a point alone travels
  EXPECT_TRUE(of_rows(point_bias_acceleration(), Op::kPathStrict).empty());
  EXPECT_EQ(of_rows(point_bias_acceleration(), Op::kCross).size(), 2U);
  const Expression of_links = transpose(W) * J_d * D * w;  // a tensor stops the rows
  const Derivation stopped = derive_rows(of_links).value();
  EXPECT_TRUE(stopped.values.acted().contains(Rule::kMeet));
  EXPECT_EQ(of_rows(of_links, Op::kApply).size(), 1U);
}

TEST(F7, HandsOnSumsOfVelocities) {
  EXPECT_EQ(of_rows(point_bias_acceleration(), Op::kBackward).size(), 1U);  // places alone
  EXPECT_EQ(of_rows(point_bias_acceleration(), Op::kSubtreeStrict).size(), 1U);
}

TEST(R7, KeepsTheKindOfBlocks) {
  const Derivation C = derive(force_jacobian_transpose(points()), false);
  EXPECT_TRUE(C.wide);
  EXPECT_TRUE(C.values.acted().count(Rule::kKinds) > 0);
  for (const int id : C.values.needed(C.roots)) {  // the skew blocks travel as their vectors
    EXPECT_NE(C.values[id].type, Type::kTensor) << static_cast<int>(C.values[id].op);
  }
  EXPECT_FALSE(
      derive(transpose(skew(joint_to_com_vectors())) * skew(joint_to_com_vectors()), false).wide);
}

TEST(R7, LetsPointsTakeTheBlocksOfTheirLinks) {
  EXPECT_EQ(count(point_bias_acceleration(), Op::kPick), 2);  // a and Ω
}

TEST(R6, TakesColumnsOfSymmetricMatricesToTheRoot) {
  EXPECT_TRUE(derive(mass_matrix(), false, false).symmetric);
  EXPECT_TRUE(derive(transpose(D) * m_d * D, false).symmetric);
  const Expression J_v = velocity_jacobian(centres_of_mass());
  const Expression prismatic = (E - sigma) * transpose(z_d) * transpose(D) * m_d * J_v;
  EXPECT_FALSE(derive(prismatic, false, false).symmetric);
  EXPECT_FALSE(derive(D * m_d, false).symmetric);
}

TEST(R6, LeavesWhatReachesBelowTheColumnOnlyThroughItsFathers) {
  EXPECT_FALSE(derive(mass_matrix() * mass_matrix(), false, false).symmetric);
}

TEST(R6, LeavesSymmetricMatricesWhoseBranchesMeet) {
  const Expression C = force_jacobian_transpose(points());
  for (const Expression& dense : {D * transpose(D), ones * transpose(ones), qd * transpose(qd),
                                  C * transpose(C), transpose(D) * W * transpose(W) * D}) {
    EXPECT_FALSE(derive(dense, false).symmetric);
  }
}

/// Values of the derivation with an operation.
std::vector<Value> values_of(const Expression& e, Op op) {
  const Derivation derivation = derive(e, false, false);
  std::vector<Value> result;
  for (const int id : derivation.values.needed(derivation.roots)) {
    if (derivation.values[id].op == op) {
      result.push_back(derivation.values[id]);
    }
  }
  return result;
}

TEST(R7, MakesTwoSidedWordsComposites) {
  EXPECT_TRUE(values_of(mass_matrix(), Op::kPath).empty());  // nothing travels from the root
  EXPECT_TRUE(values_of(mass_matrix(), Op::kPathStrict).empty());
  EXPECT_EQ(values_of(mass_matrix(), Op::kSubtree).size(), 2U);  // m^c and the force of the column
  EXPECT_EQ(values_of(mass_matrix(), Op::kBackward).size(),
            2U);  // h^c and the moment of the column
  EXPECT_EQ(values_of(mass_matrix(), Op::kComposite).size(), 1U);
}

/// A factor C of B = C q̇ for which dA/dt - 2 C is skew.
Expression coriolis_matrix() {
  const Expression J_v = velocity_jacobian(centres_of_mass());
  const Expression J_w = angular_jacobian();
  const Expression omega = D * w;
  const Expression Lam = skew(diagb(omega));
  return transpose(J_v) * m_d * dot(J_v) + transpose(J_w) * J_d * dot(J_w) +
         block::Ratio{1, 2} *
             (transpose(J_w) * (Lam * J_d - J_d * Lam - skew(diagb(J_d * omega))) * J_w);
}

/// How often an operation occurs whose values do, or do not, depend on the column.
auto count_of_column(const Expression& e, Op op, bool of_column) {
  const Derivation derivation = derive(e, false, false);
  const std::vector<int> needed = derivation.values.needed(derivation.roots);
  return std::ranges::count_if(needed, [&](int id) {
    return derivation.values[id].op == op && derivation.values.of_unit(id) == of_column;
  });
}

TEST(R7, TakesBothSidesOfMatricesThatAreNotSymmetric) {
  const Derivation derivation = derive(coriolis_matrix(), false, false);
  EXPECT_FALSE(derivation.symmetric);
  EXPECT_TRUE(derivation.values.acted().contains(Rule::kComposites));
  // up: the force and the moment of the column; down: z, its rate and what moves with them
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kSubtree, true), 1);
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kBackward, true), 1);
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kPathStrict, true), 3);
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kPath, true), 0);
  // of all columns: m^c, h^c and I^c as in (2), the rates of h^c and of its moment
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kSubtree, false), 1);
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kBackward, false), 3);
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kComposite, false), 1);
}

/// The centroidal momentum matrix, its lower half: I^c and h^c as for A, nothing else travels.
TEST(R7, TakesSumsOverAllLinksByComposites) {
  const Expression r = D * s_d * ones + c_d * ones;
  const Expression J_v = velocity_jacobian(centres_of_mass());
  const Expression J_w = D * z_d * sigma;
  const Expression about_mean = skew(diagb(r - ones * (transpose(ones) * m_d * r)));
  const Expression e = transpose(ones) * (about_mean * m_d * J_v + J_d * J_w);
  const Derivation derivation = derive(e, false, false);
  EXPECT_TRUE(derivation.by_units && !derivation.by_rows);
  EXPECT_TRUE(derivation.values.acted().contains(Rule::kPlaceSums));
  EXPECT_EQ(count_of_column(e, Op::kComposite, false), 1);
  EXPECT_EQ(count_of_column(e, Op::kPath, false), 1);  // P
  for (const Op op :
       {Op::kPath, Op::kPathStrict, Op::kSubtree, Op::kSubtreeStrict, Op::kBackward}) {
    EXPECT_EQ(count_of_column(e, op, true), 0);
  }
}

TEST(R7, LeavesSumsWithoutTensorsToTheirRows) {
  const Expression momentum = transpose(ones) * m_d * velocity_jacobian(centres_of_mass());
  EXPECT_TRUE(derive(momentum, false, false).by_rows);
  const Expression one_row = transpose(g) * J_d * D * z_d * sigma;
  EXPECT_TRUE(derive(one_row, false, false).by_rows);
}

TEST(F8, WritesTurningTensorsWithPseudoInertias) {
  EXPECT_TRUE(derive(coriolis_matrix(), false, false).values.acted().contains(Rule::kTurned));
  const Expression J_w = angular_jacobian();
  const Expression Lam = skew(diagb(D * w));
  const Expression half = transpose(J_w) * (Lam * J_d - J_d * Lam) * J_w;  // without Λ(J_c ω)
  EXPECT_FALSE(derive(half, false, false).values.acted().contains(Rule::kTurned));
}

TEST(F9, LetsSpeedsBetweenLinksAloneTravelToTheRoot) {
  const Derivation derivation = derive(coriolis_matrix(), false, false);
  EXPECT_TRUE(derivation.values.acted().contains(Rule::kRelative));
  EXPECT_TRUE(derivation.values.acted().contains(Rule::kMomentum));
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kPseudo, false), 1);   // E^c, no E of links
  EXPECT_EQ(count_of_column(coriolis_matrix(), Op::kProduct, false), 2);  // with w and ω_f
}

/// D, N and X on a forest, entry by entry.
class Enclosed : public testing::TestWithParam<std::vector<int>> {
 protected:
  using Matrix = std::vector<std::vector<int>>;

  Enclosed() : n_(GetParam().size()), D_(n_, std::vector<int>(n_)), N_(D_), X_(D_) {
    for (std::size_t i = 0; i < n_; ++i) {
      X_[i][i] = static_cast<int>(3 * i * i + 7 * i + 1) % 23;
      for (int j = static_cast<int>(i); j >= 0; j = GetParam()[static_cast<std::size_t>(j)]) {
        D_[i][static_cast<std::size_t>(j)] = 1;
        N_[i][static_cast<std::size_t>(j)] = j == static_cast<int>(i) ? 0 : 1;
      }
    }
  }
  static Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c(a.size(), std::vector<int>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < a.size(); ++j) {
        for (std::size_t k = 0; k < a.size(); ++k) {
          c[i][j] += a[i][k] * b[k][j];
        }
      }
    }
    return c;
  }
  static Matrix sum(Matrix a, const Matrix& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < a.size(); ++j) {
        a[i][j] += b[i][j];
      }
    }
    return a;
  }
  static Matrix turned(const Matrix& a) {
    Matrix c = a;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < a.size(); ++j) {
        c[i][j] = a[j][i];
      }
    }
    return c;
  }
  /// diagb(M^T x), X = diagb(x).
  [[nodiscard]] Matrix composite(const Matrix& M) const {
    Matrix c(n_, std::vector<int>(n_));
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) {
        c[i][i] += M[k][i] * X_[k][k];
      }
    }
    return c;
  }

  std::size_t n_;
  Matrix D_, N_, X_;
};

TEST_P(Enclosed, SumsAreUpperAndLowerOnes) {
  const Matrix whole = composite(D_);
  const Matrix below = composite(N_);
  const Matrix DT = turned(D_);
  const Matrix NT = turned(N_);
  EXPECT_EQ(product(product(DT, X_), D_), sum(product(DT, whole), product(whole, N_)));
  EXPECT_EQ(product(product(DT, X_), N_), sum(product(DT, below), product(whole, N_)));
  EXPECT_EQ(product(product(NT, X_), N_), sum(product(DT, below), product(below, N_)));
  EXPECT_EQ(product(product(NT, X_), D_), sum(sum(product(NT, whole), below), product(below, N_)));
}

/// F9 is bilinear in h, m s and w: that it holds for numbers of either is enough.
TEST_P(Enclosed, RatesAreThoseOfSpeedsBetweenLinks) {
  const auto times = [this](const Matrix& M, const std::vector<int>& x) {
    std::vector<int> y(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) {
        y[i] += M[i][j] * x[j];
      }
    }
    return y;
  };
  const auto each = [this](const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> y(n_);
    std::ranges::transform(a, b, y.begin(), std::multiplies());
    return y;
  };
  const auto plus = [this](const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<int> y(n_);
    std::ranges::transform(a, b, y.begin(), std::plus());
    return y;
  };
  std::vector<int> h(n_);
  std::vector<int> ms(n_);
  std::vector<int> speeds(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const int k = static_cast<int>(i);
    h[i] = 7 * k * k - 3 * k + 2;
    ms[i] = 5 * k - 11;
    speeds[i] = k * k * k - 13 * k + 4;
  }
  const Matrix DT = turned(D_);
  const Matrix NT = turned(N_);
  const std::vector<int> omega_f = times(N_, speeds);
  const std::vector<int> h_c = plus(times(DT, h), times(NT, ms));
  EXPECT_EQ(plus(times(DT, each(times(D_, speeds), h)), times(NT, each(omega_f, ms))),
            plus(each(omega_f, h_c), times(DT, each(speeds, h_c))));
}

/// R7'' is bilinear in s and y: that it holds for numbers is enough.
TEST_P(Enclosed, SumsOfPlacesAreThoseOfLevers) {
  const auto with = [this](const std::vector<int>& diagonal) {
    Matrix m(n_, std::vector<int>(n_));
    for (std::size_t i = 0; i < n_; ++i) {
      m[i][i] = diagonal[i];
    }
    return m;
  };
  std::vector<int> s(n_);
  std::vector<int> places(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    s[i] = static_cast<int>(i * i) - 5 * static_cast<int>(i) + 3;
  }
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = 0; j < n_; ++j) {
      places[i] += D_[i][j] * s[j];
    }
  }
  const std::vector<int> ones(n_, 1);
  const auto column = [&](const Matrix& m) {  // m 1
    std::vector<int> y(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      y[i] = std::inner_product(m[i].begin(), m[i].end(), ones.begin(), 0);
    }
    return y;
  };
  const Matrix below = product(turned(N_), product(with(s), with(column(product(turned(D_), X_)))));
  for (const Matrix& M : {D_, N_}) {
    const Matrix moments = product(turned(M), product(with(places), X_));
    const Matrix sums = product(with(places), with(column(product(turned(M), X_))));
    EXPECT_EQ(column(moments), column(sum(sums, below)));
  }
}

INSTANTIATE_TEST_SUITE_P(Forests, Enclosed,
                         testing::Values(std::vector<int>{-1, 0, 1, 2, 3},
                                         std::vector<int>{-1, 0, 0, 1, 1, 2, 4},
                                         std::vector<int>{-1, -1, 0, 1, 3, 3, 2, 6}));

TEST(R7, ReadsPointsBackwards) {
  const auto v = derive_rows(point_velocities());
  ASSERT_TRUE(v.has_value());
  for (const int id : v->values.needed(v->roots)) {
    EXPECT_NE(v->values[id].op, Op::kPath);  // nothing travels from the root
  }
  EXPECT_FALSE(derive_rows(transpose(W) * D * qd).has_value());
}

TEST(R3, KeepsSumsOverLinksAndOverPointsApart) {
  EXPECT_EQ(
      count(transpose(ones) * m_d * c_d * ones + transpose(ones_P) * t_d * ones_P, Op::kCollect),
      2);
}

TEST(R3, LetsWhatIsCommonLeaveSums) {
  const std::vector<Op> G = operations(gravity_force());
  EXPECT_EQ(std::count(G.begin(), G.end(), Op::kBackward), 1);  // first moments: h^c
  EXPECT_EQ(std::count(G.begin(), G.end(), Op::kSubtree), 1);   // masses: m^c
  const std::vector<Op> U = operations(potential_energy());
  EXPECT_EQ(std::count(U.begin(), U.end(), Op::kPath), 0);
  EXPECT_EQ(std::count(U.begin(), U.end(), Op::kCollect), 1);
}

TEST(R3, LetsRowsOfAllLinksShareTheirSums) {
  const Expression momentum = transpose(ones) * m_d * velocity_jacobian(centres_of_mass());
  EXPECT_EQ(count_of_column(momentum, Op::kSubtree, false), 1);   // m^c of three rows
  EXPECT_EQ(count_of_column(momentum, Op::kBackward, false), 1);  // h^c
}

void expect_no_centres(std::initializer_list<Expression> expressions) {
  for (const Expression& e : expressions) {
    const Derivation derivation = derive(e, false, false);
    for (const int id : derivation.values.needed(derivation.roots)) {
      EXPECT_NE(derivation.values[id].name, "c^d");
      EXPECT_NE(derivation.values[id].name, "J_c^d");
    }
  }
}

TEST(R10, MakesMassesTimesCentresFirstMoments) {
  expect_no_centres({gravity_force(), potential_energy(), bias_force(), inverse_dynamics()});
}

/// Angular momentum has no centres left, about any point.
TEST(R10, MakesMomentsOfMomentaInertias) {
  const Expression J_v = velocity_jacobian(centres_of_mass());
  const Expression rest = J_d * (D * w);
  const Expression mean = transpose(ones) * m_d * (D * s_d * ones + c_d * ones);
  const Expression about_mean =
      transpose(ones) * skew(block::diagb(D * s_d * ones + c_d * ones - ones * mean));
  expect_no_centres({moment_of(m_d * J_v * qd) + transpose(ones) * rest,
                     about_mean * m_d * J_v * qd + transpose(ones) * rest,
                     about_mean * m_d * J_v + transpose(ones) * J_d * D * z_d * sigma});
}

TEST(R10, KeepsCentresWhoseTermsDoNotMakeUpAnInertia) {
  const Expression half = transpose(D) * skew(c_d) * (D * w) + transpose(D) * m_d * c_d * qd;
  EXPECT_EQ(count(half, Op::kCross), 1);
  const Expression too_much = transpose(skew(c_d)) * m_d * skew(c_d) * w + J_d * w + J_d * w;
  const Derivation derivation = derive(too_much, false, false);
  std::set<std::string> names;
  for (const int id : derivation.values.needed(derivation.roots)) {
    names.insert(derivation.values[id].name);
  }
  EXPECT_TRUE(names.contains("I^d"));
  EXPECT_TRUE(names.contains("J_c^d"));
}

TEST(F1, PutsSlidingJointsIntoTheirLinks) {
  const auto names = [](bool keeps_joints) {
    const Derivation derivation = derive(joint_to_com_vectors(), false, keeps_joints);
    std::set<std::string> result;
    for (const int id : derivation.values.needed(derivation.roots)) {
      result.insert(derivation.values[id].name);
    }
    return result;
  };
  EXPECT_TRUE(names(true).contains("l^d"));
  EXPECT_FALSE(names(false).contains("l^d"));
}

TEST(F1, TakesTheSlidesOfJointsIntoTheRatesOfTheirPlaces) {
  const auto slides = [](bool keeps_joints) {
    const Derivation derivation =
        derive(dot(velocity_jacobian(centres_of_mass())) * qd, false, keeps_joints);
    std::set<Op> result;
    for (const int id : derivation.values.needed(derivation.roots)) {
      const Value& v = derivation.values[id];
      if (v.op == Op::kFather) {
        result.insert(derivation.values[v.operands.front()].op);
      }
    }
    return result;
  };
  EXPECT_TRUE(slides(true).contains(Op::kScale));    // s has the slide of the father
  EXPECT_FALSE(slides(false).contains(Op::kScale));  // s has its own
}

TEST(F2, LetsPathsStartWithGravity) {
  const std::vector<Value> paths = values_of(inverse_dynamics(), Op::kPath);  // ω, α and a
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(std::count_if(paths.begin(), paths.end(),
                          [](const Value& v) { return v.operands.size() == 2; }),
            1);
  EXPECT_EQ(values_of(inverse_dynamics(), Op::kSubtree).size(),
            1U);  // no sums of masses beside forces
  EXPECT_EQ(values_of(inverse_dynamics(), Op::kBackward).size(), 1U);
}

TEST(F3, TakesTurningTensorsFromFathers) {
  EXPECT_EQ(values_of(inverse_dynamics(), Op::kFather).size(), 1U);
  EXPECT_EQ(values_of(inverse_dynamics(), Op::kSkewProduct).size(), 1U);  // Λ(ω)², none of ω_f
}

TEST(F4, WritesMomentsWithPseudoInertias) {
  EXPECT_EQ(values_of(inverse_dynamics(), Op::kMoment).size(), 1U);
  EXPECT_EQ(count(transpose(D) * J_d * D * w, Op::kMoment), 0);
}

TEST(F4, FindsJointsThatTurnAboutTheirAxes) {
  const auto turnings = [](const Expression& e) {
    const Derivation derivation = derive(e, false, false);
    return turnings_about_axes(derivation.values, derivation.values.needed(derivation.roots))
        .size();
  };
  EXPECT_EQ(turnings(inverse_dynamics()), 1U);
  EXPECT_EQ(turnings(bias_force()), 1U);
  const Expression alpha = D * diagb(z_d * sigma * qdd + 2 * w) * ones;
  EXPECT_EQ(turnings(skew(diagb(alpha)) * g), 0U);
}

TEST(F6, WritesEnergiesWithPseudoInertias) {
  const auto squares = [](const Expression& e) {
    const Derivation derivation = derive(e, false, false);
    const std::vector<int> needed = derivation.values.needed(derivation.roots);
    return std::count_if(needed.begin(), needed.end(),
                         [&](int id) { return derivation.values[id].op == Op::kSquare; });
  };
  EXPECT_EQ(squares(kinetic_energy()), 1);
  EXPECT_EQ(squares(transpose(D * w) * J_d * D * w), 0);
}

/// Values of a system that R9 solves for q̈; nothing if it does not act.
std::optional<std::vector<Value>> of_solved(const Expression& system) {
  const auto derivation = solved(derive(system, false, false), "q̈");
  if (!derivation) {
    return std::nullopt;
  }
  std::vector<Value> result;
  for (const int id : derivation->values.needed(derivation->roots)) {
    result.push_back(derivation->values[id]);
  }
  return result;
}

TEST(R9, EliminatesJointByJoint) {
  const std::vector<Value> all = of_solved(forward_dynamics()).value();
  const auto count = [&](Op op) {
    return std::count_if(all.begin(), all.end(), [op](const Value& v) { return v.op == op; });
  };
  EXPECT_EQ(count(Op::kFold), 5);        // inertia in three blocks and bias in two
  EXPECT_EQ(count(Op::kReciprocal), 1);  // one pivot a joint
  EXPECT_EQ(count(Op::kPath), 1);        // ω; what accelerates travels after the elimination
  EXPECT_EQ(count(Op::kSubtree) + count(Op::kBackward) + count(Op::kComposite), 0);
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [](const Value& v) { return v.name == "q̈"; }));
  EXPECT_TRUE(of_solved(mass_matrix() * qdd - tau).has_value());
}

/// Lines of a derivation with the rules behind them.
std::map<std::string, std::set<Rule>> rules_of_lines(const Derivation& derivation) {
  std::map<std::string, std::set<Rule>> result;
  for (const Line& line : lines(derivation)) {
    result.emplace(line.text, line.rules);
  }
  return result;
}

TEST(Lines, NameTheRulesThatMadeThem) {
  const auto of_A = rules_of_lines(derive(mass_matrix(), false, false));
  EXPECT_EQ(of_A.at("m^c = D^T m^d"), (std::set{Rule::kSums, Rule::kComposites}));
  const auto has = [](const std::set<Rule>& rules, std::initializer_list<Rule> wanted) {
    return std::ranges::all_of(wanted, [&](Rule rule) { return rules.contains(rule); });
  };
  bool composite = false;
  for (const auto& [text, rules] : of_A) {
    if (text.starts_with("I^c = ")) {
      composite = true;
      EXPECT_TRUE(has(rules, {Rule::kSums, Rule::kMerge, Rule::kComposites, Rule::kComposite}))
          << text;
    }
    EXPECT_FALSE(rules.contains(Rule::kTelescope)) << text;
  }
  EXPECT_TRUE(composite);
  const auto of_tau = rules_of_lines(derive(inverse_dynamics(), false, false));
  EXPECT_EQ(std::ranges::count_if(
                of_tau, [](const auto& line) { return line.second.contains(Rule::kTelescope); }),
            1);  // Λ(ω)²
}

/// No rule that made something is lost on the way to the lines; F1 leaves nothing.
TEST(Lines, NameEveryRuleThatActed) {
  for (const Expression& e :
       {mass_matrix(), bias_force(), gravity_force(), inverse_dynamics(), kinetic_energy(),
        potential_energy(), point_positions(), point_velocities(), point_bias_acceleration(),
        force_jacobian_transpose(points()), coriolis_matrix()}) {
    const Derivation derivation = derive(e, false, false);
    std::set<Rule> named = {Rule::kPlaces};
    for (const Line& line : lines(derivation)) {
      named.insert(line.rules.begin(), line.rules.end());
    }
    for (const Rule rule : derivation.values.acted()) {
      EXPECT_TRUE(named.contains(rule)) << block::print(e) << ": " << row_of(rule).name;
    }
  }
}

/// Those of the elimination have the rules of what it takes apart; R0 and R5 act on sums.
TEST(Lines, NameTheRulesOfWhatIsEliminated) {
  const Derivation derivation = solved(derive(forward_dynamics(), false, false), "q̈").value();
  std::set<Rule> named = {Rule::kPlaces};
  for (const Line& line : lines(derivation)) {
    named.insert(line.rules.begin(), line.rules.end());
  }
  EXPECT_EQ(derivation.values.acted(), named);
}

/// α of the velocities and of all, M of a column and its rate: a reader sees which is which.
TEST(Lines, NameValuesApart) {
  for (const Expression& e :
       {dot(bias_force()), dot(mass_matrix()), inverse_dynamics(), coriolis_matrix()}) {
    std::set<std::string> names;
    for (const Line& line : lines(derive(e, false, false))) {
      const std::string name = line.text.substr(0, line.text.find(" = "));
      EXPECT_TRUE(names.insert(name).second) << block::print(e) << ": " << line.text;
    }
  }
}

TEST(R9, SolvesSymmetricMatricesAlone) {
  EXPECT_FALSE(of_solved(forward_dynamics() + (E - sigma) * mass_matrix() * qdd).has_value());
  EXPECT_FALSE(of_solved(sigma * mass_matrix() * qdd - tau).has_value());
  EXPECT_FALSE(of_solved(transpose(D) * m_d * D * qdd - tau).has_value());
  EXPECT_FALSE(of_solved(D * qdd - tau).has_value());
}

TEST(R9, HasTheRulesInItsDerivation) {
  const auto derivation = solved(derive(forward_dynamics(), false, false), "q̈").value();
  for (const Rule rule : {Rule::kElimination, Rule::kYields}) {
    EXPECT_TRUE(derivation.values.acted().contains(rule)) << row_of(rule).name;
  }
}

/// Identities that the rules rest on, for all vectors.
class Identities : public testing::Test {
 protected:
  using Matrix = GiNaC::matrix;

  static Matrix vector(const std::string& name) {
    Matrix v(3, 1);
    for (unsigned k = 0; k < 3; ++k) {
      v(k, 0) = GiNaC::symbol(name + std::to_string(k));
    }
    return v;
  }
  static Matrix symmetric(const std::string& name) {
    Matrix m(3, 3);
    for (unsigned i = 0; i < 3; ++i) {
      for (unsigned j = i; j < 3; ++j) {
        m(i, j) = m(j, i) = GiNaC::symbol(name + std::to_string(3 * i + j));
      }
    }
    return m;
  }
  static Matrix lambda(const Matrix& a) {
    return {{0, -a(2, 0), a(1, 0)}, {a(2, 0), 0, -a(0, 0)}, {-a(1, 0), a(0, 0), 0}};
  }
  static Matrix cross(const Matrix& a, const Matrix& b) { return lambda(a).mul(b); }
  static bool equal(const Matrix& a, const Matrix& b) {
    const Matrix difference = a.sub(b);
    for (std::size_t n = 0; n < difference.nops(); ++n) {
      if (!difference.op(n).expand().is_zero()) {
        return false;
      }
    }
    return true;
  }

  const Matrix alpha_ = vector("a");
  const Matrix omega_ = vector("w");
  const Matrix c_ = vector("c");
  const GiNaC::symbol m_{"m"};
  const Matrix steiner_ = lambda(c_).mul(lambda(c_)).mul_scalar(-m_);  // I - J_c
};

TEST_F(Identities, OfR10) {
  const Matrix h = c_.mul_scalar(m_);
  EXPECT_TRUE(equal(cross(c_, cross(alpha_, h)), steiner_.mul(alpha_)));
  EXPECT_TRUE(
      equal(cross(c_, cross(omega_, cross(omega_, h))), cross(omega_, steiner_.mul(omega_))));
  EXPECT_TRUE(
      equal(cross(c_, cross(alpha_, omega_.mul_scalar(m_))), cross(h, cross(alpha_, omega_))));
}

TEST_F(Identities, OfWhatTurnsTwice) {
  const Matrix square = lambda(omega_).mul(lambda(omega_));
  EXPECT_TRUE(equal(cross(omega_, cross(omega_, c_)), square.mul(c_)));
  EXPECT_TRUE(equal(cross(cross(omega_, c_), omega_), square.mul(c_).mul_scalar(-1)));
}

TEST_F(Identities, OfJacobi) {
  EXPECT_TRUE(equal(cross(cross(alpha_, omega_), c_),
                    cross(alpha_, cross(omega_, c_)).sub(cross(omega_, cross(alpha_, c_)))));
}

TEST_F(Identities, OfF4) {
  const Matrix pseudo = symmetric("E");
  const GiNaC::ex trace = pseudo(0, 0) + pseudo(1, 1) + pseudo(2, 2);
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Matrix I = one.mul_scalar(trace).sub(pseudo);
  const Matrix p = lambda(alpha_).add(lambda(omega_).mul(lambda(omega_))).mul(pseudo);
  const Matrix vee{{p(2, 1) - p(1, 2)}, {p(0, 2) - p(2, 0)}, {p(1, 0) - p(0, 1)}};
  EXPECT_TRUE(equal(I.mul(alpha_).add(cross(omega_, I.mul(omega_))), vee));
}

TEST_F(Identities, OfF8) {
  const Matrix J_c = symmetric("J");
  const Matrix I = J_c.add(steiner_);
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Matrix pseudo = one.mul_scalar(I.trace() / 2).sub(I);
  const Matrix L = lambda(omega_);
  const Matrix turned = L.mul(J_c).sub(J_c.mul(L)).sub(lambda(J_c.mul(omega_)));
  const Matrix lever = lambda(c_).mul(lambda(cross(omega_, c_.mul_scalar(m_))));
  EXPECT_TRUE(
      equal(turned.mul_scalar(GiNaC::numeric(1, 2)).sub(lever), L.mul(pseudo).mul_scalar(-1)));
}

TEST_F(Identities, OfF9) {
  const Matrix h = vector("h");
  const Matrix s = vector("s");
  const Matrix rates =
      lambda(s).mul(lambda(cross(omega_, h))).add(lambda(h).mul(lambda(cross(omega_, s))));
  const Matrix both = h.mul(s.transpose()).add(s.mul(h.transpose()));
  EXPECT_TRUE(equal(rates, lambda(omega_).mul(both)));
  const Matrix pseudo = symmetric("E");
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Matrix I = one.mul_scalar(pseudo.trace()).sub(pseudo);
  EXPECT_TRUE(equal(I.mul(cross(omega_, c_)).sub(cross(omega_, pseudo.mul(c_))),
                    cross(pseudo.mul(omega_), c_)));
}

TEST_F(Identities, OfF5) {
  const Matrix& h = alpha_;
  const Matrix& s = omega_;
  const Matrix ms = s.mul_scalar(m_);
  const Matrix shift = lambda(h).mul(lambda(s)).add(lambda(s).mul(lambda(h.add(ms))));
  const Matrix F = h.mul(s.transpose()).add(s.mul(h.transpose())).add(ms.mul(s.transpose()));
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_TRUE(equal(shift.mul_scalar(-1), one.mul_scalar(F.trace()).sub(F)));
}

/// R7': what a father takes of a body, X^T M X, keeps the kinds of its blocks: m E, Λ(h), I = I^T.
TEST_F(Identities, OfTheKindsOfComposites) {
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Matrix I = symmetric("I");
  const Matrix h = vector("h");
  const Matrix s = vector("s");
  const Matrix mass = one.mul_scalar(m_);
  const Matrix shift = lambda(s);  // y_1 has Λ^T(s) y_0 of the father
  const Matrix mixed = lambda(h).add(shift.mul(mass));
  const Matrix turning = I.add(shift.mul(lambda(h).transpose())).sub(mixed.mul(shift));
  EXPECT_TRUE(equal(mixed, lambda(h.add(s.mul_scalar(m_)))));
  EXPECT_TRUE(equal(turning, turning.transpose()));
  const Matrix sum = lambda(h).add(lambda(s));  // and so do sums of them
  EXPECT_TRUE(equal(sum, lambda(h.add(s))));
}

TEST_F(Identities, OfF6) {
  const Matrix pseudo = symmetric("E");
  const Matrix one{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Matrix I = one.mul_scalar(pseudo.trace()).sub(pseudo);
  const Matrix energy = omega_.transpose().mul(I).mul(omega_);
  const Matrix square = lambda(omega_).mul(lambda(omega_)).mul(pseudo);
  EXPECT_TRUE(equal(energy, Matrix{{-square.trace()}}));
}

/// K' = K - U U^T / d, p' = p + U u / d.
TEST_F(Identities, OfTheJointThatYields) {
  const Matrix K = symmetric("K");
  const Matrix& b = alpha_;
  const Matrix& p = omega_;
  const GiNaC::symbol r("r");
  const Matrix U = K.mul(b);
  const GiNaC::ex d = b.transpose().mul(U)(0, 0);
  const GiNaC::ex u = r - b.transpose().mul(p)(0, 0);
  const Matrix without = K.mul_scalar(d).sub(U.mul(U.transpose()));  // d K'
  EXPECT_TRUE(equal(without.mul(b), Matrix(3, 1)));
  EXPECT_TRUE(equal(b.transpose().mul(p.mul_scalar(d).add(U.mul_scalar(u))), Matrix{{d * r}}));
  const Matrix y = vector("y");  // b·(K (y + b x) + p) = r, and what is left is K' y + p'
  const GiNaC::ex dx = u - U.transpose().mul(y)(0, 0);
  const Matrix force = K.mul(y.mul_scalar(d).add(b.mul_scalar(dx))).add(p.mul_scalar(d));
  EXPECT_TRUE(equal(b.transpose().mul(force), Matrix{{d * r}}));
  EXPECT_TRUE(equal(force, without.mul(y).add(p.mul_scalar(d)).add(U.mul_scalar(u))));
}

/// X^T K X for y_1 += Λ^T(s) y_0 of the father.
TEST_F(Identities, OfWhatFathersTake) {
  const Matrix I = symmetric("I");
  const Matrix M = symmetric("M");
  const Matrix S = lambda(c_);
  const Matrix H{{GiNaC::symbol("a"), GiNaC::symbol("b"), GiNaC::symbol("c")},
                 {GiNaC::symbol("d"), GiNaC::symbol("e"), GiNaC::symbol("f")},
                 {GiNaC::symbol("g"), GiNaC::symbol("h"), GiNaC::symbol("i")}};
  const Matrix H_father = S.mul(M).add(H);
  const Matrix I_father = S.mul(H.transpose()).sub(H_father.mul(S)).add(I);
  const Matrix y0 = alpha_;
  const Matrix y1 = omega_.add(S.transpose().mul(y0));
  const Matrix F = H.transpose().mul(y0).add(M.mul(y1));
  const Matrix moment = I.mul(y0).add(H.mul(y1)).add(S.mul(F));
  EXPECT_TRUE(equal(moment, I_father.mul(y0).add(H_father.mul(omega_))));
  EXPECT_TRUE(equal(F, H_father.transpose().mul(y0).add(M.mul(omega_))));
}

TEST_F(Identities, OfTheCommonColumn) {
  const Matrix z = vector("z");
  const GiNaC::symbol x("x");
  const GiNaC::symbol y("y");
  const Matrix own = z.mul_scalar(y);
  const Matrix omega = omega_.add(own);
  const Matrix alpha = alpha_.add(z.mul_scalar(x)).add(cross(omega_, own));
  const auto Omega = [](const Matrix& a, const Matrix& b) {
    return lambda(a).add(lambda(b).mul(lambda(b)));
  };
  EXPECT_TRUE(equal(Omega(alpha, omega).mul(z), Omega(alpha_, omega_).mul(z)));
}

TEST(F1, ActsWhereNoPlaceOfASlidingJointIsReferredTo) {
  for (const Expression& e :
       {mass_matrix(), bias_force(), gravity_force(), inverse_dynamics(), applied_force(),
        point_positions(), point_velocities(), point_bias_acceleration(), potential_energy(),
        force_jacobian_transpose(points()), bias_force() + gravity_force()}) {
    EXPECT_FALSE(refers_to_places(e)) << block::print(e);
  }
  for (const Expression& e :
       {joint_to_link_vectors(), joint_to_com_vectors(), D * s_d * (D - E) * qd, l_d * D * qd,
        sigma * D * s_d * (D - E) * qd, skew(l_d * D) * z_d * (E - sigma), D * l_d * qd}) {
    EXPECT_TRUE(refers_to_places(e)) << block::print(e);
  }
}

const Expression x = leaf("x", block::Structure::kFull, {kLinks, kOne});
const Expression b = leaf("b", block::Structure::kFull, {kLinks, kOne});

/// Operations of the numbers for which the equation is zero.
std::vector<Op> of_numbers(const Expression& equation, const std::string& unknown) {
  const Factored f = factored(equation, unknown).value();
  std::vector<Op> result;
  for (const int id : f.derivation.values.needed(f.derivation.roots)) {
    result.push_back(f.derivation.values[id].op);
  }
  return result;
}

TEST(R12, FactorsSymmetricMatrices) {
  for (const auto& [equation, unknown] : {std::pair{mass_matrix_factor(), "L"},
                                          {mass_matrix_solve(), "x"},
                                          {mass_matrix_inverse(), "X"},
                                          {forward_dynamics(), "q̈"},
                                          {transpose(D) * m_d * D * x - b, "x"}}) {
    const Factored f = factored(equation, unknown).value();
    EXPECT_TRUE(f.derivation.values.acted().contains(Rule::kFactors)) << unknown;
    const std::vector<Op> all = of_numbers(equation, unknown);
    EXPECT_EQ(std::count(all.begin(), all.end(), Op::kEliminated), 1) << unknown;
    EXPECT_EQ(f.given.back().first, "A");
  }
}

TEST(R12, TakesWhatIsKnownAsOneColumn) {
  const Factored f = factored(forward_dynamics(), "q̈").value();
  ASSERT_EQ(f.given.size(), 2U);
  EXPECT_EQ(f.given[0].first, "h");
  EXPECT_TRUE(block::equal(f.given[0].second, bias_force() + gravity_force()));
  EXPECT_TRUE(block::equal(f.given[1].second, mass_matrix()));
}

TEST(R12, SolvesTrianglesFromTheirEnds) {
  const Expression L = leaf("L", block::Structure::kAlongPaths, {kLinks, kLinks});
  EXPECT_EQ(of_numbers(transpose(L) * x - b, "x").back(), Op::kFromLeaves);
  EXPECT_EQ(of_numbers(L * x - b, "x").back(), Op::kFromRoot);
}

TEST(R12, EliminatesAccelerationsFromRows) {
  const auto& [motion, rows] = constrained_dynamics();
  const Factored f = constrained(motion, rows, "q̈", "λ").value();
  EXPECT_TRUE(f.derivation.values.acted().contains(Rule::kReactions));
  ASSERT_EQ(f.given.size(), 4U);
  EXPECT_EQ(f.given[0].first, "h");
  EXPECT_TRUE(block::equal(f.given[0].second, bias_force() + gravity_force() - applied_force()));
  EXPECT_EQ(f.given[1].first, "γ");
  EXPECT_TRUE(block::equal(f.given[2].second, reaction_jacobian_transpose()));
  EXPECT_TRUE(block::equal(f.given[3].second, mass_matrix()));
  ASSERT_EQ(f.derivation.roots.size(), 3U);
  EXPECT_EQ(f.derivation.values[f.derivation.roots[0]].op, Op::kCongruence);
  EXPECT_EQ(f.derivation.values[f.derivation.roots[2]].op, Op::kFromRoot);
}

TEST(R0, GivesUpOnTooManyWordsBeforeTheyAreMade) {
  Expression sum = qd;
  for (int k = 0; k < 4000; ++k) {
    sum = sum + qd;
  }
  EXPECT_FALSE(words(transpose(sum) * sum, 10000));  // 16 million
  EXPECT_EQ(words(transpose(qd) * sum, 10000).value().size(), 4001U);
  EXPECT_FALSE(words(sum, 4000));
}

TEST(R12, TakesTheLeastReactionsOfAMotion) {
  const auto& [passive, drives] = constrained_inverse_dynamics();
  const Factored f = least(passive, drives, "λ", "μ").value();
  EXPECT_TRUE(f.derivation.values.acted().contains(Rule::kLeast));
  ASSERT_EQ(f.given.size(), 2U);
  EXPECT_TRUE(block::equal(f.given[0].second, reaction_jacobian_transpose()));
  EXPECT_TRUE(block::equal(block::unnamed(f.given[1].second), loaded_dynamics()));
  ASSERT_EQ(f.derivation.roots.size(), 4U);
  EXPECT_EQ(f.derivation.values[f.derivation.roots[0]].op, Op::kCongruence);
  EXPECT_EQ(f.derivation.values[f.derivation.roots[3]].op, Op::kLinear);
  const Expression h = named("h", loaded_dynamics());
  const Expression M = transpose(E_u) * reaction_jacobian_transpose();
  EXPECT_FALSE(least(M * lambda, drives, "λ", "μ"));  // nothing to be equal to
  EXPECT_FALSE(least(M * lambda - transpose(E_u) * (D * qdd), drives, "λ", "μ"));
  EXPECT_FALSE(least(-(M * lambda) + transpose(E_u) * h, drives, "λ", "μ"));
}

TEST(R12, LeavesRowsThatAreNotThoseOfTheReactions) {
  const auto& [motion, rows] = constrained_dynamics();
  EXPECT_FALSE(
      constrained(motion, 2 * (transpose(reaction_jacobian_transpose()) * qdd) - a_des, "q̈", "λ"));
  EXPECT_FALSE(constrained(motion, transpose(S_f) * point_bias_acceleration() - a_des, "q̈", "λ"));
  EXPECT_FALSE(constrained(motion + 2 * (reaction_jacobian_transpose() * lambda), rows, "q̈", "λ"));
}

TEST(R0, MultipliesWhatIsDerivedByDirections) {
  const Factored J = with_directions(reaction_jacobian_transpose()).value();
  ASSERT_EQ(J.given.size(), 2U);
  EXPECT_TRUE(block::equal(J.given[0].second, force_jacobian_transpose(points())));
  EXPECT_TRUE(block::equal(J.given[1].second, moment_jacobian_transpose(points())));
  const Factored gamma = with_directions(bias_of_attached_rows()).value();
  ASSERT_EQ(gamma.given.size(), 2U);
  EXPECT_TRUE(block::equal(gamma.given[0].second, point_bias_acceleration()));
  EXPECT_TRUE(block::equal(gamma.given[1].second, angular_bias_acceleration()));
  EXPECT_FALSE(with_directions(reaction_bias_acceleration()));  // directions that move
  EXPECT_FALSE(with_directions(mass_matrix()));
}

TEST(R12, LeavesOtherEquations) {
  EXPECT_FALSE(factored(D * x - b, "x"));                        // not symmetric
  EXPECT_FALSE(factored(transpose(D) * m_d * x - b, "x"));       // not symmetric
  EXPECT_FALSE(factored(mass_matrix() * x + m_d * x - b, "x"));  // two terms
  EXPECT_FALSE(factored(mass_matrix() * b, "x"));                // none
  EXPECT_FALSE(factored(-(mass_matrix() * x) - b, "x"));         // -A has other pivots
  EXPECT_FALSE(factored(mass_matrix() * x, "x"));                // nothing to solve for
}

TEST(R11, KnowsThatReachabilityAndMassesAreConstant) {
  EXPECT_EQ(operations(dot(D * m_d) * qd), (std::vector<Op>{Op::kZero}));
  EXPECT_THROW(dot(tau), NoRate);
}

TEST(R11, GivesTheBiasOfTheJacobianWithoutBlocksOfThree) {
  const Expression rate = dot(velocity_jacobian(centres_of_mass())) * qd;
  EXPECT_FALSE(acts(rate, Rule::kCrossWords));
  EXPECT_FALSE(acts(rate, Rule::kComponents));
}

TEST(Print, NamesWhatTheFieldNames) {
  const std::vector<Line> all = lines(derive(D * w, false));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].text, "w = q̇ σ z^d");
  EXPECT_EQ(all[1].text, "ω = D w");
}

}  // namespace
}  // namespace treedyn::derive
