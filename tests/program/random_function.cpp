#include "program/random_function.hpp"

#include <array>

namespace treedyn::program {

namespace {

Signature signature_for(int joints, std::vector<Array> outputs) {
  return {"test", "", "", {{"q", joints, ""}, {"qd", joints, ""}, {"qdd", joints, ""}}, outputs};
}

using Vector = std::array<Expr, 3>;

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Joint i turns about z (even) or x (odd); the next link begins 0.3 along x.
class Chain {
 public:
  explicit Chain(int links) : links_(links) {}
  Function write();

 private:
  Expr number(const char* digits) { return {graph_, graph_.constant(Real(digits))}; }
  Expr input(int array, int i) { return {graph_, graph_.input(array, i)}; }
  Vector turn(int i, const Vector& v, bool back);
  Vector inertia_times(int i, const Vector& v);

  int links_;
  Graph graph_;
  std::vector<Vector> force_;
  std::vector<Vector> moment_;
};

Vector Chain::turn(int i, const Vector& v, bool back) {
  const Expr q = input(0, i);
  const Expr c(graph_, graph_.cos(q.ref()));
  const Expr s0(graph_, graph_.sin(q.ref()));
  const Expr s = back ? -s0 : s0;
  return i % 2 == 0 ? Vector{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]}
                    : Vector{v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
}

Vector Chain::inertia_times(int i, const Vector& v) {
  const Expr xy = number(i % 2 == 0 ? "0.011" : "0.017");
  return {number("0.21") * v[0] + xy * v[1], xy * v[0] + number("0.34") * v[1],
          number("0.45") * v[2]};
}

Function Chain::write() {
  const Vector r{number("0.3"), Expr(), Expr()};
  const Vector com{number("0.14"), number("0.02"), number("-0.03")};
  Vector omega;
  Vector alpha;
  Vector a{Expr(), Expr(), number("9.81")};
  for (int i = 0; i < links_; ++i) {
    graph_.set_body(i);
    const std::size_t axis = i % 2 == 0 ? 2 : 0;
    a = a + cross(alpha, r) + cross(omega, cross(omega, r));
    a = turn(i, a, true);
    omega = turn(i, omega, true);
    alpha = turn(i, alpha, true);
    Vector joint;
    joint[axis] = input(1, i);
    alpha = alpha + cross(omega, joint);
    alpha[axis] += input(2, i);
    omega[axis] += input(1, i);
    for (const Expr component : omega) {
      graph_.name(component.ref(), "omega", i, "x");
    }
    const Expr m = number("1.7");
    const Vector f = a + cross(alpha, com) + cross(omega, cross(omega, com));
    force_.push_back({m * f[0], m * f[1], m * f[2]});
    moment_.push_back(inertia_times(i, alpha) + cross(omega, inertia_times(i, omega)) +
                      cross(com, force_.back()));
  }
  Function function;
  function.outputs.resize(static_cast<std::size_t>(links_));
  for (int i = links_ - 1; i >= 0; --i) {
    const auto k = static_cast<std::size_t>(i);
    function.outputs[k] = moment_[k][i % 2 == 0 ? 2 : 0].ref();
    if (i > 0) {
      const Vector f = turn(i, force_[k], false);
      moment_[k - 1] = moment_[k - 1] + turn(i, moment_[k], false) + cross(r, f);
      force_[k - 1] = force_[k - 1] + f;
    }
  }
  function.signature = signature_for(links_, {{"tau", links_, ""}});
  function.graph = std::move(graph_);
  return function;
}

/// A value of a random function and its degree as a polynomial.
struct Value {
  Ref ref = 0;
  int degree = 0;
};

std::vector<Real> relative_to(const std::vector<Real>& values, Real& scale) {
  for (const Real& value : values) {
    scale = std::max(scale, Real(abs(value)));
  }
  return values;
}

}  // namespace

Function random_function(std::uint64_t seed, int size) {
  Random random(seed);
  Function function;
  Graph& graph = function.graph;
  std::vector<Value> values{{graph.constant(Real("0.7")), 0}, {graph.constant(Real("1.9")), 0}};
  for (int i = 0; i < 4; ++i) {
    const Ref q = graph.input(0, i);
    for (const Ref value : {q, graph.sin(q), graph.cos(q), graph.input(1, i)}) {
      values.push_back({value, 1});
    }
  }
  for (int k = 0; k < size; ++k) {
    const int count = static_cast<int>(values.size());
    const Value a = values[static_cast<std::size_t>(random.below(count))];
    const Value b = values[static_cast<std::size_t>(count - 1 - random.below(14))];
    const bool sum = random.below(2) == 0 || a.degree + b.degree > 6;
    const Value made = sum ? Value{graph.add(a.ref, random.below(2) == 0 ? b.ref : -b.ref),
                                   std::max(a.degree, b.degree)}
                           : Value{graph.multiply(a.ref, b.ref), a.degree + b.degree};
    values.push_back(made.ref == 0 ? a : made);
  }
  for (int i = 0; i < 6; ++i) {
    function.outputs.push_back(values[values.size() - 1 - static_cast<std::size_t>(i)].ref);
  }
  function.signature = signature_for(4, {{"y", 6, ""}});
  return function;
}

Function planar_arm() {
  Function function;
  Graph& graph = function.graph;
  std::array<Expr, 3> q;
  std::array<Expr, 3> w;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    q[k] = Expr(graph, graph.input(0, i)) + (i > 0 ? q[k - 1] : Expr());
    w[k] = Expr(graph, graph.input(1, i)) + (i > 0 ? w[k - 1] : Expr());
  }
  const Expr length(graph, graph.constant(Real("0.4")));
  for (std::size_t i = 0; i < 3; ++i) {
    Expr tau;
    for (std::size_t j = 0; j < 3; ++j) {
      const Expr c(graph, graph.cos((q[i] - q[j]).ref()));
      const Expr s(graph, graph.sin((q[i] - q[j]).ref()));
      const Expr acceleration(graph, graph.input(2, static_cast<int>(j)));
      const Expr mass(graph, graph.constant(Real(static_cast<int>(3 - std::max(i, j)))));
      tau += mass * length * length * c * acceleration + mass * length * length * s * w[j] * w[j];
    }
    function.outputs.push_back(tau.ref());
  }
  function.signature = signature_for(3, {{"tau", 3, ""}});
  return function;
}

Function spatial_chain(int links) { return Chain(links).write(); }

Real largest_difference(const Function& a, const Function& b, int states) {
  Real largest = 0;
  Real scale = 0;
  for (int state = 0; state < states; ++state) {
    const auto seed = static_cast<std::uint64_t>(100 + state);
    const auto x = relative_to(evaluate_at_random<Real>(a, seed), scale);
    const auto y = evaluate_at_random<Real>(b, seed);
    for (std::size_t i = 0; i < x.size(); ++i) {
      largest = std::max(largest, Real(abs(x[i] - y[i])));
    }
  }
  return scale == 0 ? largest : Real(largest / scale);
}

double rounding_error(const Function& function, int states) {
  Real largest = 0;
  Real scale = 0;
  for (int state = 0; state < states; ++state) {
    const auto seed = static_cast<std::uint64_t>(200 + state);
    const auto x = relative_to(evaluate_at_random<Real>(function, seed), scale);
    const auto y = evaluate_at_random<double>(function, seed);
    for (std::size_t i = 0; i < x.size(); ++i) {
      largest = std::max(largest, Real(abs(x[i] - Real(y[i]))));
    }
  }
  return scale == 0 ? 0 : static_cast<double>(largest / scale);
}

}  // namespace treedyn::program
