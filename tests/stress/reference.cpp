#include "stress/reference.hpp"

#include <algorithm>
#include <optional>

#include "engine/engine.hpp"
#include "verify/scene_equations.hpp"

namespace treedyn::stress {

namespace {

using Matrix = std::vector<Values>;

/// Below this a scaled pivot is zero: what rounding at 50 digits leaves, also where the robot is
/// perturbed by much more.
const Real kNoPivot("1e-25");
/// What decimals of 40 digits leave of an entry of J that is zero; lengths have 12 decades.
const Real kNoLength("1e-30");

/// A x = b by elimination with the largest pivot of each column.
Values solved(Matrix A, Values b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      best = abs(A[i][k]) > abs(A[best][k]) ? i : best;
    }
    std::swap(A[k], A[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real f = A[i][k] / A[k][k];
      for (std::size_t j = k; j < n; ++j) {
        A[i][j] -= f * A[k][j];
      }
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) {
      b[k] -= A[k][j] * b[j];
    }
    b[k] /= A[k][k];
  }
  return b;
}

Real product(const Values& a, const Values& b) {
  Real sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += a[k] * b[k];
  }
  return sum;
}

/// (8) of the scene.
struct Equations {
  Matrix A;
  Values free;  ///< qdd without reactions
  std::vector<verify::SceneEquations::Row> rows;
  Matrix towards;  ///< A^-1 J^T, one entry a row
  Matrix K;
};

Equations equations(const Robot& robot) {
  const verify::SceneEquations scene(robot.scene, robot.q, robot.qd, 0);
  Equations result;
  result.A = scene.inertia();
  Values force = scene.force();
  for (std::size_t k = 0; k < force.size(); ++k) {
    force[k] += robot.tau[k] - scene.bias()[k];
  }
  result.free = solved(result.A, force);
  result.rows = scene.rows(robot.scene.phases.front().active);
  for (const verify::SceneEquations::Row& row : result.rows) {
    result.towards.push_back(solved(result.A, row.J));
  }
  for (const verify::SceneEquations::Row& row : result.rows) {
    Values line;
    for (const Values& w : result.towards) {
      line.push_back(product(row.J, w));
    }
    result.K.push_back(line);
  }
  return result;
}

/// Rows of full rank, the largest scaled pivot first, and the smallest of these pivots.
struct Choice {
  std::vector<std::size_t> rows;
  Real smallest = 1;
};

Choice independent(const Equations& equations) {
  Matrix K = equations.K;
  const std::size_t r = K.size();
  Values scale(r);
  for (std::size_t k = 0; k < r; ++k) {
    const bool vanishes =
        std::ranges::all_of(equations.rows[k].J, [](const Real& x) { return abs(x) <= kNoLength; });
    scale[k] = vanishes ? Real(0) : K[k][k];
  }
  Choice result;
  std::vector<bool> used(r, false);
  for (std::size_t step = 0; step < r; ++step) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < r; ++k) {
      const bool counts = !used[k] && scale[k] > 0 && K[k][k] > kNoPivot * scale[k];
      if (counts && (!best || K[k][k] / scale[k] > K[*best][*best] / scale[*best])) {
        best = k;
      }
    }
    if (!best) {
      break;
    }
    used[*best] = true;
    result.rows.push_back(*best);
    result.smallest = std::min(result.smallest, Real(K[*best][*best] / scale[*best]));
    const Values pivot = K[*best];
    for (std::size_t i = 0; i < r; ++i) {
      const Real f = used[i] ? Real(0) : Real(K[i][*best] / pivot[*best]);
      for (std::size_t j = 0; j < r; ++j) {
        K[i][j] -= f * pivot[j];
      }
    }
  }
  return result;
}

/// Reactions of the chosen rows.
Values reactions(const Equations& e, const Choice& choice) {
  Matrix K;
  Values wanted;
  for (const std::size_t i : choice.rows) {
    Values line;
    for (const std::size_t j : choice.rows) {
      line.push_back(e.K[i][j]);
    }
    K.push_back(line);
    wanted.push_back(e.rows[i].wanted - e.rows[i].gamma - product(e.rows[i].J, e.free));
  }
  return solved(K, wanted);
}

Values accelerations(const Robot& robot) {
  const Equations e = equations(robot);
  const Choice choice = independent(e);
  const Values lambda = reactions(e, choice);
  Values qdd = e.free;
  for (std::size_t k = 0; k < lambda.size(); ++k) {
    for (std::size_t j = 0; j < qdd.size(); ++j) {
      qdd[j] += e.towards[choice.rows[k]][j] * lambda[k];
    }
  }
  return qdd;
}

}  // namespace

Results reference(const Robot& robot) {
  engine::Engine<Real> engine(robot.scene.tree, robot.scene.points, robot.scene.gravity);
  return {{"mass_matrix", engine.evaluate("mass_matrix", {robot.q})},
          {"bias_force", engine.evaluate("bias_force", {robot.q, robot.qd})},
          {"gravity_force", engine.evaluate("gravity_force", {robot.q})},
          {"inverse_dynamics", engine.evaluate("inverse_dynamics", {robot.q, robot.qd, robot.tau})},
          {"forward_dynamics", engine.evaluate("forward_dynamics", {robot.q, robot.qd, robot.tau})},
          {"constrained_dynamics", accelerations(robot)}};
}

Real smallest_pivot(const Robot& robot) { return independent(equations(robot)).smallest; }

namespace {

template <class List>
Real norm(const List& values) {
  Real sum = 0;
  for (const Real& x : values) {
    sum += x * x;
  }
  return sqrt(sum);
}

/// One link of the recursion with norms.
struct Size {
  Real omega = 0, alpha = 0, a = 0;  ///< of its origin
  Real arm = 0;                      ///< from the father's origin
  Real f = 0, n = 0;                 ///< what it and all behind it need
};

/// Sizes of the joint forces for sizes of rates and accelerations.
Values force_sizes(const Robot& robot, const Values& qd, const Values& qdd, const Real& gravity) {
  const std::vector<model::Link>& links = robot.scene.tree.links;
  std::vector<Size> sizes(links.size());
  for (std::size_t i = 0; i < links.size(); ++i) {
    Size father;
    father.a = gravity;
    if (links[i].father >= 0) {
      father = sizes[static_cast<std::size_t>(links[i].father)];
    }
    const bool turns = links[i].joint.type == model::JointType::kRevolute;
    Size& s = sizes[i];
    const Real both = abs(qdd[i]) + 2 * father.omega * abs(qd[i]);
    s.arm = norm(links[i].joint.offset) + (turns ? Real(0) : Real(abs(robot.q[i])));
    s.omega = father.omega + (turns ? Real(abs(qd[i])) : Real(0));
    s.alpha = father.alpha + (turns ? both : Real(0));
    s.a =
        father.a + (father.alpha + father.omega * father.omega) * s.arm + (turns ? Real(0) : both);
  }
  Values result(links.size());
  for (std::size_t i = links.size(); i-- > 0;) {
    Size& s = sizes[i];
    const Real turning = s.alpha + s.omega * s.omega;
    const Real com = norm(links[i].inertia.com);
    const Real f = links[i].inertia.mass * (s.a + turning * com);
    s.f += f;
    s.n += norm(links[i].inertia.about_com) * turning + com * f;
    result[i] = links[i].joint.type == model::JointType::kRevolute ? s.n : s.f;
    if (links[i].father >= 0) {
      Size& father = sizes[static_cast<std::size_t>(links[i].father)];
      father.f += s.f;
      father.n += s.n + s.arm * s.f;
    }
  }
  return result;
}

Values sum_of(const Values& a, const Values& b) {
  Values result = a;
  for (std::size_t k = 0; k < a.size(); ++k) {
    result[k] += abs(b[k]);
  }
  return result;
}

/// |A^-1| forces.
Values acceleration_sizes(const Matrix& A, const Values& forces) {
  Values result(forces.size(), 0);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    Values unit(forces.size(), 0);
    unit[k] = 1;
    const Values column = solved(A, unit);
    for (std::size_t j = 0; j < result.size(); ++j) {
      result[j] += abs(column[j]) * forces[k];
    }
  }
  return result;
}

Values constrained_sizes(const Robot& robot, const Equations& e) {
  const Choice choice = independent(e);
  const Values lambda = reactions(e, choice);
  Values qdd = sum_of(Values(e.free.size(), 0), e.free);
  Values forces = sum_of(Values(e.free.size(), 0), robot.tau);
  for (std::size_t k = 0; k < lambda.size(); ++k) {
    for (std::size_t j = 0; j < qdd.size(); ++j) {
      qdd[j] += abs(e.towards[choice.rows[k]][j] * lambda[k]);
      forces[j] += abs(e.rows[choice.rows[k]].J[j] * lambda[k]);
    }
  }
  for (const Spring& spring : robot.springs) {
    const auto j = static_cast<std::size_t>(spring.joint);
    forces[j] +=
        spring.stiffness * (abs(robot.q[j]) + abs(spring.rest)) + spring.damping * abs(robot.qd[j]);
  }
  const Real g = norm(robot.scene.gravity);
  Values result = acceleration_sizes(e.A, sum_of(forces, force_sizes(robot, robot.qd, qdd, g)));
  for (Real& x : result) {
    x /= choice.smallest;
  }
  return result;
}

}  // namespace

Results sizes(const Robot& robot, const Results& truth) {
  const std::size_t n = robot.q.size();
  const Values none(n, 0);
  const Real g = norm(robot.scene.gravity);
  const Equations e = equations(robot);
  Results result;
  result["mass_matrix"] = Values(n * n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    Values unit = none;
    unit[k] = 1;
    const Values column = force_sizes(robot, none, unit, 0);
    for (std::size_t j = 0; j < n; ++j) {
      result["mass_matrix"][j * n + k] = column[j];
    }
  }
  result["bias_force"] = force_sizes(robot, robot.qd, none, 0);
  result["gravity_force"] = force_sizes(robot, none, none, g);
  result["inverse_dynamics"] = force_sizes(robot, robot.qd, robot.tau, g);
  const Values& qdd = truth.at("forward_dynamics");
  result["forward_dynamics"] =
      acceleration_sizes(e.A, sum_of(force_sizes(robot, robot.qd, qdd, g), robot.tau));
  result["constrained_dynamics"] = constrained_sizes(robot, e);
  return result;
}

bool is_consistent(const Robot& robot) {
  const Equations e = equations(robot);
  const Values qdd = accelerations(robot);
  return std::all_of(e.rows.begin(), e.rows.end(), [&](const verify::SceneEquations::Row& row) {
    Real size = abs(row.wanted) + abs(row.gamma);
    for (std::size_t k = 0; k < qdd.size(); ++k) {
      size += abs(row.J[k] * qdd[k]);
    }
    const Real error = product(row.J, qdd) + row.gamma - row.wanted;
    return abs(error) <= Real("1e-15") * size;
  });
}

}  // namespace treedyn::stress
