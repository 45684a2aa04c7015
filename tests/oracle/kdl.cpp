#include <kdl/tree.hpp>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <stdexcept>

#include <fmt/format.h>

#include "oracle/engines.hpp"

namespace treedyn::oracle {

namespace {

KDL::Vector vector(const Vec<double>& a) { return {a[0], a[1], a[2]}; }

std::string segment_name(int body) { return body < 0 ? "ground" : fmt::format("body{}", body); }

/// KDL's joint moves in the father's frame; its tip frame is the body frame at q = 0.
KDL::Segment segment(const Body<double>& body, int index) {
  const Mat<double>& R = body.rotation;
  const KDL::Rotation rotation(R[0], R[1], R[2], R[3], R[4], R[5], R[6], R[7], R[8]);
  const KDL::Vector origin = vector(body.offset);
  const KDL::Joint joint(fmt::format("joint{}", index), origin, rotation * vector(body.axis),
                         body.revolute ? KDL::Joint::RotAxis : KDL::Joint::TransAxis);
  const Mat<double>& I = body.inertia;
  const KDL::RigidBodyInertia inertia(body.mass, vector(body.com),
                                      KDL::RotationalInertia(I[0], I[4], I[8], I[1], I[2], I[5]));
  return KDL::Segment(segment_name(index), joint, KDL::Frame(rotation, origin), inertia);
}

class Kdl final : public Engine {
 public:
  Kdl(const Robot<double>& robot, const Vec<double>& gravity) : tree_("ground"), gravity_(gravity) {
    for (std::size_t i = 0; i < robot.size(); ++i) {
      const int index = static_cast<int>(i);
      if (!tree_.addSegment(segment(robot[i], index), segment_name(robot[i].father))) {
        throw std::runtime_error("KDL refuses " + segment_name(index));
      }
    }
    for (std::size_t i = 0; i < robot.size(); ++i) {  // KDL numbers joints in its own order
      place_.push_back(tree_.getSegment(segment_name(static_cast<int>(i)))->second.q_nr);
    }
  }

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) override {
    return solve(q, qd, qdd, gravity_);
  }

  Vector mass_matrix(const Vector& q) override {
    const std::size_t n = place_.size();
    const Vector rest(n);
    Vector A(n * n);
    for (std::size_t j = 0; j < n; ++j) {
      Vector unit(n);
      unit[j] = 1;
      const Vector column = solve(q, rest, unit, {0, 0, 0});
      for (std::size_t i = 0; i < n; ++i) {
        A[i * n + j] = column[i];
      }
    }
    return A;
  }

  Vector origins(const Vector& q) override {
    KDL::TreeFkSolverPos_recursive solver(tree_);
    Vector result;
    for (std::size_t i = 0; i < place_.size(); ++i) {
      KDL::Frame frame;
      solver.JntToCart(ordered(q), frame, segment_name(static_cast<int>(i)));
      result.insert(result.end(), {frame.p.x(), frame.p.y(), frame.p.z()});
    }
    return result;
  }

 private:
  [[nodiscard]] KDL::JntArray ordered(const Vector& x) const {
    KDL::JntArray result(static_cast<unsigned>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      result(place_[i]) = x[i];
    }
    return result;
  }

  [[nodiscard]] Vector solve(const Vector& q, const Vector& qd, const Vector& qdd,
                             const Vec<double>& gravity) const {
    KDL::TreeIdSolver_RNE solver(tree_, vector(gravity));
    KDL::JntArray tau(static_cast<unsigned>(q.size()));
    if (solver.CartToJnt(ordered(q), ordered(qd), ordered(qdd), KDL::WrenchMap(), tau) != 0) {
      throw std::runtime_error("KDL cannot solve the inverse dynamics");
    }
    Vector result;
    for (const unsigned place : place_) {
      result.push_back(tau(place));
    }
    return result;
  }

  KDL::Tree tree_;
  Vec<double> gravity_;
  std::vector<unsigned> place_;
};

}  // namespace

std::unique_ptr<Engine> make_kdl(const Robot<double>& robot, const Vec<double>& gravity) {
  return std::make_unique<Kdl>(robot, gravity);
}

}  // namespace treedyn::oracle
