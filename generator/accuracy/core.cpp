#include "accuracy/core.hpp"

#include <algorithm>

namespace treedyn::accuracy {

namespace {

/// Software floating point: a cycle and a fifth for an instruction (taken branches, loads), and
/// nothing to fuse.
Precision in_software(Prices of) {
  constexpr double kCycles = 1.2;
  of.fused = of.add + of.mul;
  of.fused_pair = of.pair;
  return {{kCycles * of.add, kCycles * of.mul, kCycles * of.div, kCycles * of.sqrt,
           kCycles * of.pair, kCycles * of.libm, kCycles * of.fused, kCycles * of.fused_pair},
          of};
}

/// Instructions of sums, products, pairs and fused products are fitted to those that QEMU and
/// callgrind count in the functions of tests/firmware, which holds them (fused ones on the host
/// were counted in the text of three functions); those of square roots, of quotients in software
/// and of the C library (newlib's sin and cos of angles below 1.5 rad) were counted once.
///
/// Cycles of the Cortex-M4F are fitted to the sums over executed instructions of the benchmark's
/// firmware.md, -O2, each with its cycles after ARM's technical reference manual (VADD, VMUL 1,
/// VFMA 3, loads and stores 2, jumps 3, VDIV and VSQRT 14): of the biped A comes out 12 % too low,
/// G 6 %, B 2 %, tau 4 % and forward dynamics 1 % too high; of code of --core m4f, which forbids
/// -fschedule-insns, A 2 % and tau 6 % too high, G 5 %, B and forward dynamics 1 % too low. The
/// M33 is taken for the same core. M7 and host are estimates: a core with two pipes, and one that
/// issues three instructions a cycle; what contraction adds to or takes from them is that of the
/// models of llvm-mca for the Cortex-M7 and for Haswell.
const std::vector<Core> kCores = {
    {"m0plus",
     "Cortex-M0+, software floating point",
     in_software({56, 135, 383, 583, 3810, 4500}),
     in_software({135, 305, 650, 1250, 10350, 9750}),
     {"-mcpu=cortex-m0plus", "-mfloat-abi=soft"}},
    {"m4f",
     "Cortex-M4F",
     {{2.4, 2.4, 14, 14, 78, 220, 5.9, 103}, {1.53, 1.53, 1, 1, 71, 180, 2.2, 62}},
     in_software({72, 53, 575, 667, 2640, 3000}),
     {"-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"},
     true},
    {"m33",
     "Cortex-M33 with FPU",
     {{2.4, 2.4, 14, 14, 81, 220, 5.9, 106}, {1.53, 1.53, 1, 1, 74, 180, 2.2, 66}},
     in_software({72, 53, 575, 667, 2640, 3000}),
     {"-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"},
     true},
    {"m7",
     "Cortex-M7 with double FPU",
     {{1.2, 1.2, 16, 14, 58, 110, 3.1, 66}, {1.53, 1.53, 1, 1, 73, 180, 2.3, 66}},
     {{1.7, 1.9, 30, 28, 84, 210, 4.0, 86}, {1.48, 1.48, 1, 1, 73, 180, 3.0, 72}},
     {"-mcpu=cortex-m7", "-mfloat-abi=hard", "-mfpu=fpv5-d16"}},
    {"host",
     "desktop core, scalar",
     {{0.65, 0.65, 5, 6, 16, 30, 1.2, 14}, {1.93, 1.93, 2, 2, 82, 140, 3.06, 69}},
     {{0.65, 0.65, 8, 9, 22, 50, 1.2, 17}, {1.88, 1.88, 2, 2, 84, 140, 2.96, 66}}}};

double price(const program::Cost& cost, const Prices& of, const Build& build) {
  const int fused = build.contracted ? cost.fused : 0;
  const int pairs = build.angles == 4 ? cost.fours : build.angles == 2 ? cost.twos : cost.angles;
  const double pair = build.libm ? of.libm : build.contracted ? of.fused_pair : of.pair;
  return (cost.add - fused) * of.add + (cost.mul - fused) * of.mul + fused * of.fused +
         cost.div * of.div + cost.sqrt * of.sqrt + pairs * pair;
}

const Precision& precision(const Core& core, const Build& build) {
  return build.is_float ? core.single : core.twice;
}

}  // namespace

const std::vector<Core>& cores() { return kCores; }

const Core* find_core(std::string_view name) {
  const auto found = std::ranges::find(kCores, name, &Core::name);
  return found == kCores.end() ? nullptr : &*found;
}

double cycles(const program::Cost& cost, const Core& core, const Build& build) {
  return price(cost, precision(core, build).cycles, build);
}

double instructions(const program::Cost& cost, const Core& core, const Build& build) {
  return price(cost, precision(core, build).instructions, build);
}

}  // namespace treedyn::accuracy
