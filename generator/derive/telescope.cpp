#include <algorithm>
#include <array>
#include <mutex>
#include <tuple>

#include <ginac/ginac.h>

#include "common/index.hpp"
#include "derive/algebra.hpp"

namespace treedyn::derive {
namespace {

using Vector = std::vector<GiNaC::ex>;

GiNaC::matrix skew(const Vector& a) {
  return GiNaC::matrix{{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}};
}

Vector symbols(const char* name) {
  Vector result;
  for (const char* component : {"x", "y", "z"}) {
    result.push_back(GiNaC::symbol(std::string(name) + component));
  }
  return result;
}

/// The columns w, D w and N w among the factors of the terms.
struct Chain {
  int w = -1;
  int own = -1;     ///< D w
  int father = -1;  ///< N w
};

std::optional<Chain> chain_of(const Values& values, const Terms& terms) {
  Chain chain;
  for (const auto& [factor, x] : terms) {
    if (values[x].op != Op::kSkewProduct) {
      return std::nullopt;
    }
    for (const int a : values[x].operands) {
      if (values[a].op == Op::kPath || values[a].op == Op::kPathStrict) {
        (values[a].op == Op::kPath ? chain.own : chain.father) = a;
        chain.w = values[a].operands.front();
      }
    }
  }
  if (terms.empty() || chain.own < 0 || chain.father < 0) {
    return std::nullopt;
  }
  for (const auto& [factor, x] : terms) {
    for (const int a : values[x].operands) {
      if (a != chain.w && a != chain.own && a != chain.father) {
        return std::nullopt;
      }
    }
  }
  return chain;
}

/// Of a term: its factor, and which columns it multiplies: 0 for w, 1 for D w, 2 for N w.
using Shape = std::vector<std::tuple<Ratio, int, int>>;

/// δ - (g(ω) - g(ω_f)) is the zero polynomial.
bool is_identity(const Shape& shape) {
  const Vector w = symbols("w");
  const Vector father = symbols("f");
  Vector own;
  std::ranges::transform(w, father, std::back_inserter(own),
                         [](const GiNaC::ex& a, const GiNaC::ex& b) { return a + b; });
  const std::array<GiNaC::matrix, 3> skews = {skew(w), skew(own), skew(father)};
  GiNaC::matrix difference = skews[2].mul(skews[2]).sub(skews[1].mul(skews[1]));
  for (const auto& [factor, a, b] : shape) {
    const GiNaC::numeric ratio = GiNaC::numeric(factor.numerator) / factor.denominator;
    difference = difference.add(skews[to_index(a)].mul(skews[to_index(b)]).mul_scalar(ratio));
  }
  for (std::size_t n = 0; n < difference.nops(); ++n) {
    if (!difference.op(n).expand().is_zero()) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<int> telescopes(const Values& values, const Terms& terms) {
  const std::optional<Chain> chain = chain_of(values, terms);
  if (!chain) {
    return std::nullopt;
  }
  const auto column = [&](int a) {
    return a == chain->w ? 0 : a == chain->own ? 1 : 2;
  };
  Shape shape;
  for (const auto& [factor, x] : terms) {
    shape.emplace_back(factor, column(values[x].operands[0]), column(values[x].operands[1]));
  }
  static std::mutex ginac;  // which counts references without atomics
  static std::vector<std::pair<Shape, bool>> decided;
  const std::scoped_lock lock(ginac);
  auto known = std::ranges::find(decided, shape, &std::pair<Shape, bool>::first);
  if (known == decided.end()) {
    known = decided.insert(decided.end(), {shape, is_identity(shape)});
  }
  return known->second ? std::optional(chain->w) : std::nullopt;
}

}  // namespace treedyn::derive
