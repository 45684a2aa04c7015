#include "support/shim.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace treedyn::support {

namespace {

constexpr const char* kPlainConversions = R"(
void load(const double* from, Scalar* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = static_cast<Scalar>(from[k]);
}
void poison(Scalar* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = NAN;
}
void store(const Scalar* from, double* to, double*, int n) {
  for (int k = 0; k < n; ++k) to[k] = static_cast<double>(from[k]);
}
)";

constexpr const char* kMeasuredConversions = R"(
void load(const double* from, Scalar* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = Scalar::exact(static_cast<Plain>(from[k]));
}
void poison(Scalar* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = Scalar::exact(NAN);
}
void store(const Scalar* from, double* to, double* bound, int n) {
  for (int k = 0; k < n; ++k) to[k] = static_cast<double>(from[k].value());
  for (int k = 0; k < n; ++k) bound[k] = from[k].bound();
}
)";

constexpr const char* kCounter = R"(
extern "C" SHIM void operations(long* count) {
  for (int k = 0; k < 6; ++k) count[k] = treedyn::support::Counter::operations[k];
  treedyn::support::Counter::reset();
}
)";

/// Of values that are int.
constexpr const char* kIntegers = R"(
void load(const double* from, int* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = static_cast<int>(from[k]);
}
void poison(int* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = -1000;
}
void store(const int* from, double* to, double* bound, int n) {
  for (int k = 0; k < n; ++k) to[k] = from[k];
  for (int k = 0; bound != nullptr && k < n; ++k) bound[k] = 0;
}
)";

bool has_integers(const Manifest& manifest) {
  return std::any_of(
      manifest.functions.begin(), manifest.functions.end(), [](const FunctionInfo& f) {
        return std::count(f.integer_inputs.begin(), f.integer_inputs.end(), true) > 0;
      });
}

std::string call_function(const std::string& name, const FunctionInfo& function) {
  std::string before;
  std::string arguments;
  std::string after;
  const auto type = [](bool integer) {
    return integer ? "int" : "Scalar";
  };
  for (std::size_t k = 0; k < function.inputs.size(); ++k) {
    const int n = function.inputs[k];
    before += fmt::format("  static {} i{}[{}];\n  load(in[{}], i{}, {});\n",
                          type(function.integer_inputs[k]), k, std::max(n, 1), k, k, n);
    arguments += fmt::format("{}i{}", arguments.empty() ? "" : ", ", k);
  }
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const int n = function.outputs[k];
    before += fmt::format("  static {} o{}[{}];\n  poison(o{}, {});\n",
                          type(function.integer_outputs[k]), k, std::max(n, 1), k, n);
    arguments += fmt::format("{}o{}", arguments.empty() ? "" : ", ", k);
    after += fmt::format("  store(o{}, out[{}], bound[{}], {});\n", k, k, k, n);
  }
  return fmt::format(
      "extern \"C\" SHIM int call_{}(const double* const* in, double* const* out,\n"
      "    double* const* bound) {{\n{}  {}{}::{}({});\n{}  (void)bound;\n  return status;\n}}\n",
      function.name, before, function.status ? "const int status = " : "const int status = 0;\n  ",
      name, function.name, arguments, after);
}

}  // namespace

std::string adapted_header(const std::string& header, const Manifest& manifest, Variant variant) {
  if (variant == Variant::kPlain) {
    return header;
  }
  const std::string line = fmt::format("using Scalar = {};", manifest.scalar);
  const std::size_t at = header.find(line);
  if (at == std::string::npos) {
    throw std::runtime_error("the generated header has no line '" + line + "'");
  }
  std::string result = header;
  result.replace(at, line.size(),
                 fmt::format("using Scalar = treedyn::support::Measured<{}>;", manifest.scalar));
  return "#include \"support/measured.hpp\"\n" + result;
}

std::string shim_source(const std::string& name, const Manifest& manifest, Variant variant) {
  const bool measured = variant == Variant::kMeasured;
  std::string result = fmt::format(
      "#include <cmath>\n#include \"{}.hpp\"\n#define SHIM "
      "__attribute__((visibility(\"default\")))\n"
      "using {}::Scalar;\nusing Plain = {};\nnamespace {{{}{}}}  // namespace\n",
      name, name, manifest.scalar, measured ? kMeasuredConversions : kPlainConversions,
      has_integers(manifest) ? kIntegers : "");
  for (const FunctionInfo& function : manifest.functions) {
    result += call_function(name, function);
  }
  return result + (measured ? kCounter : "");
}

}  // namespace treedyn::support
