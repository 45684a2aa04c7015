#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <stdexcept>

#include "oracle/engines.hpp"
#include "oracle/kdl_tree.hpp"

namespace treedyn::oracle {

namespace {

class Kdl final : public Engine {
 public:
  Kdl(const Robot<double>& robot, const Vec<double>& gravity)
      : tree_(kdl_tree(robot)), gravity_(gravity), place_(kdl_places(tree_, robot.size())) {}

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
      solver.JntToCart(ordered(q), frame, kdl_name(static_cast<int>(i)));
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
    KDL::TreeIdSolver_RNE solver(tree_, KDL::Vector(gravity[0], gravity[1], gravity[2]));
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
