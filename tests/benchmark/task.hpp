// From the list of robots to what competes on them.
#pragma once

#include <memory>
#include <vector>

#include "benchmark/contestant.hpp"
#include "benchmark/robots.hpp"

namespace treedyn::benchmark {

/// The robot as every engine is given it, and random states: q in [-pi, pi], the rest in [-1,
/// 1].
Task make_task(const RobotInfo& robot);

/// Generated code first (libm, default options), the block form, then the engines that read the
/// robot. \pre `task` outlives the result
std::vector<std::unique_ptr<Contestant>> contestants(const Task& task, const RobotInfo& robot);

/// The largest error of a contestant over 16 states against the recursive oracle at 50 digits,
/// relative to the largest entry; of forward dynamics the joint forces that the error amounts to.
/// \throws std::runtime_error if it exceeds the rounding of a correct engine
double checked_error(const Task& task, Contestant& contestant, Quantity quantity);

}  // namespace treedyn::benchmark
