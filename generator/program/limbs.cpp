#include "program/limbs.hpp"

#include <algorithm>
#include <cstdlib>

#include "program/copy.hpp"
#include "program/interpret.hpp"

namespace treedyn::program {

namespace {

bool same(const std::vector<Real>& a, const std::vector<Real>& b, int sign) {
  return std::ranges::equal(
      a, b, [sign](const Real& x, const Real& y) { return identical(x, Real(sign * y)); });
}

/// The column with these values (+k + 1) or their negatives (-(k + 1)); 0: none.
int find_column(const LimbClass& limb_class, const std::vector<Real>& values) {
  for (std::size_t k = 0; k < limb_class.columns.size(); ++k) {
    for (const int sign : {1, -1}) {
      if (same(limb_class.columns[k], values, sign)) {
        return sign * static_cast<int>(k + 1);
      }
    }
  }
  return 0;
}

/// A number that needs no argument: in the limbs of a class, or (one value) the same everywhere.
struct Number {
  int limb_class = -1;
  int limb = 0;
  std::vector<Real> values;

  [[nodiscard]] const Real& in(std::size_t l) const { return values[limb_class < 0 ? 0 : l]; }
  [[nodiscard]] const Real& own() const { return in(static_cast<std::size_t>(limb)); }
};

/// `operation` on the values of both; what belongs to two limbs is a constant.
template <class Operation>
Number combined(const Number& a, const Number& b, Operation operation) {
  const bool two_limbs =
      a.limb_class >= 0 && b.limb_class >= 0 && (a.limb_class != b.limb_class || a.limb != b.limb);
  if (two_limbs) {
    return {-1, 0, {operation(a.own(), b.own())}};
  }
  const Number& wide = a.limb_class >= 0 ? a : b;
  Number result = wide;
  for (std::size_t l = 0; l < wide.values.size(); ++l) {
    result.values[l] = operation(a.in(l), b.in(l));
  }
  return result;
}

Number negated(Number a) {
  std::ranges::for_each(a.values, [](Real& x) { x = -x; });
  return a;
}

Number sum(const Number& a, const Number& b) {
  return combined(a, b, [](const Real& x, const Real& y) {
    const Real total = x + y;
    return negligible(total, larger(x, y)) ? Real(0) : total;
  });
}

Number product(const Number& a, const Number& b) {
  return combined(a, b, [](const Real& x, const Real& y) { return Real(x * y); });
}

/// The value of an operation on numbers. \param of  Ref -> Number
template <class Of>
Number operation(const Node& node, Of of) {
  switch (node.kind) {
    case Kind::kConstant:
    case Kind::kInput:
      break;
    case Kind::kAdd:
      return sum(of(node.a), of(node.b));
    case Kind::kMultiply:
      return product(of(node.a), of(node.b));
    case Kind::kDivide:
      return combined(of(node.a), of(node.b),
                      [](const Real& x, const Real& y) { return Real(x / y); });
    case Kind::kSin:
    case Kind::kCos:
    case Kind::kSqrt:
      return combined(of(node.a), {-1, 0, {Real(0)}},
                      [&](const Real& x, const Real&) { return elementary(node.kind, x); });
  }
  return {};
}

class Folder {
 public:
  Folder(const Function& from, Limbs& limbs, Graph& to)
      : from_(from.graph),
        limbs_(limbs),
        to_(to),
        numbers_(from_.size()),
        copies_(from_.size(), 0) {
    numbers_.front() = {-1, 0, {Real(0)}};
    for (const Ref k : reachable(from_, from.outputs)) {
      visit(k);
    }
  }

  /// The copy of a value; a number gets its leaf when it is needed.
  Ref of(Ref a) {
    if (from_.is_fixed(a)) {
      copies_[node_index(a)] = leaf(numbers_[node_index(a)]);
    }
    return copy_of(copies_, a);
  }

 private:
  [[nodiscard]] Number number(Ref a) const {
    return a < 0 ? negated(numbers_[node_index(a)]) : numbers_[node_index(a)];
  }
  Ref leaf(const Number& number) {
    return number.limb_class < 0
               ? to_.constant(number.values.front())
               : limb_constant(to_, limbs_, number.limb_class, number.limb, number.values);
  }
  /// The number behind a fixed node of the result.
  [[nodiscard]] Number number_there(Ref a) const {
    if (to_.is_constant(a)) {
      return {-1, 0, {to_.value(a)}};
    }
    const Node& node = to_.node(a);
    const Number positive = node.kind == Kind::kInput
                                ? input_number(node)
                                : operation(node, [this](Ref b) { return number_there(b); });
    return a < 0 ? negated(positive) : positive;
  }
  [[nodiscard]] Number input_number(const Node& node) const {
    const int c = node.a - kFixedArrays;
    const LimbClass& limb_class = limbs_[static_cast<std::size_t>(c)];
    return {c, node.b % limb_class.size(),
            limb_class.columns[static_cast<std::size_t>(node.b / limb_class.size())]};
  }
  [[nodiscard]] Number fixed_number(Ref k) const;
  void visit(Ref k);
  Ref copy(Ref k);
  Ref add(Ref x, Ref fixed);
  Ref multiply(Ref x, Ref fixed);

  const Graph& from_;
  Limbs& limbs_;
  Graph& to_;
  std::vector<Number> numbers_;
  std::vector<Ref> copies_;
};

Number Folder::fixed_number(Ref k) const {
  const Node& node = from_.node(k);
  if (node.kind == Kind::kConstant) {
    return {-1, 0, {from_.value(k)}};
  }
  return node.kind == Kind::kInput ? input_number(node)
                                   : operation(node, [this](Ref a) { return number(a); });
}

/// (y + f) + fixed = y + (f + fixed).
Ref Folder::add(Ref x, Ref fixed) {
  const Node node = to_.node(x);
  if (node.kind != Kind::kAdd || (!to_.is_fixed(node.a) && !to_.is_fixed(node.b))) {
    return to_.add(x, fixed);
  }
  const auto [y, f] = to_.is_fixed(node.b) ? std::pair(node.a, node.b) : std::pair(node.b, node.a);
  const Number inner = number_there(x < 0 ? -f : f);
  return to_.add(x < 0 ? -y : y, leaf(sum(inner, number_there(fixed))));
}

/// (f y) fixed = (f fixed) y.
Ref Folder::multiply(Ref x, Ref fixed) {
  const Node node = to_.node(x);
  if (node.kind != Kind::kMultiply || (!to_.is_fixed(node.a) && !to_.is_fixed(node.b))) {
    return to_.multiply(x, fixed);
  }
  const auto [y, f] = to_.is_fixed(node.b) ? std::pair(node.a, node.b) : std::pair(node.b, node.a);
  const Ref factor = leaf(product(number_there(f), number_there(fixed)));
  return to_.multiply(factor, x < 0 ? -y : y);
}

Ref Folder::copy(Ref k) {
  const Node& node = from_.node(k);
  if (node.kind == Kind::kInput) {
    return to_.input(node.a, node.b);
  }
  const Ref a = of(node.a);
  const Ref b = of(node.b);
  const bool a_fixed = to_.is_fixed(a);
  if (a == 0 || b == 0 || a_fixed == to_.is_fixed(b)) {
    return copy_node(from_, k, copies_, to_);
  }
  if (node.kind == Kind::kDivide) {
    return a_fixed
               ? to_.divide(a, b)
               : multiply(a,
                          leaf(combined({-1, 0, {Real(1)}}, number_there(b),
                                        [](const Real& x, const Real& y) { return Real(x / y); })));
  }
  const Ref x = a_fixed ? b : a;
  const Ref fixed = a_fixed ? a : b;
  return node.kind == Kind::kAdd ? add(x, fixed) : multiply(x, fixed);
}

void Folder::visit(Ref k) {
  if (from_.is_fixed(k)) {
    numbers_[node_index(k)] = fixed_number(k);
    return;
  }
  const Ref made = copy(k);
  copies_[node_index(k)] = made;
  if (!to_.is_fixed(made) && to_.node(made).kind != Kind::kInput) {
    copy_hints(from_, k, made, to_);
  }
}

}  // namespace

Ref limb_constant(Graph& graph, Limbs& limbs, int limb_class, int limb,
                  const std::vector<Real>& values) {
  if (std::ranges::all_of(values, [&](const Real& x) { return identical(x, values.front()); })) {
    return graph.constant(values.front());
  }
  LimbClass& table = limbs[static_cast<std::size_t>(limb_class)];
  int column = find_column(table, values);
  if (column == 0) {
    table.columns.push_back(values);
    column = static_cast<int>(table.columns.size());
  }
  const Ref leaf =
      graph.input(kFixedArrays + limb_class, (std::abs(column) - 1) * table.size() + limb);
  return column < 0 ? -leaf : leaf;
}

Function fold_limb_constants(const Function& function, Limbs& limbs) {
  Function result{function.signature, {}, {}};
  Folder folder(function, limbs, result.graph);
  for (const Ref output : function.outputs) {
    result.outputs.push_back(folder.of(output));
  }
  return result;
}

}  // namespace treedyn::program
