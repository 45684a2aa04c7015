// Every function of a generated file at the same states on the host and on a microcontroller.
#pragma once

#include <stdint.h>

#ifdef EXERCISE_DOUBLE
using Scalar = double;
#else
using Scalar = float;
#endif

/// One array of a call.
struct Array {
  void* values;
  int size;
  int is_integer;
};

/// One generated function; `call` calls it with the arrays.
struct Call {
  const char* name;
  int (*call)();
  const Array* inputs;
  int inputs_size;
  const Array* outputs;
  int outputs_size;
};

extern const Call kCalls[];
extern const int kCallsSize;

/// Fills the inputs with the next pseudo-random numbers between -1.5 and 1.5; integers are zero.
void draw(const Call& call, uint32_t* state);
/// The bits of outputs and status, joined to `hash` (FNV-1a); every NaN counts as the same one.
uint32_t joined(uint32_t hash, const Call& call, int status);
/// Of ten states.
uint32_t hash_of(const Call& call);
