#include "formulate/functions.hpp"

#include "model/scene.hpp"
#include "optimise/optimise.hpp"
#include "program/canonical.hpp"
#include "program/random.hpp"

namespace treedyn::formulate {

int weight(const program::Cost& cost) {
  constexpr int kOperationsOfSineAndCosine = 8;
  return cost.total() + kOperationsOfSineAndCosine * cost.angles;
}

void add_operation(const program::Node& node, program::Cost& cost) {
  cost.add += node.kind == program::Kind::kAdd ? 1 : 0;
  cost.mul += node.kind == program::Kind::kMultiply ? 1 : 0;
  cost.div += node.kind == program::Kind::kDivide ? 1 : 0;
}

void count_new(const Graph& graph, std::size_t first, program::Cost& cost) {
  for (std::size_t n = first; n < graph.size(); ++n) {
    add_operation(graph.node(static_cast<program::Ref>(n)), cost);
  }
}

namespace {

/// The coordinates of limbs count with the signs that `normal` gives those of limbs.
model::Tree with_signs(model::Tree tree, const NormalTree& normal) {
  for (std::size_t i = 0; i < tree.drives.size(); ++i) {
    tree.drives[i].multiplier *= normal.links[i].coordinate_sign;
  }
  return tree;
}

/// The recipe's expressions.
program::Function written(const model::Tree& tree, const NormalTree& normal, const Recipe& recipe,
                          const Options& options, const Variant& variant, SharedLimbs* limbs) {
  program::Function function;
  const Kinematics kinematics(function.graph, tree, normal, variant, recipe.places, limbs);
  for (const Expr& output : recipe.build({tree, normal, options, kinematics})) {
    function.outputs.push_back(output.ref());
  }
  return function;
}

/// The variant of which the recipe can make use.
Variant usable(const Recipe& recipe, bool has_trunk, Variant used) {
  if (used.trunk && has_trunk) {
    for (std::size_t i = 3; i < 6;
         ++i) {  // the base axes stay in one point and the trunk keeps its mass
      used.links[i].mass = MassGauge::kNothing;
      used.links[i].slide = Slide::kNone;
    }
    used.links[4].cut =
        LinkVariant::kWholeRun;  // forward dynamics needs the second axis as a frame axis
  }
  if (recipe.freedom.fixed_frames) {
    for (LinkVariant& link : used.links) {
      link.slide = Slide::kNone;
    }
  }
  return used;
}

std::vector<LimbLinks> limbs_of(const model::Tree& tree, const Recipe& recipe,
                                const Options& options) {
  return options.share_limbs && !recipe.freedom.own_code ? find_limbs(tree)
                                                         : std::vector<LimbLinks>{};
}

/// Two hashes at once.
class Mixer {
 public:
  void add(std::uint64_t x) {
    first_ = program::scramble(first_ ^ x);
    second_ = program::scramble(second_ ^ x);
  }
  void add(const Real& x) { add(std::uint64_t{std::hash<Digits>()(x.seen())}); }
  template <class Numbers>
  void add_all(const Numbers& numbers) {
    for (const Real& x : numbers) {
      add(x);
    }
  }

  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> result() const { return {first_, second_}; }

 private:
  std::uint64_t first_ = 1;
  std::uint64_t second_ = 2;
};

/// Of numbers and signs of the links, and of those choices that do not make them.
std::pair<std::uint64_t, std::uint64_t> fingerprint(const Variant& used, const NormalTree& normal) {
  Mixer all;
  for (const NormalLink& link : normal.links) {
    all.add((link.sign < 0 ? 1U : 0U) + (link.coordinate_sign < 0 ? 2U : 0U));
    all.add_all(link.rotation);
    all.add_all(link.offset);
    all.add(link.mass);
    all.add_all(link.moment);
    all.add_all(link.pseudo);
    all.add_all(link.to_normal);
    all.add_all(link.origin);
  }
  all.add_all(normal.gravity);
  all.add_all(normal.ground_moment);
  all.add(normal.unit);
  for (const LinkVariant& link : used.links) {
    all.add((link.merge_parallel ? 1U : 0U) + (link.column_of_father ? 2U : 0U) +
            (link.tensor_moment ? 4U : 0U) + 8U * link.cut);
  }
  all.add((used.add_angles ? 1U : 0U) + (used.inertia_tensor ? 2U : 0U) + (used.trunk ? 4U : 0U) +
          (used.articulated ? 8U : 0U) + 16U * static_cast<unsigned>(used.way));
  return all.result();
}

}  // namespace

Formulations::Formulations(const model::Tree& tree, const Recipe& recipe, const Options& options)
    : tree_(tree),
      recipe_(recipe),
      options_(options),
      limbs_(limbs_of(tree, recipe, options)),
      has_trunk_(recipe.freedom.trunk && has_trunk(tree)),
      forms_(tree, options.gravity, limbs_) {}

Built Formulations::build(const Variant& variant) {
  const Variant used = usable(recipe_, has_trunk_, variant);
  return made(used, forms_.of(used), true);
}

template <class Value, class Make>
Value Formulations::known(std::map<Fingerprint, Value>& values, const Variant& variant, Make make) {
  const Variant used = usable(recipe_, has_trunk_, variant);
  const NormalTree normal = forms_.of(used);
  const Fingerprint key = fingerprint(used, normal);
  const auto found = values.find(key);
  return found != values.end() ? found->second
                               : values.emplace(key, make(used, normal)).first->second;
}

program::Cost Formulations::cost(const Variant& variant) {
  return known(costs_, variant, [&](const Variant& used, const NormalTree& normal) {
    return program::cost(made(used, normal, false).function);
  });
}

int Formulations::estimate(const Variant& variant) {
  return known(estimates_, variant, [&](const Variant& used, const NormalTree& normal) {
    const program::Function function = made(used, normal, true).function;
    return optimise::estimate_operations(function.graph, function.outputs);
  });
}

Built Formulations::made(const Variant& used, const NormalTree& normal, bool in_order) {
  if (limbs_.empty()) {
    program::Function function = written(tree_, normal, recipe_, options_, used, nullptr);
    return {in_order ? program::canonical(function) : std::move(function), {}};
  }
  SharedLimbs limbs = shared_limbs(tree_, normal, limbs_);
  program::Function function =
      written(with_signs(tree_, normal), normal, recipe_, options_, used, &limbs);
  if (in_order) {
    function = program::canonical(function);
  }
  function = program::fold_limb_constants(function, limbs.table);
  return {std::move(function), std::move(limbs.table)};
}

program::Function plain_function(const model::Scene& scene, const std::string& name) {
  Options options;
  options.gravity = scene.gravity;
  options.points = scene.points;
  options.effort = 0;
  program::Function function =
      formulate::build(scene.tree, recipe_of(name), options, plain_variant(scene.tree));
  function.signature = signature(name, scene.tree.dof(), static_cast<int>(scene.points.size()));
  return function;
}

}  // namespace treedyn::formulate
