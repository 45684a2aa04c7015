#include "formulate/regressor.hpp"

#include <array>

#include "common/index.hpp"
#include "formulate/derived.hpp"

namespace treedyn::formulate {

namespace {

constexpr int kParameters = 10;
/// Rows and columns of xx xy xz yy yz zz.
constexpr std::array<std::array<std::size_t, 2>, 6> kEntries = {
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

/// Pseudo-inertia of a tensor J = tr(E) 1 - E with one entry.
Matrix3 pseudo_inertia(std::size_t row, std::size_t column) {
  Matrix3 result{};
  if (row == column) {
    for (std::size_t k = 0; k < 3; ++k) {
      result[4 * k] = Real(1) / 2;
    }
    result[4 * row] -= 1;
  } else {
    result[3 * row + column] = -1;
    result[3 * column + row] = -1;
  }
  return result;
}

/// Gives a link a unit of one parameter, which counts in the model's frame of the link.
void add_unit(NormalLink& link, int parameter) {
  const auto k = static_cast<std::size_t>(parameter);
  Vector3 moment{};
  Matrix3 pseudo{};
  if (k == 0) {
    link.mass = 1;
  } else if (k < 4) {
    moment[k - 1] = 1;
  } else {
    pseudo = pseudo_inertia(kEntries[k - 4][0], kEntries[k - 4][1]);
  }
  const Vector3& o = link.origin;
  pseudo = pseudo - outer(o, moment) - outer(moment, o) + link.mass * outer(o, o);
  link.moment = multiply(link.to_normal, moment - link.mass * o);
  link.pseudo = congruence(link.to_normal, pseudo);
}

}  // namespace

std::vector<Expr> build_regressor(const Task& task) {
  const Kinematics& k = task.kinematics;
  model::Tree bare = task.tree;
  for (model::Link& link : bare.links) {
    link.inertia = {};
  }
  const NormalTree nothing = normal_form(bare, task.options.gravity, k.variant());
  const std::size_t columns = kParameters * bare.links.size();
  std::vector<Expr> Y(bare.links.size() * columns);
  for (int link = 0; link < bare.size(); ++link) {
    for (int parameter = 0; parameter < kParameters; ++parameter) {
      NormalTree normal = nothing;
      add_unit(normal.links[to_index(link)], parameter);
      const Kinematics own(k.graph(), bare, normal, k.variant(), k.inputs());
      const std::vector<Expr> tau =
          build_equation({bare, normal, task.options, own}, "inverse_dynamics");
      for (std::size_t row = 0; row < tau.size(); ++row) {
        Y[row * columns + to_index(kParameters * link + parameter)] = tau[row];
      }
    }
  }
  return Y;
}

}  // namespace treedyn::formulate
