#include "simulation/recording.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/index.hpp"
#include "simulation/column_names.hpp"

namespace treedyn::simulation {

namespace {

/// Links without mass between the ground and the first that has some: joints in space, no bodies.
std::vector<bool> carriages(const model::Tree& tree) {
  std::vector<bool> result;
  for (const model::Link& link : tree.links) {
    const bool on_ground = link.father == model::kGround || result[to_index(link.father)];
    result.push_back(on_ground && link.inertia.mass == 0);
  }
  return result;
}

/// Every link is joined to its father, and its points and its centre of mass to it.
Figure figure_of(const model::Scene& scene) {
  Figure figure;
  const model::Tree& tree = scene.tree;
  const std::vector<bool> carries = carriages(tree);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    figure.names.push_back(tree.links[i].name);
    const int father = tree.links[i].father;
    if (father != model::kGround && !carries[to_index(father)]) {
      figure.lines.emplace_back(father, static_cast<int>(i));
    }
    if (!carries[i]) {
      figure.visible.push_back(static_cast<int>(i));
    }
  }
  const auto add = [&](const std::string& name, int link) {
    if (!carries[to_index(link)]) {
      figure.lines.emplace_back(link, static_cast<int>(figure.names.size()));
    }
    figure.visible.push_back(static_cast<int>(figure.names.size()));
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
    for (const Column& column : columns_of(scene)) {
      recording_.columns.push_back(column.name);
    }
    recording_.figure = figure_of(scene);
  }

  /// The state now.
  void add_row() {
    const int phase = simulator_.phase();
    if (!recording_.rows.empty() && recording_.rows.back().t == simulator_.time() &&
        recording_.rows.back().phase == phase && recorded_events_ == simulator_.events().size()) {
      return;  // a row of the table right before an event
    }
    recorded_events_ = simulator_.events().size();
    Row row{simulator_.time(), phase, {}, {}, {}};
    const Vector q = simulator_.q();
    const Vector qd = simulator_.qd();
    pose_.update(q, qd);
    row.values.insert(row.values.end(), q.begin(), q.end());
    row.values.insert(row.values.end(), qd.begin(), qd.end());
    add_reactions(row.values);
    add_forces(q, qd, row.values);
    System& system = simulator_.system();
    const double kinetic = pose_.kinetic_energy() + system.armature_energy(qd);
    const double potential = pose_.potential_energy() + system.elastic_energy(q);
    row.values.insert(row.values.end(), {kinetic, potential, kinetic + potential,
                                         system.violation(simulator_.time(), q).size});
    add_nodes(row.nodes);
    look();
    std::swap(row.contacts, contacts_);
    recording_.rows.push_back(std::move(row));
  }

  /// Contacts may be shorter than the time between rows.
  void look() {
    if (scene_.contacts.empty()) {
      return;
    }
    System& system = simulator_.system();
    const Vector q = simulator_.q();
    std::vector<double> forces;
    system.forces().append_forces(system.geometry(q), {simulator_.time(), q, simulator_.qd()},
                                  forces);
    const auto count = static_cast<std::ptrdiff_t>(3 * scene_.contacts.size());
    keep_longer(contacts_, {forces.end() - count, forces.end()});
  }

  Recording finish() {
    recording_.end = simulator_.time();
    recording_.events = simulator_.events();
    recording_.cost = simulator_.cost();
    recording_.notices = simulator_.monitor().notices();
    recording_.energy_error = simulator_.monitor().unexplained();
    recording_.energy_part = simulator_.monitor().energy_error();
    recording_.residual = simulator_.monitor().largest_residual();
    recording_.drift_warning = simulator_.monitor().drift_warning();
    recording_.drift = simulator_.monitor().largest_drift();
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

  void add_forces(const Vector& q, const Vector& qd, std::vector<double>& values) {
    System& system = simulator_.system();
    const Terms& terms = system.geometry(q);
    system.forces().append_forces(terms, {simulator_.time(), q, qd}, values);
    for (const model::Point& point : scene_.points) {
      if (point.link != model::kGround) {
        const Eigen::Vector3d p = pose_.point(point.link, vector_of(point.at));
        values.insert(values.end(), p.begin(), p.end());
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
  std::vector<double> contacts_;  ///< Row::contacts of the next row
  std::size_t recorded_events_ = 0;
};

}  // namespace

void keep_longer(std::vector<double>& vectors, const std::vector<double>& others) {
  vectors.resize(others.size());
  for (std::size_t k = 0; k < others.size(); k += 3) {
    if (std::hypot(others[k], others[k + 1], others[k + 2]) >
        std::hypot(vectors[k], vectors[k + 1], vectors[k + 2])) {
      std::copy_n(&others[k], 3, &vectors[k]);
    }
  }
}

Recording record(const model::Scene& scene, Simulator& simulator, double output_step,
                 const Progress& progress) {
  Recorder recorder(scene, simulator);
  const double start = simulator.time();
  const auto duration = static_cast<double>(scene.duration);
  const double end = start + duration;
  std::size_t events = simulator.events().size();
  simulator.show_at(output_step, [&] { recorder.add_row(); });
  try {
    recorder.add_row();
    const bool arrived = simulator.advance_to(end, [&] {
      recorder.look();
      if (simulator.events().size() != events) {
        events = simulator.events().size();
        recorder.add_row();
      }
      return progress((simulator.time() - start) / duration);
    });
    recorder.recording().stopped = arrived ? "" : "interrupted";
    if (recorder.recording().rows.back().t < simulator.time()) {
      recorder.add_row();
    }
  } catch (const std::runtime_error& problem) {
    recorder.recording().stopped = problem.what();
  }
  return recorder.finish();
}

Recording record_states(const model::Scene& scene, Simulator& simulator,
                        const std::function<bool(const ShowState&, const LookAtState&)>& drive) {
  Recorder recorder(scene, simulator);
  const auto show = [&](const std::vector<double>& reactions) {
    recorder.add_row();
    std::vector<double>& values = recorder.recording().rows.back().values;
    std::ranges::copy(reactions, values.begin() + 2 * scene.tree.dof());
  };
  try {
    recorder.recording().stopped = drive(show, [&] { recorder.look(); }) ? "" : "interrupted";
  } catch (const std::runtime_error& problem) {
    recorder.recording().stopped = problem.what();
  }
  return recorder.finish();
}

}  // namespace treedyn::simulation
