// A robot description as a file writes it: texts with their places, nothing resolved, nothing
// computed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/error.hpp"

namespace treedyn::description {

/// A place in the file of the RawTree; line and column count from 1.
struct Place {
  int line = 0;
  int column = 0;
  /// Of every character of a text that has several lines in its file.
  std::shared_ptr<const std::vector<Place>> characters = nullptr;

  /// The place of a character of the text that begins here; of its end behind the last.
  [[nodiscard]] Place at(std::size_t offset) const {
    return characters != nullptr ? (*characters)[std::min(offset, characters->size() - 1)]
                                 : Place{line, column + static_cast<int>(offset)};
  }
  [[nodiscard]] Location in(const std::string& file) const { return {file, line, column}; }
};

struct Text {
  std::string text;
  Place where;
};

/// Numbers as written, and the place of the whole.
struct Numbers {
  std::vector<Text> values;
  Place where;
};

/// x_outer = xyz + R(rpy or matrix) x_inner; what is missing is the identity.
struct RawPose {
  std::optional<Numbers> xyz;
  std::optional<Numbers> rpy;
  std::optional<Numbers> matrix;
};

struct RawLimits {
  std::optional<Text> lower;
  std::optional<Text> upper;
  std::optional<Text> velocity;
  std::optional<Text> effort;
};

/// Position of the joint = multiplier * position of `joint` + offset.
struct RawMimic {
  Text joint;
  std::optional<Text> multiplier;
  std::optional<Text> offset;
};

/// `<dynamics>` of a URDF.
struct RawDissipation {
  std::optional<Text> damping;
  std::optional<Text> friction;
};

struct RawJoint {
  Text name;
  Text type;
  Text father;  ///< a link, or "ground" in a tree description
  Text son;
  RawPose pose;  ///< joint frame in the father's link frame
  std::optional<Numbers> axis;
  RawLimits limits;
  std::optional<RawMimic> mimic;
  RawDissipation dissipation;
  Place where;
};

struct RawInertia {
  Text mass;
  RawPose pose;                   ///< centre of mass and the frame of the tensor, in the link frame
  std::optional<Numbers> tensor;  ///< ixx ixy ixz iyy iyz izz about the centre of mass
  Place where;
};

struct RawLink {
  Text name;
  std::optional<RawInertia> inertia;
  Place where;
};

struct RawPoint {
  Text name;
  Text link;
  std::optional<Numbers> at;
};

struct RawParameter {
  Text name;
  Text value;
};

/// What is known at run time only: "mass", "com", "inertia" or "offset" of a link, "at" of a point,
/// a component of one ("com.x"), or "gravity".
struct RawRuntime {
  Text owner;  ///< a link or a point; empty: none
  Text quantity;
  bool of_point = false;
};

enum class Format { kYaml, kUrdf };

struct RawTree {
  Format format = Format::kYaml;
  std::string file;  ///< as messages show it
  Text name;
  std::vector<RawParameter> parameters;
  std::vector<RawLink> links;
  std::vector<RawJoint> joints;  ///< in a tree description joint k is the joint of link k
  std::vector<RawPoint> points;
  std::vector<RawRuntime> runtime;
  std::vector<Warning> oddities;  ///< what is not read and looks like a slip
};

inline Location location(const RawTree& raw, const Place& place) { return place.in(raw.file); }

}  // namespace treedyn::description
