#include "common/provenance.hpp"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <iterator>
#include <map>
#include <tuple>
#include <unordered_map>

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

std::vector<Origin> united(const std::vector<Origin>& a, const std::vector<Origin>& b) {
  std::vector<Origin> result;
  std::ranges::set_union(a, b, std::back_inserter(result));
  return result;
}

}  // namespace

/// What is known of numbers, by the magnitudes that they are seen as; each source once.
class Sources {
  struct Hash {
    std::size_t operator()(const Digits& x) const { return std::hash<Digits>()(x); }
  };

 public:
  static constexpr int kNone = -1;

  [[nodiscard]] int find(const Real& number) const {
    if (by_number_.empty() || number.digits() == number.seen()) {
      return kNone;
    }
    const auto found = by_number_.find(magnitude(number));
    return found == by_number_.end() ? kNone : found->second;
  }
  [[nodiscard]] const Provenance& at(int index) const {
    return sources_[static_cast<std::size_t>(index)];
  }

  void begin(const std::vector<std::pair<Real, Provenance>>& numbers) {
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
      const auto& [number, source] = numbers[k];
      const int known = find(number);
      if (number.digits() != number.seen()) {
        Provenance all = source;
        all.origins = known == kNone ? all.origins : united(at(known).origins, all.origins);
        by_number_[magnitude(number)] = index_of(all);
      }
    }
  }

  /// Of two ways to one number the one with less in it counts: the rest has cancelled.
  void note(const Real& number, int source) {
    if (source == kNone || number.digits() == number.seen()) {
      return;
    }
    keep(magnitude(number), source);
  }

  /// The same choice for what a task has noted of the same numbers.
  void learn(const Sources& other) {
    if (robot_ != other.robot_) {
      *this = other;
      return;
    }
    std::vector<int> here;
    for (const Provenance& source : other.sources_) {
      here.push_back(index_of(source));
    }
    for (const auto& [number, index] : other.by_number_) {
      keep(number, here[static_cast<std::size_t>(index)]);
    }
  }

  int combine(RecipeKind kind, int a, int b) {
    if (a == kNone && b == kNone) {
      return kNone;
    }
    const auto [place, is_new] = combinations_.try_emplace({kind, a, b}, kNone);
    if (is_new) {
      place->second = index_of(combination(kind, a, b));
    }
    return place->second;
  }

  int without_unit(int a) {
    Provenance source = at(a);
    source.dimension = {};
    return index_of(source);
  }
  int root(int a) {
    Provenance source = at(a);
    Dimension& d = source.dimension;
    d.is_known = d.is_known && d.mass % 2 == 0 && d.length % 2 == 0 && d.time % 2 == 0;
    d = {d.mass / 2, d.length / 2, d.time / 2, d.is_known};
    return index_of(source);
  }

 private:
  static Digits magnitude(const Real& number) {
    return number.seen() < 0 ? Digits(-number.seen()) : number.seen();
  }
  void keep(const Digits& magnitude, int source) {
    const auto [place, is_new] = by_number_.try_emplace(magnitude, source);
    if (!is_new && is_less(source, place->second)) {
      place->second = source;
    }
  }
  [[nodiscard]] bool is_less(int a, int b) const {
    const std::size_t x = at(a).origins.size();
    const std::size_t y = at(b).origins.size();
    return x != y ? x < y : at(a) < at(b);
  }
  int index_of(const Provenance& source) {
    const auto [place, is_new] = known_.try_emplace(source, static_cast<int>(sources_.size()));
    if (is_new) {
      sources_.push_back(source);
    }
    return place->second;
  }
  /// A number of the equations has no unit in a product, and that of the other one in a sum.
  [[nodiscard]] Provenance combination(RecipeKind kind, int a, int b) const {
    const bool sum = kind == RecipeKind::kAdd || kind == RecipeKind::kSubtract;
    if (a != kNone && b != kNone) {
      return {united(at(a).origins, at(b).origins),
              combined(kind, at(a).dimension, at(b).dimension)};
    }
    const Provenance& one = at(a != kNone ? a : b);
    const Dimension none;
    return {one.origins, sum          ? one.dimension
                         : a != kNone ? combined(kind, one.dimension, none)
                                      : combined(kind, none, one.dimension)};
  }

  std::vector<std::pair<Digits, Provenance>> robot_;
  std::map<Provenance, int> known_;
  std::deque<Provenance> sources_;  // which stay where they are
  std::map<std::tuple<RecipeKind, int, int>, int> combinations_;
  std::unordered_map<Digits, int, Hash> by_number_;
};

namespace {

std::shared_ptr<Sources>& of_this_thread() {
  static thread_local auto all = std::make_shared<Sources>();
  return all;
}

Sources& sources() { return *of_this_thread(); }

}  // namespace

std::shared_ptr<Sources> copy_of_sources() { return std::make_shared<Sources>(sources()); }

std::shared_ptr<Sources> exchange_sources(std::shared_ptr<Sources> of_thread) {
  of_this_thread().swap(of_thread);
  return of_thread;
}

void learn_sources(const Sources& of_task) { sources().learn(of_task); }

const Provenance* provenance_of(const Real& number) {
  const int found = sources().find(number);
  return found == Sources::kNone ? nullptr : &sources().at(found);
}

void begin_provenance(const std::vector<std::pair<Real, Provenance>>& numbers) {
  sources().begin(numbers);
}

void note_result(RecipeKind kind, const Real& a, const Real& b, const Real& result) {
  Sources& all = sources();
  all.note(result, all.combine(kind, all.find(a), all.find(b)));
}

void note_root(const Real& of, const Real& result) {
  Sources& all = sources();
  if (const int source = all.find(of); source != Sources::kNone) {
    all.note(result, all.root(source));
  }
}

void note_ratio(std::span<const Real> of, const Real& result) {
  Sources& all = sources();
  int made = Sources::kNone;
  for (const Real& number : of) {
    made = all.combine(RecipeKind::kMultiply, made, all.find(number));
  }
  if (made != Sources::kNone) {
    all.note(result, all.without_unit(made));
  }
}

}  // namespace treedyn
