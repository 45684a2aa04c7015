// Independent tasks on several cores: order of results, errors, what they learn of numbers.
#include "common/parallel.hpp"

#include <atomic>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "common/provenance.hpp"

namespace treedyn {
namespace {

using Tasks = std::vector<std::function<int()>>;

TEST(Parallel, ResultsStandInTheOrderOfTheTasks) {
  for (const int threads : {1, 2, 5}) {
    set_threads(threads);
    Tasks tasks;
    std::vector<int> expected;
    for (int k = 0; k < 100; ++k) {
      tasks.emplace_back([k] { return k * k; });
      expected.push_back(k * k);
    }
    EXPECT_EQ(results_of(tasks), expected);
  }
}

TEST(Parallel, TasksHaveTasks) {
  for (const int threads : {1, 2, 5}) {
    set_threads(threads);
    const auto sum = [](int of) {
      const std::vector<int> parts = results_of(Tasks{[of] { return of; },
                                                      [] {
                                                        return 1;
                                                      }});
      return parts[0] + parts[1];
    };
    EXPECT_EQ(results_of(Tasks{[&] { return sum(10); },
                               [&] {
                                 return sum(20);
                               }}),
              (std::vector<int>{11, 21}));
  }
}

TEST(Parallel, TheFirstErrorInTheirOrderIsThrownWhenAllAreDone) {
  set_threads(3);
  std::atomic<int> done = 0;
  Tasks tasks;
  for (int k = 0; k < 20; ++k) {
    tasks.emplace_back([&, k] {
      ++done;
      if (k % 7 == 3) {
        throw std::runtime_error(std::to_string(k));
      }
      return k;
    });
  }
  try {
    results_of(tasks);
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
  EXPECT_EQ(done, 20);
}

/// A mass and a length, and their product made of stand-ins in each of two tasks.
TEST(Parallel, TasksKnowTheNumbersOfTheCallerWhoLearnsTheirs) {
  set_threads(2);
  const Real mass = Real::seen_as(2, Digits("1.234567"));
  const Real length = Real::seen_as(3, Digits("2.345678"));
  begin_provenance({{mass, {{{0, ModelPart::kMass, 0}}, {1, 0, 0, true}}},
                    {length, {{{0, ModelPart::kPlace, 0}}, {0, 1, 0, true}}}});
  const std::function<Real()> once = [&] {
    return mass * length;
  };
  const std::function<Real()> twice = [&] {
    return mass * length * length;
  };
  const std::vector<Real> made = results_of<Real>({once, twice});
  for (std::size_t k = 0; k < 2; ++k) {
    const std::optional<Provenance> known = provenance_of(made[k]);
    ASSERT_TRUE(known);
    EXPECT_EQ(known->origins.size(), 2U);
    EXPECT_EQ(known->dimension.length, static_cast<int>(k) + 1);
  }
}

}  // namespace
}  // namespace treedyn
