// The manifest NAME.json of generated code, INTERFACE.md 5, as the tests need it.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace treedyn::support {

struct FunctionInfo {
  std::string name;
  std::vector<std::string> arguments;  ///< names of the input arrays, in order
  std::vector<int> inputs;             ///< their sizes
  std::vector<std::string> results;    ///< names of the output arrays, in order
  std::vector<int> outputs;            ///< their sizes
  std::vector<bool> integer_inputs;    ///< which are int
  std::vector<bool> integer_outputs;
  bool status = false;               ///< returns one
  std::array<long, 6> operations{};  ///< add, mul, div, sqrt, sin, cos of one call
};

struct Manifest {
  std::string model;   ///< base name of the model file
  std::string base;    ///< "fixed" or "axes"
  std::string scalar;  ///< "double" or "float"
  int dof = 0;
  std::vector<std::string> joints;  ///< names as the model writes them, in generated order
  std::vector<std::string> points;
  std::vector<FunctionInfo> functions;

  /// \throws std::out_of_range if there is no such function.
  [[nodiscard]] const FunctionInfo& function(const std::string& name) const;
  [[nodiscard]] bool has(const std::string& name) const;
};

/// \throws std::runtime_error or nlohmann::json::exception if `path` is not such a manifest.
Manifest read_manifest(const std::filesystem::path& path);

}  // namespace treedyn::support
