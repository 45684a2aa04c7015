#include "stress/batch.hpp"

#include <dlfcn.h>

#include <stdexcept>

#include <fmt/format.h>

#include "pipeline.hpp"
#include "support/process.hpp"

namespace treedyn::stress {

namespace {

constexpr const char* kConversions = R"(
namespace {
template <class To, class From>
void copy(const From* from, To* to, int n) {
  for (int k = 0; k < n; ++k) to[k] = static_cast<To>(from[k]);
}
}  // namespace
)";

Request request_for(const Robot& robot, const std::string& scalar) {
  Request request;
  request.scene = robot.name;
  request.effort = 0;
  request.target.scalar = scalar == "float" ? emit::Scalar::kFloat : emit::Scalar::kDouble;
  return request;
}

/// All functions; what the tool would refuse to write is not compared, so no proof runs here.
program::Programs programs_of(const Robot& robot, const Request& request, Model& model) {
  model.source = {robot.name, ""};
  model.name = robot.name;
  model.scene = robot.scene;
  model.tree = robot.scene.tree;
  model.points = robot.scene.points;
  model.functions.assign(kFunctions.begin(), kFunctions.end() - 1);
  model.scene_functions = {kFunctions.back()};
  return formulate_model(model, request, [](const std::string&) {});
}

/// extern "C" void NAME_FUNCTION(inputs, first output).
std::string shim(const std::string& name, const program::Signature& signature) {
  std::string before;
  std::string arguments;
  for (std::size_t k = 0; k < signature.inputs.size(); ++k) {
    const int n = signature.inputs[k].size;
    before += fmt::format("  {}::Scalar i{}[{}];\n  copy(in[{}], i{}, {});\n", name, k, n, k, k, n);
    arguments += fmt::format("i{}, ", k);
  }
  for (std::size_t k = 0; k < signature.outputs.size(); ++k) {
    before += fmt::format("  {}::Scalar o{}[{}];\n", name, k, signature.outputs[k].size);
    arguments += fmt::format("{}o{}", k > 0 ? ", " : "", k);
  }
  return fmt::format(
      "extern \"C\" void {0}_{1}(const double* const* in, double* out) {{\n{2}  "
      "{0}::{1}({3});\n  copy(o0, out, {4});\n}}\n",
      name, signature.name, before, arguments, signature.outputs.front().size);
}

std::string shims(const std::string& name, const program::Programs& programs) {
  std::string result;
  for (const program::Function& function : programs.functions) {
    result += shim(name, function.signature);
  }
  for (const program::Staged& staged : programs.staged) {
    result += shim(name, staged.signature);
  }
  return result;
}

}  // namespace

Batch::Batch(const std::vector<Robot>& robots, const std::string& scalar) {
  const support::TemporaryFolder folder;
  std::string includes;
  std::string calls;
  for (const Robot& robot : robots) {
    const Request request = request_for(robot, scalar);
    Model model;
    program::Programs programs = programs_of(robot, request, model);
    calls += shims(robot.name, programs);
    for (const emit::File& file : emit_files(model, request, std::move(programs))) {
      support::write_file(folder.path() / file.name, file.text);
    }
    includes += fmt::format("#include \"{}.cpp\"\n", robot.name);
  }
  const auto source = folder.path() / "all.cpp";
  const auto object = folder.path() / "all.so";
  support::write_file(source, includes + kConversions + calls);
  const support::Outcome outcome =
      support::run({TREEDYN_CXX, "-std=c++11", "-O1", "-ffp-contract=off", "-fPIC", "-shared",
                    source, "-o", object});
  if (outcome.status != 0) {
    throw std::runtime_error("generated code does not compile:\n" + outcome.err);
  }
  void* handle = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(dlerror());
  }
  library_ = std::shared_ptr<void>(handle, [](void* library) { dlclose(library); });
}

std::vector<double> Batch::call(const Robot& robot, const std::string& function) const {
  const std::size_t n = robot.q.size();
  std::vector<std::vector<double>> arrays;
  for (const Values* values : {&robot.q, &robot.qd, &robot.tau}) {
    arrays.emplace_back();
    for (const Real& x : *values) {
      arrays.back().push_back(static_cast<double>(x));
    }
  }
  const std::vector<const double*> in = {arrays[0].data(), arrays[1].data(), arrays[2].data()};
  std::vector<double> out(function == "mass_matrix" ? n * n : n);
  using Call = void (*)(const double* const*, double*);
  const std::string name = robot.name + "_" + function;
  void* address = dlsym(library_.get(), name.c_str());
  if (address == nullptr) {
    throw std::runtime_error("no symbol " + name);
  }
  reinterpret_cast<Call>(address)(in.data(), out.data());
  return out;
}

}  // namespace treedyn::stress
