// What users should know of the numbers of programs.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "program/rounding.hpp"
#include "stages/stages.hpp"

namespace treedyn {

namespace {

template <class Check>
void for_each_function(const program::Programs& programs, Check check) {
  for (const program::Function& function : programs.functions) {
    check(function.signature.name, function);
  }
  for (const program::Staged& staged : programs.staged) {
    check(staged.signature.name, staged.function);
  }
}

/// What float may lose of the largest result at some ordinary state before there is a warning.
constexpr double kFloatLoses = 1e-2;

/// What the rounding of K in float does to the solution of K x = b, as a part of it: that of an
/// entry, over the smallest pivot of ordinary states, in the best of them.
double error_of_rows(const program::RowSolve& solve) {
  constexpr double kRounding = 0x1p-24;
  return solve.least > 0 ? solve.rows * kRounding / solve.least : 0;
}

}  // namespace

std::vector<Warning> float_warnings(const program::Programs& programs, emit::Scalar scalar,
                                    const Location& where) {
  std::vector<Warning> result;
  const auto check = [&](const std::string& name, const program::Function& function) {
    const double error = program::float_error(function);
    if (!(error <= kFloatLoses)) {
      result.push_back(
          {where, fmt::format("function '{}' {} in float at some ordinary state, and no status "
                              "tells; expected double, or masses and lengths of more equal size",
                              name,
                              std::isfinite(error)
                                  ? fmt::format("is off by {:.1g} of its largest result", error)
                                  : "has no result")});
    }
  };
  if (scalar != emit::Scalar::kFloat) {
    return result;
  }
  for_each_function(programs, check);
  for (const program::Staged& staged : programs.staged) {
    for (const program::RowSolve& solve : staged.solves) {
      const double error = error_of_rows(solve);
      if (error > kFloatLoses) {
        result.push_back(
            {where,
             fmt::format(
                 "function '{}': in float forces (or impulses) of constraints are off by {:.1g} "
                 "of their size or rows are lost (status rank_lost), as a row depends "
                 "on the others but for {:.1g} of its own size; expected double, or "
                 "masses and points that tell the rows apart",
                 staged.signature.name, std::min(error, 1.0), solve.least)});
      }
    }
  }
  return result;
}

namespace {

/// Without an initial state a scene begins at zeros, where many robots are singular.
std::vector<Warning> singular_beginnings(const program::Programs& programs, const Model& model,
                                         const Location& where) {
  std::vector<Warning> result;
  const auto is_zero = [](const Real& x) {
    return x == 0;
  };
  if (!model.scene || !std::ranges::all_of(model.scene->q0, is_zero)) {
    return result;
  }
  for (const program::Staged& staged : programs.staged) {
    for (const program::RowSolve& solve : staged.solves) {
      if (solve.elsewhere > solve.rank) {
        result.push_back(
            {where, fmt::format("function '{}': where the scene begins, with all joints at 0, its "
                                "{} rows have rank {}, and {} elsewhere; what is generated is for "
                                "motions from there; if positions count to which none leads (an "
                                "arm that begins stretched), give an initial position",
                                staged.signature.name, solve.rows, solve.rank, solve.elsewhere)});
      }
    }
  }
  return result;
}

}  // namespace

std::vector<Warning> warnings_of(const program::Programs& programs, const Model& model,
                                 const Request& request) {
  const Location where{request.scene.value_or(request.model), 0, 0};
  std::vector<Warning> result = singular_beginnings(programs, model, where);
  for_each_function(programs, [&](const std::string& name, const program::Function& function) {
    const program::Rounding& rounding = function.rounding;
    if (rounding.refused > 0) {
      result.push_back(
          {where, fmt::format(
                      "function '{}' is generated without {}: {} by it", name,
                      fmt::join(rounding.left_out, ", "),
                      std::isfinite(rounding.refused)
                          ? fmt::format("rounding errors would grow {:.2g} times", rounding.refused)
                          : "values that are exact would be rounded")});
    }
  });
  const std::vector<Warning> lost = float_warnings(programs, request.target.scalar, where);
  result.insert(result.end(), lost.begin(), lost.end());
  return result;
}

}  // namespace treedyn
