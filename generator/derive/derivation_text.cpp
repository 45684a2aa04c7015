#include "derive/derivation_text.hpp"

#include <map>
#include <set>

#include <fmt/format.h>

#include "derive/columns.hpp"
#include "derive/forms.hpp"
#include "equations/symbols.hpp"

namespace treedyn::derive {
namespace {

namespace eq = equations;

using Names = std::map<int, std::string>;

/// What the field calls the values that occur everywhere.
Names known_names(const Values& values) {
  Values copy = values;
  Columns columns(copy);
  const block::Expression w = eq::z_d * eq::sigma * eq::qd;
  const block::Expression alpha =
      eq::D * eq::sigma * eq::qd_d * block::skew_transpose(eq::z_d) * (eq::D - eq::E) * w;
  Names names;
  const auto add = [&](const char* name, const block::Expression& e) {
    names.emplace(columns.column(e), name);
  };
  add("w", w);
  add("ω", eq::D * w);
  add("v", eq::D * (eq::z_d * (eq::E - eq::sigma) * eq::qd +
                    block::skew_transpose(eq::s_d) * (eq::D - eq::E) * w));
  add("ω_f", (eq::D - eq::E) * w);
  add("α", alpha);
  add("α", eq::D * eq::z_d * eq::sigma * eq::qdd + alpha);
  add("P", eq::D * eq::s_d * eq::ones);
  add("m^c", transpose(eq::D) * eq::m_d * eq::ones);
  add("q̇_s", (eq::E - eq::sigma) * eq::qd);
  return names;
}

/// Of dynamics: Ω, the accelerations of joints, the forces and moments that they carry.
void add_dynamic_names(const Values& values, const std::vector<int>& needed, Names& names) {
  const std::vector<Turning> turnings = turnings_about_axes(values, needed);
  if (turnings.size() != 1) {
    return;
  }
  names.emplace(turnings.front().Omega, "Ω");
  for (const int id : needed) {
    const Value& v = values[id];
    if (v.type == Type::kVector) {
      const char* const name = v.op == Op::kPath       ? "a"
                               : v.op == Op::kSubtree  ? "F"
                               : v.op == Op::kBackward ? "M"
                                                       : nullptr;
      if (name != nullptr) {
        names.emplace(id, name);
      }
    }
  }
}

/// Of symmetric matrices: composites, and the force and moment of the column that is asked for.
void add_composite_names(const Values& values, const std::vector<int>& needed, Names& names) {
  for (const int id : needed) {
    const Value& v = values[id];
    if (v.op == Op::kComposite) {
      names.emplace(id, "I^c");
      names.emplace(v.operands[1], "h^c");
    } else if (values.choices().composites && values.of_unit(id) && v.type == Type::kVector) {
      const char* const name = v.op == Op::kSubtree ? "F" : v.op == Op::kBackward ? "M" : nullptr;
      if (name != nullptr) {
        names.emplace(id, name);
      }
    }
  }
}

class Printer {
 public:
  /// \param result  the name of the one root; empty: one like the others
  Printer(const Values& values, const std::vector<int>& roots, const std::string& result)
      : values_(values), needed_(values.needed(roots)) {
    add_own_names();
    if (!result.empty() && roots.size() == 1 && taken_.insert(result).second) {
      names_.emplace(roots.front(), result);
    }
    add_field_names();
  }

  std::vector<Line> run() {
    std::vector<Line> result;
    int count = 0;
    for (const int id : needed_) {
      const Value& value = values_[id];
      if (is_symbol(value)) {
        continue;
      }
      while (names_.count(id) == 0) {
        const std::string next = fmt::format("x{}", ++count);
        if (taken_.insert(next).second) {
          names_[id] = next;
        }
      }
      result.push_back({id, fmt::format("{} = {}", name(id), expression(value)), rules(id)});
    }
    return result;
  }

 private:
  /// Of symbols, and of values that the derivation itself names.
  void add_own_names() {
    for (const int id : needed_) {
      const Value& value = values_[id];
      if (is_symbol(value)) {
        names_[id] = value.op == Op::kAtLink ? name(value.operands.front()) : symbol(value);
      } else if (!value.name.empty()) {
        names_[id] = value.name;
      }
    }
    for (const auto& [travelling, definition] : values_.definitions()) {
      names_[definition] = values_[travelling].name;
    }
    for (const auto& [id, own] : names_) {
      taken_.insert(own);
    }
  }

  /// A name is one value's: what the field calls alike gets a number, α and α_2.
  void add_field_names() {
    Names field = known_names(values_);
    add_dynamic_names(values_, needed_, field);
    add_composite_names(values_, needed_, field);
    for (const int id : needed_) {
      const auto found = field.find(id);
      if (found == field.end() || names_.count(id) != 0) {
        continue;
      }
      std::string once = found->second;
      for (int k = 2; !taken_.insert(once).second; ++k) {
        once = fmt::format("{}_{}", found->second, k);
      }
      names_[id] = once;
    }
  }

  [[nodiscard]] bool is_symbol(const Value& value) const {
    return value.op == Op::kLeaf || value.op == Op::kOnes || value.op == Op::kZero ||
           value.op == Op::kUnit || value.op == Op::kIdentity || value.op == Op::kTravelling ||
           (value.op == Op::kAtLink && values_[value.operands.front()].op == Op::kLeaf);
  }

  /// A symbol has no line: what made it (h of m c) stands where it is used.
  [[nodiscard]] std::set<Rule> rules(int id) const {
    std::set<Rule> result = values_.made_by(id);
    for (const int operand : values_[id].operands) {
      if (is_symbol(values_[operand])) {
        result.insert(values_.made_by(operand).begin(), values_.made_by(operand).end());
      }
    }
    return result;
  }

  static std::string symbol(const Value& value) {
    switch (value.op) {
      case Op::kOnes:
        return "1";
      case Op::kIdentity:
        return "E_3";  // E is that of links in E-σ
      case Op::kZero:
        return "0";
      case Op::kUnit:
        return "e_j";
      default:
        return value.name.find('-') == std::string::npos ? value.name
                                                         : fmt::format("({})", value.name);
    }
  }

  static const char* item(Set set) {
    return set == Set::kPoints ? "point" : set == Set::kRows ? "row" : "link";
  }

  [[nodiscard]] const std::string& name(int id) const { return names_.at(id); }

  [[nodiscard]] std::string sum(const Value& value) const {
    std::string text;
    for (std::size_t k = 0; k < value.operands.size(); ++k) {
      const Ratio& f = value.factors[k];
      const bool minus = f.numerator < 0;
      const int size = minus ? -f.numerator : f.numerator;
      const std::string number = f.denominator != 1 ? fmt::format("{}/{} ", size, f.denominator)
                                 : size != 1        ? fmt::format("{} ", size)
                                                    : "";
      text += text.empty() ? (minus ? "-" : "") : minus ? " - " : " + ";
      text += number + name(value.operands[k]);
    }
    return text;
  }

  [[nodiscard]] const std::string& first(const Value& value) const {
    return name(value.operands.front());
  }
  [[nodiscard]] const std::string& last(const Value& value) const {
    return name(value.operands.back());
  }

  /// Of values that come along the tree or from all of its links, and of numbers of joints.
  [[nodiscard]] std::string tree_expression(const Value& value) const {
    switch (value.op) {
      case Op::kPath:
        return value.operands.size() == 1
                   ? fmt::format("D {}", first(value))
                   : fmt::format("{} at every link + D {}", last(value), first(value));
      case Op::kPathStrict:
        return fmt::format("N {}", first(value));
      case Op::kSubtree:
        return fmt::format("D^T {}", first(value));
      case Op::kSubtreeStrict:
        return fmt::format("N^T {}", first(value));
      case Op::kBackward:
        return fmt::format("D^T {} + N^T {}", first(value), last(value));
      case Op::kFather:
        return value.operands.size() == 1
                   ? fmt::format("{} of the father", first(value))
                   : fmt::format("{} of the father, {} above roots", first(value), last(value));
      case Op::kSons:
        return fmt::format("sum of {} of the sons", first(value));
      case Op::kGather:
        return fmt::format("W {}", first(value));
      case Op::kPick:
        return fmt::format("W^T {}", first(value));
      case Op::kSpread:
        return fmt::format("{} at every {}", first(value), item(value.set));
      case Op::kCollect:
        return fmt::format("sum of {} over every {}", first(value),
                           item(values_[value.operands.front()].set));
      case Op::kFold:
        return fmt::format("{} + sum of {} of the sons", first(value), last(value));
      case Op::kDiagonal:
        return fmt::format("diagonal of {}", first(value));
      case Op::kTransposed:
        return fmt::format("{}^T", first(value));
      case Op::kCongruence:
        return value.operands.size() == 1 ? fmt::format("{0} {0}^T", first(value))
                                          : fmt::format("{0} {1} {0}^T", first(value), last(value));
      case Op::kEliminated:
      case Op::kFromLeaves:
      case Op::kFromRoot: {
        const bool up = value.op != Op::kFromRoot;
        return fmt::format("{} - {}{} {}, from the {}", first(value), last(value), up ? "^T" : "",
                           value.name, up ? "leaves" : "root");
      }
      default:
        return symbol(value);
    }
  }

  [[nodiscard]] std::string expression(const Value& value) const {
    switch (value.op) {
      case Op::kLinear:
        return sum(value);
      case Op::kScale: {
        std::string text;
        for (const int operand : value.operands) {
          text += (text.empty() ? "" : " ") + name(operand);
        }
        return text;
      }
      case Op::kDot:
        return fmt::format("{}·{}", first(value), last(value));
      case Op::kCross:
        return fmt::format("{} × {}", first(value), last(value));
      case Op::kSkew:
        return fmt::format("Λ({})", first(value));
      case Op::kSkewProduct:
        return first(value) == last(value) ? fmt::format("Λ({})²", first(value))
                                           : fmt::format("Λ({}) Λ({})", first(value), last(value));
      case Op::kProduct:
      case Op::kApply:
        return fmt::format("{} {}", first(value), last(value));
      case Op::kApplyTranspose:
        return fmt::format("{}^T {}", first(value), last(value));
      case Op::kComposite:
        return fmt::format(
            "tr(Ψ^c) E_3 - Ψ^c, Ψ^c = D^T Ψ + N^T ({1} {2}^T + {2} {1}^T + {0} {2} {2}^T)",
            first(value), name(value.operands[1]), last(value));
      case Op::kMoment:
        return fmt::format("vee({} Ψ)", first(value));
      case Op::kSquare:
        return fmt::format("-tr(Λ({})² Ψ)", first(value));
      case Op::kPseudo:
        return fmt::format("½ tr({0}) E_3 - {0}", first(value));
      case Op::kComponent:
        return fmt::format("{}_{}", first(value), "xyz"[value.component]);
      case Op::kAtLink:
        return first(value);
      case Op::kReciprocal:
        return fmt::format("1 / {}", first(value));
      case Op::kLever:
        return value.operands.size() == 2
                   ? fmt::format("Λ({}) {}", first(value), last(value))
                   : fmt::format("Λ({}) {}^T - {} Λ({})", first(value), name(value.operands[1]),
                                 last(value), first(value));
      case Op::kAcross:
        return fmt::format("{} - {} {}^T, across {} and {}", first(value), name(value.operands[1]),
                           name(value.operands[2]), name(value.operands[3]), last(value));
      case Op::kAlong:
        return fmt::format("{}, along {} {}", first(value), name(value.operands[1]), last(value));
      case Op::kAssemble:
        return fmt::format("({}, {}, {})", first(value), name(value.operands[1]), last(value));
      default:
        return tree_expression(value);
    }
  }

  const Values& values_;
  std::vector<int> needed_;
  Names names_;
  std::set<std::string> taken_;
};

}  // namespace

std::vector<Line> lines(const Derivation& derivation, const std::string& result) {
  return Printer(derivation.values, derivation.roots, result).run();
}

}  // namespace treedyn::derive
