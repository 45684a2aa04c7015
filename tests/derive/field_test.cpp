// Searched programs, those that invert A among them, in the field of the integers modulo a prime:
// at a random point of it a program is exactly its block equation. A difference that is not zero
// everywhere is zero at such a point with a probability of its degree in 2^61. Models as in
// exact_test.cpp, also those whose polynomials are too large.
#include <cstdint>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "block/evaluate.hpp"
#include "derive/exact_options.hpp"
#include "derive/turning.hpp"
#include "description/read.hpp"
#include "equations/equations.hpp"
#include "equations/kinematics.hpp"
#include "equations/table.hpp"
#include "expansion/rational.hpp"
#include "formulate/derived.hpp"
#include "program/interpret.hpp"
#include "support/random_tree.hpp"

namespace treedyn {
namespace {

/// An integer modulo 2^61 - 31: another prime than that of the keys by which programs are
/// simplified (program/residue.hpp), and no arithmetic of theirs.
class Residue {
 public:
  static constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61U) - 31;

  Residue() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): Eigen and `block` write numbers as scalars
  Residue(int value)
      : value_(value < 0 ? kPrime - static_cast<std::uint64_t>(-value)
                         : static_cast<std::uint64_t>(value)) {}
  static Residue of(std::uint64_t value) {
    Residue result;
    result.value_ = value % kPrime;
    return result;
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

  Residue& operator+=(Residue b) { return *this = of(value_ + b.value_); }
  Residue& operator-=(Residue b) { return *this += -b; }
  Residue& operator*=(Residue b) {
    __extension__ using Wide = unsigned __int128;
    return *this = of(static_cast<std::uint64_t>(static_cast<Wide>(value_) * b.value_ % kPrime));
  }
  /// \pre b is not zero
  Residue& operator/=(Residue b) {
    EXPECT_NE(b.value_, 0U);
    for (std::uint64_t power = kPrime - 2; power != 0; power /= 2) {  // b^(p-2) = 1/b
      if (power % 2 == 1) {
        *this *= b;
      }
      b *= b;
    }
    return *this;
  }
  friend Residue operator-(Residue a) { return of(kPrime - a.value_); }
  friend Residue operator+(Residue a, Residue b) { return a += b; }
  friend Residue operator-(Residue a, Residue b) { return a -= b; }
  friend Residue operator*(Residue a, Residue b) { return a *= b; }
  friend Residue operator/(Residue a, Residue b) { return a /= b; }
  friend bool operator==(Residue a, Residue b) = default;

 private:
  std::uint64_t value_ = 0;
};

int to_int(Residue small) {
  return small.value() < Residue::kPrime / 2 ? static_cast<int>(small.value())
                                             : -static_cast<int>((-small).value());
}

using Number = support::Turning<Residue>;

Residue residue(const GiNaC::numeric& integer) {
  const auto remainder =
      GiNaC::mod(integer, GiNaC::numeric(std::to_string(Residue::kPrime).c_str()));
  std::ostringstream digits;
  digits << remainder;
  return Residue::of(std::stoull(digits.str()));
}

/// The fraction behind a constant.
Residue constant(const Real& value) {
  const std::optional<GiNaC::numeric> fraction = expansion::nearby_rational(value);
  EXPECT_TRUE(fraction) << value.str(30);
  return fraction ? residue(fraction->numer()) / residue(fraction->denom()) : Residue();
}

}  // namespace
}  // namespace treedyn

template <>
struct Eigen::NumTraits<treedyn::Residue> : Eigen::GenericNumTraits<treedyn::Residue> {
  using Real = treedyn::Residue;
  using NonInteger = treedyn::Residue;
  using Nested = treedyn::Residue;
};

namespace treedyn {

template <>
Number program::from_real<Number>(const Real& value) {
  return Number(constant(value));
}

namespace {

/// Random elements of the field.
class Elements {
 public:
  Residue next() { return Residue::of(engine_()); }
  std::vector<Residue> next(std::size_t count) {
    std::vector<Residue> result(count);
    std::ranges::generate(result, [this] { return next(); });
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

using Residues = std::vector<Residue>;

/// A tree at a random point: sines and cosines on the circle, slides, rates, forces.
class Point {
 public:
  Point(const model::Tree& tree, const formulate::Options& options)
      : index_(equations::index_of(tree, options.points)),
        constants_(equations::constants_of<Residue>(tree, options.points, constant)),
        gravity_(equations::vector3<Residue>(options.gravity, constant)),
        poses_(tree.links.size()),
        slide_(elements_.next(tree.links.size())),
        qd_(elements_.next(tree.links.size())),
        qdd_(elements_.next(tree.links.size())),
        f_(elements_.next(3 * options.points.size())),
        n_(elements_.next(3 * options.points.size())) {
    for (std::size_t i = 0; i < tree.links.size(); ++i) {
      const Residue t = elements_.next();  // of half the angle
      const Residue below = Residue(1) + t * t;
      sine_.push_back(Residue(2) * t / below);
      cosine_.push_back((Residue(1) - t * t) / below);
    }
    equations::compute_poses<Residue>(constants_, {sine_, cosine_, slide_}, poses_);
  }

  /// A block expression, row-major.
  [[nodiscard]] Residues value(const block::Expression& expression) const {
    block::Plan plan(index_);
    const int result = plan.add(expression);
    block::Evaluation<Residue> evaluation(plan);
    equations::LeafWriter<Residue>(evaluation).write(constants_, poses_);
    Residues masses;
    Residues gravities;
    for (const auto& link : constants_.links) {
      masses.push_back(link.mass);
      gravities.insert(gravities.end(), gravity_.data(), gravity_.data() + 3);
    }
    for (const auto& [name, values] : {std::pair("q̇", &qd_),
                                       {"q̇^d", &qd_},
                                       {"q̈", &qdd_},
                                       {"f_b", &f_},
                                       {"n_b", &n_},
                                       {"m^d", &masses},
                                       {"g", &gravities}}) {
      const std::span<Residue> leaf = evaluation.leaf(name);
      std::copy_n(values->begin(), leaf.size(), leaf.begin());
    }
    evaluation.run(plan.needed({result}));
    const block::Pattern& blocks = plan.step(result).pattern;
    Residues entries(to_index(blocks.rows() * expression.shape().rows.size) *
                     to_index(blocks.cols() * expression.shape().cols.size));
    evaluation.write(result, expression.shape(), entries);
    return entries;
  }

  /// What a program makes of the point; `last` stands for `tau` and the like.
  [[nodiscard]] Residues value(const program::Function& function, const std::string& name,
                               const Residues& last) const {
    const auto inputs = equations::find_function(name)->inputs;
    const auto input = [&](int array, int k) {
      const std::string_view argument = inputs[to_index(array)].name;
      if (argument == "q") {
        return constants_.links[to_index(k)].revolute ? Number::angle(k)
                                                      : Number(slide_[to_index(k)]);
      }
      return Number((argument == "qd"    ? qd_
                     : argument == "qdd" ? qdd_
                     : argument == "f"   ? f_
                     : argument == "n"   ? n_
                                         : last)[to_index(k)]);
    };
    const auto values = program::node_values<Number>(
        function.graph, function.outputs, input, [&](program::Kind kind, const Number& angle) {
          EXPECT_EQ(angle.value, Residue());
          return support::trigonometric(
              kind, angle, [&](int joint) { return sine_[to_index(joint)]; },
              [&](int joint) { return cosine_[to_index(joint)]; });
        });
    Residues result;
    for (const program::Ref output : function.outputs) {
      const Residue value = values[program::node_index(output)].value;
      result.push_back(output < 0 ? -value : value);
    }
    return result;
  }

  [[nodiscard]] const Residues& qdd() const { return qdd_; }

 private:
  Elements elements_;
  block::Index index_;
  equations::Constants<Residue> constants_;
  equations::Vector3<Residue> gravity_;
  equations::Poses<Residue> poses_;
  Residues sine_, cosine_, slide_, qd_, qdd_, f_, n_;
};

/// a b for n x n matrices, row-major; b may have other columns.
Residues product(const Residues& a, const Residues& b, std::size_t n) {
  Residues result(b.size());
  const std::size_t columns = b.size() / n;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < columns; ++j) {
        result[i * columns + j] += a[i * n + k] * b[k * columns + j];
      }
    }
  }
  return result;
}

Residues unit(std::size_t n) {
  Residues result(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    result[i * n + i] = 1;
  }
  return result;
}

/// Two digits of every mass, centre and tensor: fractions of theirs are found behind 50 digits.
model::Tree with_short_numbers(model::Tree tree) {
  const auto shorten = [](Real& value) {
    const double x = static_cast<double>(value);
    value = Real(fmt::format("{:.1e}", x));
  };
  for (model::Link& link : tree.links) {
    shorten(link.inertia.mass);
    std::ranges::for_each(link.inertia.com, shorten);
    std::ranges::for_each(link.inertia.about_com, shorten);
  }
  return tree;
}

struct Sample {
  const char* model;
  description::Base base = description::Base::kFixed;
};
void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.model; }

class Field : public testing::TestWithParam<Sample> {
 protected:
  Field()
      : tree_(description::read_model(
            std::string(TREEDYN_SOURCE_DIR "/models/") + GetParam().model + ".yaml",
            {.base = GetParam().base})),
        n_(tree_.links.size()),
        options_(support::exact_options(tree_, 20)) {}

  [[nodiscard]] Residues program(const Point& point, const std::string& name,
                                 const Residues& last) const {
    return point.value(formulate::formulated(tree_, name, options_), name, last);
  }

  model::Tree tree_;
  std::size_t n_;
  formulate::Options options_;
};

TEST_P(Field, ProgramsAreTheirEquations) {
  const Point point(tree_, options_);
  for (const equations::Equation& equation : equations::table()) {
    const std::string name(equation.name);
    EXPECT_EQ(program(point, name, {}), point.value(*equation.expression)) << name;
  }
}

TEST_P(Field, ProgramsAreNoOtherEquations) {
  const Point point(tree_, options_);
  equations::Attached wrong = equations::points();
  wrong.t_d = -wrong.t_d;
  EXPECT_NE(program(point, "force_jacobian_transpose", {}),
            point.value(equations::force_jacobian_transpose(wrong)));
}

TEST_P(Field, ForwardDynamicsInvertInverseDynamics) {
  tree_ = with_short_numbers(tree_);
  const Point point(tree_, options_);
  const Residues tau = point.value(equations::inverse_dynamics());
  for (const auto method :
       {formulate::ForwardDynamics::kFactor, formulate::ForwardDynamics::kArticulated}) {
    options_.forward_dynamics = method;
    EXPECT_EQ(program(point, "forward_dynamics", tau), point.qdd()) << static_cast<int>(method);
  }
}

TEST_P(Field, SolutionsAndInversesOfTheMassMatrixInvertIt) {
  const Point point(tree_, options_);
  const Residues A = point.value(equations::mass_matrix());
  EXPECT_EQ(program(point, "mass_matrix_solve", product(A, point.qdd(), n_)), point.qdd());
  EXPECT_EQ(product(A, program(point, "mass_matrix_inverse", {}), n_), unit(n_));
}

TEST_P(Field, FactorsMultiplyToTheMassMatrix) {
  const Point point(tree_, options_);
  const Residues all = program(point, "mass_matrix_factor", {});  // L, then the diagonal of Δ
  Residues upper(n_ * n_);                                        // L^T Δ
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < n_; ++k) {
      upper[k * n_ + i] = all[i * n_ + k] * all[n_ * n_ + i];
    }
  }
  const Residues lower(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n_ * n_));
  EXPECT_EQ(product(upper, lower, n_), point.value(equations::mass_matrix()));
}

INSTANTIATE_TEST_SUITE_P(Models, Field,
                         testing::Values(Sample{"two_link"}, Sample{"polar"},
                                         Sample{"compass_walker"}, Sample{"puma560"},
                                         Sample{"panda"}, Sample{"quadruped"}, Sample{"biped"},
                                         Sample{"biped", description::Base::kAxes}),
                         [](const auto& test) {
                           const bool axes = test.param.base == description::Base::kAxes;
                           return std::string(test.param.model) + (axes ? "_axes" : "");
                         });

}  // namespace
}  // namespace treedyn
