#include "formulate/choices.hpp"

#include <cstdint>
#include <numeric>

namespace treedyn::formulate {

namespace {

template <auto field, class Enum>
void set_enum(Variant& variant, const std::vector<int>& links, int setting) {
  set_links(variant, links, field, static_cast<Enum>(setting));
}

template <auto field>
void set_flag(Variant& variant, const std::vector<int>& links, int setting) {
  set_links(variant, links, field, setting != 0);
}

void set_cut(Variant& variant, const std::vector<int>& links, int setting) {
  const std::uint8_t cut =
      setting == 3 ? LinkVariant::kWholeRun : static_cast<std::uint8_t>(setting);
  set_links(variant, links, &LinkVariant::cut, cut);
}

void add_link_choices(const Freedom& freedom, const Options& options, const std::vector<int>& links,
                      bool parallel, std::vector<Choice>& choices) {
  const auto add = [&](bool wanted, int settings,
                       void (*set)(Variant&, const std::vector<int>&, int)) {
    if (wanted) {
      choices.push_back({settings, links, set});
    }
  };
  const bool runs = options.has(Pass::kParallel);
  const bool frames = options.has(Pass::kNormals);
  const bool gauges = freedom.regrouping && options.has(Pass::kRegrouping);
  add(parallel && runs, 2, set_flag<&LinkVariant::merge_parallel>);
  add(runs, 4, set_cut);
  add(frames, 4, set_enum<&LinkVariant::angle, FrameAngle>);
  add(frames && !freedom.fixed_frames, 4, set_enum<&LinkVariant::slide, Slide>);
  add(gauges, 6, set_enum<&LinkVariant::mass, MassGauge>);
  add(gauges, 4, set_enum<&LinkVariant::tensor, TensorGauge>);
  add(freedom.moment_form && options.has(Pass::kColumn), 2,
      set_flag<&LinkVariant::column_of_father>);
  add(freedom.moment_form && options.has(Pass::kPseudoInertia), 2,
      set_flag<&LinkVariant::tensor_moment>);
}

/// True if the unit of length may change the cost.
bool chooses_unit(const Freedom& freedom, const Options& options) {
  return freedom.regrouping && !freedom.fixed_length && options.has(Pass::kRegrouping) &&
         options.has(Pass::kSearch);
}

void add_global_choices(const model::Tree& tree, const Freedom& freedom, const Options& options,
                        std::vector<Choice>& choices) {
  const auto add = [&](bool wanted, int settings,
                       void (*set)(Variant&, const std::vector<int>&, int)) {
    if (wanted && settings > 1) {
      choices.push_back({settings, {}, set});
    }
  };
  const bool units = chooses_unit(freedom, options) && !options.metres;
  const int lengths = units ? static_cast<int>(unit_lengths(tree).size()) + 1 : 1;
  add(true, lengths, [](Variant& v, const std::vector<int>&, int k) { v.unit_length = k; });
  add(freedom.tensor_form && options.has(Pass::kPseudoInertia), 2,
      [](Variant& v, const std::vector<int>&, int k) { v.inertia_tensor = k != 0; });
  add(freedom.trunk && has_trunk(tree) && options.has(Pass::kTrunk), 2,
      [](Variant& v, const std::vector<int>&, int k) { v.trunk = k != 0; });
  add(freedom.any_way, 3,
      [](Variant& v, const std::vector<int>&, int k) { v.way = static_cast<Way>(k); });
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
      const bool parallel = first.father != model::kGround && first.euler.alpha.is_identity() &&
                            normal.links[static_cast<std::size_t>(first.father)].revolute;
      add_link_choices(freedom, options, links, parallel, choices);
    }
  }
  add_global_choices(tree, freedom, options, choices);
  return choices;
}

int other_settings(const std::vector<Choice>& choices) {
  return std::accumulate(choices.begin(), choices.end(), 0,
                         [](int sum, const Choice& choice) { return sum + choice.settings - 1; });
}

}  // namespace treedyn::formulate
