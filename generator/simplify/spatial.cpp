#include "simplify/spatial.hpp"

namespace treedyn::simplify {

Expr sum(Graph& graph, const std::vector<Expr>& terms) {
  Expr result;
  Expr constants;
  for (const Expr& term : terms) {
    (term.is_constant() ? constants : result) += term;
  }
  return constants.is_zero() ? result : result + constant(graph, constants.value());
}

void name(Graph& graph, const Vec3& v, const char* symbol, int body) {
  constexpr std::array<const char*, 3> kComponent = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    graph.name(v[k].ref(), symbol, body, kComponent[k]);
  }
}

}  // namespace treedyn::simplify
