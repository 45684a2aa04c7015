#include "emit/sincos.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "emit/template_file.hpp"

namespace treedyn::emit {

namespace {

/// How sine and cosine are approximated: fdlibm's polynomials for double, Cephes' for float. pi/2
/// is subtracted in parts, all but the last so short that k times them is exact for |k| < 2^bits.
/// The errors bound those measured without contraction over 1e9 arguments of the range (double,
/// against long double: 1.655e-16) and over all of its arguments (float, against double: 9.91e-8),
/// tests/benchmark/results/sines.md.
struct Approximation {
  const char* error;
  const char* range;
  const char* end;                ///< 2^bits pi/2, rounded up
  int digits;                     ///< binary digits of the scalar
  int largest_exponent;           ///< numbers from 2^this on overflow
  int bits;                       ///< of k
  std::vector<int> ends;          ///< of the parts but the last: binary places behind the point
  std::vector<const char*> sine;  ///< highest power of r^2 first
  std::vector<const char*> cosine;
};

const Approximation& approximation(Scalar scalar) {
  static const Approximation for_double = {
      "1.7e-16",
      "1.3e7",
      "1.32e7",
      53,
      1024,
      23,
      {29},
      {"1.58969099521155010221e-10", "-2.50507602534068634195e-08", "2.75573137070700676789e-06",
       "-1.98412698298579493134e-04", "8.33333333332248946124e-03", "-0.166666666666666324348"},
      {"-1.13596475577881948265e-11", "2.08757232129817482790e-09", "-2.75573143513906633035e-07",
       "2.48015872894767294178e-05", "-1.38888888888741095749e-03", "0.0416666666666666019037"}};
  static const Approximation for_float = {
      "1e-7",
      "1e5",
      "1.03e5",
      24,
      128,
      16,
      {7, 15},
      {"-1.9515295891e-4", "8.3321608736e-3", "-0.16666654611"},
      {"2.443315711809948e-5", "-1.388731625493765e-3", "4.166664568298827e-2"}};
  return scalar == Scalar::kFloat ? for_float : for_double;
}

/// Of a single state not Scalar: another type may stand for that.
std::string number_type(const Target& target) {
  return target.lanes == 1 ? type_name(target.scalar) : target.number;
}

/// What an angle is.
std::string type(const Target& target) {
  return target.takes_vectors() ? "Angle" : number_type(target);
}

/// Horner's rule in z, a statement a coefficient.
std::string horner(const std::string& name, const std::vector<const char*>& coefficients,
                   const Target& target) {
  std::string text;
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    const std::string previous =
        k == 1 ? literal(Real(coefficients[0]), target.scalar) : fmt::format("{}_{}", name, k - 1);
    const Real coefficient(coefficients[k]);
    text += fmt::format("  const {} {}_{} = {} * z {} {};\n", type(target), name, k, previous,
                        coefficient < 0 ? '-' : '+', literal(abs(coefficient), target.scalar));
  }
  return text;
}

Real power_of_two(int exponent) { return ldexp(Real(1), exponent); }

/// 2^n with which k overflows from |k| = 2^bits on.
Real scale(const Approximation& a) { return power_of_two(a.largest_exponent - a.bits); }

/// 3/4 of the first number beside which the next one is 2 off: added and subtracted it rounds to a
/// whole number.
Real rounding(const Approximation& a) { return 3 * power_of_two(a.digits - 2); }

/// pi/2 in parts.
std::vector<Real> right_angle(const Approximation& a) {
  std::vector<Real> parts;
  Real rest = pi() / 2;
  for (const int end : a.ends) {
    const Real unit = power_of_two(-end);
    parts.emplace_back(round(rest / unit) * unit);
    rest -= parts.back();
  }
  parts.push_back(rest);
  return parts;
}

/// x - k pi/2, part by part; the first product is that of t = k scale.
std::string reduction(const Approximation& a, const Target& target) {
  std::string text;
  std::string previous = "x";
  const std::vector<Real> parts = right_angle(a);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const Real& value = parts[part];
    const std::string name = part + 1 == parts.size() ? "r" : fmt::format("r_{}", part + 1);
    const Real factor = part == 0 ? Real(value / scale(a)) : Real(abs(value));
    text +=
        fmt::format("  const {} {} = {} {} {} * {};\n", type(target), name, previous,
                    value < 0 ? '+' : '-', part == 0 ? 't' : 'k', literal(factor, target.scalar));
    previous = name;
  }
  return text;
}

/// True if the code of the text, not a comment, calls the function of this name.
bool calls(const std::string& text, const std::string& name) {
  const std::string call = name + "(";
  for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
    const char before = at == 0 ? ' ' : text[at - 1];
    const std::size_t line = text.rfind('\n', at) + 1;  // 0 in the first one
    if ((before == ' ' || before == '(' || before == '-') && text.find("//", line) > at) {
      return true;
    }
  }
  return false;
}

/// `sin` and `cos`, of those the called ones; where limbs and numbers have their own, one of both
/// may be called alone.
std::string singles(const Target& target, const std::string& functions,
                    const std::string& argument) {
  std::string text;
  const char* const unused = target.limb_lanes ? "[[gnu::always_inline, gnu::unused]] " : "";
  for (const auto& [name, member] : {std::pair("sin", "sine"), std::pair("cos", "cosine")}) {
    if (calls(functions, name)) {
      text += fmt::format("\n{0}inline {1} {2}({3} x) noexcept {{ return sine_cosine(x).{4}; }}",
                          unused, number_type(target), name, argument, member);
    }
  }
  return text;
}

/// "x[0], x[1]".
std::string elements(std::size_t count) {
  std::vector<std::string> all;
  for (std::size_t k = 0; k < count; ++k) {
    all.push_back(fmt::format("x[{}]", k));
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

/// Lanes are no numbers beyond the range because t - t is none, which -ffinite-math-only takes for
/// 0.
bool needs_no_numbers(const Target& target) { return target.lanes > 1 || target.limb_lanes; }
constexpr const char* kFiniteMath =
    "    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \\\n";

constexpr const char* kShortDouble =
    "#if defined(__SIZEOF_DOUBLE__) && __SIZEOF_DOUBLE__ != 8\n"
    "#error \"sine_cosine takes a double of 64 bits: --scalar float is for this compiler\"\n"
    "#endif\n";

constexpr const char* kCalled = "[[gnu::noinline]]";
constexpr const char* kInline = "[[gnu::always_inline]] inline";

/// What k modulo 4 does to sine and cosine: by numbers, or in vectors by bits, which costs less.
std::string quadrant_text(const Target& target) {
  const Approximation& a = approximation(target.scalar);
  const auto number = [&](const Real& value) {
    return literal(value, target.scalar);
  };
  const bool is_float = target.scalar == Scalar::kFloat;
  return target.lanes > 1
             ? fill(template_text("quadrant_of_lanes.cpp"),
                    {{"type", type(target)},
                     {"rounding", number(rounding(a))},
                     {"bits", is_float ? "unsigned" : "unsigned long long"},
                     {"minus", is_float ? "0x80000000U" : "0x8000000000000000ULL"},
                     {"to_sign", is_float ? "30" : "62"}})
             : fill(template_text("quadrant.cpp"), {{"type", type(target)},
                                                    {"half", number(Real("0.5"))},
                                                    {"one", number(1)},
                                                    {"four", number(4)},
                                                    {"third", number(Real(1) / 3)},
                                                    {"rounding_to_fours", number(4 * rounding(a))},
                                                    {"unscale", number(1 / scale(a))}});
}

/// The function that gives both, with `head` before its type, of an argument that is passed as
/// `argument`.
std::string pair_text(const Target& target, const std::string& head, const std::string& argument) {
  const Approximation& a = approximation(target.scalar);
  const auto number = [&](const Real& value) {
    return literal(value, target.scalar);
  };
  const bool by_bits = target.lanes > 1;
  return fill(
      template_text("sine_cosine.cpp"),
      {{"error", a.error},
       {"range", a.range},
       {"end", a.end},
       {"type", type(target)},
       {"argument", argument},
       {"half", number(Real("0.5"))},
       {"one", number(1)},
       {"two_over_pi", number(2 / pi())},
       {"rounding", number(rounding(a))},
       {"scale", number(scale(a))},
       {"square", by_bits ? "r * r + (t - t)" : "r * r"},
       {"quadrants", by_bits ? "which of them is which, and the\n/// signs, by the last bits of k"
                             : "sine and cosine of k pi/2 from k\n/// modulo 4; the addition "
                               "theorem, with factors 0, 1 and -1"},
       {"quadrant", quadrant_text(target)},
       {"reduction", reduction(a, target)},
       {"sine", horner("s", a.sine, target)},
       {"cosine", horner("c", a.cosine, target)},
       {"sine_end", fmt::format("s_{}", a.sine.size() - 1)},
       {"cosine_end", fmt::format("c_{}", a.cosine.size() - 1)},
       {"head", head},
       {"name", target.takes_vectors() ? "pair_of" : kSineCosine}});
}

/// The constants of the source as numbers.
template <class T>
struct Numbers {
  T two_over_pi, rounding, rounding_to_fours, scale, unscale, third;
  std::vector<T> parts;  ///< of pi/2, the first less `scale` times
  std::vector<T> sine, cosine;

  explicit Numbers(const Approximation& a)
      : two_over_pi((2 / pi()).convert_to<T>()),
        rounding(emit::rounding(a).convert_to<T>()),
        rounding_to_fours((4 * emit::rounding(a)).convert_to<T>()),
        scale(emit::scale(a).convert_to<T>()),
        unscale((1 / emit::scale(a)).convert_to<T>()),
        third((Real(1) / 3).convert_to<T>()) {
    std::vector<Real> right = right_angle(a);
    right.front() = right.front() / emit::scale(a);
    for (const Real& part : right) {
      parts.push_back(part.convert_to<T>());
    }
    for (const char* const coefficient : a.sine) {
      sine.push_back(Real(coefficient).convert_to<T>());
    }
    for (const char* const coefficient : a.cosine) {
      cosine.push_back(Real(coefficient).convert_to<T>());
    }
  }
};

template <class T>
T value_of(const std::vector<T>& polynomial, T z) {
  T value = polynomial.front();
  for (std::size_t k = 1; k < polynomial.size(); ++k) {
    const T product = value * z;
    value = product + polynomial[k];
  }
  return value;
}

/// The statements of the templates `sine_cosine.cpp` and `quadrant.cpp`, one by one.
template <class T>
SineCosine<T> executed(const Numbers<T>& a, T x) {
  const T k = (x * a.two_over_pi + a.rounding) - a.rounding;
  const T t = k * a.scale;
  T r = x;
  for (std::size_t part = 0; part < a.parts.size(); ++part) {
    r = r - (part == 0 ? t : k) * a.parts[part];
  }
  const T z = r * r;
  const T sine = r + r * z * value_of(a.sine, z);
  const T cosine = T(1) - z * (T(0.5) - z * value_of(a.cosine, z));
  const T l = t * a.unscale;
  const T m = l - ((l + a.rounding_to_fours) - a.rounding_to_fours);
  const T n = T(4) - m * m;
  const T s = m * (n * a.third);
  const T c = T(0.5) * (n - s * s) - T(1);
  return {c * sine + s * cosine, c * cosine - s * sine};
}

}  // namespace

SineCosine<float> sine_cosine(float x) {
  static const Numbers<float> numbers(approximation(Scalar::kFloat));
  return executed(numbers, x);
}

SineCosine<double> sine_cosine(double x) {
  static const Numbers<double> numbers(approximation(Scalar::kDouble));
  return executed(numbers, x);
}

std::size_t most_angles(Scalar scalar) { return scalar == Scalar::kFloat ? 8 : 4; }

bool has_sincos(const Unit& unit) {
  const program::Cost cost = total_cost(unit);
  return !unit.target.takes_libm() && cost.sin + cost.cos > 0;
}

std::string sincos_text(Target target, const std::string& functions, bool has_numbers) {
  target.vectors = target.vectors && calls(functions, kSinesCosines);
  const std::string head =
      target.takes_vectors() ? fmt::format("template <class Angle>\n{}", kInline) : kCalled;
  std::string pair = has_numbers ? pair_text(target, head, type(target)) : "";
  std::string others = has_numbers ? singles(target, functions, number_type(target)) : "";
  if (target.takes_vectors()) {
    const std::size_t most = most_angles(target.scalar);
    pair += fmt::format(
        "\n[[gnu::noinline, gnu::unused]] SineCosine<{0}> {1}({0} x) noexcept {{\n"
        "  return pair_of(x);\n}}\n",
        type_name(target.scalar), kSineCosine);
    others +=
        '\n' +
        fill(template_text("sines_cosines.cpp"),
             {{"type", type_name(target.scalar)},
              {"most", std::to_string(most)},
              {"filling",
               fmt::format("{}", fmt::join(std::vector<std::string>(most - 1, "first"), ", "))},
              {"long", elements(most)},
              {"short", elements(most / 2)}});
    others.pop_back();
  }
  const std::string order = order_of_sums(
      target.scalar,
      needs_no_numbers(target)
          ? "sine_cosine of lanes rounds by adding and subtracting, and tells what is no number: "
            "not for -ffast-math, -ffinite-math-only or x87"
          : "sine_cosine rounds by adding and subtracting: not for -ffast-math or x87; --sincos "
            "libm is",
      needs_no_numbers(target) ? kFiniteMath : "");
  return fill(template_text("sincos.cpp"),
              {{"order_of_sums", target.scalar == Scalar::kDouble ? kShortDouble + order : order},
               {"pair", pair},
               {"others", others}});
}

std::string order_of_sums(Scalar scalar, const std::string& error, const std::string& finite) {
  const bool wide = scalar == Scalar::kDouble;
  return fill(template_text("order_of_sums.cpp"), {{"finite", finite},
                                                   {"methods", wide ? "17" : "16"},
                                                   {"registers", wide ? "__SSE2__" : "__SSE__"},
                                                   {"error", error}});
}

std::string sincos_of_limbs(const Target& target, const std::string& functions) {
  const std::string argument = fmt::format("const {}&", type(target));
  std::string both = pair_text(target, kInline, argument);
  if (const std::string one = singles(target, functions, argument); !one.empty()) {
    both += one + '\n';
  }
  return both;
}

StatedSines stated_sines(Scalar scalar) {
  const Approximation& a = approximation(scalar);
  return {static_cast<double>(Real(a.error)), static_cast<double>(Real(a.range))};
}

std::string sincos_range(const Target& target) {
  const Approximation& a = approximation(target.scalar);
  return fmt::format(R"({{"error": {}, "range": {}, "end": {}}})", a.error, a.range, a.end);
}

std::string sincos_comment(const Target& target) {
  const Approximation& a = approximation(target.scalar);
  return fmt::format(
      "Sines and cosines, without contraction the same bits everywhere, have errors below {} for "
      "arguments below {} rad where results are rounded to nearest, the default of all processors; "
      "they are not a number beyond {} rad. Arguments are angles, alone "
      "or, rounded, in sums with constant ones and those of parallel axes.",
      a.error, a.range, a.end);
}

}  // namespace treedyn::emit
