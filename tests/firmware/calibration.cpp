#include "calibration.hpp"

#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "accuracy/core.hpp"

namespace treedyn {

int off_the_table(const Counts& counts) {
  std::map<std::string, std::pair<double, std::string>> largest;
  int failures = 0;
  for (const Count& count : counts) {
    const double of_table =
        accuracy::instructions(count.cost, *accuracy::find_core(count.core),
                               {.is_float = count.is_float, .contracted = count.contracted});
    const double off = of_table / static_cast<double>(count.instructions) - 1;
    const std::string place =
        fmt::format("{}, {}{}", count.core, count.is_float ? "float" : "double",
                    count.contracted ? ", contracted" : "");
    auto& [most, function] = largest[place];
    if (std::fabs(off) >= std::fabs(most)) {
      most = off;
      function = count.function;
    }
    if (std::fabs(off) > accuracy::kInstructionsOff) {
      fmt::print("{}, {}: {} instructions, {:.0f} by the table\n", place, count.function,
                 count.instructions, of_table);
      ++failures;
    }
  }
  for (const auto& [place, worst] : largest) {
    fmt::print("{}: the table is off by at most {:+.1f} % ({})\n", place, 100 * worst.first,
               worst.second);
  }
  return failures;
}

}  // namespace treedyn
