#include "program/pivots.hpp"

#include <algorithm>
#include <functional>
#include <ios>
#include <set>

#include "common/index.hpp"
#include "common/transformed.hpp"
#include "program/interpret.hpp"
#include "program/random.hpp"

namespace treedyn::program {

namespace {

using NodeValues = std::vector<Real>;  ///< by node

NodeValues values_at(const Function& function, const std::vector<double>& q) {
  return node_values<Real>(
      function.graph, function.outputs,
      [&](int array, int element) {
        const std::uint64_t name =
            (static_cast<std::uint64_t>(array) << 32U) + static_cast<std::uint64_t>(element);
        return Real(array == 0 ? q[to_index(element)] : Random(scramble(name)).symmetric());
      },
      elementary_of_any<Real>);
}

class Pivots {
 public:
  Pivots(const Function& function, const std::vector<std::vector<double>>& states)
      : function_(function), graph_(function.graph), uses_(graph_.size(), 0) {
    for (const std::vector<double>& q : states) {
      values_.push_back(values_at(function, q));
    }
    for (const Ref k : reachable(graph_, function.outputs)) {
      for_each_operand(graph_.node(k), [&](Ref operand) { ++uses_[node_index(operand)]; });
    }
    for (const Ref output : function.outputs) {
      ++uses_[node_index(output)];
    }
  }

  [[nodiscard]] std::vector<Pivot> find() const;

 private:
  [[nodiscard]] std::set<Ref> divisors() const;
  [[nodiscard]] Pivot pivot(Ref divisor) const;
  void visit_terms(Ref a, const std::function<void(Ref)>& visit) const;
  /// +1 or -1 in all states, or 0.
  [[nodiscard]] int sign(Ref a) const;
  [[nodiscard]] Real sum_of_sizes(Ref a) const;
  [[nodiscard]] Real largest_size(Ref a) const;
  [[nodiscard]] bool may_be_named(Ref a) const;
  [[nodiscard]] bool of_first_alone(Ref a) const;

  const Function& function_;
  const Graph& graph_;
  std::vector<int> uses_;           // by node
  std::vector<NodeValues> values_;  // by state
};

/// Of divisions, and the elements of an output d.
std::set<Ref> Pivots::divisors() const {
  std::set<Ref> result;
  for (const Ref k : reachable(graph_, function_.outputs)) {
    if (graph_.node(k).kind == Kind::kDivide) {
      result.insert(std::abs(graph_.node(k).b));
    }
  }
  std::size_t first = 0;
  for (const Array& array : function_.signature.outputs) {
    for (std::size_t k = 0; array.name == "d" && k < to_index(array.size); ++k) {
      result.insert(std::abs(function_.outputs[first + k]));
    }
    first += to_index(array.size);
  }
  std::erase_if(result, [this](Ref a) { return graph_.is_constant(a) || !of_first_alone(a); });
  return result;
}

/// The partial sums and the terms of a sum, without itself.
void Pivots::visit_terms(Ref a, const std::function<void(Ref)>& visit) const {
  if (graph_.node(a).kind == Kind::kAdd) {
    for_each_operand(graph_.node(a), [&](Ref operand) {
      visit(std::abs(operand));
      visit_terms(operand, visit);
    });
  }
}

int Pivots::sign(Ref a) const {
  const auto all = [&](auto holds) {
    return std::ranges::all_of(values_,
                               [&](const NodeValues& at) { return holds(at[node_index(a)]); });
  };
  return all([](const Real& x) { return x > 0; })   ? 1
         : all([](const Real& x) { return x < 0; }) ? -1
                                                    : 0;
}

Real Pivots::sum_of_sizes(Ref a) const {
  Real sum = 0;
  for (const NodeValues& at : values_) {
    sum += abs(at[node_index(a)]);
  }
  return sum;
}

Real Pivots::largest_size(Ref a) const {
  Real largest = 0;
  for (const NodeValues& at : values_) {
    largest = std::max(largest, Real(abs(at[node_index(a)])));
  }
  return largest;
}

/// A product that only its sum uses may be contracted with it, which a name of its own would
/// prevent.
bool Pivots::may_be_named(Ref a) const {
  return graph_.node(a).kind == Kind::kAdd ||
         (graph_.node(a).kind == Kind::kMultiply && uses_[node_index(a)] > 1);
}

bool Pivots::of_first_alone(Ref a) const {
  const std::vector<Ref> root = {a};
  return std::ranges::none_of(reachable(graph_, root), [this](Ref k) {
    return graph_.node(k).kind == Kind::kInput && graph_.node(k).a != 0;
  });
}

Pivot Pivots::pivot(Ref divisor) const {
  const int own = sign(divisor);
  Pivot result{own < 0 ? -divisor : divisor, 0, 0, own != 0};
  Real size = largest_size(divisor);
  Real most = sum_of_sizes(divisor);
  visit_terms(divisor, [&](Ref term) {
    size = std::max(size, largest_size(term));
    const Real sum = sum_of_sizes(term);
    if (may_be_named(term) && sign(term) != 0 && sum > most) {
      most = sum;
      result.whole = sign(term) * term;
    }
  });
  result.size = static_cast<double>(Real(size.str(2, std::ios_base::scientific)));
  return result;
}

std::vector<Pivot> Pivots::find() const {
  return transformed(divisors(), [&](Ref divisor) { return pivot(divisor); });
}

}  // namespace

std::vector<Pivot> pivots_of(const Function& function,
                             const std::vector<std::vector<double>>& states) {
  return Pivots(function, states).find();
}

namespace {

void add_array(Function& function, const char* name, const std::vector<Ref>& refs) {
  if (!refs.empty()) {
    function.signature.outputs.push_back({name, static_cast<int>(refs.size()), ""});
    function.outputs.insert(function.outputs.end(), refs.begin(), refs.end());
  }
}

}  // namespace

void show_pivots(Function& function, const std::vector<Pivot>& pivots) {
  std::vector<Ref> values;
  std::vector<Ref> wholes;
  for (const Pivot& pivot : pivots) {
    values.push_back(pivot.value);
    if (pivot.whole != 0) {
      wholes.push_back(pivot.whole);
    }
  }
  add_array(function, kPivotArray, values);
  add_array(function, kWholeArray, wholes);
}

Cost test_cost(const std::vector<Pivot>& pivots) {
  return {.mul = static_cast<int>(
              std::ranges::count_if(pivots, [](const Pivot& pivot) { return pivot.whole != 0; }))};
}

}  // namespace treedyn::program
