#include "expansion/lagrange.hpp"

#include "expansion/rational.hpp"

namespace treedyn::expansion {
namespace {

using Matrix4 = Lagrange::Matrix4;
using Vector4 = std::array<Expanded, 4>;

Matrix4 unit() {
  Matrix4 m{};
  for (std::size_t i = 0; i < 4; ++i) {
    m[5 * i] = 1;
  }
  return m;
}

Matrix4 times(const Matrix4& a, const Matrix4& b, bool b_transposed = false) {
  Matrix4 c{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        c[4 * i + j] += a[4 * i + k] * (b_transposed ? b[4 * j + k] : b[4 * k + j]);
      }
    }
  }
  return c;
}

Vector4 times(const Matrix4& a, const Vector4& x) {
  Vector4 y{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      y[i] += a[4 * i + k] * x[k];
    }
  }
  return y;
}

Expanded trace(const Matrix4& a) { return a[0] + a[5] + a[10] + a[15]; }

}  // namespace

Lagrange::Lagrange(const model::Tree& tree, const std::vector<model::Point>& points,
                   const model::Vector3& gravity, const Expansion& expansion)
    : expansion_(expansion) {
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const model::Link& link = tree.links[i];
    const bool ground = link.father == model::kGround;
    const Matrix4 father = ground ? unit() : poses_[static_cast<std::size_t>(link.father)];
    poses_.push_back(times(father, joint_pose(link, i)));
    pseudo_inertia_.push_back(pseudo_inertia(link));
    revolute_.push_back(link.joint.type == model::JointType::kRevolute);
    const Expanded m = constant(link.inertia.mass);
    first_moments_.push_back({m * constant(link.inertia.com[0]), m * constant(link.inertia.com[1]),
                              m * constant(link.inertia.com[2]), m});
  }
  for (const model::Point& point : points) {
    const bool ground = point.link == model::kGround;
    point_poses_.push_back(ground ? unit() : poses_[static_cast<std::size_t>(point.link)]);
    points_.push_back({constant(point.at[0]), constant(point.at[1]), constant(point.at[2]), 1});
  }
  gravity_ = {constant(gravity[0]), constant(gravity[1]), constant(gravity[2])};
}

Expanded Lagrange::constant(const Real& value) const {
  return {expansion_.ring(), nearby_rational(value).value()};
}

// Placement in the father, then the motion: a turn (Rodrigues) or a slide.
Matrix4 Lagrange::joint_pose(const model::Link& link, std::size_t i) const {
  Matrix4 placement = unit();
  Matrix4 motion = unit();
  const auto& a = link.joint.axis;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      placement[4 * r + c] = constant(link.joint.rotation[3 * r + c]);
    }
    placement[4 * r + 3] = constant(link.joint.offset[r]);
  }
  if (link.joint.type == model::JointType::kPrismatic) {
    for (std::size_t r = 0; r < 3; ++r) {
      motion[4 * r + 3] = constant(a[r]) * expansion_.position(i);
    }
    return times(placement, motion);
  }
  const Expanded& s = expansion_.sine(i);
  const Expanded& c = expansion_.cosine(i);
  for (std::size_t r = 0; r < 3; ++r) {
    motion[5 * r] = c;
    for (std::size_t k = 0; k < 3; ++k) {
      motion[4 * r + k] += constant(a[r] * a[k]) * (Expanded(1) - c);
    }
    const std::size_t next = (r + 1) % 3;
    const std::size_t last = (r + 2) % 3;
    motion[4 * next + r] += constant(a[last]) * s;
    motion[4 * r + next] -= constant(a[last]) * s;
  }
  return times(placement, motion);
}

// ∫ (x, 1) (x, 1)^T dm about the link's origin: second moments 1/2 tr(I) E - I with I = J - m
// Λ(c)^2.
Matrix4 Lagrange::pseudo_inertia(const model::Link& link) const {
  const Real& m = link.inertia.mass;
  const auto& c = link.inertia.com;
  const auto& J = link.inertia.about_com;
  const Real half_trace = (J[0] + J[4] + J[8]) / 2;
  Matrix4 S{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Real central = (r == k ? half_trace : Real(0)) - J[3 * r + k];
      S[4 * r + k] = constant(central + m * c[r] * c[k]);
    }
    S[4 * r + 3] = constant(m * c[r]);
    S[12 + r] = S[4 * r + 3];
  }
  S[15] = constant(m);
  return S;
}

Expanded Lagrange::slope(const Expanded& value, std::size_t joint) const {
  const auto partial = [&](const Expanded& variable) {
    const auto symbol = GiNaC::ex_to<GiNaC::symbol>(variable.value());
    return Expanded(expansion_.ring(), value.value().diff(symbol));
  };
  if (!revolute_[joint]) {
    return partial(expansion_.position(joint));
  }
  const Expanded& s = expansion_.sine(joint);
  const Expanded& c = expansion_.cosine(joint);
  return partial(s) * c - partial(c) * s;
}

Matrix4 Lagrange::slope(const Matrix4& pose, std::size_t joint) const {
  Matrix4 result{};
  for (std::size_t n = 0; n < 12; ++n) {  // the last row is constant
    result[n] = slope(pose[n], joint);
  }
  return result;
}

std::vector<Expanded> Lagrange::A() const {
  const std::size_t n = revolute_.size();
  std::vector<Expanded> result(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const Matrix4 weighted = times(slope(poses_[i], k), pseudo_inertia_[i]);
      for (std::size_t l = 0; l < n; ++l) {
        result[k * n + l] += trace(times(weighted, slope(poses_[i], l), true));
      }
    }
  }
  return result;
}

std::vector<Expanded> Lagrange::B() const {
  const std::size_t n = revolute_.size();
  const std::vector<Expanded> A = this->A();
  std::vector<Expanded> result(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        const Expanded christoffel = slope(A[k * n + i], j) - slope(A[i * n + j], k) / Expanded(2);
        result[k] += christoffel * expansion_.rate(i) * expansion_.rate(j);
      }
    }
  }
  return result;
}

std::vector<Expanded> Lagrange::G() const {
  std::vector<Expanded> result(revolute_.size());
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Vector4 moment = times(poses_[i], first_moments_[i]);  // m r
    for (std::size_t k = 0; k < result.size(); ++k) {
      for (std::size_t n = 0; n < 3; ++n) {
        result[k] -= gravity_[n] * slope(moment[n], k);
      }
    }
  }
  return result;
}

std::vector<Expanded> Lagrange::C() const {
  const std::size_t width = 3 * points_.size();
  std::vector<Expanded> result(revolute_.size() * width);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const Vector4 place = times(point_poses_[p], points_[p]);
    for (std::size_t k = 0; k < revolute_.size(); ++k) {
      for (std::size_t n = 0; n < 3; ++n) {
        result[k * width + 3 * p + n] = slope(place[n], k);
      }
    }
  }
  return result;
}

// ∂R/∂q_k R^T is the skew matrix of column k of H^T.
std::vector<Expanded> Lagrange::H() const {
  const std::size_t width = 3 * points_.size();
  std::vector<Expanded> result(revolute_.size() * width);
  for (std::size_t p = 0; p < points_.size(); ++p) {
    Matrix4 R = point_poses_[p];
    R[3] = R[7] = R[11] = 0;
    for (std::size_t k = 0; k < revolute_.size(); ++k) {
      const Matrix4 turn = times(slope(R, k), R, true);
      result[k * width + 3 * p] = turn[9];
      result[k * width + 3 * p + 1] = turn[2];
      result[k * width + 3 * p + 2] = turn[4];
    }
  }
  return result;
}

// Σ_kl ∂(row k)/∂q_l q̇_k q̇_l
std::vector<Expanded> Lagrange::curvature(const std::vector<Expanded>& slopes) const {
  const std::size_t width = 3 * points_.size();
  std::vector<Expanded> result(width);
  for (std::size_t n = 0; n < width; ++n) {
    for (std::size_t k = 0; k < revolute_.size(); ++k) {
      for (std::size_t l = 0; l < revolute_.size(); ++l) {
        result[n] += slope(slopes[k * width + n], l) * expansion_.rate(k) * expansion_.rate(l);
      }
    }
  }
  return result;
}

std::vector<Expanded> Lagrange::gamma_f() const { return curvature(C()); }

std::vector<Expanded> Lagrange::gamma_n() const { return curvature(H()); }

}  // namespace treedyn::expansion
