#include "derive/rules.hpp"

#include <array>

namespace treedyn::derive {

namespace {

constexpr std::array<RuleRow, 39> kRules = {{
    {Rule::kRates, "R11",
     "dot: (X Y)' = X' Y + X Y', of a number y^T M y with M = M^T 2 y^T M y' + y^T M' y; D, σ, m "
     "are constant, vectors of links turn, s has the slide"},
    {Rule::kValueRates, "R11'",
     "dot of what is derived, in frames of links: y = D^T a + N^T b: y' = D^T a' + N^T (b' + w×y), "
     "w = σ q̇ z"},
    {Rule::kDistribute, "R0", "products distribute over sums, transposes go down to the symbols"},
    {Rule::kSums, "R1",
     "D x, N x are sums along the path from the root, D^T x, N^T x over the subtree"},
    {Rule::kTransposes, "R1'",
     "1^T (a·D^T y) = 1^T (D a·y), 1^T (D a×y) = 1^T (a×D^T y), so N, a·(b×c) = b·(c×a)"},
    {Rule::kSkewPasses, "R2", "Λ(D X) = D Λ(X), Λ(X D) = Λ(X) D"},
    {Rule::kMerge, "R3",
     "D x + D y = D (x + y), D^T y + N^T x is one recursion, a×b + a×c = a×(b+c)"},
    {Rule::kJacobi, "R2'", "(a×b)×c = a×(b×c) - b×(a×c)"},
    {Rule::kTwiceTurned, "R2''", "ω×(ω×x) = Λ(ω)² x: with α×x it is Ω x"},
    {Rule::kCrossWords, "R4", "Λ^T(Λ^T(P) u) x = Σ Λ(x) Λ(u) P: sums of 3x3 blocks times s"},
    {Rule::kTelescope, "R5", "D (g - g of the father) = g"},
    {Rule::kComponents, "R4'", "Λ(Y) x = Σ (Y x_k) × e_k, component by component"},
    {Rule::kBlownUp, "R4''", "numbers A are A E_3 where they multiply vectors: (A x)_k = A x_k"},
    {Rule::kUnits, "R6'", "X is its columns X e_j (or rows), whatever is zero in them vanishes"},
    {Rule::kRowOfUnit, "R6'''", "a row times e_j is its number j: x y^T e_j = x y_j"},
    {Rule::kMeet, "R6''", "rows come from the left, columns from the right, they meet anywhere"},
    {Rule::kSymmetric, "R6", "A e_j = A^T e_j: the rows from link j to the root are enough"},
    {Rule::kComposites, "R7",
     "D^T X D = D^T X^c + X^c N, N^T X N = D^T X^s + X^s N: composites X^c = D^T X, X^s = N^T X"},
    {Rule::kPlaceSums, "R7''",
     "1^T X D y = 1^T (D^T X) y; of places P = D s: D^T (P×y) = P×D^T y + N^T (s×D^T y)"},
    {Rule::kKinds, "R7'",
     "3x3 blocks keep their kind: D^T (y E_3) = (D^T y) E_3, D^T Λ(x) = Λ(D^T x)"},
    {Rule::kCommon, "R3'",
     "what is the same for all links leaves sums: D^T(y g) = (D^T y) g, D^T(x×g) = (D^T x)×g"},
    {Rule::kParameters, "R10",
     "m c = h, J_c - m Λ(c)² = I: c×(m x) = h×x, c×(Λ(α) h) = (I - J_c) α"},
    {Rule::kPlaces, "F1",
     "of what no P_i of a sliding joint is in: it may be anywhere on its axis, in the link, l = 0"},
    {Rule::kStart, "F2", "what is added to all sums along paths is where they start"},
    {Rule::kFathers, "F3", "what is made of N x alone is the father's: S(N x) = Π S(D x)"},
    {Rule::kPseudoInertia, "F4",
     "I α + ω×(I ω) = vee(Ω Ψ), Ω = Λ(α) + Λ(ω)², of the second moments Ψ, I = tr(Ψ) E_3 - Ψ: the "
     "same products twice; vee(X) = (X_zy - X_yz, X_xz - X_zx, X_yx - X_xy)"},
    {Rule::kComposite, "F5",
     "-Λ(h)Λ(s) - Λ(s)Λ(h + m s) = tr(F) E_3 - F, F = h s^T + s h^T + m s s^T: symmetric"},
    {Rule::kSquare, "F6", "ω·(I ω) = -tr(Λ(ω)² Ψ): squares and products of ω, each once"},
    {Rule::kTwice, "F7", "D^T a + N^T (a + 2 b) = a + 2 N^T (a + b)"},
    {Rule::kTurned, "F8",
     "½ (Λ(ω) J_c - J_c Λ(ω) - Λ(J_c ω)) - Λ(c) Λ(ω×h) = -Λ(ω) Ψ, I = tr(Ψ) E_3 - Ψ"},
    {Rule::kRelative, "F9",
     "D^T ω×h + N^T m (ω_f×s + v) = ω_f×h^c + D^T w×h^c + N^T m v: what turns with the father does "
     "not travel"},
    {Rule::kMomentum, "F9'", "I^c (ω_f×x) - Λ(ω_f) Ψ^c x = (Ψ^c ω_f)×x"},
    {Rule::kElimination, "R9",
     "A x = r: U = K b, d = b·U, x = (u - U·y)/d; fathers take K' = K - U U^T/d, p' = p + U u/d"},
    {Rule::kYields, "R9'", "K' b = 0 and b·p' = r: a joint hands on nothing along its axis"},
    {Rule::kFactors, "R12",
     "A = A^T, zero but along paths: A = L^T Δ L, L = E + L' zero where D is, a = Δ L is A - L'^T "
     "a"},
    {Rule::kTriangles, "R12'",
     "L x = r: x = r - L' x from the root; L^T x = r: x = r - L'^T x from the leaves"},
    {Rule::kReactions, "R12''",
     "A x = r + J^T λ, J x = s: L^T Y = J^T, L^T y = r, K_λ λ = s - Y^T Δ^-1 y, K_λ = Y^T Δ^-1 Y"},
    {Rule::kLeast, "R12'''", "M λ = s, the least λ·λ: λ = M^T μ, K_μ μ = s with K_μ = M M^T"},
    {Rule::kTrunk, "R13",
     "joints at the root that move a link in every way: y = B q̈ + γ along its axes takes their "
     "place, B^T f = τ"},
}};

constexpr bool is_in_order() {
  for (std::size_t k = 0; k < kRules.size(); ++k) {
    if (kRules[k].rule != static_cast<Rule>(k)) {
      return false;
    }
  }
  return kRules.size() == static_cast<std::size_t>(Rule::kTrunk) + 1;
}
static_assert(is_in_order(), "row_of takes the rows in the order of the enumeration");

}  // namespace

std::span<const RuleRow> rules() { return kRules; }

const RuleRow& row_of(Rule rule) { return rules()[static_cast<std::size_t>(rule)]; }

}  // namespace treedyn::derive
