#include "emit/taken_names.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "common/identifier.hpp"

namespace treedyn::emit {

namespace {

/// Types, namespaces, helpers and arguments; in C99 the functions for sin and cos, and a macro.
constexpr const char* kOwn =
    "Angle Angles Bits DerivedParameters Moment Motion NOINLINE Number Parameters Scalar "
    "SineCosine add advance anchors approach approaches begins_to_fall below_zero check chord "
    "compare cosine cut derived dip dips due dynamics_in earlier factor_stage "
    "falls_from_plane falls_now find_event find_stage first_event guards h happen integrate "
    "integrate_part joint literals_are_double look move_stage next_clock note pair_of phase point "
    "press sine "
    "sine_cosine sines_cosines solve_stage status store store_sines_cosines try_step way "
    "weigh";

/// Behind these stands a number, or a name of the scene or of the model.
constexpr std::string_view kBeginnings[] = {
    "known_", "Limbs",       "phase_",         "status_",          "guards_", "approaches_",
    "press_", "solve_rows_", "solve_regular_", "solve_deficient_", "treedyn_"};

/// Types of C99, behind the prefix.
constexpr std::string_view kTypesOfC[] = {"_Scalar", "_Parameters", "_DerivedParameters"};

/// Macros and constants of C99, behind the prefix in capitals; the guard of the header.
constexpr std::string_view kMacros[] = {
    "DOF",    "POINTS", "MASS_MATRIX_NONZEROS", "MASS_MATRIX_ROW", "MASS_MATRIX_COLUMN", "STEP",
    "DIGEST", "H",      "NOMINAL_PARAMETERS",
};

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

/// kDof: k, a capital letter, and more.
bool is_constant(std::string_view name) {
  return name.size() > 2 && name[0] == 'k' && is_capital(name[1]);
}

bool is_macro(std::string_view name) {
  const auto is_small = [](char c) {
    return c >= 'a' && c <= 'z';
  };
  return std::ranges::none_of(name, is_small) &&
         std::ranges::any_of(kMacros, [&](std::string_view macro) {
           const std::size_t before = name.size() - std::min(name.size(), macro.size());
           return name.ends_with(macro) && (before == 0 || name[before - 1] == '_');
         });
}

}  // namespace

bool is_own_name(std::string_view name) {
  const auto begins = [&](std::string_view beginning) {
    return name.starts_with(beginning);
  };
  const auto ends = [&](std::string_view ending) {
    return name.ends_with(ending);
  };
  static const std::vector<std::string> own = words_in(kOwn);
  return std::ranges::find(own, name) != own.end() || is_constant(name) || is_macro(name) ||
         std::ranges::any_of(kBeginnings, begins) || std::ranges::any_of(kTypesOfC, ends);
}

bool is_part_of(std::string_view name, std::string_view function) {
  constexpr std::string_view kLimb = "limb_";
  if (!name.starts_with(function) || name.size() < function.size() + 2 ||
      name[function.size()] != '_') {
    return false;
  }
  std::string_view number = name.substr(function.size() + 1);
  number = number.starts_with(kLimb) ? number.substr(kLimb.size()) : number;
  return !number.empty() &&
         std::ranges::all_of(number, [](char c) { return is_digit(c) || c == '_'; });
}

}  // namespace treedyn::emit
