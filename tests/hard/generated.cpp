#include "hard/generated.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <fmt/format.h>

#include "dynamics/scene_dynamics.hpp"
#include "hard/code.hpp"

namespace treedyn::hard {

namespace {

Numbers numbers(const Vector& x) { return {x.begin(), x.end()}; }
Vector vector(const Numbers& x) {
  return Eigen::Map<const Vector>(x.data(), static_cast<Eigen::Index>(x.size()));
}

/// Singular values above a part of the largest: what is left of the others is rounding.
int rank_of(const Eigen::MatrixXd& M, double part) {
  const Eigen::VectorXd s = Eigen::JacobiSVD<Eigen::MatrixXd>(M).singularValues();
  return static_cast<int>((s.array() > part * s[0]).count());
}

}  // namespace

GeneratedMotion::GeneratedMotion(const model::Scene& scene, std::shared_ptr<const Code> code,
                                 const GeneratedSource& source, long& steps)
    : scene_(scene),
      code_(std::move(code)),
      source_(source),
      steps_(steps),
      h_(static_cast<double>(scene.stepping.step)),
      dynamics_(program_dynamics(scene)),
      system_(scene, *dynamics_, 0),
      terms_(scene.tree.dof(), static_cast<int>(scene.points.size()), simulation::needs_of(scene)) {
  const auto in_scalar = [&](const std::vector<Real>& x) {
    Vector result(static_cast<Eigen::Index>(x.size()));
    std::transform(x.begin(), x.end(), result.begin(),
                   [&](const Real& value) { return source.rounded(static_cast<double>(value)); });
    return result;
  };
  now_.q = in_scalar(scene.q0);
  now_.qd = in_scalar(scene.qd0);
  now_.t = static_cast<double>(scene.t0);
  now_.state = scene.start_phase;
  now_.anchor = anchors_at(scene, now_.q, now_.t);
  shown_ = now_;
  begin(now_.state);
}

void GeneratedMotion::begin(int state) {
  const std::vector<int> before = system_.constraints().active();
  const std::vector<int>& active = code_->states()[static_cast<std::size_t>(state)].active;
  system_.constraints().activate(active);
  const simulation::Terms& terms = system_.geometry(shown_.q);
  for (const int c : active) {
    if (std::find(before.begin(), before.end(), c) == before.end()) {
      system_.constraints().begin(c, shown_.t, shown_.q, terms);
    }
  }
}

Arrays GeneratedMotion::inputs(const Moment& moment) const {
  return {{"q", numbers(moment.q)},
          {"qd", numbers(moment.qd)},
          {"tau", Numbers(static_cast<std::size_t>(moment.q.size()), 0)},
          {"t", {moment.t}},
          {"anchor", moment.anchor},
          {"phase", {static_cast<double>(moment.state)}},
          {"steps", {static_cast<double>(moment.steps)}},
          {"begun", {moment.begun}}};
}

Moment GeneratedMotion::stepped(const Moment& moment) {
  Arrays result = code_->call("step", inputs(moment));
  ++steps_;
  Moment next = moment;
  next.number = moment.number + 1;
  next.t = static_cast<double>(scene_.t0) + static_cast<double>(next.number) * h_;
  next.q = vector(result.at("q_next"));
  next.qd = vector(result.at("qd_next"));
  const auto integer = [&](const char* name, int otherwise) {
    return result.contains(name) ? static_cast<int>(result.at(name).front()) : otherwise;
  };
  next.state = integer("phase_next", moment.state);
  next.steps = integer("steps_next", moment.steps);
  next.begun = result.contains("begun_next") ? result.at("begun_next").front() : 0;
  if (result.contains("anchor_next")) {
    next.anchor = result.at("anchor_next");
  }
  if (!next.q.allFinite() || !next.qd.allFinite()) {
    throw std::runtime_error(fmt::format("the generated step is not finite at t = {:.6g}", next.t));
  }
  return next;
}

Arrays GeneratedMotion::dynamics(const Moment& moment, const Numbers& tau) const {
  Arrays given = inputs(moment);
  given["tau"] = tau;
  const auto& state = code_->states()[static_cast<std::size_t>(moment.state)];
  return code_->call("constrained_dynamics" + state.ending, given);
}

Vector GeneratedMotion::acceleration(const Moment& moment) const {
  return vector(dynamics(moment, inputs(moment).at("tau")).at("qdd"));
}

void GeneratedMotion::advance_to(double end, const std::function<void()>& observe) {
  const double reach = 1e-6 * h_;
  while (static_cast<double>(scene_.t0) + static_cast<double>(now_.number + 1) * h_ <=
         end + reach) {
    Moment next = stepped(now_);
    const std::optional<Fall> fall = landing(now_, next);
    if (fall) {
      record(*fall, now_, next);
    }
    now_ = next;
    shown_ = now_;
    if (fall) {
      begin(now_.state);
    }
    observe();
  }
  if (end > now_.t + reach) {
    shown_ = between(now_, stepped(now_), end);
    observe();
  }
}

/// One step of rk4 of the generated dynamics, of any length: where no step ends, and no event is.
Moment GeneratedMotion::moved(const Moment& from, double s) const {
  const auto at = [&](double c, const Vector& v, const Vector& a) {
    Moment result = from;
    result.t = from.t + c;
    result.q = from.q + c * v;
    result.qd = from.qd + c * a;
    return result;
  };
  const Vector a1 = acceleration(from);
  const Moment second = at(s / 2, from.qd, a1);
  const Vector a2 = acceleration(second);
  const Moment third = at(s / 2, second.qd, a2);
  const Vector a3 = acceleration(third);
  const Moment fourth = at(s, third.qd, a3);
  const Vector a4 = acceleration(fourth);
  return at(s, (from.qd + 2 * (second.qd + third.qd) + fourth.qd) / 6,
            (a1 + 2 * (a2 + a3) + a4) / 6);
}

/// Quintic through positions, velocities and accelerations of both ends; beside an event from the
/// nearer end.
Moment GeneratedMotion::between(const Moment& a, const Moment& b, double t) const {
  if (const std::optional<Fall> fall = landing(a, b)) {
    const Moment& from = t >= fall->time ? b : a;
    return moved(from, t - from.t);
  }
  Moment result = a;
  result.t = t;
  const double x = t - a.t;
  const Vector qdd_a = acceleration(a);
  const Vector qdd_b = acceleration(b);
  const Vector d = b.q - a.q - h_ * a.qd - h_ * h_ / 2 * qdd_a;
  const Vector e = h_ * (b.qd - a.qd - h_ * qdd_a);
  const Vector f = h_ * h_ * (qdd_b - qdd_a);
  const Vector c3 = 10 * d - 4 * e + f / 2;
  const Vector c4 = -15 * d + 7 * e - f;
  const Vector c5 = 6 * d - 3 * e + f / 2;
  const double s = x / h_;
  result.q = a.q + x * a.qd + x * x / 2 * qdd_a + s * s * s * (c3 + s * (c4 + s * c5));
  result.qd = a.qd + x * qdd_a + s * s / h_ * (3 * c3 + s * (4 * c4 + 5 * s * c5));
  return result;
}

/// Height of an event's point over its plane and the speed at which it changes.
std::pair<double, double> GeneratedMotion::height(const model::Event& event,
                                                  const Moment& moment) const {
  const model::Point& point = scene_.points[static_cast<std::size_t>(event.point)];
  simulation::Pose pose(scene_.tree, scene_.gravity);
  pose.update(moment.q, moment.qd);
  const Eigen::Vector3d p = pose.point(point.link, simulation::vector_of(point.at));
  const simulation::LinkState& link = pose.links().at(static_cast<std::size_t>(point.link));
  const Eigen::Vector3d n = simulation::vector_of(event.plane.normal);
  return {n.dot(p) - static_cast<double>(event.plane.height),
          n.dot(link.v + link.omega.cross(p - link.O))};
}

/// What falls below zero where the event happens: a height, or the velocity of a joint that stops.
double GeneratedMotion::guard(const model::Event& event, const Moment& moment) const {
  return event.stops < 0 ? height(event, moment).first
                         : event.value.evaluate([&](const model::Variable& variable) {
                             return moment.qd[variable.index];
                           });
}

/// What ended a phase within the step: where the motion from its beginning meets the plane.
std::optional<Fall> GeneratedMotion::landing(const Moment& a, const Moment& b) const {
  const auto& states = code_->states();
  const auto phase = static_cast<std::size_t>(states[static_cast<std::size_t>(a.state)].phase);
  for (const model::Event& event : scene_.phases[phase].until) {
    if (event.stops >= 0 && states[static_cast<std::size_t>(b.state)].phase == event.then) {
      return Fall{&event, fall_time(event, a)};
    }
    if (event.kind != model::EventKind::kHeight) {
      continue;
    }
    const auto [before, falling] = height(event, a);
    const double rising = height(event, b).second;
    const bool leads =
        a.state != b.state && states[static_cast<std::size_t>(b.state)].phase == event.then;
    const bool bounces = a.state == b.state && event.impact &&
                         event.then == static_cast<int>(phase) && falling < 0 &&
                         rising > falling / 2 && before < -2 * h_ * falling;
    if (leads || bounces) {
      return Fall{&event, fall_time(event, a)};
    }
  }
  if (a.state != b.state) {
    return Fall{nullptr, b.t};
  }
  return std::nullopt;
}

double GeneratedMotion::fall_time(const model::Event& event, const Moment& a) const {
  double low = 0;
  double high = h_;
  while (low < (low + high) / 2 && (low + high) / 2 < high) {
    const double middle = (low + high) / 2;
    (guard(event, moved(a, middle)) > 0 ? low : high) = middle;
  }
  return a.t + high;
}

void GeneratedMotion::record(const Fall& fall, const Moment& a, const Moment& b) {
  simulation::EventRecord result;
  result.time = fall.time;
  result.phase = code_->states()[static_cast<std::size_t>(a.state)].phase;
  const Moment before = moved(a, fall.time - a.t);
  result.q = before.q;
  result.qd_before = before.qd;
  result.qd_after = moved(b, fall.time - b.t).qd;
  if (fall.event != nullptr && fall.event->impact) {
    const auto all = formulate::impacts_of(scene_);
    const formulate::ImpactName wanted =
        formulate::impact_with(*fall.event->impact, fall.event->impact->restitution);
    const auto used =
        std::find_if(all.begin(), all.end(),
                     [&](const formulate::ImpactName& impact) { return impact.same_as(wanted); });
    Arrays given = inputs(before);
    given["qd_minus"] = numbers(before.qd);
    result.impulse = vector(code_->call(used->name, given).at("P"));
  }
  events_.push_back(result);
}

const simulation::Solution& GeneratedMotion::solution() {
  const Arrays result = dynamics(shown_, inputs(shown_).at("tau"));
  solution_.qdd = vector(result.at("qdd"));
  solution_.lambda = result.contains("lambda") ? vector(result.at("lambda")) : Vector();
  return solution_;
}

/// The dimension of the reactions that joint forces call forth.
int GeneratedMotion::rank() {
  const Vector none = solution().lambda;
  const Eigen::Index n = shown_.q.size();
  Eigen::MatrixXd reactions(none.size(), n);
  for (Eigen::Index k = 0; k < n; ++k) {
    Numbers tau(static_cast<std::size_t>(n), 0);
    tau[static_cast<std::size_t>(k)] = std::max(1.0, none.cwiseAbs().maxCoeff());
    reactions.col(k) = vector(dynamics(shown_, tau).at("lambda")) - none;
  }
  return rank_of(reactions, source_.noise());
}

double GeneratedMotion::residual() {
  const Vector qdd = solution().qdd;
  dynamics_->evaluate(shown_.q, shown_.qd, terms_);
  simulation::Matrix J;
  Vector wanted;
  system_.constraints().jacobian(terms_, J);
  system_.constraints().accelerations(terms_, {shown_.t, shown_.q, shown_.qd}, wanted);
  return (J * qdd - wanted).cwiseAbs().maxCoeff();
}

Strike GeneratedMotion::strike_all() {
  model::Scene struck = scene_;
  std::vector<int> all(scene_.constraints.size());
  std::iota(all.begin(), all.end(), 0);
  model::Event event;
  event.kind = model::EventKind::kTime;
  event.not_before = 1;
  event.impact = model::Impact{all, 0, 0};
  struck.phases = {{"struck", all, {event}}};
  struck.start_phase = 0;
  const Code code(struck, source_.scalar(), {"impact", "constrained_dynamics"});
  Arrays given = inputs(shown_);
  const auto impact = [&](const Vector& qd) {
    given["qd_minus"] = numbers(qd);
    return code.call("impact", given);
  };
  const Arrays result = impact(shown_.qd);
  Strike strike;
  strike.impulse = vector(result.at("P"));
  strike.qd = vector(result.at("qd_plus"));
  given["qd"] = numbers(strike.qd);
  strike.qdd = vector(code.call("constrained_dynamics", given).at("qdd"));
  Eigen::MatrixXd impulses(strike.impulse.size(), shown_.q.size());
  for (Eigen::Index k = 0; k < shown_.q.size(); ++k) {
    impulses.col(k) = vector(impact(Vector::Unit(shown_.q.size(), k)).at("P"));
  }
  strike.rank = rank_of(impulses, source_.noise());
  return strike;
}

int GeneratedMotion::slip_direction() {
  const double speed = shown_.qd[scene_.frictions.front().joint];
  return speed > 0 ? 1 : speed < 0 ? -1 : 0;
}

double GeneratedSource::rounded(double x) const {
  return scalar_ == "float" ? static_cast<double>(static_cast<float>(x)) : x;
}

double GeneratedSource::noise() const {
  return std::sqrt(scalar_ == "float" ? static_cast<double>(std::numeric_limits<float>::epsilon())
                                      : std::numeric_limits<double>::epsilon());
}

}  // namespace treedyn::hard
