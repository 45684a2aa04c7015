#include "equations/symbol_names.hpp"

#include <algorithm>

#include "common/transformed.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {
namespace {

using block::named;

struct Row {
  std::string_view name;
  Expression expression;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows = {
      {"D", D},
      {"E", E},
      {"N", D - E},
      {"sigma", sigma},
      {"m_d", m_d},
      {"qd_d", qd_d},
      {"z_d", z_d},
      {"s_d", named("s_0^d", s_d * block::diagb(Pi * ones))},  // E9: 0 for links on the base
      {"l_d", l_d},
      {"c_d", centres_of_mass().t_d},
      {"J_d", J_d},
      {"W", W},
      {"t_d", t_d},
      {"qd", qd},
      {"qdd", qdd},
      {"tau", tau},
      {"ones", ones},
      {"g", g},
      {"f_b", f_b},
      {"n_b", n_b},
      {"ones_P", ones_P},
      {"l_D", joint_to_link_vectors()},
      {"c_fD", joint_to_com_vectors()},
      {"t_fD", points().t_fD},
      {"D_P", points().D_P},
      {"J_v", velocity_jacobian(centres_of_mass())},
      {"J_w", angular_jacobian()},
      {"A", mass_matrix()},
      {"B", bias_force()},
      {"G", gravity_force()},
      {"C", force_jacobian_transpose(points())},
      {"H", moment_jacobian_transpose(points())},
      {"K", bias_matrix(centres_of_mass())},
      {"gamma_f", point_bias_acceleration()},
      {"gamma_n", angular_bias_acceleration()},
      {"omega", named("ω", D * z_d * sigma * qd)},
      {"r", named("r", D * s_d * ones + centres_of_mass().t_d * ones)},
      {"p", point_positions()},
      {"v", point_velocities()},
  };
  return kRows;
}

}  // namespace

std::optional<Expression> find_name(std::string_view name) {
  const auto found = std::ranges::find(rows(), name, &Row::name);
  return found == rows().end() ? std::nullopt : std::optional(found->expression);
}

std::vector<std::string_view> known_names() { return transformed(rows(), &Row::name); }

}  // namespace treedyn::equations
