// Engines from Debian behind one face. They know nothing of treedyn; the robot is handed to them as
// plain numbers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "oracle/recursive.hpp"

namespace treedyn::oracle {

/// A robot loaded by another engine; joints in the order of the robot.
class Engine {
 public:
  using Vector = std::vector<double>;
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  virtual ~Engine() = default;
  /// N x N, row-major.
  virtual Vector mass_matrix(const Vector& q) = 0;
  /// Joint forces for the accelerations `qdd`, gravity included.
  virtual Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) = 0;
  /// Origin of every body, base frame, 3N; entries of bodies that the engine does not keep are NaN.
  virtual Vector origins(const Vector& q) = 0;
};

/// True if MuJoCo can represent the robot: every massless body has no inertia and exactly one son
/// (they then become one body with several joints), and every inertia is positive definite and
/// satisfies the triangle inequality.
bool mujoco_reads(const Robot<double>& robot);

/// The robot as MuJoCo reads it: body i is "body<i>", its joint "joint<i>". \pre
/// mujoco_reads(robot)
std::string mjcf(const Robot<double>& robot, const Vec<double>& gravity);

/// \pre mujoco_reads(robot)
/// \throws std::runtime_error with MuJoCo's message if it refuses the model.
std::unique_ptr<Engine> make_mujoco(const Robot<double>& robot, const Vec<double>& gravity);

/// Orocos KDL reads every tree.
std::unique_ptr<Engine> make_kdl(const Robot<double>& robot, const Vec<double>& gravity);

}  // namespace treedyn::oracle
