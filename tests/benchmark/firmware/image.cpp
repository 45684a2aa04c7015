// Calls one generated function CALLS times on a bare Cortex-M4F and ends the emulator.
// FUNCTION and ARGUMENTS (of q, qd, x, out) come from the command line of the compiler.
#include <cstdint>

#include "generated.hpp"

namespace {

using generated::Scalar;
constexpr int kDof = generated::kDof;

Scalar q[kDof], qd[kDof], x[kDof], out[kDof * kDof];

[[noreturn]] void stop() {
  register std::uint32_t operation asm("r0") = 0x18;  // SYS_EXIT
  register std::uint32_t reason asm("r1") = 0x20026;  // ADP_Stopped_ApplicationExit
  asm volatile("bkpt 0xab" : : "r"(operation), "r"(reason) : "memory");
  while (true) {
  }
}

void reset() {
  auto* const coprocessors = reinterpret_cast<volatile std::uint32_t*>(0xE000ED88);
  *coprocessors = *coprocessors | 0xF00000U;  // the floating-point unit
  asm volatile("dsb\n isb" : : : "memory");
  for (int i = 0; i < kDof; ++i) {
    q[i] = 0.1f * static_cast<Scalar>(i - 5);
    qd[i] = 0.2f * static_cast<Scalar>(i);
    x[i] = 0.3f;
  }
  for (int i = 0; i < CALLS; ++i) {
    generated::FUNCTION ARGUMENTS;
    asm volatile("" : : : "memory");
  }
  stop();
}

}  // namespace

extern "C" std::uint32_t top_of_stack;

struct Vectors {
  std::uint32_t* stack;
  void (*reset)();
};
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors{&top_of_stack, reset};
