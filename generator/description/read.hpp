// From a file to the checked model: the only entry to this folder for later stages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/real.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// What carries the root of the robot, INTERFACE.md 4: the ground, or six one-DOF joints base_px ..
/// base_rx.
enum class Base { kFixed, kAxes };

/// What carries the root of a tree that was read.
Base base_of(const model::Tree& tree);
/// True for the links of a base on axes, by their numbers.
bool is_base_link(const model::Tree& tree, int link);

/// URDF mimic joints: eliminated (`Tree::drives`), or joints of their own.
enum class Mimic { kReduce, kIndependent };

struct ReadOptions {
  Base base = Base::kFixed;
  Mimic mimic = Mimic::kReduce;
  Real snap = Real("1e-9");  ///< tolerance of snapping, rad; 0 switches it off
  /// Known at run time: LINK.mass, LINK.com, LINK.inertia, LINK.offset, POINT.at, components of
  /// them, gravity.
  std::vector<std::string> runtime = {};
};

/// True for `*.urdf`, in letters of either case.
bool is_urdf(const std::string& path);

/// The bytes of a file, "-": of standard input. \throws InputError, also beyond 64 MiB
std::string read_text(const std::string& path);

/// The same of a model: what is neither a URDF (`*.urdf`) nor a tree description (`*.yaml`,
/// `*.yml`,
/// `*.json`; "-") is not read at all.
std::string read_model_text(const std::string& path);

/// Reads and checks a URDF (`*.urdf`) or a tree description (`*.yaml`, `*.yml`, `*.json`; "-": YAML
/// on standard input).
///
/// Fixed joints are merged, decimals close to exact angles are snapped (`Tree::snaps`).
/// Linear in the size of the file; memory is bounded whatever the file holds.
/// \throws InputError with file, line and column at the first mistake.
model::Tree read_model(const std::string& path, const ReadOptions& options);

/// The same from text that was read already; the name of the file says what it is.
model::Tree parse_model(const std::string& text, const std::string& path,
                        const ReadOptions& options);

/// The points of `--points LIST`, INTERFACE.md 2: comma-separated `name`, `name=link`,
/// `name=link:x,y,z`, or `all`. \throws InputError for an unknown link, a malformed number or a
/// name used twice.
std::vector<model::Point> resolve_points(const model::Tree& tree, const std::string& list);
/// The origin of every moving link, under its name: "all" of such a list. Their identifiers may be
/// the same.
std::vector<model::Point> points_of_links(const model::Tree& tree);

/// Joints that can move, alone or together, without moving any inertia: A(q) is singular in every
/// position and forward dynamics has no solution. One warning for every such movement (the joints
/// of a vector x with A x = 0), by the first of its joints; not part of `Tree::warnings`.
/// \param armature  inertia added to every coordinate, dof
std::vector<Warning> joints_without_inertia(const model::Tree& tree);
std::vector<Warning> joints_without_inertia(const model::Tree& tree,
                                            const std::vector<Real>& armature);

/// What `treedyn vet` reports of a model that can be read.
struct Vetted {
  model::Tree tree;
  std::vector<Warning>
      findings;  ///< near misses of snapping, doubtful inertias and limits, joints without inertia
  std::optional<InputError> error;  ///< why there is no tree; then findings are those of the format
};
/// \param text  of the file `path` \throws InputError where the file cannot be taken apart
Vetted vet_model(const std::string& text, const std::string& path, const ReadOptions& options);

}  // namespace treedyn::description
