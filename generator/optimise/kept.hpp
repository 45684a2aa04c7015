// Memory that outlives one network.
#pragma once

namespace treedyn::optimise {

/// One of each type for every thread: a search works on many small networks, and would spend its
/// time on memory.
template <class T>
T& kept_by_thread() {
  thread_local T kept;
  return kept;
}

}  // namespace treedyn::optimise
