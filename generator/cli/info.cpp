#include "cli/info.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/model_facts.hpp"
#include "cli/prices.hpp"
#include "common/decimal.hpp"
#include "emit/header.hpp"
#include "emit/layout.hpp"
#include "equations/scene_table.hpp"

namespace treedyn {

namespace {

using emit::table;
using Rows = std::vector<std::vector<std::string>>;

std::string joint_table(const Model& model) {
  Rows rows = {{"index", "joint", "type", "father", "link", "mass/kg"}};
  for (int k = 0; k < model.tree.dof(); ++k) {
    const model::Link& link = model.tree.moved_by(k);
    rows.push_back({std::to_string(k), shown(link.joint.name),
                    link.joint.turns() ? "revolute" : "prismatic",
                    std::to_string(emit::father_coordinate(model.tree, k)), shown(link.name),
                    emit::decimal(link.inertia.mass)});
  }
  return table(rows);
}

/// Joints that follow another one: q = multiplier u + offset.
std::string mimic_lines(const Model& model) {
  std::string result;
  for (int i = 0; i < model.tree.size(); ++i) {
    const model::Drive& drive = model.tree.drives[static_cast<std::size_t>(i)];
    if (model.tree.is_mimic(i)) {
      result += fmt::format(
          "  {} = {} {} + {}\n", shown(model.tree.links[static_cast<std::size_t>(i)].joint.name),
          emit::decimal(drive.multiplier), shown(model.tree.moved_by(drive.coordinate).joint.name),
          emit::decimal(drive.offset));
    }
  }
  return result.empty() ? result : "\nmimic joints\n" + result;
}

std::string reachability_text(const model::Tree& tree) {
  Rows rows;
  const std::vector<std::string> matrix = reachability_rows(tree);
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    rows.push_back({matrix[i], shown(tree.links[i].name)});
    blocks += static_cast<std::size_t>(std::ranges::count(matrix[i], 'x'));
  }
  return fmt::format("\nD, one row a link ({} of {} blocks are zero)\n{}",
                     matrix.size() * matrix.size() - blocks, matrix.size() * matrix.size(),
                     table(rows));
}

std::string point_table(const Model& model) {
  if (model.points.empty()) {
    return {};
  }
  Rows rows = {{"index", "point", "link", "at/m"}};
  for (std::size_t k = 0; k < model.points.size(); ++k) {
    const model::Point& point = model.points[k];
    const model::Vector3 at = model::place_in_frame(model.tree, point);
    rows.push_back({std::to_string(k), shown(point.name), shown(point.link_name),
                    fmt::format("{}, {}, {}", emit::decimal(at[0]), emit::decimal(at[1]),
                                emit::decimal(at[2]))});
  }
  return "\npoints\n" + table(rows);
}

std::string snap_table(const model::Tree& tree) {
  if (tree.snaps.empty()) {
    return "\nsnapped constants: none\n";
  }
  Rows rows = {{"place", "what", "written", "taken as", "change"}};
  for (const model::Snap& snap : tree.snaps) {
    rows.push_back({to_string(snap.where), shown(snap.what), shown(snap.from), snap.to,
                    fmt::format("{:.1e}", snap.change.convert_to<double>())});
  }
  return "\nsnapped constants\n" + table(rows);
}

std::string dissipation_table(const model::Tree& tree) {
  if (tree.dissipations.empty()) {
    return {};
  }
  Rows rows = {{"place", "joint", "damping", "friction"}};
  for (const model::Dissipation& of : tree.dissipations) {
    rows.push_back({to_string(of.where), shown(of.joint), shown(of.damping), shown(of.friction)});
  }
  return "\n<dynamics>: in no function of the model; scenes name effects of their own for it\n" +
         table(rows);
}

std::string cost_table(const Model& model, const Request& request,
                       const program::Programs& programs) {
  Rows rows = {{"function", "equation", "values", "mul + add + div", "fused", "of these"}};
  for (const Priced& function : priced(model, request, programs)) {
    rows.push_back({function.signature.name, function.signature.equation,
                    std::to_string(function.values()), std::to_string(function.cost.total()),
                    std::to_string(function.cost.fused), emit::cost_text(function.cost)});
  }
  return "\nfunctions, operations in one call\n" + table(rows);
}

/// \param head  of the first column
std::string price_table(const char* head, const std::vector<Price>& prices) {
  Rows rows = {{head, "function", "without", "with", "price"}};
  for (const Price& price : prices) {
    rows.push_back({shown(price.of), price.function.empty() ? "none" : price.function,
                    std::to_string(price.without.total()), std::to_string(price.with.total()),
                    emit::change_text(price.with, price.without)});
  }
  return table(rows);
}

std::string effects_text(const Model& model, const Request& request,
                         const program::Programs& programs) {
  if (!model.scene) {
    return {};
  }
  const std::vector<Price> prices = effect_prices(model, request, programs);
  std::string result = "\nprice of every effect: operations with it less those without it\n";
  result += prices.empty() ? "  the scene names no effect\n" : price_table("effect", prices);
  for (const ContactPrice& contact : contact_prices(programs)) {
    result += fmt::format("  closed contact {}: {} more\n", contact.contact,
                          emit::cost_text(contact.cost));
  }
  return result;
}

std::string parameters_text(const Model& model, const Request& request,
                            const program::Programs& programs) {
  return !programs.update
             ? ""
             : "\nprice of every run-time parameter: operations with it less those without it\n" +
                   price_table("declared", parameter_prices(model, request, programs));
}

}  // namespace

std::string info_text(const Model& model, const Request& request,
                      const program::Programs& programs) {
  const bool axes = decided_request(model, request).read.base == description::Base::kAxes;
  return fmt::format("{}: {} joints, {} moving links, {} kg, base {}\n\njoints\n",
                     shown(model.tree.name), model.tree.dof(), model.tree.size(),
                     emit::decimal(total_mass(model.tree)), axes ? "axes" : "fixed") +
         joint_table(model) + mimic_lines(model) + reachability_text(model.tree) +
         point_table(model) + snap_table(model.tree) + dissipation_table(model.tree) +
         cost_table(model, request, programs) + parameters_text(model, request, programs) +
         effects_text(model, request, programs);
}

std::string passes_text(const Model& model, const Request& request) {
  const formulate::Options options = formulate_options(model, request);
  Rows rows = {{"pass"}};
  const auto add = [&](const std::string& name, const auto& function) {
    const auto made = [&](const formulate::Options& some) {
      return formulate::formulated(model.tree, function, some);
    };
    const std::vector<formulate::PassCost> costs = formulate::pass_costs(made, options);
    rows.front().push_back(name);
    rows.resize(costs.size() + 1);
    for (std::size_t k = 0; k < costs.size(); ++k) {
      const program::Cost& cost = costs[k].cost;
      if (rows[k + 1].empty()) {
        rows[k + 1].push_back(costs[k].pass);
      }
      rows[k + 1].push_back(fmt::format("{} + {}", cost.total(), cost.angles));
    }
  };
  for (const std::string& function : model.functions) {
    add(function, function);
  }
  for (const auto& equation : model.equations) {
    add(equation->equation.name, equation);
  }
  return fmt::format(
             "operations (add + mul + div) + pairs of sin and cos of {}, each row with the "
             "passes above it\n\n",
             shown(model.tree.name)) +
         table(rows);
}

std::string list_functions() {
  std::string result;
  const auto add = [&](const std::string& name, const std::string& equation,
                       const std::string& what) {
    result += fmt::format("{:30} {:10} {}\n", name, equation, what);
  };
  for (const std::string& name : formulate::function_names()) {
    const program::Signature signature = formulate::signature(name, 1, 1);
    add(name, signature.equation, signature.brief);
  }
  for (const equations::SceneFunctionInfo& info : equations::scene_function_infos()) {
    add(info.name, info.equation, fmt::format("With --scene: {}", info.what));
  }
  return result;
}

}  // namespace treedyn
