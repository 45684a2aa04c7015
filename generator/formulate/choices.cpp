#include "formulate/choices.hpp"

#include <cstdint>
#include <numeric>
#include <type_traits>

namespace treedyn::formulate {

namespace {

template <auto field>
void set_field(Variant& variant, const Choice& choice, int setting) {
  using Value = decltype(LinkVariant{}.*field);
  set_links(variant, choice.links, field, static_cast<std::remove_reference_t<Value>>(setting));
}

constexpr int kCuts = 4;

std::uint8_t cut_of(int setting) {
  return setting == kCuts - 1 ? LinkVariant::kWholeRun : static_cast<std::uint8_t>(setting);
}

void set_cut(Variant& variant, const Choice& choice, int setting) {
  set_links(variant, choice.links, &LinkVariant::cut, cut_of(setting));
}

void set_run(Variant& variant, const Choice& choice, int setting) {
  set_links(variant, choice.links, &LinkVariant::merge_parallel, true);
  set_links(variant, choice.heads, &LinkVariant::cut, cut_of(setting));
}

void add_link_choices(const Freedom& freedom, const Options& options, const std::vector<int>& links,
                      bool parallel, std::vector<Choice>& choices) {
  const auto add = [&](bool wanted, int settings, void (*change)(Variant&, const Choice&, int)) {
    if (wanted) {
      choices.push_back({settings, links, change});
    }
  };
  const bool runs = options.has(Pass::kParallel);
  const bool frames = options.has(Pass::kNormals);
  const bool gauges = freedom.regrouping && options.has(Pass::kRegrouping);
  add(parallel && runs, 2, set_field<&LinkVariant::merge_parallel>);
  add(runs, kCuts, set_cut);
  add(frames, 4, set_field<&LinkVariant::angle>);
  add(frames && !freedom.fixed_frames, 4, set_field<&LinkVariant::slide>);
  add(gauges, 6, set_field<&LinkVariant::mass>);
  add(gauges, 4, set_field<&LinkVariant::tensor>);
  add(freedom.moment_form && options.has(Pass::kColumn), 2,
      set_field<&LinkVariant::column_of_father>);
  add(freedom.moment_form && options.has(Pass::kPseudoInertia), 2,
      set_field<&LinkVariant::tensor_moment>);
}

void add_global_choices(const model::Tree& tree, const Freedom& freedom, const Options& options,
                        std::vector<Choice>& choices) {
  const auto add = [&](bool wanted, int settings, void (*change)(Variant&, const Choice&, int)) {
    if (wanted && settings > 1) {
      choices.push_back({settings, {}, change});
    }
  };
  const bool units = freedom.regrouping && !freedom.fixed_length &&
                     options.has(Pass::kRegrouping) && !options.metres;
  const int lengths = units ? static_cast<int>(unit_lengths(tree).size()) + 1 : 1;
  add(true, lengths, [](Variant& v, const Choice&, int k) { v.unit_length = k; });
  add(freedom.tensor_form && options.has(Pass::kPseudoInertia), 2,
      [](Variant& v, const Choice&, int k) { v.inertia_tensor = k != 0; });
  add(freedom.trunk && has_trunk(tree) && options.has(Pass::kTrunk), 2,
      [](Variant& v, const Choice&, int k) { v.trunk = k != 0; });
  add(freedom.any_way, 3, [](Variant& v, const Choice&, int k) { v.way = static_cast<Way>(k); });
}

bool has_parallel_father(const NormalLink& link, const NormalTree& normal) {
  return link.revolute && link.father != model::kGround && link.euler.alpha.is_identity() &&
         normal.links[static_cast<std::size_t>(link.father)].revolute;
}

/// The first link of the run of parallel axes that link i is in.
int head_of(int i, const NormalTree& normal) {
  const NormalLink& link = normal.links[static_cast<std::size_t>(i)];
  return has_parallel_father(link, normal) ? head_of(link.father, normal) : i;
}

}  // namespace

std::vector<Choice> choices_of(const model::Tree& tree, const Freedom& freedom,
                               const Options& options) {
  std::vector<Choice> choices;
  if (!options.has(Pass::kSearch)) {
    return choices;
  }
  const NormalTree normal = normal_form(tree, {}, plain_variant(tree));
  for (const std::vector<int>& links : similar_links(tree)) {
    const NormalLink& first = normal.links[static_cast<std::size_t>(links.front())];
    if (first.revolute) {
      add_link_choices(freedom, options, links, has_parallel_father(first, normal), choices);
    }
  }
  add_global_choices(tree, freedom, options, choices);
  return choices;
}

std::vector<Choice> run_choices_of(const model::Tree& tree, const Options& options) {
  std::vector<Choice> choices;
  if (!options.has(Pass::kSearch) || !options.has(Pass::kParallel)) {
    return choices;
  }
  const NormalTree normal = normal_form(tree, {}, plain_variant(tree));
  for (const std::vector<int>& links : similar_links(tree)) {
    if (has_parallel_father(normal.links[static_cast<std::size_t>(links.front())], normal)) {
      Choice& run = choices.emplace_back(Choice{kCuts, links, set_run});
      for (const int i : links) {
        run.heads.push_back(head_of(i, normal));
      }
    }
  }
  return choices;
}

int other_settings(const std::vector<Choice>& choices) {
  return std::accumulate(choices.begin(), choices.end(), 0,
                         [](int sum, const Choice& choice) { return sum + choice.settings - 1; });
}

}  // namespace treedyn::formulate
