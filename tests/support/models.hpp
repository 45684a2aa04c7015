// The committed models and their generated code.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/compiled.hpp"
#include "support/manifest.hpp"

namespace treedyn::support {

/// One folder of generated/.
struct Committed {
  std::filesystem::path folder;
  std::string stem;  ///< of NAME.hpp
  std::filesystem::path model;
  Manifest manifest;
};

/// Sorted by folder. \throws std::runtime_error if there is none.
std::vector<Committed> committed(const std::filesystem::path& source_dir);

/// One entry a model, the one in double.
std::vector<Committed> committed_models(const std::filesystem::path& source_dir);

/// Names for gtest's parametrised tests.
std::string test_name(const Committed& committed);

/// The model with every function of INTERFACE.md 3, generated and compiled now; with less effort
/// than the committed code, which stands for the default. \param more  options
CompiledModel with_all_functions(const Committed& committed, const std::string& scalar,
                                 Variant variant, const std::vector<std::string>& more = {});

}  // namespace treedyn::support
