// The dynamics of a scene by generated functions.
#include <utility>

#include <fmt/format.h>

#include "dynamics/scene_dynamics.hpp"
#include "dynamics/shared_library.hpp"
#include "emit/template_file.hpp"

namespace treedyn {

namespace {

const char* const kName = "scene";

class CompiledDynamics final : public simulation::Dynamics {
 public:
  CompiledDynamics(const std::vector<emit::File>& files, std::size_t geometry)
      : library_("--compiled", files, {}),
        terms_(library_.find<void (*)(const double*, const double*, double*)>("treedyn_terms")),
        geometry_(library_.find<void (*)(const double*, double*)>("treedyn_geometry")),
        buffer_(geometry) {}

  void evaluate(const simulation::Vector& q, const simulation::Vector& qd,
                simulation::Terms& terms) override {
    terms_(q.data(), qd.data(), terms.values().data());
  }
  void evaluate_geometry(const simulation::Vector& q, simulation::Terms& terms) override {
    geometry_(q.data(), buffer_.data());
    terms.set_geometry(buffer_);
  }

 private:
  SharedLibrary library_;
  void (*terms_)(const double*, const double*, double*);
  void (*geometry_)(const double*, double*);
  std::vector<double> buffer_;
};

void describe(program::Function& function, const std::string& name) {
  function.signature.name = name;
  function.signature.brief = "For treedyn simulate.";
  function.signature.outputs = {{"out", static_cast<int>(function.outputs.size()), ""}};
}

std::vector<emit::File> sources(const model::Scene& scene, ScenePrograms programs) {
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
  std::vector<emit::File> files = emit::emit_files(unit);
  files.push_back(
      {"simulate.cpp",
       emit::fill(emit::template_text("simulate.cpp"),
                  {{"name", kName},
                   {"geometry", has_geometry ? fmt::format("  {}::geometry(q, out);", kName)
                                             : std::string()}})});
  return files;
}

}  // namespace

std::unique_ptr<simulation::Dynamics> compiled_dynamics(const model::Scene& scene) {
  ScenePrograms programs = scene_programs(scene);
  const std::size_t geometry = programs.geometry.outputs.size();
  return std::make_unique<CompiledDynamics>(sources(scene, std::move(programs)), geometry);
}

}  // namespace treedyn
