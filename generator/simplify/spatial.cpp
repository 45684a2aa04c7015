#include "simplify/spatial.hpp"

namespace treedyn::simplify {

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

}  // namespace treedyn::simplify
