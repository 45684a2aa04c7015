#include "simulation/monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "common/index.hpp"
#include "model/scene_facts.hpp"
#include "simulation/column_names.hpp"

namespace treedyn::simulation {

namespace {

/// A row of J below this part of what it is nearby counts as zero.
constexpr double kLostRow = 1e-9;
/// How far nearby is, rad or m: other joints by other amounts.
constexpr double kNearby = 0.1;
/// Roundings of the potential energy that are no energy.
constexpr double kRoundings = 1e3;
/// Steps whose power belongs to the scale of energies, for a method's quadrature may lag by half a
/// step, and steps of the beginning that are not judged.
constexpr double kPowerSteps = 100;
constexpr int kFirstSteps = 10;
/// Steps in a row in which a growing energy is more than the motion began with and was given: those
/// end it whatever its power is, which grows as fast where a motion explodes.
constexpr int kEndingSteps = 10;
/// The part of energy out of nothing, and of all work, that is still there: work that steps do not
/// resolve, of stiff drives, leaves none behind.
constexpr double kPresent = 0.01;
/// The part of the speeds that a row adds up that counts as a speed of its own.
constexpr double kOwnSpeed = 1e-3;
/// The part of them that a projection may take at the end of a step.
constexpr double kPulled = 1e-2;

Vector nearby(const Vector& q) {
  Vector result = q;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    result[k] += kNearby * (1 + std::fmod(0.618 * static_cast<double>(k + 1), 1.0));
  }
  return result;
}

}  // namespace

double energy(System& system, Pose& pose, const Vector& q, const Vector& qd) {
  pose.update(q, qd);
  return pose.kinetic_energy() + system.armature_energy(qd) + pose.potential_energy() +
         system.elastic_energy(q);
}

std::string to_string(const Notice& notice) {
  if (!(notice.worst > notice.value)) {
    return notice.text;
  }
  return fmt::format("{}; at most {:.3g}{}{} at t = {:.6g} s", notice.text, notice.worst,
                     notice.unit.empty() ? "" : " ", notice.unit, notice.worst_time);
}

Monitor::Monitor(const model::Scene& scene, const Bounds& bounds)
    : scene_(scene),
      bounds_(bounds),
      pose_(scene.tree, scene.gravity),
      names_(reaction_names(scene)),
      lost_(names_.size(), 0) {
  std::size_t first = 0;
  for (const model::Constraint& constraint : scene.constraints) {
    first_.push_back(first);
    first += constraint.rows();
  }
}

Monitor::Row Monitor::row(const Constraints& constraints, int k) const {
  const auto c = to_index(constraints.constraint(k));
  const bool is_angular = model::is_angular(scene_.tree, scene_.constraints[c]);
  return {first_[c] + constraints.number(k), is_angular ? 1 : size_, is_angular};
}

/// A warning once a kind and name; later ones only if they are worse.
void Monitor::note(Notice notice) {
  const auto same = std::ranges::find_if(
      notices_, [&](const Notice& n) { return n.kind == notice.kind && n.name == notice.name; });
  if (same == notices_.end()) {
    notices_.push_back(std::move(notice));
  } else if (notice.value > same->worst) {
    same->worst = notice.value;
    same->worst_time = notice.time;
  }
}

void Monitor::row_equations(const System& system, double t, double h) {
  const Solution& solution = system.last();
  const Constraints& constraints = system.constraints();
  for (int k = 0; k < solution.residuals.size(); ++k) {
    const Row row = this->row(constraints, k);
    const double lacks = std::fabs(solution.residuals[k]);
    const double terms = std::fabs(solution.wanted[k]) +
                         system.rows().row(k).cwiseAbs().dot(solution.qdd.cwiseAbs());
    largest_residual_ = std::max(largest_residual_, lacks);
    if (!(lacks > bounds_.residual_warning * (terms + row.scale))) {
      continue;
    }
    const char* const unit = row.is_angular ? "1/s^2" : "m/s^2";
    note({"residual", names_[row.name], t, lacks, bounds_.residual_warning * (terms + row.scale),
          unit,
          fmt::format("constraint '{}' lacks {:.3g} {} of its acceleration at t = {:.6g} s: the "
                      "motion does not meet all rows that act, of which {} of {} count as "
                      "independent",
                      names_[row.name], lacks, unit, t, solution.rank, solution.residuals.size())});
    lost_[row.name] += lacks * h;
    if (lost_[row.name] > bounds_.residual_end * row.scale) {
      throw std::runtime_error(fmt::format(
          "no motion meets constraint '{}' and the others: it lacks {:.3g} {} and has lost {:.3g} "
          "of its velocity (bound {:.3g})",
          names_[row.name], lacks, unit, lost_[row.name], bounds_.residual_end * row.scale));
    }
  }
}

void Monitor::positions(System& system, double t, const Vector& q) {
  if (system.constraints().rows() == 0) {
    return;
  }
  Matrix here;
  Matrix there;
  system.constraints().jacobian(system.geometry(nearby(q)), there);
  system.constraints().jacobian(system.geometry(q), here);
  for (int k = 0; k < here.rows(); ++k) {
    if (here.row(k).norm() > kLostRow * there.row(k).norm() || there.row(k).norm() == 0) {
      continue;
    }
    const std::string& name = names_[row(system.constraints(), k).name];
    note({"position", name, t, here.row(k).norm(), kLostRow * there.row(k).norm(), "",
          fmt::format("constraint '{}' acts at t = {:.6g} s in a position in which no joint moves "
                      "it: its row of J is {:.2g}, nearby {:.2g}",
                      name, t, here.row(k).norm(), there.row(k).norm())});
  }
}

void Monitor::speeds(System& system, double t, const Vector& q, const Vector& qd,
                     const Vector& qd_before, const std::vector<int>& acted) {
  const Vector moving = qd.cwiseAbs() + qd_before.cwiseAbs();
  Matrix J;
  Vector wanted;
  system.constraints().jacobian(system.geometry(q), J);
  system.constraints().velocities(t, wanted);
  for (int k = 0; k < J.rows(); ++k) {
    const double own = std::fabs(J.row(k).dot(qd) - wanted[k]);
    const bool is_new = !std::ranges::binary_search(acted, system.constraints().constraint(k));
    const double off = is_new ? own : own - std::fabs(J.row(k).dot(qd_before) - wanted[k]);
    const Row row = this->row(system.constraints(), k);
    const double bound = bounds_.no_speed * row.scale +
                         kOwnSpeed * (J.row(k).cwiseAbs().dot(moving) + std::fabs(wanted[k]));
    if (!system.constraints().is_held(k) || !(off > bound)) {
      continue;
    }
    const char* const unit = row.is_angular ? "1/s" : "m/s";
    note({"speed", names_[row.name], t, off, bound, unit,
          fmt::format(
              "constraint '{}' {} at t = {:.6g} s at a speed of {:.3g} {} that no impact has taken",
              names_[row.name], is_new ? "begins to act" : "acts on", t, off, unit)});
  }
}

void Monitor::pull(const System& system, double t, const Vector& qd) {
  const Constraints& constraints = system.constraints();
  for (int k = 0; k < system.pulled().size(); ++k) {
    const double off = std::fabs(system.pulled()[k]);
    const Row row = this->row(constraints, k);
    const double bound =
        kPulled * system.rows().row(k).cwiseAbs().dot(qd.cwiseAbs()) + bounds_.pull * row.scale;
    if (!(off > bound)) {
      continue;
    }
    const char* const unit = row.is_angular ? "1/s" : "m/s";
    note({"pull", names_[row.name], t, off, bound, unit,
          fmt::format("constraint '{}' pulls the motion by {:.3g} {} in no time at t = {:.6g} s: "
                      "what leads it jumps, or steps are too long",
                      names_[row.name], off, unit, t)});
  }
}

void Monitor::turn(const Constraints& constraints, const Turn& turn, double t, double h) {
  if (!(turn.beside > bounds_.beside)) {
    return;
  }
  turned_ += turn.rate * h;
  if (!(turned_ > bounds_.turn_warning)) {
    return;
  }
  const std::string& name = names_[row(constraints, turn.row).name];
  note({"branch", name, t, turned_, bounds_.turn_warning, "rad",
        fmt::format("constraint '{}' is near a position in which it moves no joint and turns the "
                    "motion at t = {:.6g} s, {:.2g} rad so far, by errors of position and velocity "
                    "that turn its own direction by {:.2g} rad",
                    name, t, turned_, turn.beside)});
  if (turned_ > bounds_.turn_end) {
    throw std::runtime_error(
        fmt::format("constraint '{}' and the others no longer tell where the motion goes: near a "
                    "singular position their errors have turned it by {:.2g} rad (bound {:.2g})",
                    name, turned_, bounds_.turn_end));
  }
}

void Monitor::drift(System& system, double t, const Vector& q) {
  Constraints& constraints = system.constraints();
  if (constraints.rows() == 0) {
    return;
  }
  Vector phi;
  constraints.errors(system.geometry(q), t, q, phi);
  for (int k = 0; k < phi.size(); ++k) {
    const Row row = this->row(constraints, k);
    const double off = std::fabs(phi[k]);
    largest_drift_ = std::max(largest_drift_, off);
    if (!(off > bounds_.drift_warning * row.scale)) {
      continue;
    }
    const char* const unit = row.is_angular ? "rad" : "m";
    note({"drift", names_[row.name], t, off, bounds_.drift_warning * row.scale, unit,
          fmt::format("constraint '{}' acts and is {:.3g} {} off at t = {:.6g} s (bound {:.2g})",
                      names_[row.name], off, unit, t, bounds_.drift_warning * row.scale)});
    if (off > bounds_.drift_end * row.scale) {
      throw std::runtime_error(
          fmt::format("constraint '{}' acts and is {:.3g} {} off (bound {:.3g})", names_[row.name],
                      off, unit, bounds_.drift_end * row.scale));
    }
  }
}

/// How large the robot is, and the energy of its fall by this size, or of roundings if it has
/// none: of a motion of all joints by 1 rad/s and 1 m/s.
void Monitor::measure(System& system, const Vector& q) {
  Eigen::AlignedBox3d box;
  double most = 0;
  double weight = 0;
  const Eigen::Vector3d g = vector_of(scene_.gravity);
  for (std::size_t i = 0; i < pose_.links().size(); ++i) {
    const LinkState& link = pose_.links()[i];
    const auto mass = static_cast<double>(scene_.tree.links[i].inertia.mass);
    box.extend(link.O);
    box.extend(link.r);
    weight += mass * g.norm();
    most += mass * g.norm() * (link.r.norm() + 1);
  }
  for (const model::Point& point : scene_.points) {
    if (point.link != model::kGround) {
      box.extend(pose_.point(point.link, vector_of(point.at)));
    }
  }
  size_ = box.isEmpty() || box.diagonal().norm() == 0 ? 1 : box.diagonal().norm();
  const Vector ones = Vector::Ones(q.size());
  pose_.update(q, ones);
  most += pose_.kinetic_energy() + system.armature_energy(ones) + q.norm();
  rounding_ = kRoundings * std::numeric_limits<double>::epsilon() * most;
  weight_ = std::max(weight * size_, rounding_);
}

void Monitor::restart_energy(System& system, const Vector& q, const Vector& qd) {
  energy_ = simulation::energy(system, pose_, q, qd);
  if (!has_energy_) {
    has_energy_ = true;
    potential_ = pose_.potential_energy();
    exchanged_ = energy_ - potential_;
    given_ = exchanged_;
    measure(system, q);
  }
}

/// True where more energy than that is there that no force explains, and grows; never of sdirk2,
/// which damps what is stiff.
bool Monitor::explodes(double given) {
  if (model::step_method(scene_) == StepMethod::kSdirk2) {
    return false;
  }
  const bool excessive =
      std::min(gained_, unexplained_) > bounds_.energy_end * given && gained_ > kPresent * worked_;
  excessive_steps_ = excessive ? excessive_steps_ + 1 : 0;
  excess_from_ = excessive_steps_ == 1 ? energy_ : excess_from_;
  return excessive_steps_ >= kEndingSteps && energy_ > excess_from_;
}

void Monitor::energy(System& system, double t, double h, const Vector& q, const Vector& qd,
                     const Work& work) {
  const double before = energy_;
  energy_ = simulation::energy(system, pose_, q, qd);
  if (scene_.velocity_products && !std::isfinite(energy_)) {
    throw std::runtime_error("the energy is beyond the range of double");
  }
  gained_ += energy_ - before;
  unexplained_ += energy_ - before - work.done;
  const double excess = std::max(0.0, unexplained_);
  worked_ += std::fabs(work.done);
  given_ += std::max(0.0, work.done);
  exchanged_ = std::max({exchanged_, worked_, pose_.kinetic_energy() - excess,
                         std::fabs(pose_.potential_energy() - potential_) - excess});
  using Scale = std::pair<double, const char*>;
  const Scale fall{weight_, "of a fall by the robot's size"};
  const Scale had =
      exchanged_ < weight_ ? fall : Scale{exchanged_, "that the motion has exchanged"};
  const Scale power{kPowerSteps * h * work.power, "of its forces' power in a hundred steps"};
  const Scale given = given_ < weight_ ? fall : Scale{given_, "that it began with and was given"};
  const bool explodes = this->explodes(given.first);
  const auto [scale, name] = explodes ? given : power.first > had.first ? power : had;
  const double part = unexplained_ / scale;
  most_unexplained_ = std::max(most_unexplained_, std::fabs(unexplained_));
  if (!scene_.velocity_products || ++energy_steps_ <= kFirstSteps ||
      !(std::fabs(part) > bounds_.energy_warning)) {
    return;
  }
  note({"energy", part > 0 ? "gained" : "lost", t, std::fabs(unexplained_),
        bounds_.energy_warning * scale, "J",
        fmt::format("energy {}: by {:.3g} J in all up to t = {:.6g} s, beside {:.3g} J {}",
                    part > 0 ? "grows without power" : "is lost to no force",
                    std::fabs(unexplained_), t, scale, name)});
  if (explodes || (part > bounds_.energy_end && gained_ > kPresent * unexplained_)) {
    throw std::runtime_error(fmt::format(
        "energy grows without power: {:.3g} J more than forces explain, beside {:.3g} J {}",
        unexplained_, scale, name));
  }
}

void Monitor::guard(const std::string& event, double t, bool may_end) {
  note({"guard", event, t, 0, 0, "",
        fmt::format("event '{}' has a guard that is not a number at t = {:.6g} s", event, t)});
  if (may_end) {
    throw std::runtime_error(
        fmt::format("event '{}' has a guard that is not a number: it cannot be seen", event));
  }
}

}  // namespace treedyn::simulation
