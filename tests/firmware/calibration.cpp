#include "calibration.hpp"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "accuracy/core.hpp"

namespace treedyn {

int off_the_table(const Counts& counts) {
  std::map<std::pair<std::string, bool>, std::pair<double, std::string>> largest;
  int failures = 0;
  for (const Count& count : counts) {
    const double of_table =
        accuracy::instructions(count.cost, *accuracy::find_core(count.core), count.is_float);
    const double off = of_table / static_cast<double>(count.instructions) - 1;
    auto& [most, function] = largest[{count.core, count.is_float}];
    if (std::fabs(off) >= std::fabs(most)) {
      most = off;
      function = count.function;
    }
    if (std::fabs(off) > accuracy::kInstructionsOff) {
      fmt::print("{}, {}: {} instructions, {:.0f} by the table\n", count.core, count.function,
                 count.instructions, of_table);
      ++failures;
    }
  }
  for (const auto& [place, worst] : largest) {
    fmt::print("{}, {}: the table is off by at most {:+.1f} % ({})\n", place.first,
               place.second ? "float" : "double", 100 * worst.first, worst.second);
  }
  return failures;
}

}  // namespace treedyn
