#include "accuracy/core.hpp"

#include <algorithm>

namespace treedyn::accuracy {

namespace {

/// Cortex-M4F and M33: ARM's technical reference manuals (VADD, VMUL 1, VDIV, VSQRT 14, VLDR, VSTR
/// 2 cycles). `memory` is half a load or store for each operation: 1.5 instructions an operation
/// are executed in generated functions of the biped (results/firmware.md of the benchmark). Their
/// double, and all of M0+, is software: sums, products and quotients are instructions of libgcc's
/// routines, counted under QEMU for one pair of operands, each a cycle and a fifth (taken branches,
/// loads); square roots and sines there are estimates from those. M7 and host are estimates: a core
/// with two pipes and a double FPU, and one that issues two operations a cycle. None is calibrated
/// by a test.
const std::vector<Core> kCores = {
    {"m0plus",
     "Cortex-M0+, software floating point",
     {106, 140, 460, 700, 5200, 4},
     {184, 350, 779, 1500, 14000, 8}},
    {"m4f", "Cortex-M4F", {1, 1, 14, 14, 62, 1}, {96, 60, 690, 800, 2300, 4}},
    {"m33", "Cortex-M33 with FPU", {1, 1, 14, 14, 60, 1}, {96, 60, 690, 800, 2300, 4}},
    {"m7", "Cortex-M7 with double FPU", {0.8, 0.8, 16, 14, 45, 0.4}, {1, 1.3, 30, 28, 62, 0.6}},
    {"host", "desktop core, scalar", {0.5, 0.5, 5, 6, 16, 0.15}, {0.5, 0.5, 8, 9, 22, 0.15}}};

}  // namespace

const std::vector<Core>& cores() { return kCores; }

const Core* find_core(std::string_view name) {
  const auto found = std::find_if(kCores.begin(), kCores.end(),
                                  [&](const Core& core) { return core.name == name; });
  return found == kCores.end() ? nullptr : &*found;
}

double cycles(const program::Cost& cost, const Core& core, bool is_float) {
  const Cycles& of = is_float ? core.single : core.twice;
  return cost.add * (of.add + of.memory) + cost.mul * (of.mul + of.memory) + cost.div * of.div +
         cost.sqrt * of.sqrt + std::max(cost.sin, cost.cos) * of.pair;
}

}  // namespace treedyn::accuracy
