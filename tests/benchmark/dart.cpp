#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/EulerJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/TranslationalJoint.hpp>

#include "benchmark/contestant.hpp"

namespace treedyn::benchmark {

namespace {

using dart::dynamics::BodyNode;
using dart::dynamics::Skeleton;
using Matrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Body = oracle::Body<double>;

Eigen::Vector3d vector(const oracle::Vec<double>& a) { return {a[0], a[1], a[2]}; }

Matrix3 matrix(const oracle::Mat<double>& a) { return Eigen::Map<const Matrix3>(a.data()); }

template <class Properties>
Properties properties_of(const Body& body, const std::string& name) {
  Properties properties;
  properties.mName = "joint of " + name;
  properties.mT_ParentBodyToJoint.linear() = matrix(body.rotation);
  properties.mT_ParentBodyToJoint.translation() = vector(body.offset);
  return properties;
}

BodyNode* add_body(Skeleton& skeleton, BodyNode* father, const Body& body,
                   const std::string& name) {
  using dart::dynamics::PrismaticJoint;
  using dart::dynamics::RevoluteJoint;
  if (body.revolute) {
    auto properties = properties_of<RevoluteJoint::Properties>(body, name);
    properties.mAxis = vector(body.axis);
    return skeleton
        .createJointAndBodyNodePair<RevoluteJoint>(father, properties,
                                                   BodyNode::AspectProperties(name))
        .second;
  }
  auto properties = properties_of<PrismaticJoint::Properties>(body, name);
  properties.mAxis = vector(body.axis);
  return skeleton
      .createJointAndBodyNodePair<PrismaticJoint>(father, properties,
                                                  BodyNode::AspectProperties(name))
      .second;
}

void set_inertia(BodyNode& node, const Body& body) {
  dart::dynamics::Inertia inertia;
  inertia.setMass(body.mass);
  inertia.setLocalCOM(vector(body.com));
  const oracle::Mat<double>& I = body.inertia;
  inertia.setMoment(I[0], I[4], I[8], I[1], I[2], I[5]);
  node.setInertia(inertia);
}

/// The six joints of --base axes as DART's own: one of translations, one of Euler angles.
BodyNode* add_axes(Skeleton& skeleton) {
  using dart::dynamics::EulerJoint;
  using dart::dynamics::TranslationalJoint;
  BodyNode* carriage = skeleton.createJointAndBodyNodePair<TranslationalJoint>(nullptr).second;
  set_inertia(*carriage, {});
  EulerJoint::Properties properties;
  properties.mName = "joint of base";
  properties.mAxisOrder = EulerJoint::AxisOrder::ZYX;
  return skeleton
      .createJointAndBodyNodePair<EulerJoint>(carriage, properties,
                                              BodyNode::AspectProperties("base"))
      .second;
}

bool has_axes(const Task& task) {
  return task.dof() > 6 && task.tree.links[0].joint.name == "base_px";
}

class Dart final : public Contestant {
 public:
  explicit Dart(const Task& task)
      : points_(task.problem.points), turns_(task.states), rest_(vector_of(task.dof())) {
    skeleton_ = Skeleton::create("robot");
    skeleton_->setGravity(vector(task.problem.gravity));
    build(task);
    for (const State& state : task.states) {
      states_.push_back(
          {ordered(state.q), ordered(state.qd), ordered(state.qdd), ordered(state.tau)});
    }
    for (const oracle::Point<double>& point : points_) {
      offsets_.push_back(vector(point.at));
    }
    jacobians_.resize(points_.size());
  }
  [[nodiscard]] std::string name() const override { return "DART"; }
  [[nodiscard]] bool can(Quantity /*quantity*/) const override { return true; }

  void run(Quantity quantity, Turn turn) override {
    repeat(turns_, turn, [&](std::size_t k) { evaluate(quantity, states_[k]); });
  }

  [[nodiscard]] Vector result(Quantity quantity) const override {
    switch (quantity) {
      case Quantity::kMassMatrix:
        return mass_matrix();
      case Quantity::kForwardDynamics:
        return reordered(skeleton_->getAccelerations());
      case Quantity::kJacobian:
        return jacobian();
      default:
        return reordered(out_);
    }
  }

 private:
  struct DartState {
    Eigen::VectorXd q, qd, qdd, tau;
  };

  static Eigen::VectorXd vector_of(std::size_t size) {
    return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(size));
  }

  void build(const Task& task) {
    const oracle::Robot<double>& robot = task.problem.robot;
    std::size_t first = 0;
    if (has_axes(task)) {
      nodes_.assign(6, add_axes(*skeleton_));
      set_inertia(*nodes_.back(), robot[5]);
      place_ = {0, 1, 2, 3, 4, 5};
      first = 6;
    }
    for (std::size_t i = first; i < robot.size(); ++i) {
      BodyNode* father =
          robot[i].father < 0 ? nullptr : nodes_[static_cast<std::size_t>(robot[i].father)];
      nodes_.push_back(add_body(*skeleton_, father, robot[i], "body " + std::to_string(i)));
      set_inertia(*nodes_.back(), robot[i]);
    }
    for (std::size_t i = first; i < robot.size(); ++i) {
      place_.push_back(
          static_cast<Eigen::Index>(nodes_[i]->getParentJoint()->getIndexInSkeleton(0)));
    }
  }

  void evaluate(Quantity quantity, const DartState& s) {
    skeleton_->setPositions(s.q);
    switch (quantity) {
      case Quantity::kMassMatrix:
        mass_matrix_ = &skeleton_->getMassMatrix();
        return;
      case Quantity::kBiasForce:
        skeleton_->setVelocities(s.qd);
        out_ = skeleton_->getCoriolisForces();
        return;
      case Quantity::kGravityForce:
        out_ = skeleton_->getGravityForces();
        return;
      case Quantity::kInverseDynamics:
        skeleton_->setVelocities(s.qd);
        skeleton_->setAccelerations(s.qdd);
        skeleton_->computeInverseDynamics();
        out_ = skeleton_->getForces();
        return;
      case Quantity::kForwardDynamics:
        skeleton_->setVelocities(s.qd);
        skeleton_->setForces(s.tau);
        skeleton_->computeForwardDynamics();
        return;
      case Quantity::kJacobian:
        for (std::size_t k = 0; k < points_.size(); ++k) {
          jacobians_[k] = skeleton_->getLinearJacobian(
              nodes_[static_cast<std::size_t>(points_[k].body)], offsets_[k]);
        }
        return;
    }
  }

  [[nodiscard]] Eigen::VectorXd ordered(const Vector& x) const {
    Eigen::VectorXd result = rest_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      result[place_[i]] = x[i];
    }
    return result;
  }
  [[nodiscard]] Vector reordered(const Eigen::VectorXd& x) const {
    Vector result;
    for (const Eigen::Index place : place_) {
      result.push_back(x[place]);
    }
    return result;
  }
  [[nodiscard]] Vector mass_matrix() const {
    Vector A;
    for (const Eigen::Index row : place_) {
      for (const Eigen::Index column : place_) {
        A.push_back((*mass_matrix_)(row, column));
      }
    }
    return A;
  }
  [[nodiscard]] Vector jacobian() const {
    Vector C;
    for (const Eigen::Index place : place_) {
      for (const auto& jacobian : jacobians_) {
        C.insert(C.end(), {jacobian(0, place), jacobian(1, place), jacobian(2, place)});
      }
    }
    return C;
  }

  std::vector<oracle::Point<double>> points_;
  const std::vector<State>& turns_;
  Eigen::VectorXd rest_;
  dart::dynamics::SkeletonPtr skeleton_;
  std::vector<BodyNode*> nodes_;     ///< of the bodies
  std::vector<Eigen::Index> place_;  ///< joint -> DART's coordinate
  std::vector<DartState> states_;    ///< in DART's order
  std::vector<Eigen::Vector3d> offsets_;
  const Eigen::MatrixXd* mass_matrix_ = nullptr;
  Eigen::VectorXd out_;
  std::vector<dart::math::LinearJacobian> jacobians_;
};

}  // namespace

std::unique_ptr<Contestant> make_dart(const Task& task) { return std::make_unique<Dart>(task); }

}  // namespace treedyn::benchmark
