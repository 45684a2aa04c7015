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
/// by a test. Sines of the C library: instructions of newlib's sin and cos under QEMU, of angles
/// below 1.5 rad, a cycle and a fifth each; of the host estimates.
const std::vector<Core> kCores = {{"m0plus",
                                   "Cortex-M0+, software floating point",
                                   {106, 140, 460, 700, 5200, 5400, 4},
                                   {184, 350, 779, 1500, 14000, 11700, 8},
                                   {"-mcpu=cortex-m0plus", "-mfloat-abi=soft"}},
                                  {"m4f",
                                   "Cortex-M4F",
                                   {1, 1, 14, 14, 62, 220, 1},
                                   {96, 60, 690, 800, 2300, 3600, 4},
                                   {"-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"}},
                                  {"m33",
                                   "Cortex-M33 with FPU",
                                   {1, 1, 14, 14, 60, 220, 1},
                                   {96, 60, 690, 800, 2300, 3600, 4},
                                   {"-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"}},
                                  {"m7",
                                   "Cortex-M7 with double FPU",
                                   {0.8, 0.8, 16, 14, 45, 110, 0.4},
                                   {1, 1.3, 30, 28, 62, 210, 0.6},
                                   {"-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"}},
                                  {"host",
                                   "desktop core, scalar",
                                   {0.5, 0.5, 5, 6, 16, 30, 0.15},
                                   {0.5, 0.5, 8, 9, 22, 50, 0.15}}};

}  // namespace

const std::vector<Core>& cores() { return kCores; }

const Core* find_core(std::string_view name) {
  const auto found = std::find_if(kCores.begin(), kCores.end(),
                                  [&](const Core& core) { return core.name == name; });
  return found == kCores.end() ? nullptr : &*found;
}

double cycles(const program::Cost& cost, const Core& core, bool is_float, bool libm) {
  const Cycles& of = is_float ? core.single : core.twice;
  return cost.add * (of.add + of.memory) + cost.mul * (of.mul + of.memory) + cost.div * of.div +
         cost.sqrt * of.sqrt + std::max(cost.sin, cost.cos) * (libm ? of.libm : of.pair);
}

}  // namespace treedyn::accuracy
