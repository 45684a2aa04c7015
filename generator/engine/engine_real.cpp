// Software floats, apart from engine.cpp because they take long to compile.
#include "common/real.hpp"
#include "engine/eigen_real.hpp"
#include "engine/engine.hpp"
#include "engine/implementation.hpp"

namespace treedyn::engine {

template class Engine<Real>;
template class Engine<boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                    boost::multiprecision::et_off>>;

}  // namespace treedyn::engine
