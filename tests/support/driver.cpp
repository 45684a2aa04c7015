#include "support/driver.hpp"

#include <array>

#include <fmt/format.h>

namespace treedyn::support {

namespace {

/// A call of both functions with random arguments, and how many results differ in a bit.
std::string comparison(const FunctionInfo& function, const std::array<Program, 2>& programs) {
  std::string text = "  {\n";
  std::string inputs;
  for (std::size_t k = 0; k < function.inputs.size(); ++k) {
    const bool integer = function.integer_inputs[k];
    text += fmt::format("    {0} {1}[{2}];\n    for ({0}& x : {1}) x = {3};\n",
                        integer ? "int" : "Scalar", function.arguments[k], function.inputs[k],
                        integer ? "0" : "random_number()");
    inputs += ", " + function.arguments[k];
  }
  std::string compare = "0";
  std::array<std::string, 2> outputs;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const std::string& name = function.results[k];
    for (std::size_t program = 0; program < 2; ++program) {
      const std::string own = programs[program].results + name;
      text += fmt::format("    {} {}[{}] = {{}};\n", function.integer_outputs[k] ? "int" : "Scalar",
                          own, function.outputs[k]);
      outputs[program] += ", " + own;
    }
    compare += fmt::format(" + (std::memcmp({0}{2}, {1}{2}, sizeof {0}{2}) != 0)",
                           programs[0].results, programs[1].results, name);
  }
  const auto call = [&](std::size_t program) {
    return fmt::format("{}{}({})", programs[program].before, function.name,
                       (inputs + outputs[program]).substr(2));
  };
  text += function.status ? fmt::format("    differ += {} != {};\n", call(0), call(1))
                          : fmt::format("    {};\n    {};\n", call(0), call(1));
  return text + fmt::format("    differ += {};\n    calls += 1;\n  }}\n", compare);
}

}  // namespace

std::string comparing_driver(const Manifest& manifest, const Program& first,
                             const Program& second) {
  std::string calls;
  for (const FunctionInfo& function : manifest.functions) {
    calls += comparison(function, {first, second});
  }
  return fmt::format(R"(#include <cstdio>
#include <cstring>
{}
{}
using {}Scalar;
static unsigned state = 1;
static Scalar random_number() {{
  state = state * 1664525u + 1013904223u;
  return static_cast<Scalar>(state >> 8) / 8388608 - 1;
}}
int main() {{
  int differ = 0;
  int calls = 0;
  for (int n = 0; n < 100; ++n) {{
{}  }}
  std::printf("%d of %d", differ, calls);
}}
)",
                     first.includes, second.includes, second.before, calls);
}

}  // namespace treedyn::support
