#include "formulate/spatial.hpp"

namespace treedyn::formulate {

Mat3 inertia_tensor(const Mat3& Psi) {
  return {{{Psi[1][1] + Psi[2][2], -Psi[0][1], -Psi[0][2]},
           {-Psi[0][1], Psi[0][0] + Psi[2][2], -Psi[1][2]},
           {-Psi[0][2], -Psi[1][2], Psi[0][0] + Psi[1][1]}}};
}

Mat3 second_moments_of(Graph& graph, Mat3 I) {
  const Expr half_trace = constant(graph, Real("0.5")) * (I[0][0] + I[1][1] + I[2][2]);
  for (std::size_t k = 0; k < kSize; ++k) {
    I[k] = -I[k];
    I[k][k] += half_trace;
  }
  return I;
}

Expr sum(const std::vector<Expr>& terms) {
  Expr result;
  Expr constants;
  for (const Expr& term : terms) {
    (term.is_fixed() ? constants : result) += term;
  }
  return result + constants;
}

void name(Graph& graph, const Vec3& v, const char* symbol, int body) {
  constexpr std::array<const char*, 3> kComponent = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    graph.name(v[k].ref(), symbol, body, kComponent[k]);
  }
}

}  // namespace treedyn::formulate
