#include "support/models.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace treedyn::support {

namespace fs = std::filesystem;

namespace {

void append(const fs::path& source_dir, const fs::path& folder, std::vector<Committed>& result) {
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().extension() == ".json") {
      const Manifest manifest = read_manifest(file.path());
      result.push_back(
          {folder, file.path().stem().string(), source_dir / "models" / manifest.model, manifest});
    }
  }
}

}  // namespace

std::vector<Committed> committed(const fs::path& source_dir) {
  std::vector<Committed> result;
  for (const auto& folder : fs::directory_iterator(source_dir / "generated")) {
    if (folder.is_directory()) {
      append(source_dir, folder.path(), result);
    }
  }
  if (result.empty()) {
    throw std::runtime_error("no generated code in generated/");
  }
  std::sort(result.begin(), result.end(),
            [](const Committed& a, const Committed& b) { return a.folder < b.folder; });
  return result;
}

std::vector<Committed> committed_models(const fs::path& source_dir) {
  std::vector<Committed> result = committed(source_dir);
  std::erase_if(result, [](const Committed& c) { return c.manifest.scalar != "double"; });
  return result;
}

std::string test_name(const Committed& committed) {
  std::string result = committed.folder.filename().string();
  std::erase_if(result, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
  return result;
}

CompiledModel with_all_functions(const Committed& committed, const std::string& scalar,
                                 Variant variant, const std::vector<std::string>& more) {
  std::string functions =
      "mass_matrix,bias_force,gravity_force,inverse_dynamics,forward_dynamics,"
      "joint_to_link_vectors,joint_to_com_vectors,kinetic_energy,potential_energy";
  if (!committed.manifest.points.empty()) {
    functions +=
        ",point_positions,point_velocities,point_rotations,force_jacobian_transpose,"
        "moment_jacobian_transpose,point_bias_acceleration,angular_bias_acceleration,applied_force";
  }
  std::vector<std::string> options = {
      "--base", committed.manifest.base, "--scalar", scalar, "--functions", functions, "--effort",
      "100"};
  options.insert(options.end(), more.begin(), more.end());
  return generate_and_compile(committed.model, options, variant);
}

}  // namespace treedyn::support
