// Kinematics of EQUATIONS.md 1.2: the values of the leaves of equations/symbols.hpp at a state.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "block/evaluate.hpp"
#include "block/pattern.hpp"
#include "model/tree.hpp"

namespace treedyn::equations {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3, Eigen::RowMajor>;

template <class Scalar, class Number, class Convert>
Vector3<Scalar> vector3(const std::array<Number, 3>& a, const Convert& convert) {
  return {convert(a[0]), convert(a[1]), convert(a[2])};
}

template <class Scalar, class Number, class Convert>
Matrix3<Scalar> matrix3(const std::array<Number, 9>& a, const Convert& convert) {
  Matrix3<Scalar> result;
  for (std::size_t n = 0; n < a.size(); ++n) {
    result.data()[n] = convert(a[n]);
  }
  return result;
}

/// The constants of a tree and its points in one scalar type.
template <class Scalar>
struct Constants {
  struct Link {
    int father;
    bool revolute;
    Vector3<Scalar> axis, offset, com;
    Matrix3<Scalar> rotation, inertia;
    Scalar mass;
  };
  struct Point {
    int link;
    Vector3<Scalar> at;
    Matrix3<Scalar> rotation;  ///< frame of the named link -> link
  };
  std::vector<Link> links;
  std::vector<Point> points;
};

/// The tree as block expressions see it.
block::Index index_of(const model::Tree& tree, std::span<const model::Point> points);

/// `convert` turns a model::Real into a Scalar.
template <class Scalar, class Convert>
Constants<Scalar> constants_of(const model::Tree& tree, std::span<const model::Point> points,
                               const Convert& convert) {
  Constants<Scalar> result;
  for (const model::Link& link : tree.links) {
    result.links.push_back(
        {link.father, link.joint.turns(), vector3<Scalar>(link.joint.axis, convert),
         vector3<Scalar>(link.joint.offset, convert), vector3<Scalar>(link.inertia.com, convert),
         matrix3<Scalar>(link.joint.rotation, convert),
         matrix3<Scalar>(link.inertia.about_com, convert), convert(link.inertia.mass)});
  }
  for (const model::Point& point : points) {
    result.points.push_back(
        {point.link, vector3<Scalar>(point.at, convert), matrix3<Scalar>(point.rotation, convert)});
  }
  return result;
}

/// Sines, cosines and slides of the joints; what does not apply to a joint is not read.
template <class Scalar>
struct JointPositions {
  std::span<const Scalar> sine, cosine, q;
};

/// Rotations and places of all links, base frame.
template <class Scalar>
struct Poses {
  explicit Poses(std::size_t links) : R(links), P(links), O(links), z(links) {}
  std::vector<Matrix3<Scalar>> R;        ///< link frame -> base frame
  std::vector<Vector3<Scalar>> P, O, z;  ///< joint origin, link origin, joint axis
};

/// Rot(a, x) = cos x E + sin x Λ(a) + (1 - cos x) a a^T for a unit vector a.
template <class Scalar>
Matrix3<Scalar> rotation(const Vector3<Scalar>& a, const Scalar& sine, const Scalar& cosine) {
  Matrix3<Scalar> aaT;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      aaT(i, j) = a(i) * a(j) * (Scalar(1) - cosine);
      aaT(i, j) += i == j ? cosine : Scalar(0);
    }
  }
  aaT(0, 1) -= sine * a(2);
  aaT(1, 0) += sine * a(2);
  aaT(0, 2) += sine * a(1);
  aaT(2, 0) -= sine * a(1);
  aaT(1, 2) -= sine * a(0);
  aaT(2, 1) += sine * a(0);
  return aaT;
}

/// 1.2, fathers first.
template <class Scalar>
void compute_poses(const Constants<Scalar>& constants, const JointPositions<Scalar>& at,
                   Poses<Scalar>& poses) {
  for (std::size_t i = 0; i < constants.links.size(); ++i) {
    const auto& link = constants.links[i];
    if (link.father == model::kGround) {
      poses.P[i] = link.offset;
      poses.R[i] = link.rotation;
    } else {
      const auto f = static_cast<std::size_t>(link.father);
      poses.P[i] = poses.O[f] + poses.R[f] * link.offset;
      poses.R[i] = poses.R[f].lazyProduct(link.rotation);
    }
    poses.z[i] = poses.R[i] * link.axis;
    poses.O[i] = poses.P[i];
    if (link.revolute) {
      const Matrix3<Scalar> turn = rotation(link.axis, at.sine[i], at.cosine[i]);
      poses.R[i] = Matrix3<Scalar>(poses.R[i].lazyProduct(turn));
    } else {
      poses.O[i] += poses.z[i] * at.q[i];
    }
  }
}

/// Writes the leaves s^d, l^d, c^d, t^d, z^d, J_c^d (convention A of 1.1); those that the
/// evaluation does not use are left out.
template <class Scalar>
class LeafWriter {
 public:
  explicit LeafWriter(block::Evaluation<Scalar>& evaluation)
      : z_(evaluation.leaf("z^d")),
        s_(evaluation.leaf("s^d")),
        l_(evaluation.leaf("l^d")),
        c_(evaluation.leaf("c^d")),
        t_(evaluation.leaf("t^d")),
        J_(evaluation.leaf("J_c^d")) {}

  void write(const Constants<Scalar>& constants, const Poses<Scalar>& poses) const {
    for (std::size_t i = 0; i < constants.links.size(); ++i) {
      const auto& link = constants.links[i];
      const Matrix3<Scalar>& R = poses.R[i];
      const Vector3<Scalar> l = poses.O[i] - poses.P[i];  // the slide, E15
      put(z_, i, poses.z[i]);
      put(l_, i, l);
      put(c_, i, Vector3<Scalar>(R * link.com));
      if (link.father == model::kGround) {
        put(s_, i, poses.P[i]);  // only positions see it, (D-E) hides it elsewhere (E8, E9)
      } else {
        const auto f = static_cast<std::size_t>(link.father);
        put(s_, i, Vector3<Scalar>(poses.P[i] - poses.P[f]));  // contains the father's slide, E15
      }
      if (!J_.empty()) {
        const Matrix3<Scalar> RJ = R.lazyProduct(link.inertia);
        put(J_, i, Matrix3<Scalar>(RJ.lazyProduct(R.transpose())));
      }
    }
    for (std::size_t p = 0; p < constants.points.size(); ++p) {
      put(t_, p, point_vector(constants.points[p], poses));
    }
  }

 private:
  static Vector3<Scalar> point_vector(const typename Constants<Scalar>::Point& point,
                                      const Poses<Scalar>& poses) {
    if (point.link == model::kGround) {
      return point.at;
    }
    const auto i = static_cast<std::size_t>(point.link);
    return poses.O[i] - poses.P[i] + poses.R[i] * point.at;
  }

  template <class Value>
  static void put(std::span<Scalar> leaf, std::size_t block, const Value& value) {
    const auto size = static_cast<std::size_t>(value.size());
    if (!leaf.empty()) {
      std::copy_n(value.data(), size, leaf.data() + block * size);
    }
  }

  std::span<Scalar> z_, s_, l_, c_, t_, J_;
};

}  // namespace treedyn::equations
