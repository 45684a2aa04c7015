// R9: A x = r with the states that A's derivation has, joint by joint from the leaves: articulated
// bodies.
#include <algorithm>

#include "derive/affine.hpp"
#include "derive/derive.hpp"

namespace treedyn::derive {
namespace {

/// A vector that travels from the root, y = Π y + b x + Σ block * (other y of the father) + rest,
/// or to it.
struct State {
  int sum = -1;
  int axis = -1;
  Affine own;     ///< of what a link adds
  Affine handed;  ///< of what sons hand on beside the sum
};

class Eliminator {
 public:
  Eliminator(Values& values, const std::string& unknown)
      : values_(values), opening_(values, unknown), algebra_(opening_.algebra()) {}

  /// The unknowns; -1 if R9 does not act.
  int run(int root);

 private:
  Affine opened(int x);
  std::pair<int, int> representative(int path);
  bool find_states(int root);
  bool find_motion(const Affine& force);
  State* place(std::array<State, 2>& states, int axis, int sum);
  bool is_symmetric();
  int transposed(int X);
  [[nodiscard]] bool is_symmetric_tensor(int S) const;
  int tensor(const Affine& a, const Atom& of);

  int made(Op op, Type type, std::vector<int> operands, const char* name = "") {
    return values_.intern({op, Set::kLinks, type, name, 0, std::move(operands), {}});
  }
  /// As it stands, without R3: the order of the sums is that of the elimination.
  int sum(const Terms& terms);
  int travelling(const char* name, Type type) { return made(Op::kTravelling, type, {}, name); }
  void fold(int travelling, int own, int handed, int sum);
  int yields(int x) { return values_.note(Rule::kYields, x); }
  void eliminate(int r);
  int onward();

  Values& values_;
  Opening opening_;
  Algebra& algebra_;
  std::vector<std::pair<int, Affine>> paths_;  ///< with what their links add
  std::array<State, 2> y_, z_;  ///< from the root and to it, the first of each for turning
  int s_ = -1;                  ///< y_1 of the link has Λ^T(s) y_0 of the father
  std::array<int, 2> U_{}, zeta_{};
  int inverse_ = -1;
  int u_ = -1;
};

/// Sums along paths that the unknowns decide alike are one and a sum that they do not decide.
Affine Eliminator::opened(int x) {
  Affine result = opening_.open(x);
  for (const auto& [atom, block] : std::exchange(result.blocks, {})) {
    const auto [path, more] = representative(atom.first);
    const auto [other, is_new] = result.blocks.emplace(Atom{path, atom.second}, block);
    other->second = is_new ? block : algebra_.linear({{kPlus, other->second}, {kPlus, block}});
    if (path != atom.first) {
      const Op op = atom.second ? Op::kPathStrict : Op::kPath;
      result.rest.emplace_back(kPlus,
                               algebra_.step(block, algebra_.sum_along(op, Set::kLinks, more)));
    }
  }
  return result;
}

/// The first path of that kind, and what a link adds to this one beside.
std::pair<int, int> Eliminator::representative(int path) {
  const Value v = values_[path];
  if (v.op != Op::kPath) {
    return {path, -1};
  }
  const Affine own = opened(v.operands[0]);
  for (const auto& [other, of_other] : paths_) {
    const std::vector<int>& operands = values_[other].operands;
    if (of_other.blocks == own.blocks && std::equal(operands.begin() + 1, operands.end(),
                                                    v.operands.begin() + 1, v.operands.end())) {
      return {other, algebra_.linear({{kPlus, opening_.rest(own, Type::kVector)},
                                      {kMinus, opening_.rest(of_other, Type::kVector)}})};
    }
  }
  paths_.emplace_back(path, own);
  return {path, -1};
}

/// The state of joints with that axis; null if it is no axis or has another sum.
State* Eliminator::place(std::array<State, 2>& states, int axis, int sum) {
  const int z = algebra_.leaf("z^d", Set::kLinks, Type::kVector);
  for (std::size_t k = 0; k < 2; ++k) {
    const int number = algebra_.leaf(k == 0 ? "σ" : "E-σ", Set::kLinks, Type::kScalar);
    State& state = states[k];
    if (algebra_.scale(number, z) == axis && (state.sum < 0 || state.sum == sum)) {
      state.sum = sum;
      state.axis = axis;
      return &state;
    }
  }
  return nullptr;
}

/// The vectors that travel, those for turning joints first. False if they are not two and two.
bool Eliminator::find_states(int root) {
  const Affine out = opened(root);
  u_ = algebra_.negative(opening_.rest(out, Type::kScalar));
  std::map<int, Ratio> signs;
  for (const auto& [row, axis] : out.blocks) {
    const Value v = values_[row.first];
    State* force = place(z_, axis, row.first);
    signs[row.first] = force != nullptr ? kPlus : kMinus;
    force = force != nullptr ? force : place(z_, algebra_.negative(axis), row.first);
    if (force == nullptr || (v.op != Op::kSubtree && v.op != Op::kBackward)) {
      return false;
    }
    force->own = opened(v.operands[0]);
    force->handed = v.op == Op::kBackward ? opened(v.operands[1]) : Affine{};
    if (!find_motion(force->own)) {
      return false;
    }
  }
  const auto with_sign = [&](const Ratio& sign, int& block) {
    block = algebra_.linear({{sign, block}});
  };
  for (State& force : z_) {  // -F of -z as F of z
    for (auto& [atom, block] : force.own.blocks) {
      with_sign(signs[force.sum], block);
    }
    for (auto& [factor, x] : force.own.rest) {
      factor = multiply(signs[force.sum], factor);
    }
    for (auto& [atom, block] : force.handed.blocks) {
      with_sign(multiply(signs[force.sum], signs[atom.first]), block);
    }
  }
  return y_[0].sum >= 0 && y_[1].sum >= 0 && z_[0].sum >= 0 && z_[1].sum >= 0;
}

/// The accelerations that a force comes from.
bool Eliminator::find_motion(const Affine& force) {
  for (const auto& [atom, block] : force.blocks) {
    const Value path = values_[atom.first];
    Affine own = path.op == Op::kPath ? opened(path.operands[0]) : Affine{};
    const auto x = std::ranges::find_if(
        own.blocks, [this](const auto& part) { return values_[part.first.first].op == Op::kLeaf; });
    State* const motion = x == own.blocks.end() ? nullptr : place(y_, x->second, atom.first);
    if (motion == nullptr || atom.second) {
      return false;
    }
    own.blocks.erase(x);
    motion->own = own;
  }
  return true;
}

/// Of a step of links; -1: of a tensor that is not symmetric.
int Eliminator::transposed(int X) {
  switch (values_[X].type) {
    case Type::kScalar:
      return X;
    case Type::kVector:
      return algebra_.negative(X);
    case Type::kTensor:
      break;
  }
  return is_symmetric_tensor(X) ? X : -1;
}

bool Eliminator::is_symmetric_tensor(int S) const {
  const Value& v = values_[S];
  return v.name == "I^d" || v.name == "J_c^d" || v.op == Op::kIdentity ||
         (v.op == Op::kScale && is_symmetric_tensor(v.operands.back())) ||
         (v.op == Op::kLinear &&
          std::ranges::all_of(v.operands, [this](int x) { return is_symmetric_tensor(x); }));
}

/// True if what travels to the root mirrors what comes from it: A = P^T M P with M^T = M.
bool Eliminator::is_symmetric() {
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t l = 0; l < 2; ++l) {
      const int K = z_[k].own.block({y_[l].sum, false});
      const int other = z_[l].own.block({y_[k].sum, false});
      if ((K < 0) != (other < 0) || (K >= 0 && transposed(K) != other)) {
        return false;
      }
    }
  }
  const int X = y_[1].own.block({y_[0].sum, true});
  if (X < 0 || values_[X].type != Type::kVector || !y_[0].own.blocks.empty() ||
      y_[1].own.blocks.size() != 1 || !z_[1].handed.blocks.empty() ||
      z_[0].handed.blocks.size() != 1 || z_[0].handed.block({z_[1].sum, false}) != transposed(X)) {
    return false;
  }
  s_ = transposed(X);
  return z_[0].handed.rest.empty() && z_[1].handed.rest.empty();
}

int Eliminator::tensor(const Affine& a, const Atom& of) {
  const int X = a.block(of);
  if (X < 0) {
    return algebra_.zero(Set::kLinks, Type::kTensor);
  }
  return values_[X].type == Type::kTensor   ? made(Op::kAtLink, Type::kTensor, {X})
         : values_[X].type == Type::kVector ? algebra_.skew(X)
                                            : algebra_.scale(X, algebra_.identity(Set::kLinks));
}

int Eliminator::sum(const Terms& terms) {
  const Value first = values_[terms.front().second];
  Terms kept = terms;
  std::erase_if(kept, [this](const auto& term) { return values_[term.second].op == Op::kZero; });
  if (kept.empty()) {
    return algebra_.zero(first.set, first.type);
  }
  return kept.size() == 1 && kept[0].first == kPlus
             ? kept[0].second
             : values_.intern(plain_sum(kept, first.set, first.type));
}

/// \param sum  what travelled before
void Eliminator::fold(int travelling, int own, int handed, int sum) {
  const int result = made(Op::kFold, values_[travelling].type, {own, handed});
  values_.note(values_.made_by(sum), result);
  values_.define(travelling, result);
}

/// From the leaves: what a joint does not take goes to the father, X^T K' X and X^T p'.
void Eliminator::eliminate(int r) {
  const int I = travelling("I^A", Type::kTensor);
  const int H = travelling("h^A", Type::kTensor);
  const int M = travelling("m^A", Type::kTensor);
  const std::array<int, 2> p = {travelling("p_M", Type::kVector), travelling("p_F", Type::kVector)};
  const std::array<int, 2> b = {y_[0].axis, y_[1].axis};
  const auto times = [&](int S, int x, bool turned = false) {
    return made(turned ? Op::kApplyTranspose : Op::kApply, Type::kVector, {S, x});
  };
  const auto dot = [&](int x, int y) {
    return made(Op::kDot, Type::kScalar, {x, y});
  };
  U_ = {sum({{kPlus, times(I, b[0])}, {kPlus, times(H, b[1])}}),
        sum({{kPlus, times(H, b[0], true)}, {kPlus, times(M, b[1])}})};
  const int d = sum({{kPlus, dot(b[0], U_[0])}, {kPlus, dot(b[1], U_[1])}});
  inverse_ = made(Op::kReciprocal, Type::kScalar, {d});
  const int bias = sum({{kPlus, dot(b[0], p[0])}, {kPlus, dot(b[1], p[1])}});
  u_ = made(Op::kAtLink, Type::kScalar, {sum({{kPlus, r}, {kMinus, bias}}), inverse_}, "u");
  std::array<int, 2> V{};
  std::array<int, 2> q{};  // p + U u / d
  for (std::size_t k = 0; k < 2; ++k) {
    zeta_[k] = made(Op::kAtLink, Type::kVector, {opening_.rest(y_[k].own, Type::kVector)},
                    k == 0 ? "" : "ζ");
    const int scaled = made(Op::kScale, Type::kVector, {inverse_, U_[k]});
    V[k] = yields(made(Op::kAlong, Type::kVector, {scaled, b[k], algebra_.ones(Set::kLinks)}));
    const int more = made(Op::kScale, Type::kVector, {u_, V[k]});
    const int taken = values_.note(Rule::kElimination, sum({{kPlus, p[k]}, {kPlus, more}}));
    q[k] = yields(made(Op::kAlong, Type::kVector, {taken, b[k], r}));
  }
  const auto without = [&](int K, std::size_t k, std::size_t l) {
    const int rest = made(Op::kAcross, Type::kTensor, {K, U_[k], V[l], b[k], b[l]});
    return yields(values_.note(Rule::kElimination, rest));
  };
  const int I1 = without(I, 0, 0);
  const int H1 = without(H, 0, 1);
  const int M1 = without(M, 1, 1);
  const std::array<int, 2> p1 = {
      sum({{kPlus, q[0]},
           {kPlus, sum({{kPlus, times(I1, zeta_[0])}, {kPlus, times(H1, zeta_[1])}})}}),
      sum({{kPlus, q[1]},
           {kPlus, sum({{kPlus, times(H1, zeta_[0], true)}, {kPlus, times(M1, zeta_[1])}})}})};
  const int H2 = sum({{kPlus, made(Op::kLever, Type::kTensor, {s_, M1})}, {kPlus, H1}});
  const int I2 = sum({{kPlus, made(Op::kLever, Type::kTensor, {s_, H1, H2})}, {kPlus, I1}});
  fold(I, tensor(z_[0].own, {y_[0].sum, false}), I2, z_[0].sum);
  fold(H, tensor(z_[0].own, {y_[1].sum, false}), H2, z_[0].sum);
  fold(M, tensor(z_[1].own, {y_[1].sum, false}), M1, z_[1].sum);
  const int moment = algebra_.step(s_, p1[1]);
  const std::array<int, 2> own = {opening_.rest(z_[0].own, Type::kVector),
                                  opening_.rest(z_[1].own, Type::kVector)};
  fold(p[0], own[0], sum({{kPlus, p1[0]}, {kPlus, moment}}), z_[0].sum);
  fold(p[1], own[1], p1[1], z_[1].sum);
}

/// From the root: y without the joint's own part, x, y.
int Eliminator::onward() {
  const std::array<int, 2> y = {travelling("α", Type::kVector), travelling("a", Type::kVector)};
  std::array<int, 2> father{};
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<int> operands = values_[y_[k].sum].operands;
    operands[0] = y[k];
    father[k] = made(Op::kFather, Type::kVector, operands);
    values_.note(values_.made_by(y_[k].sum), father[k]);
  }
  const std::array<int, 2> before = {
      made(Op::kAtLink, Type::kVector, {sum({{kPlus, father[0]}, {kPlus, zeta_[0]}})}),
      made(Op::kAtLink, Type::kVector,
           {sum({{kPlus, sum({{kPlus, father[1]},
                              {kPlus, algebra_.step(algebra_.negative(s_), father[0])}})},
                 {kPlus, zeta_[1]}})})};
  const int taken = sum({{kPlus, made(Op::kDot, Type::kScalar, {U_[0], before[0]})},
                         {kPlus, made(Op::kDot, Type::kScalar, {U_[1], before[1]})}});
  const int x = made(Op::kScale, Type::kScalar, {inverse_, sum({{kPlus, u_}, {kMinus, taken}})});
  for (std::size_t k = 0; k < 2; ++k) {
    const int own = made(Op::kScale, Type::kVector, {x, y_[k].axis});
    values_.define(y[k], sum({{kPlus, before[k]}, {kPlus, own}}));
  }
  return x;
}

int Eliminator::run(int root) {
  if (!find_states(root) || !is_symmetric()) {
    return -1;
  }
  eliminate(u_);
  return values_.note(Rule::kElimination, onward());
}

}  // namespace

std::optional<Derivation> solved(const Derivation& system, const std::string& x) {
  Derivation result = system;
  try {
    result.roots = {Eliminator(result.values, x).run(system.roots.front())};
  } catch (const NoComposites&) {
    return std::nullopt;
  }
  result.elimination = true;
  return result.roots.front() < 0 ? std::nullopt : std::optional(result);
}

}  // namespace treedyn::derive
