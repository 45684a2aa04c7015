// benchmark_sincos_error MILLIONS -o DIR: errors of the pair of sine and cosine of generated code,
// without contraction: over all floats of its range, against double, and over MILLIONS of millions
// of doubles, against long double. On all cores; writes sines.md.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "benchmark/command.hpp"
#include "pair_double.cpp"  // NOLINT(bugprone-suspicious-include)
#include "pair_float.cpp"   // NOLINT(bugprone-suspicious-include)
#include "support/process.hpp"

namespace treedyn::benchmark {
namespace {

// What the headers state.
constexpr double kRangeDouble = 1.3e7;
constexpr float kRangeFloat = 1e5F;

constexpr long double kRightAngle = 1.57079632679489661923132169163975144L;

struct Largest {
  double error = 0;
  double at = 0;

  void note(double other, double x) {
    if (other > error || std::isnan(other)) {  // what is not a number stays
      error = other;
      at = x;
    }
  }
};

struct Errors {
  Largest sine;
  Largest cosine;
};

/// splitmix64: any seed will do.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed << 32U) {}

  /// From [0, 1).
  double next() { return static_cast<double>(bits() >> 11U) * 0x1p-53; }
  double sign() { return (bits() >> 63U) != 0 ? 1 : -1; }

 private:
  std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15U;
    std::uint64_t z = (state_ ^ (state_ >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
  }

  std::uint64_t state_;
};

/// A multiple of pi/2 of the range and a half, or less, and 2^-4 to 2^-52 beside it.
double near(Random& random, double half) {
  const double most = kRangeDouble / static_cast<double>(kRightAngle) - 1;
  const auto multiple = static_cast<long double>(std::floor(most * random.next()) + half);
  const double beside = random.sign() * std::exp2(-4 - 48 * random.next());
  return random.sign() * static_cast<double>(multiple * kRightAngle + beside);
}

struct Distribution {
  const char* name;
  double (*draw)(Random& random);
};

constexpr Distribution kDistributions[] = {{"uniform",
                                            [](Random& random) {
                                              return random.sign() * kRangeDouble * random.next();
                                            }},
                                           {"logarithm uniform, from 1e-9 on",
                                            [](Random& random) {
                                              return random.sign() * kRangeDouble *
                                                     std::pow(1e-9 / kRangeDouble, random.next());
                                            }},
                                           {"near odd multiples of pi/4",
                                            [](Random& random) {
                                              return near(random, 0.5);
                                            }},
                                           {"near multiples of pi/2", [](Random& random) {
                                              return near(random, 0);
                                            }}};

void note(Errors& errors, double x) {
  const auto pair = pair_double::sine_cosine(x);
  long double sine = 0;
  long double cosine = 0;
  sincosl(static_cast<long double>(x), &sine, &cosine);
  const auto error = [](double value, long double exact) {
    return static_cast<double>(std::fabs(static_cast<long double>(value) - exact));
  };
  errors.sine.note(error(pair.sine, sine), x);
  errors.cosine.note(error(pair.cosine, cosine), x);
}

/// A float and its negative, whose sine is to be the negative one.
void note(Errors& errors, float x) {
  const auto pair = pair_float::sine_cosine(x);
  const auto negative = pair_float::sine_cosine(-x);
  if (negative.sine != -pair.sine || negative.cosine != pair.cosine) {
    throw std::runtime_error(fmt::format("sine_cosine of {0} and of -{0} differ", x));
  }
  const auto exact = static_cast<double>(x);
  errors.sine.note(std::fabs(static_cast<double>(pair.sine) - std::sin(exact)), exact);
  errors.cosine.note(std::fabs(static_cast<double>(pair.cosine) - std::cos(exact)), exact);
}

/// Of `chunks` that are measured on all cores; which core takes which decides nothing.
Errors on_all_cores(std::size_t chunks, const std::function<void(std::size_t, Errors&)>& measure) {
  std::vector<Errors> found(chunks);
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (unsigned core = 0; core < std::max(1U, std::thread::hardware_concurrency()); ++core) {
    threads.emplace_back([&] {
      for (std::size_t chunk = next++; chunk < chunks; chunk = next++) {
        measure(chunk, found[chunk]);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  Errors result;
  for (const Errors& errors : found) {
    result.sine.note(errors.sine.error, errors.sine.at);
    result.cosine.note(errors.cosine.error, errors.cosine.at);
  }
  return result;
}

Errors of_doubles(const Distribution& distribution, std::size_t millions) {
  return on_all_cores(millions, [&](std::size_t chunk, Errors& errors) {
    const auto kind = static_cast<std::size_t>(&distribution - kDistributions);
    Random random(chunk * std::size(kDistributions) + kind);
    for (int k = 0; k < 1000000; ++k) {
      note(errors, distribution.draw(random));
    }
  });
}

/// Zero and all positive floats of the range, in the order of their bits.
std::uint32_t count_of_floats() {
  std::uint32_t last = 0;
  std::memcpy(&last, &kRangeFloat, sizeof(last));
  return last + 1;
}

Errors of_floats() {
  constexpr std::uint32_t kChunk = 1U << 20U;
  const std::uint32_t count = count_of_floats();
  return on_all_cores((count + kChunk - 1) / kChunk, [&](std::size_t chunk, Errors& errors) {
    const std::uint32_t begin = static_cast<std::uint32_t>(chunk) * kChunk;
    for (std::uint32_t bits = begin; bits < std::min(count, begin + kChunk); ++bits) {
      float x = 0;
      std::memcpy(&x, &bits, sizeof(x));
      note(errors, x);
    }
  });
}

std::string row(const std::string& type, const std::string& arguments, double count,
                const Errors& errors) {
  return fmt::format("| {} | {} | {:.3g} | {:.4g} at {} | {:.4g} at {} |\n", type, arguments, count,
                     errors.sine.error, errors.sine.at, errors.cosine.error, errors.cosine.at);
}

std::string table(std::size_t millions) {
  std::string text = fmt::format(
      "Largest absolute errors of the pair of sine and cosine, without contraction: float against "
      "double, all\narguments up to {:g}, double against long double, random arguments up to "
      "{:g}.\n\n| scalar | arguments | number | sine | cosine |\n|---|---|---|---|---|\n",
      kRangeFloat, kRangeDouble);
  text += row("float", "all", 2.0 * count_of_floats(), of_floats());
  std::cout << text << std::flush;
  const std::size_t part = millions / std::size(kDistributions);
  for (const Distribution& distribution : kDistributions) {
    const std::string next = row("double", distribution.name, 1e6 * static_cast<double>(part),
                                 of_doubles(distribution, part));
    std::cout << next << std::flush;
    text += next;
  }
  return text;
}

}  // namespace
}  // namespace treedyn::benchmark

int main(int argc, char** argv) {
  using namespace treedyn::benchmark;  // NOLINT(google-build-using-namespace)
  return run_command(
      argc, argv, "benchmark_sincos_error", {"MILLIONS", "-o", "DIR"}, [](const Words& words) {
        const std::string text = table(std::stoul(words[0]));
        std::filesystem::create_directories(words[2]);
        treedyn::support::write_file(std::filesystem::path(words[2]) / "sines.md", text);
      });
}
