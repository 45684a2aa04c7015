// Start-up code of a bare Cortex-M and, for every function, a line on the debugger's console: name,
// hash of its results, instructions and bytes of stack of one call, everything below it included.
//
// Instructions are counted by SysTick under qemu's -icount, which gives every instruction the same
// time; a loop of known length says how many ticks that is.
#include "exercise.hpp"

namespace {

constexpr uint32_t kPaint = 0xa5a5a5a5U;
constexpr int kPainted = 16384;  // words

volatile uint32_t* at(uint32_t address) { return reinterpret_cast<volatile uint32_t*>(address); }

/// A request to the debugger that emulates the console.
void request(uint32_t operation, const void* argument) {
  register uint32_t r0 asm("r0") = operation;
  register const void* r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void print(const char* text) { request(0x04, text); }

void print(uint32_t number, uint32_t base) {
  char digits[12];
  char* place = digits + sizeof(digits);
  *--place = '\0';
  const char* const least = base == 16 ? place - 8 : place - 1;
  while (number != 0 || place > least) {
    *--place = "0123456789abcdef"[number % base];
    number /= base;
  }
  print(place);
}

uint32_t ticks() { return *at(0xE000E018); }

[[gnu::noinline]] void loop(uint32_t turns) {
  asm volatile("1: sub %0, #1\n cmp %0, #0\n bne 1b" : "+l"(turns) : : "cc");
}

int nothing() {
  asm volatile("");
  return 0;
}

/// Ticks between two readings of the clock around a call.
[[gnu::noinline]] uint32_t ticks_of(int (*call)()) {
  const uint32_t begin = ticks();
  call();
  return (begin - ticks()) & 0xffffffU;
}

/// Bytes of stack that a call writes to.
[[gnu::noinline]] uint32_t stack_of(int (*call)()) {
  volatile uint32_t* top = nullptr;
  asm volatile("mov %0, sp" : "=r"(top));
  for (int k = 1; k <= kPainted; ++k) {
    top[-k] = kPaint;
  }
  call();
  int used = kPainted;
  while (used > 0 && top[-used] == kPaint) {
    --used;
  }
  return 4U * static_cast<uint32_t>(used);
}

void report(const Call& call, uint32_t ticks_of_3000) {
  print(call.name);
  print(" ");
  print(hash_of(call), 16);
  uint32_t state = 1;
  draw(call, &state);
  const uint32_t spent = ticks_of(call.call) - ticks_of(nothing);
  const uint32_t whole = spent / ticks_of_3000 * 3000;
  const uint32_t rest = spent % ticks_of_3000;
  print(" ");
  print(whole + (rest * 3000 + ticks_of_3000 / 2) / ticks_of_3000, 10);
  print(" ");
  print(stack_of(call.call), 10);
  print("\n");
}

[[noreturn]] void reset() {
#ifdef __ARM_FP
  *at(0xE000ED88) = *at(0xE000ED88) | 0xF00000U;  // the floating-point unit
  asm volatile("dsb\n isb" : : : "memory");
#endif
  *at(0xE000E014) = 0xffffffU;
  *at(0xE000E018) = 0;
  *at(0xE000E010) = 5;  // SysTick counts the processor's clock
  const uint32_t begin = ticks();
  loop(1000);
  const uint32_t ticks_of_3000 = (begin - ticks()) & 0xffffffU;
  for (int k = 0; k < kCallsSize; ++k) {
    report(kCalls[k], ticks_of_3000);
  }
  request(0x18, reinterpret_cast<const void*>(0x20026));  // the end, without an error
  while (true) {
  }
}

/// Ends in silence: the lines that are missing say what happened.
[[noreturn]] void fault() {
  print("fault\n");
  request(0x18, reinterpret_cast<const void*>(0x20026));
  while (true) {
  }
}

}  // namespace

extern "C" uint32_t top_of_stack;

struct Vectors {
  uint32_t* stack;
  void (*handlers[7])();
};
[[gnu::section(".vectors"), gnu::used]] const Vectors vectors{
    &top_of_stack, {reset, fault, fault, fault, fault, fault, fault}};
