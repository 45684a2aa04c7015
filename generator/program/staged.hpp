// Functions whose straight-line code stops where something is decided: scene functions.
#pragma once

#include <string>
#include <vector>

#include "program/function.hpp"
#include "program/pivots.hpp"

namespace treedyn::program {

/// K x = b for a symmetric, positive semidefinite K, EQUATIONS.md 6.3.
///
/// A pivot counts as zero below `tolerance` of its own diagonal entry of K, and below rounding's
/// share of its row's size: no row is measured by another one. Without pivoting small pivots make
/// the roundings of those behind them grow: there the share is that of K_kk + sum of w_i^2 K_ii,
/// with w the multiples of the rows before that row k is left of, or of K_kk / product, no less
/// than a quarter of it.
struct RowSolve {
  int rows = 0;
  int rank = 0;             ///< of K where the constraints hold; the regular path needs rank = rows
  int elsewhere = 0;        ///< pivots above kIndependent where they need not hold
  std::vector<bool> zeros;  ///< of the lower half, row by row: entries that are always zero
  std::vector<double> sizes;  ///< of the rows: diagonal entries of K as they are in ordinary states
  double least = 0;    ///< of the pivots, as part of their diagonal entries, in ordinary states
  double product = 0;  ///< of these parts in the order of the rows, without pivoting
  bool by_product = false;  ///< pivots are measured by K_kk / product of the parts before
  bool twice = false;       ///< and by a larger share of their own diagonal entries
  bool passes = false;      ///< steps lead through positions of lower rank: rows are stabilised
  double tolerance = 0;     ///< 0: what rounding makes uncertain

  [[nodiscard]] bool regular() const { return rank == rows; }
  bool operator==(const RowSolve&) const = default;
};

/// What is left of a row that counts as one of its own where fewer rows than all are independent on
/// the motions of a scene: the square of 0.003 of its ordinary length.
inline constexpr double kIndependent = 1e-5;

/// What stands between two stages.
enum class Gate {
  kPress,   ///< every contact of positive depth adds its force: depth -> force
  kSolve,   ///< K mu = b
  kReturn,  ///< no depth: all outputs are zero, and that is all
  kClamp,   ///< normal = max(law, 0)
  kPower,   ///< power = depth^n
};

/// What kPower takes.
struct Power {
  int depth = 0;  ///< element of the array
  Real exponent = 0;
};

/// Straight-line code in stages. An input array of level s can be read after stage s - 1, when what
/// stands between the stages has written it; arguments have level 0.
struct Staged {
  Signature signature;           ///< what callers see
  Function function;             ///< all stages; its arrays are those of `signature` and local ones
  std::vector<int> levels;       ///< of the input arrays of `function`
  std::vector<Gate> gates;       ///< gate k stands between the stages k and k + 1
  std::vector<RowSolve> solves;  ///< of kSolve; at most one
  std::vector<Staged> contacts;  ///< of kPress
  bool tells = false;            ///< calls treedyn_again where one presses, for studies
  Power power;                   ///< of kPower
  std::vector<Pivot> pivots;     ///< of A, that are tested; their arrays end the outputs
  std::vector<int> constraints;  ///< of the scene: those that act
  std::vector<std::pair<int, Real>> forces;  ///< of joints, of its phase alone
  Real restitution = 0;                      ///< of an impact
  std::vector<int> held;                     ///< of an impact: those that are led through it
  std::vector<std::string> anchors;          ///< what the parts of `anchor` are
};

/// The local arrays of a solve.
inline constexpr const char* kMatrixArray = "K";
inline constexpr const char* kRightArray = "b";
inline constexpr const char* kMultiplierArray = "mu";
/// The local arrays of contacts.
inline constexpr const char* kDepthArray = "depth";
inline constexpr const char* kForceArray = "force";
inline constexpr const char* kLawArray = "law";
inline constexpr const char* kNormalArray = "normal";
inline constexpr const char* kPowerArray = "power";

/// The regular path unrolled: K = L D L^T without pivoting. Input arrays K, b, d; output arrays d,
/// whole (what pivots 2, 3, .. are measured by; 1 by K_11), x. Element k of d is output of stage k
/// and may be read, so divided by, in stage k + 1.
Function regular_solve(const RowSolve& solve);

/// Operations of the regular path, the test of the pivots included.
Cost regular_cost(const RowSolve& solve);
/// Operations of the path for deficient rows, if the pivots tell this rank.
/// \param doubtful  all pivots are so small that what rounding makes of them is looked at
Cost deficient_cost(int rows, int rank, bool doubtful);

/// Operations of one call where K has its generic rank and no contact is closed.
Cost cost(const Staged& staged);
/// Operations of the dearest call: all contacts are closed, the last pivot of the regular path
/// fails.
Cost worst_cost(const Staged& staged);

/// Calls of pow in the dearest call, which no Cost counts.
int worst_powers(const Staged& staged);

}  // namespace treedyn::program
