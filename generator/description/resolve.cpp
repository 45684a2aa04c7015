#include "description/resolve.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "common/index.hpp"
#include "common/transformed.hpp"
#include "description/bodies.hpp"
#include "description/doubts.hpp"
#include "description/identifiers.hpp"
#include "description/mimic.hpp"
#include "description/named_points.hpp"
#include "description/numbers.hpp"
#include "description/run_time_fields.hpp"
#include "description/skeleton.hpp"
#include "description/snapping.hpp"

namespace treedyn::description {

namespace {

/// Where the frame of a link stands in the moving link (of the file) that carries it, or in the
/// base.
struct Placement {
  int carrier = model::kGround;
  Matrix3 rotation = identity();
  Vector3 origin{};
};

struct BaseRow {
  const char* name;
  model::JointType type;
  std::array<int, 3> axis;
};
/// The joints of `--base axes`, INTERFACE.md 4.
constexpr std::array<BaseRow, 6> kBaseAxes = {{
    {"base_px", model::JointType::kPrismatic, {1, 0, 0}},
    {"base_py", model::JointType::kPrismatic, {0, 1, 0}},
    {"base_pz", model::JointType::kPrismatic, {0, 0, 1}},
    {"base_rz", model::JointType::kRevolute, {0, 0, 1}},
    {"base_ry", model::JointType::kRevolute, {0, 1, 0}},
    {"base_rx", model::JointType::kRevolute, {1, 0, 0}},
}};

}  // namespace

Base base_of(const model::Tree& tree) {
  const bool axes = !tree.links.empty() && tree.links.front().joint.name == kBaseAxes.front().name;
  return axes ? Base::kAxes : Base::kFixed;
}

bool is_base_link(const model::Tree& tree, int link) {
  return base_of(tree) == Base::kAxes && link < static_cast<int>(kBaseAxes.size());
}

namespace {

/// Snaps or findings by line and column.
template <typename Record>
std::vector<Record> in_file_order(std::vector<Record> records) {
  std::ranges::stable_sort(records, [](const Record& a, const Record& b) {
    return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
  });
  return records;
}

/// One model in the making.
class Resolver {
 public:
  Resolver(const RawTree& raw, const ReadOptions& options)
      : raw_(raw),
        options_(options),
        numbers_(raw),
        snapper_(raw, options.snap),
        skeleton_(resolve_skeleton(raw)),
        doubts_(raw) {}

  Vetted run() {
    tree_.name = raw_.name.text;
    tree_.identifier = to_identifier(raw_.name.text);
    add_base();
    place_links();
    add_links();
    add_inertias();
    add_frames();
    check_identifiers(joint_names(), "joint");
    resolve_mimics(raw_, skeleton_, numbers_, options_.mimic == Mimic::kReduce, tree_);
    resolve_named_points(raw_, numbers_, tree_);
    resolve_parameters(raw_, options_.runtime, tree_);
    tree_.snaps = in_file_order(snapper_.log().snaps);
    add_dissipations();
    tree_.warnings.insert(tree_.warnings.begin(), raw_.oddities.begin(), raw_.oddities.end());
    std::vector<Warning> findings = snapper_.log().misses;
    findings.insert(findings.end(), doubts_.all().begin(), doubts_.all().end());
    return {std::move(tree_), in_file_order(std::move(findings)), std::nullopt};
  }

 private:
  [[noreturn]] void fail(const Place& where, const std::string& message) const {
    throw InputError(location(raw_, where), message);
  }

  /// The model's index of what hangs on the ground in the file.
  [[nodiscard]] int ground() const {
    return options_.base == Base::kAxes ? static_cast<int>(kBaseAxes.size()) - 1 : model::kGround;
  }

  void add_base() {
    if (options_.base == Base::kFixed) {
      return;
    }
    for (const BaseRow& row : kBaseAxes) {
      refuse_base_name(row.name);
      model::Link link;
      link.name = row.name;
      link.father = tree_.size() - 1;
      link.joint.name = link.joint.identifier = row.name;
      link.joint.type = row.type;
      link.joint.axis = {row.axis[0], row.axis[1], row.axis[2]};
      link.joint.rotation = identity();
      link.where = link.joint.where = {raw_.file, 0, 0};
      tree_.links.push_back(std::move(link));
    }
  }

  void refuse_base_name(const char* name) const {
    const auto joint = skeleton_.joint_by_name.find(name);
    if (joint != skeleton_.joint_by_name.end()) {
      fail(raw_.joints[to_index(joint->second)].name.where,
           fmt::format("joint '{}' has the name of a base joint; expected another name", name));
    }
    const auto link = skeleton_.link_by_name.find(name);
    if (link != skeleton_.link_by_name.end()) {
      fail(raw_.links[to_index(link->second)].name.where,
           fmt::format("link '{}' has the name of a base link; expected another name", name));
    }
  }

  /// The frame of a joint in the father's link frame.
  Placement joint_pose(const RawJoint& joint) {
    const std::string name = fmt::format("joint '{}'", shown(joint.name.text));
    Placement pose;
    pose.origin = numbers_.vector(
        joint.pose.xyz, name + (raw_.format == Format::kYaml ? ": offset" : ": xyz of <origin>"));
    if (joint.pose.rpy) {
      const std::string what = name + ": rpy";
      const Vector3 rpy = numbers_.vector(joint.pose.rpy, what);
      doubts_.of_angles(rpy, *joint.pose.rpy, what);
      pose.rotation = snapper_.from_rpy(rpy, *joint.pose.rpy, what);
    } else if (joint.pose.matrix) {
      const std::string what = name + ": matrix";
      pose.rotation =
          snapper_.from_matrix(numbers_.matrix(*joint.pose.matrix, what), *joint.pose.matrix, what);
    }
    return pose;
  }

  /// Fathers first: fixed joints add up, moving joints start anew.
  void place_links() {
    placements_.resize(raw_.links.size());
    joint_frames_.resize(raw_.links.size());
    moving_father_.assign(raw_.links.size(), model::kGround);
    // in file order, so that the first mistake of the file is the one reported
    for (const RawJoint& joint : raw_.joints) {
      joint_frames_[to_index(skeleton_.link_by_name.find(joint.son.text)->second)] =
          joint_pose(joint);
    }
    for (const int link : skeleton_.order) {
      place_link(link);
    }
  }

  void place_link(int link) {
    const int joint = skeleton_.joint[to_index(link)];
    const int father = skeleton_.father[to_index(link)];
    const Placement on = father == model::kGround ? Placement{} : placements_[to_index(father)];
    Placement frame = joint_frames_[to_index(link)];
    frame.origin = on.origin + on.rotation * frame.origin;
    if (on.rotation != identity()) {
      const RawJoint& of = raw_.joints[to_index(joint)];
      frame.rotation = frame.rotation == identity()
                           ? on.rotation
                           : snapper_.composed(
                                 on.rotation * frame.rotation, of.where,
                                 fmt::format("joint '{}': composed rotation", shown(of.name.text)));
    }
    frame.carrier = on.carrier;
    moving_father_[to_index(link)] = on.carrier;
    joint_frames_[to_index(link)] = frame;
    const bool moves = joint != kNoJoint && skeleton_.kinds[to_index(joint)] != JointKind::kFixed;
    placements_[to_index(link)] = moves ? Placement{link, identity(), {}} : frame;
  }

  void add_links() {
    model_index_.assign(raw_.links.size(), model::kGround);
    for (const int link : moving_order(skeleton_, moving_father_)) {
      model_index_[to_index(link)] = tree_.size();
      const int father = moving_father_[to_index(link)];
      model::Link result;
      result.name = raw_.links[to_index(link)].name.text;
      result.father = father == model::kGround ? ground() : model_index_[to_index(father)];
      result.joint = moving_joint(link);
      result.where = location(raw_, raw_.links[to_index(link)].where);
      tree_.links.push_back(std::move(result));
    }
    if (tree_.links.empty()) {
      fail(raw_.name.where, fmt::format("model '{}' has no joint that moves; expected at least "
                                        "one, or --base axes for a body that floats",
                                        shown(raw_.name.text)));
    }
  }

  model::Joint moving_joint(int link) {
    const RawJoint& raw = raw_.joints[to_index(skeleton_.joint[to_index(link)])];
    const std::string name = fmt::format("joint '{}'", shown(raw.name.text));
    model::Joint joint;
    joint.name = raw.name.text;
    joint.identifier = to_identifier(raw.name.text);
    joint.type = skeleton_.kinds[to_index(skeleton_.joint[to_index(link)])] == JointKind::kPrismatic
                     ? model::JointType::kPrismatic
                     : model::JointType::kRevolute;
    if (!raw.axis) {
      fail(raw.where, name + " has no axis; expected three numbers");
    }
    const std::string what = name + ": axis";
    joint.axis = snapper_.unit_axis(numbers_.vector(raw.axis, what), *raw.axis, what);
    joint.offset = joint_frames_[to_index(link)].origin;
    joint.rotation = joint_frames_[to_index(link)].rotation;
    joint.limits = limits(raw, name);
    joint.where = location(raw_, raw.where);
    return joint;
  }

  /// A limit; infinite and huge ones are none.
  [[nodiscard]] std::optional<Real> limit(const std::optional<Text>& text,
                                          const std::string& what) const {
    constexpr std::array<std::string_view, 6> kNone = {"inf",  "-inf",  "+inf",
                                                       ".inf", "-.inf", "+.inf"};
    const bool none = !text || std::ranges::find(kNone, text->text) != kNone.end() ||
                      read_decimal(text->text).error == DecimalError::kOutOfRange;
    return none ? std::nullopt : std::optional(numbers_.number(*text, what));
  }

  model::Limits limits(const RawJoint& raw, const std::string& name) {
    model::Limits result{limit(raw.limits.lower, name + ": lower limit"),
                         limit(raw.limits.upper, name + ": upper limit"),
                         limit(raw.limits.velocity, name + ": velocity limit"),
                         limit(raw.limits.effort, name + ": effort limit")};
    const bool turns_on = raw.type.text == "continuous";  // its positions have no limits
    if (!turns_on && result.lower && result.upper && *result.lower > *result.upper) {
      tree_.warnings.push_back(
          {location(raw_, raw.limits.lower->where),
           fmt::format("{}: lower limit {} is above the upper limit {}", name,
                       shown(raw.limits.lower->text), shown(raw.limits.upper->text))});
    }
    doubts_.of_limits(raw, name, result);
    return result;
  }

  /// The model's index of a carrier.
  [[nodiscard]] int carrier_index(const Placement& placement) const {
    return placement.carrier == model::kGround ? ground()
                                               : model_index_[to_index(placement.carrier)];
  }

  void add_inertias() {
    std::vector<std::vector<model::Inertia>> bodies(tree_.links.size());
    std::vector<model::Inertia> inertias;
    for (std::size_t k = 0; k < raw_.links.size(); ++k) {
      const bool moves = carrier_index(placements_[k]) != model::kGround;
      inertias.push_back(
          resolve_inertia(raw_, raw_.links[k], numbers_, snapper_, moves, tree_.warnings));
    }
    doubts_.of_inertias(inertias, longest_offset(), written_offsets());
    for (std::size_t k = 0; k < raw_.links.size(); ++k) {
      const int carrier = carrier_index(placements_[k]);
      const bool moves = carrier != model::kGround;
      const model::Inertia& inertia = inertias[k];
      if (raw_.links[k].inertia && raw_.links[k].inertia->pose.rpy) {
        const Numbers& rpy = *raw_.links[k].inertia->pose.rpy;
        const std::string what = fmt::format("link '{}': rpy", shown(raw_.links[k].name.text));
        doubts_.of_angles(numbers_.vector(rpy, what), rpy, what);
      }
      if (moves && raw_.links[k].inertia) {
        bodies[to_index(carrier)].push_back(
            moved(inertia, placements_[k].rotation, placements_[k].origin));
      }
    }
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      tree_.links[k].inertia = combined(bodies[k]);
    }
  }

  /// From the frame of a moving link to that of a joint on it.
  [[nodiscard]] Real longest_offset() const {
    Real longest = 0;
    for (const Placement& frame : joint_frames_) {
      longest = std::max(longest, norm(frame.origin));
    }
    return longest;
  }

  /// By joint of the file, its distance from the frame of its father; 0 on what does not move,
  /// where it may be anywhere in a world.
  [[nodiscard]] std::vector<Real> written_offsets() const {
    return transformed<Real>(raw_.joints, [&](const RawJoint& joint) {
      const int son = skeleton_.link_by_name.find(joint.son.text)->second;
      const bool of_world = moving_father_[to_index(son)] == model::kGround;
      return of_world ? Real(0) : norm(numbers_.vector(joint.pose.xyz, "offset"));
    });
  }

  /// What is no zero: numbers are not asked of what no function has.
  void add_dissipations() {
    const auto written = [](const std::optional<Text>& text) {
      const Decimal number = text ? read_decimal(text->text) : Decimal{};
      return number && number.value == 0 ? std::string() : text->text;
    };
    for (const RawJoint& joint : raw_.joints) {
      const std::string damping = written(joint.dissipation.damping);
      const std::string friction = written(joint.dissipation.friction);
      if (joint.type.text != "fixed" && !(damping.empty() && friction.empty())) {
        const Place& where =
            (damping.empty() ? joint.dissipation.friction : joint.dissipation.damping)->where;
        tree_.dissipations.push_back({location(raw_, where), joint.name.text, damping, friction});
      }
    }
  }

  void add_frames() {
    for (int k = 0; options_.base == Base::kAxes && k <= ground(); ++k) {
      tree_.frames.push_back({tree_.links[to_index(k)].name, k, identity(), {}});
    }
    for (std::size_t k = 0; k < raw_.links.size(); ++k) {
      const Placement& placement = placements_[k];
      tree_.frames.push_back({raw_.links[k].name.text, carrier_index(placement), placement.rotation,
                              placement.origin});
    }
  }

  [[nodiscard]] std::vector<Named> joint_names() const {
    return transformed(tree_.links, [&](const model::Link& link) {
      return Named{link.joint.name, link.joint.identifier, link.joint.where};
    });
  }

  const RawTree& raw_;
  const ReadOptions& options_;
  NumberReader numbers_;
  Snapper snapper_;
  Skeleton skeleton_;
  Doubts doubts_;
  model::Tree tree_;
  std::vector<Placement> placements_;  ///< per link of the file: its frame in its carrier
  std::vector<Placement>
      joint_frames_;  ///< per link: its joint's frame at q = 0 in the father's carrier
  std::vector<int>
      moving_father_;             ///< per link: the moving link of the file that carries its father
  std::vector<int> model_index_;  ///< per link of the file: index in the model, kGround if merged
};

}  // namespace

Vetted resolve(const RawTree& raw, const ReadOptions& options) {
  return Resolver(raw, options).run();
}

}  // namespace treedyn::description
