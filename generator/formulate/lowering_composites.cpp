// Composite inertias: D^T of what turns, carried from sons to fathers.
#include <algorithm>

#include "common/index.hpp"
#include "formulate/lowering.hpp"

namespace treedyn::formulate {
namespace {

/// 2 s_a h_a and m s_a^2, merged into one product where s is not constant.
std::array<Expr, 2> diagonal_shift(Expr h, Expr mass, Expr s) {
  if (s.is_fixed()) {
    return {(s + s) * h, (mass * s) * s};
  }
  return {s * ((h + h) + mass * s), Expr()};
}

/// h_a s_b + s_a h_b + m s_a s_b.
std::vector<Expr> product_shift(const Vec3& h, Expr mass, const Vec3& s, std::size_t a,
                                std::size_t b) {
  if (s[a].is_fixed()) {
    return {s[b] * h[a], s[a] * h[b], (mass * s[a]) * s[b]};
  }
  return {s[b] * h[a], s[a] * (h[b] + mass * s[b])};
}

}  // namespace

Lowering::TensorTerms& Lowering::composite_terms(int id, int i) {
  std::vector<TensorTerms>& all = tensors_[id];
  all.resize(to_index(task_.tree.size()));
  TensorTerms& terms = all[to_index(i)];
  if (terms[0][0].empty()) {
    const Mat3 tensor = has_tensors() ? tensor_about_joint(i) : second_moments(i);
    const Mat3 own = frames_.moved({i, tensor}, home(block::Set::kLinks, i)).value;
    for (std::size_t a = 0; a < kSize; ++a) {
      for (std::size_t b = a; b < kSize; ++b) {
        terms[a][b] = {own[a][b]};
      }
    }
  }
  return terms;
}

/// Ψ_f += Ψ + F, F = h s^T + s h^T + m s s^T; or I_f += I + tr(F) E_3 - F.
void Lowering::hand_on(TensorTerms& father, Expr mass, const Vec3& h, const Vec3& s,
                       const Mat3& tensor) const {
  for (std::size_t a = 0; a < kSize; ++a) {
    for (std::size_t b = a; b < kSize; ++b) {
      father[a][b].push_back(tensor[a][b]);
    }
  }
  for (std::size_t a = 0; a < kSize; ++a) {
    for (const Expr& term : diagonal_shift(h[a], mass, s[a])) {
      for (const std::size_t k :
           has_tensors() ? std::vector{(a + 1) % kSize, (a + 2) % kSize} : std::vector{a}) {
        father[k][k].push_back(term);
      }
    }
    for (std::size_t b = a + 1; b < kSize; ++b) {
      for (const Expr& term : product_shift(h, mass, s, a, b)) {
        father[a][b].push_back(has_tensors() ? -term : term);
      }
    }
  }
}

/// Ψ of I = tr(Ψ) E_3 - Ψ: of a link, or of the composite at it.
Block Lowering::pseudo(const Value& v, int e) const {
  const int I = v.operands[0];
  if (value(I).op != derive::Op::kComposite) {
    return {{}, {}, {e, second_moments(e)}};
  }
  const auto sums = pseudo_.find(I);
  const Mat3 E = sums != pseudo_.end() ? sums->second[to_index(e)]
                                       : second_moments_of(graph(), of(I, e).tensor.value);
  return {{}, {}, {home(block::Set::kLinks, e), E}};
}

/// I^c of m^c, h^c and s; sons first.
Block Lowering::composite(int id, const Value& v, int i) {
  constexpr std::array<const char*, 9> kEntry = {"xx", "xy", "xz", "xy", "yy",
                                                 "yz", "xz", "yz", "zz"};
  const TensorTerms& terms = composite_terms(id, i);
  Mat3 tensor;
  for (std::size_t n = 0; n < kSize * kSize; ++n) {
    const std::size_t a = std::min(n / kSize, n % kSize);
    tensor[n / kSize][n % kSize] = sum(terms[a][std::max(n / kSize, n % kSize)]);
    graph().name(tensor[n / kSize][n % kSize].ref(), has_tensors() ? "I" : "E", i, kEntry[n]);
  }
  const int at = home(block::Set::kLinks, i);
  if (!has_tensors()) {
    pseudo_[id].resize(to_index(task_.tree.size()));
    pseudo_[id][to_index(i)] = tensor;
  }
  if (const int f = father(i); f != kBase) {
    const int above = home(block::Set::kLinks, f);
    const Vec3 h = frames_.moved(frames_.in(of(v.operands[1], i).vector, at), at, above);
    const Vec3 s = frames_.in(of(v.operands[2], i).vector, above);
    const Mat3 up = frames_.moved({at, tensor, true}, above).value;
    hand_on(composite_terms(id, f), of(v.operands[0], i).number, h, s, up);
  }
  return {{}, {}, {at, has_tensors() ? tensor : inertia_tensor(tensor)}};
}

}  // namespace treedyn::formulate
