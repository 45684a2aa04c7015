// The hash of every function, a line each.
#include <cstdio>

#include "exercise.hpp"

int main() {
  for (int k = 0; k < kCallsSize; ++k) {
    std::printf("%s %08x\n", kCalls[k].name, static_cast<unsigned>(hash_of(kCalls[k])));
  }
}
