// A tree-structured robot as every later stage sees it: plain data that `description` has checked
// once.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "common/real.hpp"

namespace treedyn::model {

using Vector3 = std::array<Real, 3>;
using Matrix3 = std::array<Real, 9>;  ///< row-major

/// Index of the ground, where a father is expected.
inline constexpr int kGround = -1;

enum class JointType { kRevolute, kPrismatic };

/// Mass properties of one link, everything fixed to it included.
struct Inertia {
  Real mass = 0;        ///< kg
  Vector3 com{};        ///< centre of mass from the link's origin, link frame, m
  Matrix3 about_com{};  ///< symmetric inertia tensor about the centre of mass, link frame, kg m^2
};

/// Limits of a joint as the file states them; they bound nothing here, later stages may use them.
struct Limits {
  std::optional<Real> lower;     ///< rad or m
  std::optional<Real> upper;     ///< rad or m
  std::optional<Real> velocity;  ///< rad/s or m/s
  std::optional<Real> effort;    ///< N m or N
};

/// The joint of a link to its father, EQUATIONS.md 1.2: x_father = offset + rotation * x_joint.
struct Joint {
  std::string name;        ///< as the file writes it
  std::string identifier;  ///< a C++ identifier, unique among the joints
  JointType type = JointType::kRevolute;
  Vector3 axis{};      ///< unit axis, joint frame (equals the link frame)
  Vector3 offset{};    ///< joint origin in the father's link frame, m
  Matrix3 rotation{};  ///< joint frame -> father's link frame at q = 0
  Location where;
  Limits limits;

  [[nodiscard]] bool turns() const { return type == JointType::kRevolute; }
};

/// A moving link. The link frame is the joint frame moved by the joint ("main frame").
struct Link {
  std::string name;  ///< as the file writes it
  int father =
      kGround;  ///< index of the father, always smaller than the own index; kGround for roots
  Joint joint;
  Inertia inertia;
  Location where;
};

/// Any link frame of the file: moving, merged into a moving link, or fixed to the ground.
struct Frame {
  std::string name;
  int link = kGround;  ///< the moving link that carries it, or kGround
  Matrix3 rotation{};  ///< frame -> carrying link's frame (base frame for ground)
  Vector3 origin{};    ///< in the carrying link's frame, m
};

/// A point whose position, Jacobian or force is asked for.
struct Point {
  std::string name;
  std::string identifier;  ///< a C++ identifier, unique among the points
  std::string link_name;   ///< the link named in the file or on the command line (may be merged)
  int link = kGround;      ///< the moving link that carries it, or kGround
  Vector3 at{};            ///< in the carrying link's frame (base frame for ground), m
  /// Frame of the named link -> carrying link's frame; not the identity for links that were merged.
  Matrix3 rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};
};

struct Tree;
/// Where a point is in the frame of the link that it names, m: numbers alone. O(frames)
Vector3 place_in_frame(const Tree& tree, const Point& point);

/// Joint coordinate i as a function of the independent coordinates u: q_i = multiplier *
/// u[coordinate] + offset.
struct Drive {
  int coordinate = 0;
  Real multiplier = 1;
  Real offset = 0;
};

/// A constant that snapping replaced by an exact value.
struct Snap {
  Location where;
  std::string what;  ///< "joint 'elbow': rpy[0]"
  std::string from;  ///< as written
  std::string to;    ///< "pi/2"
  Real change = 0;   ///< |exact - written|, rad or 1
};

/// Damping and friction that a URDF declares of a joint, as written; in no function, since scenes
/// have effects for them.
struct Dissipation {
  Location where;
  std::string joint;
  std::string damping;   ///< empty: none
  std::string friction;  ///< empty: none
};

/// kOffset: of a joint, from the origin of the father; kPoint: of a point on its link; kScene: of a
/// scene, which numbers of it are made of.
enum class ParameterKind { kMass, kCom, kInertia, kOffset, kPoint, kGravity, kScene };

/// A number of a link or of a point, a component of gravity, or a parameter of a scene, that is
/// known at run time only; the tree (or what gives gravity) has its nominal value.
struct Parameter {
  int link = kGround;  ///< of kPoint the number of the point in Tree::points; kGround: of none
  ParameterKind quantity = ParameterKind::kMass;
  int component = 0;       ///< x y z of a vector, xx xy xz yy yz zz of a tensor about the c.o.m.
  std::string declared;    ///< "forearm.com", "forearm.com.x", "gravity": as a user declares it
  std::string identifier;  ///< forearm_com_x, a C++ identifier, unique among the parameters
  Real of_scene = 0;       ///< kScene: the nominal value
};

struct Tree {
  std::string name;           ///< as the file writes it
  std::string identifier;     ///< a C++ identifier
  std::vector<Link> links;    ///< fathers before sons; joint i is the joint of link i
  std::vector<Drive> drives;  ///< one per link; identity unless mimic joints are reduced
  std::vector<int>
      coordinates;  ///< the link whose joint is independent coordinate k (size: degrees of freedom)
  std::vector<Frame> frames;          ///< every link of the file, in file order
  std::vector<Point> points;          ///< the model's own named points, in file order
  std::vector<Parameter> parameters;  ///< of one declaration one behind the other
  std::vector<Snap> snaps;
  std::vector<Dissipation> dissipations;  ///< of the file, but zeros
  std::vector<Warning> warnings;

  [[nodiscard]] int size() const { return static_cast<int>(links.size()); }
  [[nodiscard]] int dof() const { return static_cast<int>(coordinates.size()); }
  /// Joints that mimic others.
  [[nodiscard]] int mimics() const { return size() - dof(); }
  /// True if joint i mimics another one: it has no coordinate of its own.
  [[nodiscard]] bool is_mimic(int i) const {
    const Drive& drive = drives[static_cast<std::size_t>(i)];
    return coordinates[static_cast<std::size_t>(drive.coordinate)] != i;
  }
  /// The link that independent coordinate k moves.
  [[nodiscard]] const Link& moved_by(int k) const {
    return links[static_cast<std::size_t>(coordinates[static_cast<std::size_t>(k)])];
  }
};

/// The sons of every link, ascending.
std::vector<std::vector<int>> sons(const Tree& tree);

/// Number of links on the path root..i, i included (1 for a root link), for every link.
std::vector<int> depths(const Tree& tree);

/// True iff `ancestor` is `link` or lies on its path to the ground: d_ij of the reachability matrix
/// D.
bool reaches(const Tree& tree, int link, int ancestor);

/// True if joints 0..5 are three sliding and three turning joints through one point whose links
/// 0..4 have no inertia and no other son: the base of a robot that is free to move.
bool has_free_base(const Tree& tree);

}  // namespace treedyn::model
