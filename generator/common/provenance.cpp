#include "common/provenance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <unordered_map>

#include "common/index.hpp"

namespace treedyn {

namespace {

Dimension combined(RecipeKind kind, const Dimension& a, const Dimension& b) {
  const int sign = kind == RecipeKind::kDivide ? -1 : 1;
  if (kind == RecipeKind::kMultiply || kind == RecipeKind::kDivide) {
    return {a.mass + sign * b.mass, a.length + sign * b.length, a.time + sign * b.time,
            a.is_known && b.is_known};
  }
  return {a.mass, a.length, a.time, a.is_known && a == b};
}

Dimension root(Dimension d) {
  d.is_known = d.is_known && d.mass % 2 == 0 && d.length % 2 == 0 && d.time % 2 == 0;
  return {d.mass / 2, d.length / 2, d.time / 2, d.is_known};
}

double seen(const Real& number) { return static_cast<double>(number.seen()); }

/// Steps make magnitudes.
double sign(const Real& number) { return number.seen() < 0 ? -1 : 1; }

/// How the result of an operation changes with its operands.
std::pair<double, double> rates(RecipeKind kind, double a, double b) {
  switch (kind) {
    case RecipeKind::kAdd:
      return {1, 1};
    case RecipeKind::kSubtract:
      return {1, -1};
    case RecipeKind::kMultiply:
      return {b, a};
    default:
      return {1 / b, -a / (b * b)};
  }
}

double rate(RecipeKind kind, double of, double result) {
  return kind == RecipeKind::kSqrt  ? 1 / (2 * result)
         : kind == RecipeKind::kSin ? static_cast<double>(cos(Digits(of)))
                                    : -static_cast<double>(sin(Digits(of)));
}

}  // namespace

/// What is known of numbers, by the magnitudes that they are seen as: the operations that made
/// them. Numbers of the robot that are seen as one magnitude are one variable.
class Sources {
  /// Numbers of the robot that are seen as one.
  struct Variable {
    std::vector<Origin> origins;
    bool are_several = false;  ///< not only one number of links that are alike
  };

  /// An operation, or a variable.
  struct Step {
    std::array<int, 2> of = {kNone, kNone};
    std::array<double, 2> rates = {};
    int variable = kNone;
    Dimension dimension;
  };

  /// How a number changes with a step, and with all that it hands on if nothing cancels.
  struct Slope {
    double rate = 0;
    double most = 0;

    void add(const Slope& of, double factor) {
      rate += of.rate * factor;
      most += of.most * std::abs(factor);
    }
  };

 public:
  static constexpr int kNone = -1;

  [[nodiscard]] int find(const Real& number) const {
    if (by_number_.empty() || !number.has_stand_in()) {
      return kNone;
    }
    const auto found = by_number_.find(magnitude(number));
    return found == by_number_.end() ? kNone : found->second;
  }
  [[nodiscard]] Dimension dimension(int step) const {
    return step == kNone ? Dimension() : steps_[to_index(step)].dimension;
  }
  [[nodiscard]] std::optional<Provenance> provenance(const Real& number) const {
    const int step = find(number);
    if (step == kNone) {
      return std::nullopt;
    }
    std::vector<Origin> origins = origins_of(step);
    return origins.empty() ? std::nullopt
                           : std::optional(Provenance{std::move(origins), dimension(step)});
  }

  void begin(const std::vector<std::pair<Real, Provenance>>& numbers,
             const std::vector<int>& like) {
    std::vector<std::pair<Digits, Provenance>> own;
    own.reserve(numbers.size());
    for (const auto& [number, source] : numbers) {
      own.emplace_back(magnitude(number), source);
    }
    const std::size_t common = std::min(own.size(), robot_.size());
    const bool same = std::equal(own.begin(), own.begin() + std::ptrdiff_t(common), robot_.begin());
    if (same && own.size() <= robot_.size()) {
      return;
    }
    if (!same) {
      *this = {};
    }
    const std::size_t first_new = robot_.size();
    robot_ = own;
    for (std::size_t k = first_new; k < numbers.size(); ++k) {
      if (numbers[k].first.has_stand_in()) {
        add_variable(magnitude(numbers[k].first), numbers[k].second, like);
      }
    }
  }

  /// A step that makes no number that is known.
  int add(int a, double rate_a, int b, double rate_b, const Dimension& dimension) {
    steps_.push_back({{a, b}, {rate_a, rate_b}, kNone, dimension});
    return static_cast<int>(steps_.size()) - 1;
  }
  /// The first way to a number counts; a number of a search alone has no digits of the robot.
  [[nodiscard]] bool would_note(const Real& number) const {
    return number.has_stand_in() && !by_number_.contains(magnitude(number));
  }
  void note(const Real& number, int a, double rate_a, int b, double rate_b,
            const Dimension& dimension) {
    if ((a == kNone && b == kNone) || !number.has_stand_in()) {
      return;
    }
    const auto [place, is_new] = by_number_.try_emplace(magnitude(number), kNone);
    if (is_new) {
      place->second = add(a, sign(number) * rate_a, b, sign(number) * rate_b, dimension);
    }
  }

  /// What a task is given: all that is known.
  [[nodiscard]] std::shared_ptr<Sources> for_task() const {
    auto copy = std::make_shared<Sources>(*this);
    copy->given_ = steps_.size();
    return copy;
  }
  /// \param other  that of a task
  void learn(const Sources& other) {
    if (robot_ != other.robot_) {
      const std::size_t given = std::min(given_, other.given_);
      *this = other;
      given_ = given;
      return;
    }
    const int offset = static_cast<int>(steps_.size()) - static_cast<int>(other.given_);
    const auto here = [&](int step) {
      return step < static_cast<int>(other.given_) ? step : step + offset;
    };
    for (std::size_t k = other.given_; k < other.steps_.size(); ++k) {
      Step step = other.steps_[k];
      step.of = {here(step.of[0]), here(step.of[1])};
      steps_.push_back(step);
    }
    for (const auto& [number, step] : other.by_number_) {
      by_number_.try_emplace(number, here(step));
    }
  }

 private:
  static Digits magnitude(const Real& number) {
    return number.seen() < 0 ? Digits(-number.seen()) : number.seen();
  }
  /// True if it is the same number of another link that is like those.
  static bool is_alike(const Origin& one, const std::vector<Origin>& others,
                       const std::vector<int>& like) {
    const auto first = [&](int link) {
      return link >= 0 && link < static_cast<int>(like.size()) ? like[to_index(link)] : link;
    };
    return std::ranges::all_of(others, [&](const Origin& other) {
      return other.part == one.part && other.component == one.component && other.link != one.link &&
             first(other.link) == first(one.link);
    });
  }
  void add_variable(const Digits& magnitude, const Provenance& source,
                    const std::vector<int>& like) {
    const auto [place, is_new] = by_number_.try_emplace(magnitude, kNone);
    if (is_new || steps_[to_index(place->second)].variable == kNone) {
      place->second = add(kNone, 0, kNone, 0, source.dimension);
      steps_.back().variable = static_cast<int>(variables_.size());
      variables_.emplace_back();
    }
    Step& step = steps_[to_index(place->second)];
    step.dimension = source.dimension;
    Variable& variable = variables_[to_index(step.variable)];
    for (const Origin& origin : source.origins) {
      const bool is_length = origin.part == ModelPart::kPlace || origin.part == ModelPart::kTurn;
      variable.are_several =
          variable.are_several || (!is_length && !is_alike(origin, variable.origins, like));
      variable.origins.push_back(origin);
    }
  }

  /// What a step depends on. Of a variable whose parts cancel, but for rounding, nothing is left,
  /// unless it is several numbers of which the difference has vanished. O(steps below it)
  [[nodiscard]] std::vector<Origin> origins_of(int of) const {
    constexpr double kRounding = 1e-12;
    std::map<int, Slope, std::greater<>> open = {{of, {1, 1}}};
    std::map<int, Slope> variables;
    while (!open.empty()) {
      const auto [number, slope] = *open.begin();
      open.erase(open.begin());
      const Step& step = steps_[to_index(number)];
      if (step.variable != kNone) {
        variables[step.variable].add(slope, 1);
      }
      for (std::size_t k = 0; k < step.of.size(); ++k) {
        if (step.of[k] != kNone) {
          open[step.of[k]].add(slope, step.rates[k]);
        }
      }
    }
    std::vector<Origin> origins;
    for (const auto& [number, slope] : variables) {
      const Variable& variable = variables_[to_index(number)];
      const double least = kRounding * slope.most;
      if ((variable.are_several ? slope.most : std::abs(slope.rate)) > least) {
        origins.insert(origins.end(), variable.origins.begin(), variable.origins.end());
      }
    }
    std::ranges::sort(origins);
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return origins;
  }

  std::vector<std::pair<Digits, Provenance>> robot_;
  std::vector<Variable> variables_;
  std::vector<Step> steps_;  ///< operands before their results
  std::unordered_map<Digits, int> by_number_;
  std::size_t given_ = 0;  ///< of a task: how many steps its caller knows
};

namespace {

std::shared_ptr<Sources>& of_this_thread() {
  static thread_local auto all = std::make_shared<Sources>();
  return all;
}

Sources& sources() { return *of_this_thread(); }

}  // namespace

std::shared_ptr<Sources> copy_of_sources() { return sources().for_task(); }

std::shared_ptr<Sources> exchange_sources(std::shared_ptr<Sources> of_thread) {
  of_this_thread().swap(of_thread);
  return of_thread;
}

void learn_sources(const Sources& of_task) { sources().learn(of_task); }

std::optional<Provenance> provenance_of(const Real& number) { return sources().provenance(number); }

void begin_provenance(const std::vector<std::pair<Real, Provenance>>& numbers,
                      const std::vector<int>& like) {
  sources().begin(numbers, like);
}

void note_result(RecipeKind kind, const Real& a, const Real& b, const Real& result) {
  Sources& all = sources();
  const int of_a = all.find(a);
  const int of_b = all.find(b);
  const auto [by_a, by_b] = rates(kind, seen(a), seen(b));
  const bool is_sum = kind == RecipeKind::kAdd || kind == RecipeKind::kSubtract;
  // a number of the equations has no unit in a product, and that of the other one in a sum
  const Dimension dimension = is_sum && of_a == Sources::kNone ? all.dimension(of_b)
                              : is_sum && of_b == Sources::kNone
                                  ? all.dimension(of_a)
                                  : combined(kind, all.dimension(of_a), all.dimension(of_b));
  all.note(result, of_a, sign(a) * by_a, of_b, sign(b) * by_b, dimension);
}

void note_result(RecipeKind kind, const Real& of, const Real& result) {
  Sources& all = sources();
  const int source = all.find(of);
  all.note(result, source, sign(of) * rate(kind, seen(of), seen(result)), Sources::kNone, 0,
           kind == RecipeKind::kSqrt ? root(all.dimension(source)) : Dimension());
}

void note_ratio(std::span<const Real> of, const Real& result) {
  Sources& all = sources();
  if (!all.would_note(result)) {
    return;
  }
  int sum = Sources::kNone;
  double rate = seen(result);
  for (const Real& number : of) {
    rate += 1;  // some number: what is not known cancels with nothing
    sum = all.add(sum, 1, all.find(number), rate, {});
  }
  all.note(result, sum, 1, Sources::kNone, 0, {});
}

}  // namespace treedyn
