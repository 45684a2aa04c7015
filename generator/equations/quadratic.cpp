#include "equations/quadratic.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "block/rewrite.hpp"
#include "equations/equations.hpp"
#include "equations/symbols.hpp"

namespace treedyn::equations {
namespace {

using block::Kind;
using block::Ratio;
using Factors = std::vector<Expression>;

/// A diagonal of numbers of links, or of their tensors.
bool is_symmetric_leaf(const Expression& e) {
  return block::is_diagonal_leaf(e) &&
         (e.shape() == block::Shape{kLinks, kLinks} || block::equal(e, J_d));
}

bool is_one_number(const Expression& e) { return e.shape() == block::Shape{kOne, kOne}; }

/// The factors of e or of its transpose, products opened under names (but of numbers) and
/// transposes.
void open(const Expression& e, bool transposed, Factors& factors, Ratio& factor) {
  const bool whole = e.kind() == Kind::kNamed && is_one_number(e);
  const Expression& x = whole ? e : block::unnamed(e);
  switch (x.kind()) {
    case Kind::kScaled:
      factor = block::multiply(factor, x.node().factor);
      return open(x.operands().front(), transposed, factors, factor);
    case Kind::kTranspose:
      return open(x.operands().front(), !transposed, factors, factor);
    case Kind::kProduct: {
      Factors parts = x.operands();
      if (transposed) {
        std::ranges::reverse(parts);
      }
      for (const Expression& part : parts) {
        open(part, transposed, factors, factor);
      }
      return;
    }
    default:
      factors.push_back(
          transposed && !is_symmetric_leaf(e) && !is_one_number(e) ? block::transpose(e) : e);
  }
}

bool is_mirrored(const Expression& a, const Expression& b) {
  return block::equal(a, block::transpose(b)) || block::equal(b, block::transpose(a)) ||
         ((is_symmetric_leaf(a) || is_one_number(a)) && block::equal(a, b));
}

/// Diagonals of numbers, and of blocks at most one: they commute.
bool is_symmetric(const Factors& middle) {
  return std::ranges::all_of(middle, is_symmetric_leaf) &&
         std::ranges::count_if(middle,
                               [](const Expression& f) { return !block::has_numbers(f); }) <= 1;
}

/// J_v^T m J_v + J_ω^T J J_ω.
Expression by_velocities() {
  const Expression J_v = velocity_jacobian(centres_of_mass());
  const Expression J_w = angular_jacobian();
  return transpose(J_v) * m_d * J_v + transpose(J_w) * J_d * J_w;
}

class Forms {
 public:
  bool add(const Expression& e, const Ratio& factor);
  [[nodiscard]] std::vector<QuadraticForm> take() && { return std::move(forms_); }

 private:
  std::vector<QuadraticForm> forms_;
};

bool Forms::add(const Expression& e, const Ratio& factor) {
  Factors f;
  Ratio all = factor;
  open(block::unnamed(e), false, f, all);
  const std::size_t n = f.size();
  std::size_t k = 0;
  while (2 * (k + 1) <= n && is_mirrored(f[k], f[n - 1 - k])) {
    ++k;
  }
  const auto begin = f.begin() + static_cast<std::ptrdiff_t>(k);
  const auto end = f.end() - static_cast<std::ptrdiff_t>(k);
  const Factors middle(begin, end);
  if (k > 0 && is_symmetric(middle)) {
    forms_.push_back({all, middle, block::product_of(end, f.end())});
    return true;
  }
  if (middle.size() != 1) {
    return false;
  }
  static const Expression A = mass_matrix();
  static const Expression kByVelocities = by_velocities();
  const bool is_A = block::equal(middle.front(), A) || block::equal(middle.front(), transpose(A));
  const Expression& sum = block::unnamed(is_A ? kByVelocities : middle.front());
  return sum.kind() == Kind::kSum && std::ranges::all_of(sum.operands(), [&](const Expression& t) {
           const Expression inner =
               k == 0 ? t
                      : block::product_of(f.begin(), begin) * t * block::product_of(end, f.end());
           return add(inner, all);
         });
}

}  // namespace

std::optional<std::vector<QuadraticForm>> quadratic_forms(const Expression& e) {
  Forms forms;
  return is_one_number(e) && forms.add(e, {}) ? std::optional(std::move(forms).take())
                                              : std::nullopt;
}

}  // namespace treedyn::equations
