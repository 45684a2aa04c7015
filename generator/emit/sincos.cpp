#include "emit/sincos.hpp"

#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

/// How sine and cosine are approximated: fdlibm's polynomials for double, Cephes' for float. The
/// errors bound the largest distance from long double over 1.5e7 arguments, half an ulp of 1 more.
struct Approximation {
  const char* error;
  const char* range;
  const char* integer;   ///< as wide as the scalar
  const char* rounding;  ///< 1.5 ulp^-1: adding it leaves an integer in the last bits
  std::array<const char*, 3> parts_of_half_pi;
  std::vector<const char*> sine;  ///< highest power of r^2 first
  std::vector<const char*> cosine;
};

const Approximation& approximation(Scalar scalar) {
  static const Approximation for_double = {
      "2.3e-16",
      "1e6",
      "long long",
      "6755399441055744.0",
      {"1.57079632673412561417", "6.07710050630396597660e-11", "2.02226624879595063154e-21"},
      {"1.58969099521155010221e-10", "-2.50507602534068634195e-08", "2.75573137070700676789e-06",
       "-1.98412698298579493134e-04", "8.33333333332248946124e-03", "-0.166666666666666324348"},
      {"-1.13596475577881948265e-11", "2.08757232129817482790e-09", "-2.75573143513906633035e-07",
       "2.48015872894767294178e-05", "-1.38888888888741095749e-03", "0.0416666666666666019037"}};
  static const Approximation for_float = {
      "1e-7",
      "8e3",
      "int",
      "12582912.0",
      {"1.5703125", "4.837512969970703125e-4", "7.54978995489188216e-8"},
      {"-1.9515295891e-4", "8.3321608736e-3", "-0.16666654611"},
      {"2.443315711809948e-5", "-1.388731625493765e-3", "4.166664568298827e-2"}};
  return scalar == Scalar::kFloat ? for_float : for_double;
}

/// Horner's rule in z, a statement a coefficient.
std::string horner(const std::string& name, const std::vector<const char*>& coefficients,
                   Scalar scalar) {
  std::string text;
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    const std::string previous =
        k == 1 ? literal(Real(coefficients[0]), scalar) : fmt::format("{}_{}", name, k - 1);
    const Real coefficient(coefficients[k]);
    text += fmt::format("  const Scalar {}_{} = {} * z {} {};\n", name, k, previous,
                        coefficient < 0 ? '-' : '+', literal(abs(coefficient), scalar));
  }
  return text;
}

}  // namespace

std::string sincos_text(const Target& target) {
  const Approximation& a = approximation(target.scalar);
  const auto number = [&](const char* text) {
    return literal(Real(text), target.scalar);
  };
  std::map<std::string, std::string> slots = {
      {"error", a.error},
      {"range", a.range},
      {"one", number("1")},
      {"half", number("0.5")},
      {"two_over_pi", literal(2 / pi(), target.scalar)},
      {"rounding", number(a.rounding)},
      {"part_1", number(a.parts_of_half_pi[0])},
      {"part_2", number(a.parts_of_half_pi[1])},
      {"part_3", number(a.parts_of_half_pi[2])},
      {"sine", horner("s", a.sine, target.scalar)},
      {"cosine", horner("c", a.cosine, target.scalar)},
      {"sine_end", fmt::format("s_{}", a.sine.size() - 1)},
      {"cosine_end", fmt::format("c_{}", a.cosine.size() - 1)}};
  if (target.lanes > 1) {
    slots.emplace("integer", a.integer);
  }
  return fill(template_text(target.lanes == 1 ? "sincos.cpp" : "sincos_lanes.cpp"), slots);
}

}  // namespace treedyn::emit
