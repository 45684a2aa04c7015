// A control loop of 1 kHz on a bare Cortex-M, to be copied: an interrupt, two files that `treedyn
// generate` wrote, and nothing else. `run` beside it has the commands.
//
// Here the leg is a simulation too, `landing::step` with its contact, so that the loop closes
// without a leg; on a robot encoders and motor drivers stand in its place.
#include <stdint.h>

#include "landing.hpp"
#include "leg.hpp"

namespace {

constexpr int kTurns = 1000;
constexpr float kHeld[leg::kDof] = {0, 0.6F, -1.2F};          // rad; the rail has no motor
constexpr float kStiffness[leg::kDof] = {0, 150.0F, 150.0F};  // N m/rad
constexpr float kDamping[leg::kDof] = {0, 2.0F, 2.0F};        // N m s/rad

struct Leg {
  float q[leg::kDof];
  float qd[leg::kDof];
};
Leg state = {{0.45F, 0.6F, -1.2F}, {0, 0, 0}};
int failed = 0;

/// Once a millisecond: what the motors need to carry the leg itself, and springs to where it is
/// held.
void control() {
  constexpr float at_rest[leg::kDof] = {0, 0, 0};
  float tau[leg::kDof];
  leg::inverse_dynamics(state.q, state.qd, at_rest, tau);
  for (int i = 0; i < leg::kDof; ++i) {
    tau[i] += kStiffness[i] * (kHeld[i] - state.q[i]) - kDamping[i] * state.qd[i];
  }
  tau[leg::joint::height] = 0;

  Leg next;
  failed |= landing::step(state.q, state.qd, tau, next.q, next.qd);
  state = next;
}

}  // namespace

#ifdef __arm__

namespace {

volatile int turns = 0;
volatile uint32_t longest = 0;  // cycles of SysTick
constexpr uint32_t kClock = 25000000;

volatile uint32_t* at(uint32_t address) { return reinterpret_cast<volatile uint32_t*>(address); }

/// SysTick counts down from its reload to zero, where the interrupt is.
void tick() {
  if (turns < kTurns) {
    control();
    const uint32_t spent = *at(0xE000E014) - *at(0xE000E018);
    longest = spent > longest ? spent : longest;
    turns = turns + 1;
  }
}

/// A request to the debugger, for the report only.
void request(uint32_t operation, const void* argument) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void print(uint32_t number, char end) {
  char text[12];
  char* place = text + sizeof(text);
  *--place = '\0';
  *--place = end;
  do {
    *--place = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  request(0x04, place);
}

void report() {
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &state.q[leg::joint::height], sizeof(bits));
  print(bits, ' ');
  print(static_cast<uint32_t>(failed), '\n');
  print(100 * longest / (kClock / 1000), '\n');
  request(0x18, reinterpret_cast<const void*>(0x20026));
}

[[noreturn]] void reset() {
  *at(0xE000ED88) = *at(0xE000ED88) | 0xF00000U;  // the floating-point unit
  asm volatile("dsb\n isb" : : : "memory");
  *at(0xE000E014) = kClock / 1000 - 1;
  *at(0xE000E018) = 0;
  *at(0xE000E010) = 7;  // SysTick with its interrupt, by the processor's clock
  while (turns < kTurns) {
    asm volatile("wfi");
  }
  report();
  while (true) {
  }
}

[[noreturn]] void fault() {
  request(0x18, reinterpret_cast<const void*>(0x20026));
  while (true) {
  }
}

}  // namespace

extern "C" uint32_t top_of_stack;

struct Vectors {
  uint32_t* stack;
  void (*handlers[15])();
};
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors{
    &top_of_stack,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault, tick}};

#else

#include <cstdio>
#include <cstring>

int main() {
  for (int turn = 0; turn < kTurns; ++turn) {
    control();
  }
  uint32_t bits = 0;
  std::memcpy(&bits, &state.q[leg::joint::height], sizeof(bits));
  std::printf("%u %d\n", static_cast<unsigned>(bits), failed);
  std::printf("height after 1 s: %.6f m, hip %.3f rad, knee %.3f rad\n",
              static_cast<double>(state.q[0]), static_cast<double>(state.q[1]),
              static_cast<double>(state.q[2]));
}

#endif
