#include "oracle/kdl_tree.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace treedyn::oracle {

namespace {

KDL::Vector vector(const Vec<double>& a) { return {a[0], a[1], a[2]}; }

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
  return KDL::Segment(kdl_name(index), joint, KDL::Frame(rotation, origin), inertia);
}

}  // namespace

std::string kdl_name(int body) { return body < 0 ? "ground" : fmt::format("body{}", body); }

KDL::Tree kdl_tree(const Robot<double>& robot) {
  KDL::Tree tree(kdl_name(-1));
  for (std::size_t i = 0; i < robot.size(); ++i) {
    const int index = static_cast<int>(i);
    if (!tree.addSegment(segment(robot[i], index), kdl_name(robot[i].father))) {
      throw std::runtime_error("KDL refuses " + kdl_name(index));
    }
  }
  return tree;
}

std::vector<unsigned> kdl_places(const KDL::Tree& tree, std::size_t bodies) {
  std::vector<unsigned> places;
  for (std::size_t i = 0; i < bodies; ++i) {
    places.push_back(tree.getSegment(kdl_name(static_cast<int>(i)))->second.q_nr);
  }
  return places;
}

}  // namespace treedyn::oracle
