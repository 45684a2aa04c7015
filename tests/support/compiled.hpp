// Compiles generated code at test time and calls it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "support/manifest.hpp"
#include "support/shim.hpp"

namespace treedyn::support {

/// Output values of one call with a bound of their rounding errors and the operations executed.
struct Measurement {
  std::vector<double> values;
  std::vector<double> bounds;
  std::array<long, 6> operations{};
  int status = 0;  ///< that the function returned; 0 of functions without
};

/// Generated code as a loaded shared object, compiled once per content with the compiler of the
/// build (-std=c++17 -O1) and kept in a cache folder of the build.
class CompiledModel {
 public:
  using Inputs = std::vector<std::vector<double>>;

  /// Loads NAME.hpp, NAME.cpp, NAME.json of `folder`.
  /// \throws std::runtime_error with the compiler's messages if it does not compile.
  CompiledModel(const std::filesystem::path& folder, const std::string& name,
                Variant variant = Variant::kPlain);

  [[nodiscard]] const Manifest& manifest() const { return manifest_; }

  /// All outputs of the function, one array after the other; what it did not write is NaN.
  /// \pre one input array of the right size for every argument; from one thread at a time.
  [[nodiscard]] std::vector<double> call(const std::string& function, const Inputs& inputs) const;

  /// Without Variant::kMeasured bounds and operations are zero. \pre as `call`
  [[nodiscard]] Measurement measure(const std::string& function, const Inputs& inputs) const;

 private:
  template <class Function>
  Function symbol(const std::string& name) const;

  Manifest manifest_;
  std::shared_ptr<void> library_;
};

/// Runs `treedyn generate model options -o folder`; the files are named `generated.*`. An empty
/// model: the options name a scene.
/// \throws std::runtime_error with its messages if it fails.
void generate(const std::filesystem::path& model, const std::vector<std::string>& options,
              const std::filesystem::path& folder);

/// The same in one step: generated, compiled, loaded; the output is kept in the cache, too.
CompiledModel generate_and_compile(const std::filesystem::path& model,
                                   const std::vector<std::string>& options,
                                   Variant variant = Variant::kPlain);

}  // namespace treedyn::support
