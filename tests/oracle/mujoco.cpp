#include <mujoco/mujoco.h>

#include <limits>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "oracle/engines.hpp"
#include "support/process.hpp"

namespace treedyn::oracle {

namespace {

using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

constexpr Mat<double> kIdentity{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Principal moments (ascending) and axes (columns of a rotation).
struct Principal {
  Eigen::Vector3d moments;
  Matrix axes;
};

Principal principal(const Mat<double>& inertia) {
  const Matrix I = Eigen::Map<const Matrix>(inertia.data());
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(I);
  Principal result{solver.eigenvalues(), solver.eigenvectors()};
  if (result.axes.determinant() < 0) {
    result.axes.col(2) *= -1;
  }
  return result;
}

std::vector<std::vector<std::size_t>> sons(const Robot<double>& robot) {
  std::vector<std::vector<std::size_t>> result(robot.size());
  for (std::size_t i = 0; i < robot.size(); ++i) {
    if (robot[i].father >= 0) {
      result[static_cast<std::size_t>(robot[i].father)].push_back(i);
    }
  }
  return result;
}

std::string text(const Vec<double>& a) { return fmt::format("{} {} {}", a[0], a[1], a[2]); }

/// The x and y axes of a frame, MuJoCo's attribute xyaxes.
std::string text(const Mat<double>& R) {
  return fmt::format("{} {} {} {} {} {}", R[0], R[3], R[6], R[1], R[4], R[7]);
}

/// Writes MJCF. Massless bodies vanish: their joints move to the next body with mass.
class Writer {
 public:
  Writer(const Robot<double>& robot, const Vec<double>& gravity)
      : robot_(robot), sons_(sons(robot)) {
    xml_ = fmt::format(
        "<mujoco><compiler angle=\"radian\" coordinate=\"local\"/><option gravity=\"{}\"/>"
        "<worldbody>\n",
        text(gravity));
    for (std::size_t i = 0; i < robot.size(); ++i) {
      if (robot[i].father < 0) {
        body(i);
      }
    }
    xml_ += "</worldbody></mujoco>\n";
  }
  [[nodiscard]] const std::string& xml() const { return xml_; }

 private:
  /// `first` and the massless run that starts with it, down to the first body with mass.
  void body(std::size_t first) {
    std::vector<std::size_t> run{first};
    while (robot_[run.back()].mass == 0) {
      run.push_back(sons_[run.back()].front());
    }
    Mat<double> R = kIdentity;  // the last frame in the first father's frame, at q = 0
    Vec<double> origin{};
    for (const std::size_t i : run) {
      origin = origin + R * robot_[i].offset;
      R = R * robot_[i].rotation;
    }
    xml_ += fmt::format("<body name=\"body{}\" pos=\"{}\" xyaxes=\"{}\">\n", run.back(),
                        text(origin), text(R));
    joints(run, R, origin);
    inertial(robot_[run.back()]);
    for (const std::size_t son : sons_[run.back()]) {
      body(son);
    }
    xml_ += "</body>\n";
  }

  /// The joints of a run in the frame of its last body at q = 0.
  void joints(const std::vector<std::size_t>& run, const Mat<double>& R,
              const Vec<double>& origin) {
    Mat<double> to_father = kIdentity;
    Vec<double> at{};
    for (const std::size_t i : run) {
      at = at + to_father * robot_[i].offset;
      to_father = to_father * robot_[i].rotation;
      xml_ +=
          fmt::format("<joint name=\"joint{}\" type=\"{}\" pos=\"{}\" axis=\"{}\"/>\n", i,
                      robot_[i].revolute ? "hinge" : "slide", text(transposed(R) * (at - origin)),
                      text(transposed(R) * (to_father * robot_[i].axis)));
    }
  }

  void inertial(const Body<double>& body) {
    const Principal p = principal(body.inertia);
    Mat<double> axes{};
    Eigen::Map<Matrix>(axes.data()) = p.axes;
    xml_ += fmt::format(
        "<inertial mass=\"{}\" pos=\"{}\" xyaxes=\"{}\" diaginertia=\"{} {} {}\"/>\n", body.mass,
        text(body.com), text(axes), p.moments[0], p.moments[1], p.moments[2]);
  }

  const Robot<double>& robot_;
  std::vector<std::vector<std::size_t>> sons_;
  std::string xml_;
};

class Mujoco final : public Engine {
 public:
  Mujoco(const Robot<double>& robot, const Vec<double>& gravity) {
    const support::TemporaryFolder folder;
    const std::string file = folder.path() / "robot.xml";
    support::write_file(file, mjcf(robot, gravity));
    std::string error(1000, '\0');
    model_.reset(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
    if (model_ == nullptr) {
      throw std::runtime_error("MuJoCo: " + std::string(error.c_str()));
    }
    data_.reset(mj_makeData(model_.get()));
    for (std::size_t i = 0; i < robot.size(); ++i) {
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, fmt::format("joint{}", i).c_str());
      place_.push_back(static_cast<std::size_t>(joint));
      bodies_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, fmt::format("body{}", i).c_str()));
    }
  }

  Vector mass_matrix(const Vector& q) override {
    const std::size_t n = place_.size();
    set(q, Vector(n), Vector(n));
    mj_forward(model_.get(), data_.get());
    Vector full(n * n);
    mj_fullM(model_.get(), full.data(), data_->qM);
    Vector A(n * n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        A[i * n + j] = full[place_[i] * n + place_[j]];
      }
    }
    return A;
  }

  Vector inverse_dynamics(const Vector& q, const Vector& qd, const Vector& qdd) override {
    set(q, qd, qdd);
    mj_inverse(model_.get(), data_.get());
    Vector tau;
    for (const std::size_t place : place_) {
      tau.push_back(data_->qfrc_inverse[place]);
    }
    return tau;
  }

  Vector origins(const Vector& q) override {
    set(q, Vector(q.size()), Vector(q.size()));
    mj_kinematics(model_.get(), data_.get());
    Vector result;
    for (const int body : bodies_) {
      for (int k = 0; k < 3; ++k) {
        result.push_back(body < 0 ? std::numeric_limits<double>::quiet_NaN()
                                  : data_->xpos[3 * body + k]);
      }
    }
    return result;
  }

 private:
  void set(const Vector& q, const Vector& qd, const Vector& qdd) {
    for (std::size_t i = 0; i < place_.size(); ++i) {
      data_->qpos[place_[i]] = q[i];
      data_->qvel[place_[i]] = qd[i];
      data_->qacc[place_[i]] = qdd[i];
    }
  }

  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
  std::vector<std::size_t> place_;  ///< body -> MuJoCo's joint
  std::vector<int> bodies_;         ///< body -> MuJoCo's body, -1 for a massless one
};

}  // namespace

bool mujoco_reads(const Robot<double>& robot) {
  constexpr double kSmallest = 1e-15;  // mjMINVAL
  const auto all_sons = sons(robot);
  for (std::size_t i = 0; i < robot.size(); ++i) {
    if (robot[i].mass == 0) {
      if (all_sons[i].size() != 1 || robot[i].inertia != Mat<double>{}) {
        return false;
      }
      continue;
    }
    const Eigen::Vector3d I = principal(robot[i].inertia).moments;
    if (I[0] < kSmallest || I[0] + I[1] < I[2]) {
      return false;
    }
  }
  return true;
}

std::string mjcf(const Robot<double>& robot, const Vec<double>& gravity) {
  return Writer(robot, gravity).xml();
}

std::unique_ptr<Engine> make_mujoco(const Robot<double>& robot, const Vec<double>& gravity) {
  return std::make_unique<Mujoco>(robot, gravity);
}

}  // namespace treedyn::oracle
