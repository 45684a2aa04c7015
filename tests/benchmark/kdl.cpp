#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl/treejnttojacsolver.hpp>
#include <stdexcept>

#include <fmt/format.h>

#include "benchmark/contestant.hpp"
#include "oracle/kdl_tree.hpp"

namespace treedyn::benchmark {

namespace {

std::string point_name(std::size_t point) { return fmt::format("point{}", point); }

KDL::Tree with_points(KDL::Tree tree, const std::vector<oracle::Point<double>>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& at = points[k].at;
    const KDL::Segment segment(point_name(k), KDL::Joint(KDL::Joint::None),
                               KDL::Frame(KDL::Vector(at[0], at[1], at[2])));
    if (!tree.addSegment(segment, oracle::kdl_name(points[k].body))) {
      throw std::runtime_error("KDL refuses " + point_name(k));
    }
  }
  return tree;
}

KDL::Chain chain_to(const KDL::Tree& tree, const std::string& tip) {
  KDL::Chain chain;
  if (!tree.getChain(oracle::kdl_name(-1), tip, chain)) {
    throw std::runtime_error("KDL finds no chain to " + tip);
  }
  return chain;
}

struct KdlState {
  KDL::JntArray q, qd, qdd, tau;
};

/// What trees and chains have in common.
class KdlContestant : public Contestant {
 public:
  explicit KdlContestant(const Task& task)
      : tree_(oracle::kdl_tree(task.problem.robot)),
        tree_with_points_(with_points(tree_, task.problem.points)),
        place_(oracle::kdl_places(tree_, task.dof())),
        points_(task.problem.points.size()),
        turns_(task.states),
        gravity_(task.problem.gravity[0], task.problem.gravity[1], task.problem.gravity[2]),
        rest_(static_cast<unsigned>(task.dof())),
        out_(static_cast<unsigned>(task.dof())),
        jacobians_(points_, KDL::Jacobian(static_cast<unsigned>(task.dof()))) {
    for (const State& state : task.states) {
      states_.push_back(
          {ordered(state.q), ordered(state.qd), ordered(state.qdd), ordered(state.tau)});
    }
  }
  [[nodiscard]] std::string name() const override { return "KDL"; }

  [[nodiscard]] Vector result(Quantity quantity) const override {
    return quantity == Quantity::kJacobian ? jacobian() : reordered();
  }

 protected:
  template <class Step>
  void each(Turn turn, const Step& step) {
    repeat(turns_, turn, [&](std::size_t k) {
      if (step(states_[k]) < 0) {
        throw std::runtime_error("KDL cannot evaluate a state");
      }
    });
  }
  [[nodiscard]] std::size_t size() const { return place_.size(); }

  KDL::Tree tree_;
  KDL::Tree tree_with_points_;
  std::vector<unsigned> place_;
  std::size_t points_;
  const std::vector<State>& turns_;
  KDL::Vector gravity_;
  KDL::JntArray rest_;
  KDL::JntArray out_;
  std::vector<KDL::Jacobian> jacobians_;

 private:
  [[nodiscard]] KDL::JntArray ordered(const Vector& x) const {
    KDL::JntArray result(static_cast<unsigned>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) {
      result(place_[i]) = x[i];
    }
    return result;
  }
  [[nodiscard]] Vector reordered() const {
    Vector result;
    for (const unsigned place : place_) {
      result.push_back(out_(place));
    }
    return result;
  }
  [[nodiscard]] Vector jacobian() const {
    Vector C;
    for (const unsigned place : place_) {
      for (const KDL::Jacobian& jacobian : jacobians_) {
        for (const unsigned row : {0U, 1U, 2U}) {
          C.push_back(jacobian.data(row, place));
        }
      }
    }
    return C;
  }

  std::vector<KdlState> states_;
};

/// KDL has no mass matrix and no forward dynamics of a tree.
class KdlTree final : public KdlContestant {
 public:
  explicit KdlTree(const Task& task)
      : KdlContestant(task),
        dynamics_(tree_, gravity_),
        weightless_(tree_, KDL::Vector::Zero()),
        jacobian_(tree_with_points_) {}

  [[nodiscard]] bool can(Quantity quantity) const override {
    return quantity != Quantity::kMassMatrix && quantity != Quantity::kForwardDynamics;
  }

  void run(Quantity quantity, Turn turn) override {
    switch (quantity) {
      case Quantity::kBiasForce:
        return each(turn, [&](const KdlState& s) {
          return weightless_.CartToJnt(s.q, s.qd, rest_, wrenches_, out_);
        });
      case Quantity::kGravityForce:
        return each(turn, [&](const KdlState& s) {
          return dynamics_.CartToJnt(s.q, rest_, rest_, wrenches_, out_);
        });
      case Quantity::kInverseDynamics:
        return each(turn, [&](const KdlState& s) {
          return dynamics_.CartToJnt(s.q, s.qd, s.qdd, wrenches_, out_);
        });
      case Quantity::kJacobian:
        return each(turn, [&](const KdlState& s) { return jacobians(s.q); });
      default:
        throw std::logic_error("a quantity that KDL does not have");
    }
  }

 private:
  int jacobians(const KDL::JntArray& q) {
    int status = 0;
    for (std::size_t k = 0; k < points_; ++k) {
      status = std::min(status, jacobian_.JntToJac(q, jacobians_[k], point_names_[k]));
    }
    return status;
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (std::size_t k = 0; k < points_; ++k) {
      result.push_back(point_name(k));
    }
    return result;
  }

  KDL::TreeIdSolver_RNE dynamics_;
  KDL::TreeIdSolver_RNE weightless_;
  KDL::TreeJntToJacSolver jacobian_;
  KDL::WrenchMap wrenches_;
  std::vector<std::string> point_names_ = names();
};

class KdlChain final : public KdlContestant {
 public:
  explicit KdlChain(const Task& task)
      : KdlContestant(task),
        chain_(chain_to(tree_, oracle::kdl_name(static_cast<int>(size()) - 1))),
        chain_to_point_(chain_to(tree_with_points_, point_name(0))),
        terms_(chain_, gravity_),
        inverse_(chain_, gravity_),
        forward_(chain_, gravity_),
        jacobian_(chain_to_point_),
        wrenches_(size()),
        A_(static_cast<int>(size())) {}

  [[nodiscard]] bool can(Quantity quantity) const override {
    return quantity != Quantity::kJacobian ||
           (points_ == 1 && chain_to_point_.getNrOfJoints() == size());
  }

  void run(Quantity quantity, Turn turn) override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return each(turn, [&](const KdlState& s) { return terms_.JntToMass(s.q, A_); });
      case Quantity::kBiasForce:
        return each(turn, [&](const KdlState& s) { return terms_.JntToCoriolis(s.q, s.qd, out_); });
      case Quantity::kGravityForce:
        return each(turn, [&](const KdlState& s) { return terms_.JntToGravity(s.q, out_); });
      case Quantity::kInverseDynamics:
        return each(turn, [&](const KdlState& s) {
          return inverse_.CartToJnt(s.q, s.qd, s.qdd, wrenches_, out_);
        });
      case Quantity::kForwardDynamics:
        return each(turn, [&](const KdlState& s) {
          return forward_.CartToJnt(s.q, s.qd, s.tau, wrenches_, out_);
        });
      case Quantity::kJacobian:
        return each(turn,
                    [&](const KdlState& s) { return jacobian_.JntToJac(s.q, jacobians_[0]); });
    }
  }

  [[nodiscard]] Vector result(Quantity quantity) const override {
    if (quantity != Quantity::kMassMatrix) {
      return KdlContestant::result(quantity);
    }
    Vector A;
    for (unsigned i = 0; i < size(); ++i) {
      for (unsigned j = 0; j < size(); ++j) {
        A.push_back(A_(i, j));
      }
    }
    return A;
  }

 private:
  KDL::Chain chain_;
  KDL::Chain chain_to_point_;
  KDL::ChainDynParam terms_;
  KDL::ChainIdSolver_RNE inverse_;
  KDL::ChainFdSolver_RNE forward_;
  KDL::ChainJntToJacSolver jacobian_;
  KDL::Wrenches wrenches_;
  KDL::JntSpaceInertiaMatrix A_;
};

bool is_chain(const oracle::Robot<double>& robot) {
  for (std::size_t i = 0; i < robot.size(); ++i) {
    if (robot[i].father != static_cast<int>(i) - 1) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::unique_ptr<Contestant> make_kdl(const Task& task) {
  if (is_chain(task.problem.robot)) {
    return std::make_unique<KdlChain>(task);
  }
  return std::make_unique<KdlTree>(task);
}

}  // namespace treedyn::benchmark
