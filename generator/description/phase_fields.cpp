#include "description/phase_fields.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"
#include "description/identifiers.hpp"
#include "description/vectors.hpp"
#include "model/scene_facts.hpp"

namespace treedyn::description {

namespace {

using model::EventKind;

class PhaseReader {
 public:
  PhaseReader(SceneContext& context, const SceneEffects& effects, const SceneFields& root)
      : context_(context), effects_(effects), root_(root), scene_(context.scene()) {}

  void run() {
    const std::vector<Node>& nodes = root_.list("phases");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      read_phase(nodes[k], called("phase", nodes[k], k));
    }
    check_identifiers(names_, "phase");
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      read_events(nodes[k], k, called("phase", nodes[k], k));
    }
    if (nodes.empty()) {
      scene_.phases.push_back({"all", {}, {}});
    }
    check_resting_names();
    add_unlisted();
    hold_through_impacts();
    check_lift_offs();
    if (const std::optional<Text> start = root_.optional_text("start_phase")) {
      scene_.start_phase = phase(root_, *start);
    }
  }

 private:
  static Keys phase_keys() { return {"name", "active", "until"}; }

  void read_phase(const Node& node, const std::string& what) {
    const SceneFields fields = context_.fields(node, what, phase_keys());
    const Text name = fields.name("name", "phase");
    if (is_known(name.text, names_of(scene_.phases))) {
      fields.fail(name.where, "another phase has this name; expected different names");
    }
    names_.push_back({name.text, to_identifier(name.text), name.where.in(fields.file())});
    scene_.phases.push_back({name.text, constraints(fields, "active"), {}});
  }

  void read_events(const Node& node, std::size_t index, const std::string& what) {
    reading_ = index;
    const SceneFields fields = context_.fields(node, what, phase_keys());
    const std::vector<Node>& events = fields.list("until");
    for (std::size_t k = 0; k < events.size(); ++k) {
      const std::string of = fmt::format("{}: event {}", what, k + 1);
      scene_.phases[index].until.push_back(event(events[k], of));
    }
  }

  model::Event event(const Node& node, const std::string& what) {
    const SceneFields fields = context_.fields(node, what,
                                               {"touch_down", "lift_off", "time", "expression",
                                                "crossing", "not_before", "impact", "then"});
    model::Event result;
    const Node* cause = nullptr;
    for (const char* const kind : {"touch_down", "lift_off", "time", "expression"}) {
      if (const Node* const found = fields.find(kind)) {
        if (cause != nullptr) {
          fields.fail(found->key.where,
                      fmt::format("'{}' beside '{}'; expected one cause", kind, cause->key.text));
        }
        cause = found;
      }
    }
    if (cause == nullptr) {
      fields.fail(node.where, "has no cause; expected touch_down, lift_off, time or expression");
    }
    result.not_before = fields.amount_or("not_before", 0);
    read_cause(fields, *cause, what, result);
    if (const Node* const impact = fields.find("impact")) {
      result.impact = read_impact(*impact, what + ": impact", result);
    }
    result.then = phase(fields, fields.text("then"));
    return result;
  }

  void read_cause(const SceneFields& fields, const Node& cause, const std::string& what,
                  model::Event& event) {
    const std::string& kind = cause.key.text;
    if (kind != "expression" && fields.find("crossing") != nullptr) {
      fields.fail(fields.get("crossing").key.where,
                  fmt::format("'crossing' beside '{}'; expected it beside expression", kind));
    }
    if (kind == "time") {
      if (fields.find("not_before") != nullptr) {
        fields.fail(fields.get("not_before").key.where,
                    "'not_before' beside 'time'; expected one of them");
      }
      event.kind = EventKind::kTime;
      event.not_before = fields.positive("time");
    } else if (kind == "expression") {
      event.kind = EventKind::kExpression;
      event.value = context_.expression(fields.at_run_time(), cause, SceneContext::Of::kState);
      if (event.value.is_constant()) {
        fields.fail(cause.where,
                    "expression: is a constant, which never crosses 0; expected one of "
                    "t, q or qd");
      }
      const std::string crossing = fields.text_or("crossing", "falling");
      if (crossing != "falling" && crossing != "rising") {
        fields.fail(
            fields.get("crossing").where,
            fmt::format("crossing '{}' is unknown; expected falling or rising", shown(crossing)));
      }
      event.rises = crossing == "rising";
      event.value = event.rises ? -event.value : event.value;
    } else if (kind == "touch_down") {
      const SceneFields at =
          context_.fields(cause, what + ": touch_down", {"point", "normal", "height"})
              .at_run_time();
      event.point = context_.moving_point(at);
      event.plane = {normal(at), at.number_or("height", 0)};
    } else {
      const SceneFields at = context_.fields(cause, what + ": lift_off", {"constraint", "normal"});
      event.kind = EventKind::kReaction;
      event.constraint = reacting(at);
      const Place& where = at.get("constraint").where;
      lift_offs_.push_back({where.in(at.file()), at.what(), reading_, event.constraint});
      event.plane = {normal(at), 0};
      require_reaction_along(at, event);
    }
  }

  /// Constraints react along their directions alone.
  void require_reaction_along(const SceneFields& fields, const model::Event& event) const {
    const auto& directions = scene_.constraints[to_index(event.constraint)].directions;
    const auto across = [&](const model::Vector3& d) {
      return abs(dot(d, event.plane.normal)) < Real("1e-30");
    };
    if (std::ranges::all_of(directions, across)) {
      fields.fail(fields.get("constraint").where,
                  fmt::format("constraint '{}' has no reaction along the normal of this lift_off; "
                              "expected a normal along one of its directions",
                              shown(fields.text("constraint").text)));
    }
  }

  static model::Vector3 normal(const SceneFields& fields) {
    return fields.find("normal") == nullptr ? model::Vector3{0, 0, 1} : fields.direction("normal");
  }

  /// A constraint whose reactions are forces.
  [[nodiscard]] int reacting(const SceneFields& fields) const {
    const Node& node = fields.get("constraint");
    const std::optional<int> found = constraint(fields, node);
    if (!found || scene_.constraints[to_index(*found)].kind != model::ConstraintKind::kPoint) {
      fields.fail(node.where, found ? "is no point_constraint; expected one, whose reaction is a "
                                      "force"
                                    : "the constraint is switched off; expected one that acts");
    }
    return *found;
  }

  [[nodiscard]] model::Impact read_impact(const Node& node, const std::string& what,
                                          const model::Event& event) {
    const SceneFields fields =
        context_.fields(node, what, {"constraints", "restitution", "rest_below"});
    model::Impact impact{constraints(fields, "constraints"), fields.amount_or("restitution", 0),
                         fields.amount_or("rest_below", 0)};
    if (impact.restitution > 1) {
      fields.fail(fields.get("restitution").where,
                  fmt::format("'restitution' is {}; expected 0 to 1",
                              impact.restitution.convert_to<double>()));
    }
    if (impact.constraints.empty()) {
      fields.fail(node.where, "has no constraint that acts; expected at least one");
    }
    const bool is_whole = fields.list("constraints").size() == impact.constraints.size();
    if (impact.rest_below > 0 && is_whole) {  // else one is switched off
      check_rest(fields, event, impact.constraints);
    }
    return impact;
  }

  /// A rebound is the speed of a point that lands, behind an impact that may stop it.
  void check_rest(const SceneFields& fields, const model::Event& event,
                  const std::vector<int>& rows) const {
    const auto is_elsewhere = [&](int c) {
      const model::Constraint& row = scene_.constraints[to_index(c)];
      return row.kind != model::ConstraintKind::kPoint || row.point != event.point;
    };
    const Place& where = fields.get("rest_below").key.where;
    if (event.kind != EventKind::kHeight) {
      fields.fail(where, "'rest_below' without a point that lands; expected it beside touch_down");
    }
    if (model::floor_of(scene_, event, rows) < 0 && std::ranges::none_of(rows, is_elsewhere)) {
      fields.fail(where,
                  "'rest_below' of an impact that does not stop the point that lands; expected a "
                  "constraint along the normal of its plane");
    }
  }

  /// Nothing for a constraint that is switched off.
  [[nodiscard]] std::optional<int> constraint(const SceneFields& fields, const Node& node) const {
    const std::string name = fields.scalar(node).text;
    const std::optional<int> found = index_of(scene_.constraints, name);
    if (!found && !effects_.is_off(name)) {
      fields.fail(node.where,
                  fmt::format("constraint '{}' is not defined{}; expected the name of one "
                              "in 'effects'",
                              shown(name), did_you_mean(name, names_of(scene_.constraints))));
    }
    return found;
  }

  std::vector<int> constraints(const SceneFields& fields, const char* key) {
    std::set<int> result;
    for (const Node& item : fields.list(key)) {
      if (const std::optional<int> found = constraint(fields, item)) {
        if (!result.insert(*found).second) {
          fields.fail(item.where, fmt::format("constraint '{}' stands here twice; expected it once",
                                              shown(fields.scalar(item).text)));
        }
        listed_.insert(*found);
      }
    }
    return {result.begin(), result.end()};
  }

  /// A generated step gives a phase that is entered at rest a name of its own.
  void check_resting_names() const {
    std::vector<Named> names = names_;
    std::set<int> resting;
    for (const model::Phase& phase : scene_.phases) {
      for (const model::Event& event : phase.until) {
        if (event.impact && event.impact->rest_below > 0 && resting.insert(event.then).second) {
          Named name = names_[to_index(event.then)];
          name.name += "_at_rest";
          name.identifier = to_identifier(name.name);
          names.push_back(std::move(name));
        }
      }
    }
    check_identifiers(names, "phase");
  }

  [[nodiscard]] int phase(const SceneFields& fields, const Text& name) const {
    if (const std::optional<int> found = index_of(scene_.phases, name.text)) {
      return *found;
    }
    fields.fail(name.where,
                fmt::format("phase '{}' is not defined{}; expected one of 'phases'",
                            shown(name.text), did_you_mean(name.text, names_of(scene_.phases))));
  }

  void add_unlisted() {
    for (std::size_t k = 0; k < scene_.constraints.size(); ++k) {
      if (listed_.count(static_cast<int>(k)) == 0) {
        for (model::Phase& phase : scene_.phases) {
          phase.active.push_back(static_cast<int>(k));
          std::ranges::sort(phase.active);
        }
      }
    }
  }

  /// What acts before and behind an impact takes its part of it; if it is led and not named, it
  /// goes on as it is led.
  void hold_through(const std::vector<int>& before, const std::vector<int>& behind,
                    model::Impact& impact) const {
    std::vector<int> lasting;
    std::ranges::set_intersection(before, behind, std::back_inserter(lasting));
    std::ranges::set_difference(lasting, impact.constraints, std::back_inserter(impact.held));
    std::erase_if(impact.held, [&](int c) { return !is_led(scene_.constraints[to_index(c)]); });
    std::set<int> rows(impact.constraints.begin(), impact.constraints.end());
    rows.insert(lasting.begin(), lasting.end());
    impact.constraints.assign(rows.begin(), rows.end());
  }

  void hold_through_impacts() {
    for (model::Phase& phase : scene_.phases) {
      for (model::Event& event : phase.until) {
        if (event.impact) {
          hold_through(phase.active, scene_.phases[to_index(event.then)].active, *event.impact);
        }
      }
    }
  }

  /// An impact makes the constraints act that its rebound comes to rest on.
  [[nodiscard]] bool may_act(int constraint, std::size_t phase) const {
    const auto has = [constraint](const std::vector<int>& list) {
      return std::ranges::find(list, constraint) != list.end();
    };
    bool result = has(scene_.phases[phase].active);
    for (const model::Phase& other : scene_.phases) {
      for (const model::Event& event : other.until) {
        result = result || (event.then == static_cast<int>(phase) && event.impact &&
                            event.impact->rest_below > 0 && has(event.impact->constraints));
      }
    }
    return result;
  }

  void check_lift_offs() const {
    for (const LiftOff& lift_off : lift_offs_) {
      if (!may_act(lift_off.constraint, lift_off.phase)) {
        throw InputError(
            lift_off.where,
            lift_off.what +
                ": the constraint does not act in this phase; expected one of 'active'");
      }
    }
  }

  struct LiftOff {
    Location where;
    std::string what;
    std::size_t phase;
    int constraint;
  };

  SceneContext& context_;
  const SceneEffects& effects_;
  const SceneFields& root_;
  model::Scene& scene_;
  std::vector<Named> names_;  ///< of the phases, in order
  std::set<int> listed_;
  std::vector<LiftOff> lift_offs_;
  std::size_t reading_ = 0;  ///< the phase whose events are read
};

}  // namespace

void read_phases(SceneContext& context, const SceneEffects& effects, const SceneFields& root) {
  PhaseReader(context, effects, root).run();
  effects.refuse_contradictions(root);
  if (!effects.acts("impact")) {
    for (model::Phase& phase : context.scene().phases) {
      for (model::Event& event : phase.until) {
        event.impact.reset();
      }
    }
  }
}

}  // namespace treedyn::description
