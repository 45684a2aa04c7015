#include "engine/engine.hpp"

#include "engine/members.hpp"

namespace treedyn::engine {

template class Engine<float>;
template class Engine<double>;
template class Engine<long double>;

}  // namespace treedyn::engine
