// What is read off a study, from studies whose answers are known.
#include "accuracy/study.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "accuracy/chart.hpp"

namespace treedyn::accuracy {
namespace {

/// An outcome of a step that costs `additions`.
Outcome outcome(State state, const char* integrator, double step, double error, int additions) {
  Outcome result;
  result.setting = {state, integrator, step, {}};
  result.phases = {{{}, {}, {1}}};
  result.phases.front().cost.add = additions;
  result.errors[Error::kJoints] = {error, error};
  return result;
}

/// Errors h^4 above a floor of 1e-12 in double; 1e-5 in float, which rises as 1e-8 / h.
Study study_of_order_four() {
  Study study;
  for (const State state : {State::kFloat, State::kDouble}) {
    for (const double h : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001, 0.0005}) {
      const double floor = state == State::kFloat ? 1e-8 / h : 1e-12;
      study.outcomes.push_back(outcome(state, "rk4", h, std::pow(h, 4) + floor, 50));
    }
  }
  return study;
}

const Core& core(const char* name) {
  const Core* const found = find_core(name);
  EXPECT_NE(found, nullptr);
  return *found;
}

TEST(Study, FitsTheOrderAboveTheFloor) {
  const std::optional<double> order = fitted_order(study_of_order_four(), State::kDouble, "rk4");
  ASSERT_TRUE(order);
  EXPECT_NEAR(*order, 4, 0.01);
  EXPECT_FALSE(fitted_order(study_of_order_four(), State::kDouble, "euler"));
}

/// h^5 - 0.011 h^4 changes its sign at 11 ms: no order says how the error falls.
TEST(Study, FitsNoOrderThroughTermsThatCancel) {
  Study study;
  for (const double h : {0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.0001}) {
    const double error = std::fabs(std::pow(h, 5) - 0.011 * std::pow(h, 4)) + 1e-16;
    study.outcomes.push_back(outcome(State::kDouble, "rk4", h, error, 50));
  }
  EXPECT_FALSE(fitted_order(study, State::kDouble, "rk4"));
}

TEST(Study, FindsTheFloorOfAScalarAndItsStep) {
  const std::optional<Floor> floor = floor_of(study_of_order_four(), State::kFloat);
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->setting.step, 0.02);  // 1.6e-7 + 5e-7; beside it 1e-8 + 1e-6 and 6e-6 + 2e-7
  EXPECT_FALSE(floor_of(Study{}, State::kFloat));
}

TEST(Study, FindsTheFloorOfStepsThatTakeEventsAtTheirEnd) {
  Study study = study_of_order_four();
  EXPECT_FALSE(event_floor(study));
  for (const double h : {0.1, 0.01, 0.001}) {
    study.outcomes.push_back(outcome(State::kDouble, "rk4", h, h / 2, 40));
    study.outcomes.back().setting.variant.cuts = "0";
  }
  ASSERT_TRUE(event_floor(study));
  EXPECT_EQ(event_floor(study)->error, 0.0005);
  EXPECT_DOUBLE_EQ(floor_of(study, State::kDouble)->error, std::pow(0.0005, 4) + 1e-12);
}

/// The steps of the study lie between 0.1 s and 0.5 ms.
TEST(Study, DrawsStabilityLimitsThatAreInThePicture) {
  Study study = study_of_order_four();
  study.stability = {{"rk4", 0.025}, {"sdirk2", 3}};
  const std::string picture = step_chart(study);
  EXPECT_THAT(picture, testing::HasSubstr(">rk4 is stable up to 0.025 s"));
  EXPECT_THAT(picture, testing::Not(testing::HasSubstr("sdirk2")));
}

double number_behind(const std::string& text, const std::string& what, std::size_t from = 0) {
  const std::size_t at = text.find(what, from);
  EXPECT_NE(at, std::string::npos) << what;
  return std::strtod(text.c_str() + at + what.size(), nullptr);
}

/// Where the name in the picture begins: its element.
std::size_t text_with(const std::string& picture, const std::string& name) {
  return picture.rfind("<text", picture.find(name));
}

/// The names of limits stand above the plot, one above the other.
TEST(Study, NamesOfStabilityLimitsStandAboveThePlot) {
  Study study = study_of_order_four();
  study.stability = {{"dopri5-fixed", 0.06}, {"rk4", 0.025}};
  const std::string picture = step_chart(study);
  const double shorter = number_behind(picture, " y=\"", text_with(picture, "rk4 is stable"));
  const double longer = number_behind(picture, " y=\"", text_with(picture, "dopri5-fixed is"));
  const std::size_t first_of_grid = picture.find("stroke=\"#ddd\"");
  const double top = number_behind(picture, " ", picture.rfind("<path d=\"M", first_of_grid) + 10);
  EXPECT_GT(shorter - longer, 11);
  EXPECT_GT(longer, 18 + 11);    // the title
  EXPECT_LT(shorter, top - 12);  // crosses
}

/// Each line of text from its beginning to the right edge, letters about 5.8 wide.
TEST(Study, LongNamesOfMethodsFitIntoThePicture) {
  Study study = study_of_order_four();
  for (Outcome& one : study.outcomes) {
    one.setting.integrator = "semi-implicit-euler";
    one.setting.variant = {"libm", "articulated", "projection", "12", "velocity_products"};
  }
  const std::string picture = step_chart(study);
  const std::string name = method_of(study.outcomes.front().setting);
  ASSERT_GT(name.size(), 100U);
  const double left = number_behind(picture, " x=\"", text_with(picture, ">" + name + "</text>"));
  EXPECT_LT(left + 5.8 * static_cast<double>(name.size()), number_behind(picture, " width=\""));
}

/// The legend's marks and colours.
TEST(Study, ThirtyMethodsLookDifferent) {
  Study study;
  for (int k = 0; k < 30; ++k) {
    study.outcomes.push_back(outcome(State::kDouble, "rk4", 0.1, 1e-3, 1));
    study.outcomes.back().setting.variant.cuts = std::to_string(k);
  }
  const std::string picture = step_chart(study);
  std::set<std::string> looks;
  for (std::size_t at = picture.find("\"/><text"); at != std::string::npos;
       at = picture.find("\"/><text", at + 1)) {
    const std::size_t mark = picture.find('m', picture.rfind("<path d=\"M", at) + 10);
    if (mark < at && picture.substr(mark, at - mark).find(" fill=") != std::string::npos) {
      looks.insert(picture.substr(mark, at - mark));
    }
  }
  EXPECT_EQ(looks.size(), 30U);
}

TEST(Study, ErrorsOfZeroAreNotDrawn) {
  Study study;
  for (const double step : {0.1, 0.05, 0.02}) {
    study.outcomes.push_back(outcome(State::kDouble, "rk4", step, step < 0.1 ? 0 : 1e-7, 1));
  }
  const std::string picture = step_chart(study);
  EXPECT_THAT(picture, testing::HasSubstr("not drawn: 2 errors of exactly 0"));
  EXPECT_THAT(picture, testing::HasSubstr(": 1.00e-07</title>"));
  EXPECT_THAT(picture, testing::Not(testing::HasSubstr(": 0.00e+00")));
  EXPECT_THAT(picture, testing::Not(testing::HasSubstr("floor of")));
  study.outcomes.erase(study.outcomes.begin());
  const std::string nothing = step_chart(study);
  EXPECT_THAT(nothing, testing::HasSubstr("all errors are exactly 0"));
  EXPECT_THAT(nothing, testing::Not(testing::HasSubstr("</title>")));
  EXPECT_THAT(nothing, testing::Not(testing::HasSubstr(" text-anchor=\"end\">1e")));
}

/// Two floors closer than a name is high: their names stand beside their lines in their order.
TEST(Study, NamesOfNearFloorsStandAtTheirLines) {
  for (const bool plain_is_lower : {true, false}) {
    Study study;
    const double of_float = plain_is_lower ? 6e-7 : 8e-7;
    const double of_kept = plain_is_lower ? 8e-7 : 6e-7;
    for (const double step : {0.1, 0.05}) {  // shorter ones gain nothing
      study.outcomes.push_back(outcome(State::kDouble, "rk4", step, 1e-15, 1));
      study.outcomes.push_back(outcome(State::kFloat, "rk4", step, of_float, 1));
      study.outcomes.push_back(outcome(State::kCompensated, "rk4", step, of_kept, 1));
    }
    const std::string picture = step_chart(study);
    std::vector<double> lines;
    const std::string level = "<path d=\"M70 ";
    for (std::size_t at = picture.find(level); at != std::string::npos;
         at = picture.find(level, at + 1)) {
      if (picture.find("stroke-dasharray=\"2 3\"", at) < picture.find('>', at)) {
        lines.push_back(number_behind(picture, level, at));
      }
    }
    ASSERT_EQ(lines.size(), 3U);
    std::sort(lines.begin(), lines.end());
    ASSERT_LT(lines[1] - lines[0], 11);
    const std::string plain = "floor of float: ";
    const std::string kept = "floor of float compensated: ";
    const double upper =
        number_behind(picture, " y=\"", text_with(picture, plain_is_lower ? kept : plain));
    const double lower =
        number_behind(picture, " y=\"", text_with(picture, plain_is_lower ? plain : kept));
    EXPECT_NEAR(upper, lines[0] + 4, 0.1);  // the line is at half the height of its letters
    EXPECT_GT(lower, upper + 11);
    EXPECT_LT(lower, lines[1] + 4 + 11);
    const double left = number_behind(picture, " x=\"", text_with(picture, kept));
    EXPECT_GT(left, number_behind(picture, "H", picture.find(level)));
  }
}

TEST(Study, ShowsEachOfSeveralFailuresOfAStep) {
  Study study;
  for (const State state : kStates) {
    study.outcomes.push_back(outcome(state, "rk4", 0.1, std::nan(""), 1));
    study.outcomes.push_back(outcome(state, "rk4", 0.01, 1e-5, 1));
  }
  const std::string picture = step_chart(study);
  std::vector<double> places;
  for (std::size_t at = picture.find("l8 8m0"); at != std::string::npos;
       at = picture.find("l8 8m0", at + 1)) {
    places.push_back(number_behind(picture, "M", picture.rfind("d=\"", at)));
  }
  ASSERT_EQ(places.size(), 3U);
  std::sort(places.begin(), places.end());
  EXPECT_GE(places[1] - places[0], 4);
  EXPECT_GE(places[2] - places[1], 4);
}

TEST(Study, HasAParetoFrontThatFallsInErrorAsItRisesInCost) {
  const Study study = study_of_order_four();
  for (const Core& on : cores()) {
    const std::vector<std::size_t> front = pareto(study, on);
    ASSERT_GE(front.size(), 3U);
    for (std::size_t k = 1; k < front.size(); ++k) {
      const Outcome& before = study.outcomes[front[k - 1]];
      const Outcome& behind = study.outcomes[front[k]];
      EXPECT_GT(behind.cycles_per_second(on), before.cycles_per_second(on));
      EXPECT_LT(behind.error(), before.error());
    }
  }
}

TEST(Study, ChoosesTheCheapestThatReachesTheTarget) {
  const Study study = study_of_order_four();
  const std::optional<std::size_t> coarse = cheapest(study, core("m4f"), 1e-5);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(text_of(study.outcomes[*coarse].setting), "float rk4 0.05");
  const std::optional<std::size_t> fine = cheapest(study, core("m4f"), 1e-8);
  ASSERT_TRUE(fine);
  EXPECT_EQ(text_of(study.outcomes[*fine].setting), "double rk4 0.005");
  EXPECT_FALSE(cheapest(study, core("m4f"), 1e-20));
  const std::size_t best = most_accurate(study, core("m4f")).value();
  EXPECT_EQ(study.outcomes[best].setting.step, 0.0005);  // the floor, in double
}

/// 6.5e-6 at 50 ms reaches 1e-5 if the reference is known to 1e-6, not if to 5e-6.
TEST(Study, AllowsForWhatTheReferencesDifferBy) {
  Study study = study_of_order_four();
  study.reference.agreement = 1e-6;
  EXPECT_EQ(study.outcomes[cheapest(study, core("m4f"), 1e-5).value()].setting.step, 0.05);
  study.reference.agreement = 5e-6;
  EXPECT_EQ(study.outcomes[cheapest(study, core("m4f"), 1e-5).value()].setting.step, 0.02);
  EXPECT_FALSE(cheapest(study, core("m4f"), 1e-6));
}

/// A check that is off by what it is known to says nothing; by more, that one of them is wrong.
TEST(Study, ChoosesNothingThatTheCheckContradicts) {
  Study study = study_of_order_four();
  study.reference.check = "simulate";
  study.reference.check_error = 1e-4;
  study.reference.check_difference = 5e-4;
  EXPECT_TRUE(cheapest(study, core("m4f"), 1e-5));
  study.reference.check_difference = 1.1e-3;
  EXPECT_TRUE(study.reference.refuted());
  EXPECT_FALSE(cheapest(study, core("m4f"), 1e-5));
  EXPECT_TRUE(cheapest(study, core("m4f"), 1e-2));
}

/// Of 1, 2 and 4 e-6 the logarithms have mean log 2e-6 and deviation log 2; Student's t of two
/// degrees of freedom is (2 p - 1) / sqrt(2 p (1 - p)).
TEST(Study, ExpectsMoreOfOtherStatesThanTheLargestErrorOfThose) {
  Outcome one = outcome(State::kFloat, "rk4", 0.01, 1e-6, 1);
  EXPECT_DOUBLE_EQ(one.expected(), 1e-6);  // all the same
  one.errors[Error::kJoints] = {2e-6, 1e-6, 4e-6};
  const double t = 0.9 / std::sqrt(2 * 0.95 * 0.05);
  EXPECT_NEAR(one.expected(), 2e-6 * std::exp(t * std::log(2) * std::sqrt(4.0 / 3)), 1e-18);
  one.errors[Error::kJoints] = {3e-6};
  EXPECT_EQ(one.expected(), 3e-6);
}

TEST(Study, NamesSensitiveStates) {
  Study study;
  study.states = 4;
  study.outcomes = {outcome(State::kFloat, "rk4", 0.1, 1, 1),
                    outcome(State::kFloat, "rk4", 0.05, 1, 1)};
  study.outcomes[0].errors[Error::kJoints] = {1e-5, 1e-5, 2e-3, 1e-5};
  study.outcomes[1].errors[Error::kJoints] = {1e-5, 2e-5, 9e-4, 3e-5};
  const std::vector<Sensitive> found = sensitive_states(study);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].state, 3);
  EXPECT_EQ(found[0].settings, 1U);
  EXPECT_EQ(found[0].worst.step, 0.1);
}

/// The shortest of the steps is no floor unless it gains less than order one.
TEST(Study, TellsAFloorFromTheEndOfTheSteps) {
  EXPECT_TRUE(floor_of(study_of_order_four(), State::kFloat)->is_reached);
  EXPECT_TRUE(floor_of(study_of_order_four(), State::kDouble)->is_reached);
  Study study;
  study.outcomes = {outcome(State::kDouble, "rk4", 0.1, 1e-4, 1),
                    outcome(State::kDouble, "rk4", 0.05, 1e-5, 1)};
  EXPECT_FALSE(floor_of(study, State::kDouble)->is_reached);
  study.outcomes.push_back(outcome(State::kDouble, "rk4", 0.025, 9e-6, 1));
  EXPECT_TRUE(floor_of(study, State::kDouble)->is_reached);
}

/// 30 steps of 10 additions and 10 of 50, of 0.1 s each.
TEST(Study, CountsStepsInTheirPhase) {
  Outcome one = outcome(State::kFloat, "rk4", 0.1, 1, 10);
  one.phases.front().count.steps = 30;
  one.phases.push_back({{}, {}, {10}});
  one.phases.back().cost.add = 50;
  EXPECT_EQ(one.step_cost().add, 20);
  const double of_addition = core("m4f").single.cycles.add;
  EXPECT_DOUBLE_EQ(one.cycles_per_second(core("m4f")), 20 * of_addition / 0.1);
  EXPECT_DOUBLE_EQ(one.most_cycles(core("m4f")), 50 * of_addition);
}

TEST(Study, NeverChoosesWhatFailed) {
  Study study;
  const double infinity = std::numeric_limits<double>::infinity();
  study.outcomes = {outcome(State::kFloat, "rk4", 0.1, infinity, 1),
                    outcome(State::kFloat, "rk4", 0.05, 1, 1),
                    outcome(State::kFloat, "rk4", 0.02, std::nan(""), 1)};
  EXPECT_TRUE(study.outcomes[0].failed());
  EXPECT_TRUE(study.outcomes[2].failed());
  EXPECT_THAT(pareto(study, core("host")), testing::ElementsAre(1U));
  EXPECT_EQ(cheapest(study, core("host"), 2), 1U);
}

TEST(Study, CountsCyclesOfASecond) {
  const Outcome one = outcome(State::kFloat, "rk4", 0.01, 1, 10);
  const Prices& of = core("m4f").single.cycles;
  EXPECT_DOUBLE_EQ(one.cycles_per_second(core("m4f")), 10 * of.add / 0.01);
}

/// sin a, cos b, sin c and cos c: both are computed of each angle, two or four at once in vectors.
TEST(Study, CountsAPairOfSineAndCosineForEveryAngle) {
  program::Graph graph;
  const program::Ref c = graph.input(0, 2);
  const std::vector<program::Ref> outputs = {
      graph.sin(graph.input(0, 0)), graph.cos(graph.input(0, 1)), graph.sin(c), -graph.cos(c)};
  const program::Cost cost = program::cost(graph, outputs);
  EXPECT_EQ(cost.sin, 2);
  EXPECT_EQ(cost.cos, 2);
  EXPECT_EQ((2 * cost + cost).angles, 9);
  for (const char* const name : {"m4f", "host"}) {
    const Core& on = core(name);
    EXPECT_DOUBLE_EQ(cycles(cost, on, {}), 3 * on.single.cycles.pair);
    EXPECT_DOUBLE_EQ(cycles(cost, on, {.angles = 2}), 2 * on.single.cycles.pair);
    EXPECT_DOUBLE_EQ(cycles(cost, on, {.angles = 4}), on.single.cycles.pair);
    EXPECT_DOUBLE_EQ(cycles(4 * cost, on, {.angles = 4}), 4 * on.single.cycles.pair);
  }
}

}  // namespace
}  // namespace treedyn::accuracy
