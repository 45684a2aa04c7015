// Compiled by benchmark_compilers beside generated.cpp, in every way that it compares.
#include "benchmark/code.hpp"
#include "generated.hpp"

extern "C" {
extern const treedyn::benchmark::Code code;
const treedyn::benchmark::Code code{.dof = generated::kDof,
                                    .points = 0,
                                    .mass_matrix = generated::mass_matrix,
                                    .bias_force = nullptr,
                                    .gravity_force = nullptr,
                                    .inverse_dynamics = generated::inverse_dynamics,
                                    .forward_dynamics = generated::forward_dynamics,
                                    .force_jacobian_transpose = nullptr};
}
