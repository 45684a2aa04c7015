// Several states at once, and sine and cosine without a library: the same values as one state with
// libm.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "lanes_double.hpp"
#include "lanes_float.hpp"
#include "libm_double.hpp"
#include "pair_double.hpp"
#include "pair_float.hpp"

namespace {

constexpr int kDof = libm_double::kDof;
using Vector = std::array<double, kDof>;
using Matrix = std::array<double, kDof * kDof>;

/// Relative error that the absolute errors of sine and cosine (1.7e-16, 1e-7) and the rounding of
/// some 400 operations on values of one size leave: 400 eps.
constexpr double kDoubleTolerance = 400 * 1.7e-16;
constexpr double kFloatTolerance = 400 * 1e-7;

struct State {
  Vector q;
  Vector qd;
  Vector qdd;
};

std::vector<State> states(std::size_t count) {
  std::mt19937_64 random(3);
  const auto next = [&](double limit) {
    return limit * (static_cast<double>(random() >> 11U) * 0x1p-52 - 1);
  };
  std::vector<State> result(count);
  for (State& state : result) {
    for (std::size_t i = 0; i < kDof; ++i) {
      state.q[i] = static_cast<float>(next(10));
      state.qd[i] = static_cast<float>(next(3));
      state.qdd[i] = static_cast<float>(next(5));
    }
  }
  result.front() = {};
  return result;
}

template <std::size_t size>
void expect_near(const std::array<double, size>& values, const std::array<double, size>& expected,
                 double tolerance) {
  double largest = 0;
  for (const double value : expected) {
    largest = std::max(largest, std::abs(value));
  }
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_NEAR(values[i], expected[i], tolerance * largest) << "element " << i;
  }
}

Vector reference_tau(const State& state) {
  Vector tau;
  libm_double::inverse_dynamics(state.q.data(), state.qd.data(), state.qdd.data(), tau.data());
  return tau;
}

template <class Scalar, class Function>
void expect_pair_agrees(Function inverse_dynamics, double tolerance) {
  for (const State& state : states(500)) {
    std::array<Scalar, kDof> q, qd, qdd, tau;
    std::copy(state.q.begin(), state.q.end(), q.begin());
    std::copy(state.qd.begin(), state.qd.end(), qd.begin());
    std::copy(state.qdd.begin(), state.qdd.end(), qdd.begin());
    inverse_dynamics(q.data(), qd.data(), qdd.data(), tau.data());
    Vector values;
    std::copy(tau.begin(), tau.end(), values.begin());
    expect_near(values, reference_tau(state), tolerance);
  }
}

TEST(PairOfSineAndCosine, GiveTheValuesOfTheLibraryInDouble) {
  expect_pair_agrees<double>(pair_double::inverse_dynamics, kDoubleTolerance);
}

TEST(PairOfSineAndCosine, GiveTheValuesOfTheLibraryInFloat) {
  expect_pair_agrees<float>(pair_float::inverse_dynamics, kFloatTolerance);
}

template <class Scalar, int lanes, class Element, class Function, class MassMatrix>
void expect_lanes_agree(Function inverse_dynamics, MassMatrix mass_matrix, double tolerance) {
  const std::vector<State> all = states(40 * lanes);
  for (std::size_t first = 0; first < all.size(); first += lanes) {
    std::array<Scalar, kDof> q, qd, qdd, tau;
    std::array<Scalar, kDof * kDof> a;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      for (std::size_t i = 0; i < kDof; ++i) {
        q[i][lane] = static_cast<Element>(all[first + lane].q[i]);
        qd[i][lane] = static_cast<Element>(all[first + lane].qd[i]);
        qdd[i][lane] = static_cast<Element>(all[first + lane].qdd[i]);
      }
    }
    inverse_dynamics(q.data(), qd.data(), qdd.data(), tau.data());
    mass_matrix(q.data(), a.data());
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const State& state = all[first + lane];
      Vector values;
      Matrix matrix, expected;
      for (std::size_t i = 0; i < kDof; ++i) {
        values[i] = static_cast<double>(tau[i][lane]);
      }
      for (std::size_t i = 0; i < matrix.size(); ++i) {
        matrix[i] = static_cast<double>(a[i][lane]);
      }
      libm_double::mass_matrix(state.q.data(), expected.data());
      expect_near(values, reference_tau(state), tolerance);
      expect_near(matrix, expected, tolerance);
    }
  }
}

TEST(Lanes, GiveTheValuesOfSingleStatesInDouble) {
  expect_lanes_agree<lanes_double::Scalar, lanes_double::kLanes, double>(
      lanes_double::inverse_dynamics, lanes_double::mass_matrix, kDoubleTolerance);
}

TEST(Lanes, GiveTheValuesOfSingleStatesInFloat) {
  expect_lanes_agree<lanes_float::Scalar, lanes_float::kLanes, float>(
      lanes_float::inverse_dynamics, lanes_float::mass_matrix, kFloatTolerance);
}

}  // namespace
