#include "support/random_tree.hpp"

#include "common/index.hpp"

namespace treedyn::support {
namespace {

model::Vector3 random_vector(Dice& dice, double limit) {
  return {Real(dice.number(limit)), Real(dice.number(limit)), Real(dice.number(limit))};
}

// From an integer quaternion: a rational rotation.
model::Matrix3 random_rotation(Dice& dice) {
  const Real a = dice.below(4) + 1;
  const Real b = dice.below(7) - 3;
  const Real c = dice.below(7) - 3;
  const Real d = dice.below(7) - 3;
  const Real n = a * a + b * b + c * c + d * d;
  return {(a * a + b * b - c * c - d * d) / n,
          2 * (b * c - a * d) / n,
          2 * (b * d + a * c) / n,
          2 * (b * c + a * d) / n,
          (a * a - b * b + c * c - d * d) / n,
          2 * (c * d - a * b) / n,
          2 * (b * d - a * c) / n,
          2 * (c * d + a * b) / n,
          (a * a - b * b - c * c + d * d) / n};
}

// R diag R^T with principal moments that satisfy the triangle inequality.
model::Matrix3 random_inertia(Dice& dice) {
  const model::Matrix3 R = random_rotation(dice);
  const Real principal[] = {Real(dice.below(8) + 8) / 64, Real(dice.below(8) + 8) / 64,
                            Real(dice.below(8) + 8) / 64};
  model::Matrix3 J{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        J[to_index(3 * i + j)] += R[to_index(3 * i + k)] * principal[k] * R[to_index(3 * j + k)];
      }
    }
  }
  return J;
}

model::Link random_link(int index, int father, char type, Dice& dice) {
  model::Link link;
  link.name = std::string("link").append(std::to_string(index));
  link.father = father;
  link.joint.name = std::string("j").append(std::to_string(index));
  link.joint.identifier = link.joint.name;
  link.joint.type = type == 'R' ? model::JointType::kRevolute : model::JointType::kPrismatic;
  const model::Matrix3 axes = random_rotation(dice);
  link.joint.axis = {axes[0], axes[3], axes[6]};
  link.joint.offset = random_vector(dice, 0.5);
  link.joint.rotation = random_rotation(dice);
  link.inertia.mass = Real(dice.below(64) + 16) / 16;
  link.inertia.com = random_vector(dice, 0.25);
  link.inertia.about_com = random_inertia(dice);
  return link;
}

}  // namespace

int Dice::below(int n) {
  state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<int>((state_ >> 33) % static_cast<std::uint64_t>(n));
}

double Dice::number(double limit) {
  const int steps = static_cast<int>(limit * 64);
  return (below(2 * steps + 1) - steps) / 64.0;
}

std::vector<double> Dice::numbers(std::size_t count, double limit) {
  std::vector<double> result(count);
  for (double& x : result) {
    x = number(limit);
  }
  return result;
}

TreeShape chain(const std::string& types) {
  TreeShape shape{{}, types};
  for (int i = 0; i < static_cast<int>(types.size()); ++i) {
    shape.father.push_back(i - 1);
  }
  return shape;
}

TreeShape random_shape(int links, Dice& dice) {
  TreeShape shape;
  const int kind = dice.below(3);  // chain, tree, forest
  for (int i = 0; i < links; ++i) {
    const int father = kind == 0   ? i - 1
                       : kind == 1 ? (i == 0 ? -1 : dice.below(i))
                                   : dice.below(i + 1) - 1;
    shape.father.push_back(father);
    shape.types += dice.below(3) == 0 ? 'P' : 'R';
  }
  return shape;
}

model::Tree random_tree(const TreeShape& shape, Dice& dice) {
  model::Tree tree;
  tree.name = "random";
  tree.identifier = "random";
  for (std::size_t i = 0; i < shape.father.size(); ++i) {
    const int index = static_cast<int>(i);
    tree.links.push_back(random_link(index, shape.father[i], shape.types[i], dice));
    tree.drives.push_back({index, 1, 0});
    tree.coordinates.push_back(index);
  }
  return tree;
}

std::vector<model::Point> random_points(const model::Tree& tree, int count, Dice& dice) {
  std::vector<model::Point> points;
  for (int p = 0; p < count; ++p) {
    model::Point point;
    point.name = std::string("p").append(std::to_string(p));
    point.identifier = point.name;
    point.link = dice.below(tree.size() + 1) - 1;
    point.at = random_vector(dice, 0.5);
    points.push_back(point);
  }
  return points;
}

}  // namespace treedyn::support
