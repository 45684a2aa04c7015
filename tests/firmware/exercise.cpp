#include "exercise.hpp"

#include <string.h>

void draw(const Call& call, uint32_t* state) {
  for (int k = 0; k < call.inputs_size; ++k) {
    const Array& array = call.inputs[k];
    for (int i = 0; i < array.size; ++i) {
      *state = *state * 1664525U + 1013904223U;
      const int number = static_cast<int>(*state >> 16U) - 32768;
      if (array.is_integer != 0) {
        static_cast<int*>(array.values)[i] = 0;
      } else {
        static_cast<Scalar*>(array.values)[i] =
            static_cast<Scalar>(number) * (static_cast<Scalar>(1.5) / 32768);
      }
    }
  }
}

namespace {

uint32_t mixed(uint32_t hash, uint32_t bits) {
  hash = (hash ^ bits) * 16777619U;
  return hash ^ hash >> 15U;
}

/// The bits of an element; every NaN counts as the same one.
uint32_t mixed(uint32_t hash, const Array& array, int i) {
  if (array.is_integer != 0) {
    return mixed(hash, static_cast<uint32_t>(static_cast<const int*>(array.values)[i]));
  }
  const Scalar value = static_cast<const Scalar*>(array.values)[i];
  if (value != value) {
    return mixed(hash, 0x7fc00000U);
  }
  uint32_t words[sizeof(Scalar) / 4];
  memcpy(words, &value, sizeof(value));
  for (const uint32_t bits : words) {
    hash = mixed(hash, bits);
  }
  return hash;
}

}  // namespace

uint32_t joined(uint32_t hash, const Call& call, int status) {
  hash = (hash ^ static_cast<uint32_t>(status)) * 16777619U;
  for (int k = 0; k < call.outputs_size; ++k) {
    for (int i = 0; i < call.outputs[k].size; ++i) {
      hash = mixed(hash, call.outputs[k], i);
    }
  }
  return hash;
}

uint32_t hash_of(const Call& call) {
  uint32_t state = 20110602U;
  uint32_t hash = 2166136261U;
  for (int k = 0; k < 10; ++k) {
    draw(call, &state);
    hash = joined(hash, call, call.call());
  }
  return hash;
}
