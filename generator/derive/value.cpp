#include "derive/value.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/error.hpp"

namespace treedyn::derive {
namespace {

/// A hundredfold of what our equations take.
constexpr int kMostAsked = 2000000;

std::string key_of(const Value& value) {
  std::string key =
      fmt::format("{} {} {} {} {}", static_cast<int>(value.op), static_cast<int>(value.set),
                  static_cast<int>(value.type), value.component, value.name);
  for (const int operand : value.operands) {
    key += fmt::format(" {}", operand);
  }
  for (const Ratio& factor : value.factors) {
    key += fmt::format(" {}/{}", factor.numerator, factor.denominator);
  }
  return key;
}

}  // namespace

Terms terms_in(const Value& sum) {
  Terms terms;
  for (std::size_t k = 0; k < sum.operands.size(); ++k) {
    terms.emplace_back(sum.factors[k], sum.operands[k]);
  }
  return terms;
}

Value plain_sum(const Terms& terms, Set set, Type type) {
  Value sum{Op::kLinear, set, type, {}, 0, {}, {}};
  for (const auto& [factor, x] : terms) {
    sum.operands.push_back(x);
    sum.factors.push_back(factor);
  }
  return sum;
}

int Values::intern(Value value) {
  if (++asked_ > kMostAsked) {
    throw TooLarge(fmt::format(
        "takes more than {} steps to derive; expected fewer factors that are sums", kMostAsked));
  }
  const auto [place, is_new] = known_.emplace(key_of(value), size());
  if (is_new) {
    of_unit_.push_back(
        value.op == Op::kUnit ||
        std::ranges::any_of(value.operands, [this](int operand) { return of_unit(operand); }));
    values_.push_back(std::move(value));
    made_by_.emplace_back();
  }
  return place->second;
}

int Values::note(Rule rule, int id) {
  note(std::set{rule}, id);
  return id;
}

void Values::note(const std::set<Rule>& rules, int id) {
  acted_.insert(rules.begin(), rules.end());
  if (&rules != &made_by(id)) {
    made_by_[static_cast<std::size_t>(id)].insert(rules.begin(), rules.end());
  }
  const Value& value = (*this)[id];
  if (value.op == Op::kLinear && value.operands.size() == 1) {  // sums take it apart
    note(rules, value.operands.front());
  }
}

void remake(const Values& values, Values& anew, std::vector<int>& roots,
            const std::function<int(Value)>& made) {
  std::vector<int> place(static_cast<std::size_t>(values.size()), -1);
  for (const int id : values.needed(roots)) {
    Value value = values[id];
    for (int& operand : value.operands) {
      operand = place[static_cast<std::size_t>(operand)];
    }
    const int made_anew = made(std::move(value));
    anew.note(values.made_by(id), made_anew);
    place[static_cast<std::size_t>(id)] = made_anew;
  }
  for (int& root : roots) {
    root = place[static_cast<std::size_t>(root)];
  }
}

std::vector<int> Values::needed(const std::vector<int>& roots) const {
  std::vector<bool> wanted(values_.size(), false);
  std::vector<int> open = roots;
  while (!open.empty()) {
    const int id = open.back();
    open.pop_back();
    if (wanted[static_cast<std::size_t>(id)]) {
      continue;
    }
    wanted[static_cast<std::size_t>(id)] = true;
    open.insert(open.end(), (*this)[id].operands.begin(), (*this)[id].operands.end());
    if (const auto definition = definitions_.find(id); definition != definitions_.end()) {
      open.push_back(definition->second);
    }
  }
  std::vector<int> result;
  for (int id = 0; id < size(); ++id) {
    if (wanted[static_cast<std::size_t>(id)]) {
      result.push_back(id);
    }
  }
  return result;
}

}  // namespace treedyn::derive
