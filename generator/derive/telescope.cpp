#include "derive/telescope.hpp"

#include <algorithm>
#include <mutex>

#include <ginac/ginac.h>

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

std::optional<Chain> chain_of(const Values& values,
                              const std::vector<std::pair<Ratio, int>>& terms) {
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

}  // namespace

std::optional<int> telescopes(const Values& values,
                              const std::vector<std::pair<Ratio, int>>& terms) {
  const std::optional<Chain> chain = chain_of(values, terms);
  if (!chain) {
    return std::nullopt;
  }
  static std::mutex ginac;  // which counts references without atomics
  const std::scoped_lock lock(ginac);
  const Vector w = symbols("w");
  const Vector father = symbols("f");
  Vector own;
  std::transform(w.begin(), w.end(), father.begin(), std::back_inserter(own),
                 [](const GiNaC::ex& a, const GiNaC::ex& b) { return a + b; });
  const auto vector = [&](int a) {
    return a == chain->w ? w : a == chain->own ? own : father;
  };
  GiNaC::matrix difference =  // δ - (g(ω) - g(ω_f))
      skew(father).mul(skew(father)).sub(skew(own).mul(skew(own)));
  for (const auto& [factor, x] : terms) {
    const GiNaC::matrix product =
        skew(vector(values[x].operands[0])).mul(skew(vector(values[x].operands[1])));
    difference = difference.add(
        product.mul_scalar(GiNaC::numeric(factor.numerator) / GiNaC::numeric(factor.denominator)));
  }
  for (std::size_t n = 0; n < difference.nops(); ++n) {
    if (!difference.op(n).expand().is_zero()) {
      return std::nullopt;
    }
  }
  return chain->w;
}

}  // namespace treedyn::derive
