// The engine allocates nothing after construction: operator new and malloc are counted.
#include <array>
#include <atomic>
#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/engine.hpp"
#include "engine/outputs.hpp"
#include "support/random_tree.hpp"

namespace {

std::atomic<long> g_allocations{0};

}  // namespace

// Eigen allocates with malloc, the standard library with operator new, which calls malloc.
#if defined(__SANITIZE_ADDRESS__)
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*,
                                                                  std::size_t),
                                                         void (*)(const volatile void*));
namespace {
void count(const volatile void* /*memory*/, std::size_t /*size*/) { ++g_allocations; }
void ignore(const volatile void* /*memory*/) {}
const int kHooks = __sanitizer_install_malloc_and_free_hooks(count, ignore);
}  // namespace
#else
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++g_allocations;
  return __libc_malloc(size);
}
#endif

namespace treedyn {
namespace {

TEST(Counter, SeesAllocations) {
  const long before = g_allocations;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(100);
  std::vector<double> y(100);
  EXPECT_EQ(g_allocations - before, 2);
  EXPECT_EQ(x(0), y[0]);
}

template <class Scalar>
void expect_no_allocations() {
  support::Dice dice(4);
  const model::Tree tree = support::random_tree(support::random_shape(12, dice), dice);
  const std::vector<model::Point> points = support::random_points(tree, 4, dice);
  engine::Engine<Scalar> engine(tree, points, {0, 0, Real(-9.75)});
  const std::vector<Scalar> values(12, Scalar(0.5));
  for (const equations::Equation* function : engine::functions()) {
    const std::span<const Scalar> input(values);
    const std::array<std::span<const Scalar>, 3> all = {input, input, input};
    const std::span<const std::span<const Scalar>> inputs(all.data(), function->inputs.size());
    const long before = g_allocations;
    const auto result = engine.evaluate(function->name, inputs);
    const long after = g_allocations;
    EXPECT_EQ(after - before, 0) << function->name;
    EXPECT_FALSE(result.empty());
  }
}

TEST(Engine, AllocatesNothingInFloat) { expect_no_allocations<float>(); }
TEST(Engine, AllocatesNothingInDouble) { expect_no_allocations<double>(); }
TEST(Engine, AllocatesNothingInLongDouble) { expect_no_allocations<long double>(); }

template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

TEST(Engine, AllocatesNothingThroughEigenInterface) {
  support::Dice dice(4);
  const model::Tree tree = support::random_tree(support::random_shape(6, dice), dice);
  engine::Engine<double> engine(tree, {}, {0, 0, Real(-9.75)});
  const Vector<double> q = Vector<double>::Constant(6, 0.25);
  Vector<double> out(6);
  engine::Engine<double>::Matrix A(6, 6);
  const long before = g_allocations;
  engine.mass_matrix(q, A);
  engine.inverse_dynamics(q, q, q, out);
  engine.forward_dynamics(q, q, q, out);
  EXPECT_EQ(g_allocations - before, 0);
}

}  // namespace
}  // namespace treedyn
