// golden_cases DIR...: the engine, the program interpreter and compiled generated code against
// `expected` of the case files, EQUATIONS.md 9.

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "description/read.hpp"
#include "engine/engine.hpp"
#include "formulate/formulate.hpp"
#include "program/interpret.hpp"
#include "support/cases.hpp"
#include "support/compiled.hpp"
#include "support/process.hpp"

namespace treedyn {
namespace {

using support::Json;
using support::Report;
using support::Tolerance;
using Vector = std::vector<double>;
using Inputs = std::vector<Vector>;

constexpr Tolerance kTolerance{1e-12, 1e-12, 1e-9};
constexpr Tolerance kConstrained{1e-9, 1e-9, 1e-9};

/// The output of a function of INTERFACE.md 3, whoever computes it.
struct Implementation {
  std::string name;
  std::vector<std::string> joints;  ///< in the order of its arrays
  std::function<Vector(const std::string& function, const Inputs&)> call;
};

Json joint_of(const Json& data, std::size_t i) {
  return {{"name", fmt::format("joint_{}", i + 1)},
          {"type", data.at("sigma").at(i).get<int>() == 1 ? "revolute" : "prismatic"},
          {"axis", data.at("joint_axis").at(i)},
          {"offset", data.at("joint_offset").at(i)},
          {"rotation", {{"matrix", data.at("joint_R0").at(i)}}}};
}

Json link_of(const Json& data, std::size_t i) {
  const int father = data.at("father").at(i).get<int>();
  const Json& I = data.at("inertia").at(i);
  return {{"name", fmt::format("link_{}", i + 1)},
          {"father", father == 0 ? "ground" : fmt::format("link_{}", father)},
          {"joint", joint_of(data, i)},
          {"mass", data.at("mass").at(i)},
          {"com", data.at("com").at(i)},
          {"inertia", {I.at(0), I.at(1), I.at(2), I.at(4), I.at(5), I.at(8)}}};
}

/// The case as a tree description (INTERFACE.md 4); the points are `t` of each link in link order.
Json tree_description(const Json& data) {
  Json links = Json::array();
  Json points = Json::array();
  for (std::size_t i = 0; i < data.at("N").get<std::size_t>(); ++i) {
    links.push_back(link_of(data, i));
    points.push_back({{"name", fmt::format("t_{}", i + 1)},
                      {"link", fmt::format("link_{}", i + 1)},
                      {"at", data.at("t").at(i)}});
  }
  return {{"name", data.at("name")}, {"links", links}, {"points", points}};
}

const std::vector<std::string>& functions() {
  static const std::vector<std::string> result{"mass_matrix",
                                               "bias_force",
                                               "gravity_force",
                                               "inverse_dynamics",
                                               "forward_dynamics",
                                               "point_positions",
                                               "point_rotations",
                                               "force_jacobian_transpose",
                                               "moment_jacobian_transpose",
                                               "point_bias_acceleration",
                                               "angular_bias_acceleration",
                                               "applied_force"};
  return result;
}

Implementation compiled(const std::filesystem::path& model, const Vector& gravity) {
  std::string list;
  for (const std::string& function : functions()) {
    list += (list.empty() ? "" : ",") + function;
  }
  const std::vector<std::string> options{
      "--snap",      "0",  "--gravity", fmt::format("{},{},{}", gravity[0], gravity[1], gravity[2]),
      "--functions", list, "--effort",  "60"};
  const support::CompiledModel code = support::generate_and_compile(model, options);
  return {"code", code.manifest().joints,
          [code](const std::string& function, const Inputs& inputs) {
            return code.call(function, inputs);
          }};
}

std::vector<std::string> joint_names(const model::Tree& tree) {
  std::vector<std::string> result;
  for (const model::Link& link : tree.links) {
    result.push_back(link.joint.name);
  }
  return result;
}

model::Vector3 to_vector3(const Vector& values) {
  return {Real(values.at(0)), Real(values.at(1)), Real(values.at(2))};
}

Implementation interpreted(const model::Tree& tree, const Vector& gravity) {
  formulate::Options options;
  options.gravity = to_vector3(gravity);
  options.points = tree.points;
  options.effort = 30;  // other variants than the executable finds
  std::map<std::string, program::Function> programs;
  for (const std::string& name : functions()) {
    programs.emplace(name, formulate::formulated(tree, name, options));
  }
  return {"interpreter", joint_names(tree),
          [programs](const std::string& function, const Inputs& inputs) {
            const std::vector<std::span<const double>> spans(inputs.begin(), inputs.end());
            return program::interpret<double>(programs.at(function), spans);
          }};
}

/// The block equations with 50 digits: beside singular positions solving with A in double would
/// lose what is compared.
Implementation generic(const model::Tree& tree, const Vector& gravity) {
  const auto engine =
      std::make_shared<engine::Engine<Real>>(tree, tree.points, to_vector3(gravity));
  return {"engine", joint_names(tree), [engine](const std::string& function, const Inputs& inputs) {
            std::vector<std::vector<Real>> exact;
            for (const Vector& input : inputs) {
              exact.emplace_back(input.begin(), input.end());
            }
            return transformed(engine->evaluate(function, exact),
                               [](const Real& x) { return x.convert_to<double>(); });
          }};
}

/// Numbers of the case in the order of an implementation.
class Order {
 public:
  Order(const Json& data, const std::vector<std::string>& joints) {
    for (const std::string& joint : joints) {
      place_.push_back(std::stoul(joint.substr(std::string("joint_").size())) - 1);
    }
    if (place_.size() != data.at("N").get<std::size_t>()) {
      throw std::runtime_error(fmt::format("{} joints", place_.size()));
    }
  }

  /// One number, or one row, per link.
  [[nodiscard]] Vector rows(const Json& list) const {
    Vector result;
    for (const std::size_t i : place_) {
      const Vector row = support::flat(list.at(i));
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  }

  /// The link of every joint.
  [[nodiscard]] const std::vector<std::size_t>& places() const { return place_; }

  /// An N x N matrix.
  [[nodiscard]] Vector square(const Json& list) const {
    Vector result;
    for (const std::size_t i : place_) {
      for (const std::size_t j : place_) {
        result.push_back(list.at(i).at(j).get<double>());
      }
    }
    return result;
  }

 private:
  std::vector<std::size_t> place_;
};

Vector sum(Vector a, const Vector& b, double factor) {
  std::transform(a.begin(), a.end(), b.begin(), a.begin(),
                 [factor](double x, double y) { return x + factor * y; });
  return a;
}

/// O_i + R_i t_i of every link, base frame.
Vector expected_positions(const Json& data) {
  Vector result;
  for (std::size_t i = 0; i < data.at("N").get<std::size_t>(); ++i) {
    const Vector R = support::flat(data.at("expected").at("R").at(i));
    const Vector O = support::flat(data.at("expected").at("O").at(i));
    const Vector t = support::flat(data.at("t").at(i));
    for (std::size_t k = 0; k < 3; ++k) {
      result.push_back(O[k] + R[3 * k] * t[0] + R[3 * k + 1] * t[1] + R[3 * k + 2] * t[2]);
    }
  }
  return result;
}

void check_geometry(const Json& data, const Implementation& by, Report& report) {
  const Order order(data, by.joints);
  const Json& expected = data.at("expected");
  const Vector q = order.rows(data.at("q"));
  const Vector qd = order.rows(data.at("qd"));
  const auto compare = [&](const char* quantity, const char* function, const Inputs& inputs,
                           const Vector& y) {
    report.compare(by.name, quantity, by.call(function, inputs), y, kTolerance);
  };
  compare("R", "point_rotations", {q}, support::flat(expected.at("R")));
  compare("p", "point_positions", {q}, expected_positions(data));
  compare("C", "force_jacobian_transpose", {q}, order.rows(expected.at("C")));
  compare("H", "moment_jacobian_transpose", {q}, order.rows(expected.at("H")));
  compare("gamma_f", "point_bias_acceleration", {q, qd}, support::flat(expected.at("gamma_f")));
  compare("gamma_n", "angular_bias_acceleration", {q, qd}, support::flat(expected.at("gamma_n")));
}

void check_dynamics(const Json& data, const Implementation& by, Report& report) {
  const Order order(data, by.joints);
  const Json& expected = data.at("expected");
  const Vector q = order.rows(data.at("q"));
  const Vector qd = order.rows(data.at("qd"));
  const auto compare = [&](const char* quantity, const Vector& x, const Vector& y) {
    report.compare(by.name, quantity, x, y, kTolerance);
  };
  compare("A", by.call("mass_matrix", {q}), order.square(expected.at("A")));
  compare("B", by.call("bias_force", {q, qd}), order.rows(expected.at("B")));
  const Vector G = by.call("gravity_force", {q});
  compare("G", sum(Vector(G.size()), G, -1), order.rows(expected.at("G")));
  const Vector Q =
      by.call("applied_force", {q, support::flat(data.at("f")), support::flat(data.at("n"))});
  const Vector qdd = by.call("forward_dynamics", {q, qd, sum(order.rows(data.at("tau")), Q, 1)});
  compare("qdd", qdd, order.rows(expected.at("qdd")));
  const Vector tau = by.call("inverse_dynamics", {q, qd, order.rows(data.at("qdd_in"))});
  compare("tau", sum(tau, Q, -1), order.rows(expected.at("tau_id")));
}

/// Rows of a scene stand effect by effect as in its file, here by name: orientation_constraint (the
/// moments of a case), then point_constraint (its forces).
std::vector<std::size_t> row_order(const Json& constraints) {
  std::vector<std::size_t> order;
  for (const char* kind : {"moment", "force"}) {
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      if (constraints.at(k).at("kind") == kind) {
        order.push_back(k);
      }
    }
  }
  return order;
}

/// The case as a scene beside its model, golden.yaml; every row is a constraint that states its
/// acceleration.
Json scene_of(const Json& data) {
  Json points = Json::array();
  Json forces = Json::array();
  Json moments = Json::array();
  const Json& constraints = data.at("constraints");
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const Json& c = constraints.at(k);
    const std::string point = fmt::format("r_{}", k + 1);
    const bool force = c.at("kind") == "force";
    points.push_back({{"name", point},
                      {"link", fmt::format("link_{}", c.at("link").get<int>())},
                      {"at", force ? c.at("point") : Json{0, 0, 0}}});
    (force ? forces : moments)
        .push_back({{"name", point},
                    {"point", point},
                    {"along", Json::array({c.at("direction")})},
                    {"acceleration", Json::array({c.at("a_des")})}});
  }
  Json names = Json::array();
  for (const Json& constraint : forces) {
    names.push_back(constraint.at("name"));
  }
  for (const Json& constraint : moments) {
    names.push_back(constraint.at("name"));
  }
  const Json impact{
      {"time", 1}, {"impact", {{"constraints", names}, {"restitution", 0}}}, {"then", "all"}};
  Json effects{{"gravity", data.at("gravity")}};
  if (!forces.empty()) {
    effects["point_constraint"] = forces;
  }
  if (!moments.empty()) {
    effects["orientation_constraint"] = moments;
  }
  return {{"scene", data.at("name")},
          {"model", "golden.yaml"},
          {"points", points},
          {"effects", effects},
          {"phases",
           Json::array({{{"name", "all"}, {"active", names}, {"until", Json::array({impact})}}})},
          {"duration", 1}};
}

/// `values` in the order of the case, of rows in the order of the scene.
Vector in_case_order(const Vector& values, const std::vector<std::size_t>& order) {
  Vector result(values.size());
  for (std::size_t row = 0; row < order.size(); ++row) {
    result.at(order[row]) = values.at(row);
  }
  return result;
}

/// J, r x N in the order of the case, of the generated J^T.
Vector jacobian(const Vector& transposed, const std::vector<std::size_t>& order,
                const Order& joints, std::size_t n) {
  const std::size_t r = order.size();
  Vector result(r * n);
  const std::vector<std::size_t>& place = joints.places();
  for (std::size_t row = 0; row < r; ++row) {
    for (std::size_t i = 0; i < n; ++i) {
      result[order[row] * n + place[i]] = transposed[i * r + row];
    }
  }
  return result;
}

/// tau + C f + H n of the case: the forces that its motion without constraints shows.
Vector joint_forces(const Json& data) {
  const Json& expected = data.at("expected");
  const Vector qdd = support::flat(expected.at("qdd"));
  Vector result = sum(support::flat(expected.at("B")), support::flat(expected.at("G")), -1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Vector row = support::flat(expected.at("A").at(i));
    result[i] = std::inner_product(row.begin(), row.end(), qdd.begin(), result[i]);
  }
  return result;
}

/// Compiled functions of the case's scene against `expected_constrained`.
void check_constrained(const Json& data, const std::filesystem::path& folder, Report& report) {
  const std::filesystem::path scene = folder / "scene.yaml";
  support::write_file(scene, scene_of(data).dump(1));
  support::generate({}, {"--scene", scene.string(), "--effort", "30"}, folder / "scene");
  const support::CompiledModel code(folder / "scene", "generated");
  const Json& expected = data.at("expected_constrained");
  const std::vector<std::size_t> rows = row_order(data.at("constraints"));
  const Order order(data, code.manifest().joints);
  const Vector q = order.rows(data.at("q"));
  const Vector qd = order.rows(data.at("qd"));
  const auto compare = [&](const char* quantity, const Vector& x, const Vector& y) {
    report.compare("code", quantity, x, y, kConstrained);
  };
  compare("J",
          jacobian(code.call("reaction_jacobian_transpose", {q}), rows, order,
                   data.at("N").get<std::size_t>()),
          support::flat(expected.at("J")));
  compare("gamma", in_case_order(code.call("reaction_bias_acceleration", {q, qd}), rows),
          support::flat(expected.at("gamma")));
  const Vector motion =
      code.call("constrained_dynamics", {q, qd, order.rows(Json(joint_forces(data)))});
  const auto split = motion.begin() + static_cast<std::ptrdiff_t>(q.size());
  compare("qdd constrained", Vector(motion.begin(), split), order.rows(expected.at("qdd")));
  compare("lambda", in_case_order(Vector(split, motion.end()), rows),
          support::flat(expected.at("lambda")));
  const Vector impact = code.call("impact", {q, qd});
  const auto impulses = impact.begin() + static_cast<std::ptrdiff_t>(q.size());
  compare("impact qd", Vector(impact.begin(), impulses), order.rows(expected.at("impact_qd")));
  compare("impact P", in_case_order(Vector(impulses, impact.end()), rows),
          support::flat(expected.at("impact_P")));
}

void check(const std::filesystem::path& /*file*/, const Json& data, Report& report) {
  const support::TemporaryFolder folder;
  const std::filesystem::path model = folder.path() / "golden.yaml";
  support::write_file(model, tree_description(data).dump(1));
  const Vector gravity = support::flat(data.at("gravity"));
  description::ReadOptions options;
  options.snap = 0;
  const model::Tree tree = description::read_model(model.string(), options);
  for (const Implementation& by :
       {generic(tree, gravity), interpreted(tree, gravity), compiled(model, gravity)}) {
    check_geometry(data, by, report);
    check_dynamics(data, by, report);
  }
  if (data.contains("expected_constrained")) {
    check_constrained(data, folder.path(), report);
  }
}

}  // namespace
}  // namespace treedyn

int main(int argc, char** argv) {
  const std::vector<std::string> folders(argv + 1, argv + argc);
  return treedyn::support::run_cases(folders, treedyn::check);
}
