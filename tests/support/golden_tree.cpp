#include "support/golden_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/index.hpp"

namespace treedyn::support {
namespace {

using nlohmann::json;
using Numbers = std::vector<double>;

// Fathers before sons, otherwise the order of the file; position -> link of the file.
std::vector<std::size_t> tree_order(const std::vector<int>& father) {
  std::vector<std::size_t> order;
  std::vector<bool> placed(father.size() + 1, false);
  placed[0] = true;  // ground
  while (order.size() < father.size()) {
    for (std::size_t i = 0; i < father.size(); ++i) {
      if (!placed[i + 1] && placed[to_index(father[i])]) {
        placed[i + 1] = true;
        order.push_back(i);
      }
    }
  }
  return order;
}

template <std::size_t Size>
std::array<Real, Size> reals(const json& list) {
  std::array<Real, Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    result[i] = Real(list.at(i).get<double>());
  }
  return result;
}

Numbers flat(const json& value) {
  if (value.is_number()) {
    return {value.get<double>()};
  }
  Numbers result;
  for (const json& element : value) {
    const Numbers part = flat(element);
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

// Blocks of `size` numbers, reordered.
Numbers reordered(const Numbers& values, std::size_t size, const std::vector<std::size_t>& order) {
  Numbers result;
  for (const std::size_t i : order) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * size);
    result.insert(result.end(), first, first + static_cast<std::ptrdiff_t>(size));
  }
  return result;
}

// A matrix with a row per link and `width` columns per link.
Numbers reordered_matrix(const Numbers& values, std::size_t width,
                         const std::vector<std::size_t>& order) {
  const std::size_t cols = width * order.size();
  Numbers result;
  for (const std::size_t i : order) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * cols);
    const Numbers row(first, first + static_cast<std::ptrdiff_t>(cols));
    const Numbers ordered = reordered(row, width, order);
    result.insert(result.end(), ordered.begin(), ordered.end());
  }
  return result;
}

model::Link read_link(const json& file, std::size_t i, int father) {
  model::Link link;
  link.name = std::string("link").append(std::to_string(i + 1));
  link.father = father;
  link.joint.name = std::string("joint").append(std::to_string(i + 1));
  link.joint.identifier = link.joint.name;
  link.joint.type = file.at("sigma").at(i).get<int>() == 1 ? model::JointType::kRevolute
                                                           : model::JointType::kPrismatic;
  link.joint.axis = reals<3>(file.at("joint_axis").at(i));
  link.joint.offset = reals<3>(file.at("joint_offset").at(i));
  link.joint.rotation = reals<9>(file.at("joint_R0").at(i));
  link.inertia.mass = Real(file.at("mass").at(i).get<double>());
  link.inertia.com = reals<3>(file.at("com").at(i));
  link.inertia.about_com = reals<9>(file.at("inertia").at(i));
  return link;
}

void read_tree(const json& file, const std::vector<std::size_t>& order, GoldenCase& golden) {
  std::vector<int> position(order.size() + 1, model::kGround);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    position[i + 1] = static_cast<int>(k);
    const int father = position[file.at("father").at(i).get<std::size_t>()];
    golden.tree.links.push_back(read_link(file, i, father));
    golden.tree.drives.push_back({static_cast<int>(k), 1, 0});
    golden.tree.coordinates.push_back(static_cast<int>(k));
    model::Point point;
    point.name = std::string("t").append(std::to_string(i + 1));
    point.identifier = point.name;
    point.link_name = golden.tree.links.back().name;
    point.link = static_cast<int>(k);
    point.at = reals<3>(file.at("t").at(i));
    golden.points.push_back(point);
  }
  for (const json& row : file.value("constraints", json::array())) {
    model::Point point;
    point.link = position[row.at("link").get<std::size_t>()];
    point.at = reals<3>(row.at("point"));
    golden.rows.push_back({point, row.at("kind") == "moment", reals<3>(row.at("direction"))});
  }
}

void read_expected(const json& expected, const std::vector<std::size_t>& order,
                   GoldenCase& golden) {
  struct Field {
    const char* name;
    std::size_t size;
  };
  for (const Field& field : {Field{"R", 9},
                             {"O", 3},
                             {"P", 3},
                             {"B", 1},
                             {"G", 1},
                             {"gamma_f", 3},
                             {"gamma_n", 3},
                             {"qdd", 1},
                             {"tau_id", 1}}) {
    golden.expected[field.name] = reordered(flat(expected.at(field.name)), field.size, order);
  }
  for (const Field& field : {Field{"A", 1}, {"C", 3}, {"H", 3}}) {
    golden.expected[field.name] =
        reordered_matrix(flat(expected.at(field.name)), field.size, order);
  }
}

}  // namespace

GoldenCase read_golden(const std::string& path) {
  std::ifstream stream(path);
  const json file = json::parse(stream);
  const std::vector<std::size_t> order = tree_order(file.at("father").get<std::vector<int>>());
  GoldenCase golden;
  golden.name = file.at("name").get<std::string>();
  golden.tree.name = golden.name;
  golden.tree.identifier = golden.name;
  golden.gravity = reals<3>(file.at("gravity"));
  read_tree(file, order, golden);
  golden.q = reordered(flat(file.at("q")), 1, order);
  golden.qd = reordered(flat(file.at("qd")), 1, order);
  golden.qdd_in = reordered(flat(file.at("qdd_in")), 1, order);
  golden.tau = reordered(flat(file.at("tau")), 1, order);
  golden.f = reordered(flat(file.at("f")), 3, order);
  golden.n = reordered(flat(file.at("n")), 3, order);
  read_expected(file.at("expected"), order, golden);
  for (const json& row : golden.rows.empty() ? json() : file.at("expected_constrained").at("J")) {
    const Numbers ordered = reordered(flat(row), 1, order);
    Numbers& J = golden.expected["J"];
    J.insert(J.end(), ordered.begin(), ordered.end());
  }
  if (!golden.rows.empty()) {
    golden.expected["gamma"] = flat(file.at("expected_constrained").at("gamma"));
  }
  return golden;
}

std::vector<std::string> golden_files() {
  std::vector<std::string> result;
  const std::filesystem::path folder =
      std::filesystem::path(TREEDYN_SOURCE_DIR) / "tests/data/golden";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace treedyn::support
