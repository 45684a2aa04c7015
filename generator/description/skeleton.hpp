// The structure of a RawTree: which joint carries which link, checked to be a forest on the ground.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "description/raw_tree.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// What a joint of a file does; `continuous` is revolute.
enum class JointKind { kRevolute, kPrismatic, kFixed };

/// A joint of the ground that the file does not write, for the root link of a URDF.
inline constexpr int kNoJoint = -1;

struct Skeleton {
  std::vector<JointKind> kinds;  ///< per joint of the file
  std::vector<int> joint;        ///< per link: the joint that carries it, or kNoJoint
  std::vector<int> father;       ///< per link: a link, or model::kGround
  std::vector<int> order;        ///< all links, fathers before sons
  std::map<std::string_view, int> link_by_name;
  std::map<std::string_view, int> joint_by_name;
};

/// \pre `raw` outlives the result.
/// \throws InputError for unusable or repeated names, unknown joint types and fathers, a link with
/// two
///   fathers, cycles, and in a URDF several roots.
Skeleton resolve_skeleton(const RawTree& raw);

/// The links whose joints move, in the order of the model: the joint that comes first in the file
/// among those whose moving ancestors are placed already. `moving_father[link]` is a link or
/// model::kGround.
std::vector<int> moving_order(const Skeleton& skeleton, const std::vector<int>& moving_father);

}  // namespace treedyn::description
