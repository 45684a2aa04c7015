#include "simulation/recording.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace treedyn::simulation {

namespace {

std::string joint_name(const model::Tree& tree, int coordinate) {
  const int link = tree.coordinates[static_cast<std::size_t>(coordinate)];
  return tree.links[static_cast<std::size_t>(link)].joint.name;
}

/// x, y, z for an axis, else a number from 1.
std::string direction_name(const model::Constraint& constraint, std::size_t row) {
  if (constraint.kind == model::ConstraintKind::kJoint) {
    return "";
  }
  const model::Vector3& d = constraint.directions[row];
  for (std::size_t k = 0; k < 3; ++k) {
    if (d[k] == 1 && d[(k + 1) % 3] == 0 && d[(k + 2) % 3] == 0) {
      return std::string(".") + "xyz"[k];
    }
  }
  return fmt::format(".{}", row + 1);
}

std::vector<std::string> columns_of(const model::Scene& scene) {
  std::vector<std::string> result;
  for (const char* const name : {"q", "qd"}) {
    for (int k = 0; k < scene.tree.dof(); ++k) {
      result.push_back(fmt::format("{}[{}]", name, joint_name(scene.tree, k)));
    }
  }
  for (const std::string& name : reaction_names(scene)) {
    result.push_back(fmt::format("R[{}]", name));
  }
  result.insert(result.end(), {"kinetic_energy", "potential_energy", "energy", "drift"});
  return result;
}

/// Every link is joined to its father, and its points and its centre of mass to it.
Figure figure_of(const model::Scene& scene) {
  Figure figure;
  const model::Tree& tree = scene.tree;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    figure.names.push_back(tree.links[i].name);
    if (tree.links[i].father != model::kGround) {
      figure.lines.emplace_back(tree.links[i].father, static_cast<int>(i));
    }
  }
  const auto add = [&](const std::string& name, int link) {
    figure.lines.emplace_back(link, static_cast<int>(figure.names.size()));
    figure.names.push_back(name);
  };
  for (const model::Point& point : scene.points) {
    if (point.link != model::kGround) {
      add(point.name, point.link);
    }
  }
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (tree.links[i].inertia.mass > 0) {
      add(tree.links[i].name + " (com)", static_cast<int>(i));
    }
  }
  return figure;
}

class Recorder {
 public:
  Recorder(const model::Scene& scene, Simulator& simulator)
      : scene_(scene), simulator_(simulator), pose_(scene.tree, scene.gravity) {
    recording_.columns = columns_of(scene);
    recording_.figure = figure_of(scene);
  }

  /// The state now. \param at_time, phase  where it belongs
  void add_row(int phase) {
    Row row{simulator_.time(), phase, {}, {}};
    const Vector q = simulator_.q();
    const Vector qd = simulator_.qd();
    pose_.update(q, qd);
    row.values.insert(row.values.end(), q.begin(), q.end());
    row.values.insert(row.values.end(), qd.begin(), qd.end());
    add_reactions(row.values);
    System& system = simulator_.system();
    const double kinetic = pose_.kinetic_energy() + system.armature_energy(qd);
    const double potential = pose_.potential_energy() + system.elastic_energy(q);
    row.values.insert(row.values.end(), {kinetic, potential, kinetic + potential,
                                         system.violation(simulator_.time(), q)});
    add_nodes(row.nodes);
    recording_.rows.push_back(std::move(row));
  }

  Recording finish() {
    recording_.events = simulator_.events();
    recording_.steps = simulator_.steps();
    return std::move(recording_);
  }
  Recording& recording() { return recording_; }

 private:
  /// Zero for rows that do not act.
  void add_reactions(std::vector<double>& values) {
    const Vector lambda = simulator_.solution().lambda;
    const Constraints& constraints = simulator_.system().constraints();
    for (std::size_t c = 0; c < scene_.constraints.size(); ++c) {
      const auto rows = static_cast<int>(scene_.constraints[c].rows());
      int first = 0;
      while (first < constraints.rows() && constraints.constraint(first) != static_cast<int>(c)) {
        ++first;
      }
      for (int k = 0; k < rows; ++k) {
        values.push_back(first < constraints.rows() ? lambda[first + k] : 0);
      }
    }
  }

  void add_nodes(std::vector<Eigen::Vector3d>& nodes) const {
    for (const LinkState& link : pose_.links()) {
      nodes.push_back(link.O);
    }
    for (const model::Point& point : scene_.points) {
      if (point.link != model::kGround) {
        nodes.push_back(pose_.point(point.link, vector_of(point.at)));
      }
    }
    for (std::size_t i = 0; i < scene_.tree.links.size(); ++i) {
      if (scene_.tree.links[i].inertia.mass > 0) {
        nodes.push_back(pose_.links()[i].r);
      }
    }
  }

  const model::Scene& scene_;
  Simulator& simulator_;
  Pose pose_;
  Recording recording_;
};

}  // namespace

std::vector<std::string> reaction_names(const model::Scene& scene) {
  std::vector<std::string> result;
  for (const model::Constraint& constraint : scene.constraints) {
    for (std::size_t k = 0; k < constraint.rows(); ++k) {
      result.push_back(constraint.name + direction_name(constraint, k));
    }
  }
  return result;
}

Recording record(const model::Scene& scene, Simulator& simulator, double output_step,
                 const Progress& progress) {
  Recorder recorder(scene, simulator);
  const double start = simulator.time();
  const auto duration = static_cast<double>(scene.duration);
  const auto count = static_cast<long>(std::ceil(duration / output_step * (1 - 1e-12)));
  try {
    recorder.add_row(simulator.phase());
    for (long k = 1; k <= count; ++k) {
      const double end =
          k == count ? start + duration : start + static_cast<double>(k) * output_step;
      std::size_t events = simulator.events().size();
      const bool arrived = simulator.advance_to(end, [&] {
        if (simulator.events().size() != events) {
          events = simulator.events().size();
          recorder.add_row(simulator.phase());
        }
        return progress((simulator.time() - start) / duration);
      });
      if (!arrived) {
        recorder.recording().stopped = "interrupted";
        break;
      }
      recorder.add_row(simulator.phase());
    }
  } catch (const std::runtime_error& problem) {
    recorder.recording().stopped = problem.what();
  }
  return recorder.finish();
}

Recording record_states(const model::Scene& scene, Simulator& simulator,
                        const std::function<bool(const ShowState&)>& drive) {
  Recorder recorder(scene, simulator);
  const auto show = [&](const std::vector<double>& reactions) {
    recorder.add_row(simulator.phase());
    std::vector<double>& values = recorder.recording().rows.back().values;
    std::copy(reactions.begin(), reactions.end(), values.begin() + 2 * scene.tree.dof());
  };
  try {
    recorder.recording().stopped = drive(show) ? "" : "interrupted";
  } catch (const std::runtime_error& problem) {
    recorder.recording().stopped = problem.what();
  }
  return recorder.finish();
}

}  // namespace treedyn::simulation
