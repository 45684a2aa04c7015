#include "engine/engine.hpp"

#include "engine/implementation.hpp"

namespace treedyn::engine {

template class Engine<float>;
template class Engine<double>;
template class Engine<long double>;

}  // namespace treedyn::engine
