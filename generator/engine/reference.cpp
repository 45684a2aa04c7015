#include "engine/reference.hpp"

#include <array>
#include <cmath>

#include "engine/inertia_factor.hpp"
#include "engine/user_function.hpp"

namespace treedyn::engine {

namespace {

using Vector = Engine<Real>::Vector;
using Matrix = Engine<Real>::Matrix;

std::vector<std::vector<Real>> reals(const std::vector<std::vector<double>>& inputs) {
  std::vector<std::vector<Real>> result;
  for (const std::vector<double>& array : inputs) {
    result.emplace_back(array.begin(), array.end());
  }
  return result;
}

Eigen::MatrixXd sizes(const Matrix& values) {
  return values.unaryExpr([](const Real& x) { return std::abs(static_cast<double>(x)); });
}

template <class Numbers>
void append(const Numbers& values, std::vector<double>& to) {
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index j = 0; j < values.cols(); ++j) {
      to.push_back(values(i, j));
    }
  }
}

void append(const Exact& other, Exact& to) {
  to.values.insert(to.values.end(), other.values.begin(), other.values.end());
  to.scales.insert(to.scales.end(), other.scales.begin(), other.scales.end());
}

}  // namespace

/// A = L^T Delta L and its inverse.
struct Reference::Factors {
  Matrix L;
  Vector delta;
  Matrix inverse;
  Eigen::MatrixXd terms;  ///< of A: its scales
};

Reference::Reference(const model::Tree& tree, std::span<const model::Point> points,
                     const model::Vector3& gravity)
    : tree_(tree),
      points_(points.begin(), points.end()),
      gravity_(gravity),
      engine_(tree, points_, gravity) {}

Exact Reference::of_engine(const std::string& function, const Inputs& inputs) {
  return {engine_.evaluate(function, inputs), engine_.scales(function, inputs)};
}

Reference::Factors Reference::factors(const std::vector<Real>& q) {
  const Exact A = of_engine("mass_matrix", {q});
  const Eigen::Index n = engine_.dof();
  Matrix LD = Eigen::Map<const Matrix>(A.values.data(), n, n);
  factorize(LD);
  Factors result;
  result.L = Matrix::Identity(n, n);
  result.L.triangularView<Eigen::StrictlyLower>() = LD;
  result.delta = LD.diagonal();
  result.inverse.resize(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    Vector column = Vector::Unit(n, j);
    solve_factorized(LD, column);
    result.inverse.col(j) = column;
  }
  result.terms =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          A.scales.data(), n, n);
  return result;
}

Exact Reference::factor(const Inputs& inputs) {
  const Factors of = factors(inputs[0]);
  const Eigen::MatrixXd L = sizes(of.L);
  const Eigen::VectorXd delta = sizes(of.delta);
  const Eigen::MatrixXd terms = of.terms + L.transpose() * delta.asDiagonal() * L;
  Eigen::MatrixXd scales = Eigen::MatrixXd::Zero(L.rows(), L.cols());
  for (Eigen::Index k = 0; k < L.rows(); ++k) {
    for (Eigen::Index i = 0; i < k; ++i) {
      scales(k, i) = L(k, i) == 0 ? 0 : (terms(k, i) + L(k, i) * terms(k, k)) / delta(k);
    }
    scales(k, k) = 1;
  }
  Exact result{{of.L.data(), of.L.data() + of.L.size()}, {}};
  result.values.insert(result.values.end(), of.delta.data(), of.delta.data() + of.delta.size());
  append(scales, result.scales);
  append(Eigen::VectorXd(terms.diagonal()), result.scales);
  return result;
}

Exact Reference::solution(const Inputs& inputs) {
  const Factors of = factors(inputs[0]);
  const Vector b = Eigen::Map<const Vector>(inputs[1].data(), engine_.dof());
  const Vector x = of.inverse * b;
  Exact result{{x.data(), x.data() + x.size()}, {}};
  append(Eigen::VectorXd(sizes(of.inverse) * (sizes(b) + of.terms * sizes(x))), result.scales);
  return result;
}

Exact Reference::inverse(const Inputs& inputs) {
  const Factors of = factors(inputs[0]);
  const Eigen::MatrixXd size = sizes(of.inverse);
  Exact result{{of.inverse.data(), of.inverse.data() + of.inverse.size()}, {}};
  append(Eigen::MatrixXd(size * of.terms * size), result.scales);
  return result;
}

Exact Reference::terms(const Inputs& inputs) {
  Exact result = of_engine("mass_matrix", {inputs[0]});
  append(of_engine("bias_force", inputs), result);
  append(of_engine("gravity_force", {inputs[0]}), result);
  return result;
}

/// Columns of robots that have nothing but a unit of one parameter; a first moment is that of a
/// unit mass off the origin less that of the mass there.
Exact Reference::regressor(const Inputs& inputs) {
  const std::size_t columns = 10 * tree_.links.size();
  const std::size_t size = static_cast<std::size_t>(engine_.dof()) * columns;
  Exact Y{std::vector<Real>(size), std::vector<double>(size)};
  model::Tree unit = tree_;
  for (model::Link& link : unit.links) {
    link.inertia = {};
  }
  for (std::size_t column = 0; column < columns; ++column) {
    model::Inertia& inertia = unit.links[column / 10].inertia;
    const std::size_t k = column % 10;
    const auto add = [&](const Real& sign) {
      const Exact tau = Reference(unit, {}, gravity_).of_engine("inverse_dynamics", inputs);
      for (std::size_t row = 0; row < tau.values.size(); ++row) {
        Y.values[row * columns + column] += sign * tau.values[row];
        Y.scales[row * columns + column] += tau.scales[row];
      }
    };
    if (k >= 4) {
      constexpr std::array<std::array<std::size_t, 2>, 6> kPlaces = {
          {{0, 0}, {1, 3}, {2, 6}, {4, 4}, {5, 7}, {8, 8}}};
      for (const std::size_t place : kPlaces[k - 4]) {
        inertia.about_com[place] = 1;
      }
      add(1);
    } else {
      inertia.mass = 1;
      add(k == 0 ? 1 : -1);
      if (k > 0) {
        inertia.com[k - 1] = 1;  // and no tensor about the origin
        inertia.about_com = {-1, 0, 0, 0, -1, 0, 0, 0, -1};
        inertia.about_com[4 * (k - 1)] = 0;
        add(1);
      }
    }
    inertia = {};
  }
  return Y;
}

Exact Reference::operator()(const std::string& function,
                            const std::vector<std::vector<double>>& inputs) {
  const Inputs exact = reals(inputs);
  return function == "mass_matrix_factor"           ? factor(exact)
         : function == "mass_matrix_solve"          ? solution(exact)
         : function == "mass_matrix_inverse"        ? inverse(exact)
         : function == "dynamics_terms"             ? terms(exact)
         : function == "inverse_dynamics_regressor" ? regressor(exact)
                                                    : of_engine(function, exact);
}

Exact Reference::operator()(const equations::UserEquation& equation,
                            const std::vector<std::vector<double>>& inputs) {
  UserFunction<Real> function(equation, tree_, points_, gravity_);
  const Inputs exact = reals(inputs);
  return {function(exact), function.scales(exact)};
}

}  // namespace treedyn::engine
