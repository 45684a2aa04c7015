// The dynamics of a scene by generated functions.
#include <dlfcn.h>

#include <fmt/format.h>

#include "common/error.hpp"
#include "dynamics/scene_dynamics.hpp"
#include "emit/template_file.hpp"
#include "emit/unit.hpp"
#include "system/compiler.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

const char* const kName = "scene";

/// A shared library; its file may vanish while it is in use.
class Library {
 public:
  explicit Library(const std::string& path)
      : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
    if (handle_ == nullptr) {
      throw InputError({}, "--compiled: the compiled functions cannot be loaded");
    }
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { ::dlclose(handle_); }
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return reinterpret_cast<Function>(::dlsym(handle_, name));
  }

 private:
  void* handle_;
};

class CompiledDynamics final : public simulation::Dynamics {
 public:
  CompiledDynamics(const std::string& path, std::size_t geometry)
      : library_(path),
        terms_(library_.find<void (*)(const double*, const double*, double*)>("treedyn_terms")),
        geometry_(library_.find<void (*)(const double*, double*)>("treedyn_geometry")),
        buffer_(geometry) {
    TREEDYN_EXPECT(terms_ != nullptr && geometry_ != nullptr);
  }

  void evaluate(const simulation::Vector& q, const simulation::Vector& qd,
                simulation::Terms& terms) override {
    terms_(q.data(), qd.data(), terms.values().data());
  }
  void evaluate_geometry(const simulation::Vector& q, simulation::Terms& terms) override {
    geometry_(q.data(), buffer_.data());
    terms.set_geometry(buffer_);
  }

 private:
  Library library_;
  void (*terms_)(const double*, const double*, double*);
  void (*geometry_)(const double*, double*);
  std::vector<double> buffer_;
};

void describe(program::Function& function, const std::string& name) {
  function.signature.name = name;
  function.signature.brief = "For treedyn simulate.";
  function.signature.outputs = {{"out", static_cast<int>(function.outputs.size()), ""}};
}

std::vector<OutputFile> sources(const model::Scene& scene, ScenePrograms programs,
                                const std::filesystem::path& folder) {
  emit::Unit unit;
  unit.name = kName;
  unit.tree = &scene.tree;
  unit.points = scene.points;
  const bool has_geometry = !programs.geometry.outputs.empty();
  describe(programs.terms, "terms");
  describe(programs.geometry, "geometry");
  unit.functions.push_back(std::move(programs.terms));
  if (has_geometry) {
    unit.functions.push_back(std::move(programs.geometry));
  }
  unit.command = {"treedyn", "simulate", "--compiled"};
  std::vector<OutputFile> files;
  for (emit::File& file : emit::emit_files(unit)) {
    files.push_back({(folder / file.name).string(), std::move(file.text)});
  }
  files.push_back(
      {(folder / "simulate.cpp").string(),
       emit::fill(emit::template_text("simulate.cpp"),
                  {{"name", kName},
                   {"geometry", has_geometry ? fmt::format("  {}::geometry(q, out);", kName)
                                             : std::string()}})});
  return files;
}

}  // namespace

std::unique_ptr<simulation::Dynamics> compiled_dynamics(const model::Scene& scene) {
  ScenePrograms programs = scene_programs(scene);
  const TemporaryFolder folder;
  const auto path = [&](const char* name) {
    return (folder.path() / name).string();
  };
  std::vector<std::string> command = find_compiler(path("version"));
  if (command.empty()) {
    throw InputError({}, "--compiled: no C++ compiler found; expected $CXX, c++, g++ or clang++");
  }
  const std::size_t geometry = programs.geometry.outputs.size();
  write_files(sources(scene, std::move(programs), folder.path()));
  command.insert(command.end(),
                 {"-std=c++11", "-O2", "-shared", "-fPIC", path("simulate.cpp"),
                  path((std::string(kName) + ".cpp").c_str()), "-o", path("scene.so")});
  if (!succeeds(command, path("log"))) {
    throw InputError(
        {}, "--compiled: the generated functions do not compile; expected a C++11 compiler");
  }
  return std::make_unique<CompiledDynamics>(path("scene.so"), geometry);
}

}  // namespace treedyn
