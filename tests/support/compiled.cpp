#include "support/compiled.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "common/error.hpp"
#include "support/process.hpp"

namespace treedyn::support {

namespace {

namespace fs = std::filesystem;

/// FNV-1a, 64 bits.
std::string content_hash(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return fmt::format("{:016x}", hash);
}

/// What counts and bounds in every operation takes six times as long to optimise. The standard is
/// the oldest that the code is for: <cmath> of C++17 takes longer to read than a small function.
std::vector<std::string> compiler_command(const fs::path& folder, Variant variant) {
  const bool measured = variant == Variant::kMeasured;
  return {TREEDYN_CXX,
          measured ? "-std=c++17" : "-std=c++11",
          measured ? "-O0" : "-O1",
          "-fPIC",
          "-shared",
          "-fvisibility=hidden",
          "-I",
          folder,
          "-I",
          TREEDYN_TESTS};
}

/// Compiles into `object` by way of a private name, so that parallel tests never load half a file.
void compile(const fs::path& folder, const std::string& name, Variant variant,
             const fs::path& object) {
  const fs::path partial = object.string() + fmt::format(".{}", getpid());
  std::vector<std::string> command = compiler_command(folder, variant);
  command.insert(command.end(),
                 {folder / (name + ".cpp"), folder / "shim.cpp", "-o", partial.string()});
  const Outcome outcome = run(command);
  if (outcome.status != 0) {
    throw std::runtime_error("generated code does not compile:\n" + outcome.err);
  }
  fs::rename(partial, object);
}

fs::path shared_object(const fs::path& folder, const std::string& name, const Manifest& manifest,
                       Variant variant) {
  const std::string header = adapted_header(read_file(folder / (name + ".hpp")), manifest, variant);
  const std::string source = read_file(folder / (name + ".cpp"));
  const std::string shim = shim_source(name, manifest, variant);
  const std::string measured = read_file(fs::path(TREEDYN_TESTS) / "support/measured.hpp");
  std::string key = header + source + shim + measured;
  for (const std::string& word : compiler_command("", variant)) {
    key += word;
  }
  const fs::path cache = TREEDYN_TEST_CACHE;
  fs::create_directories(cache);
  const fs::path object = cache / (name + "-" + content_hash(key) + ".so");
  if (!fs::exists(object)) {
    const TemporaryFolder work;
    write_file(work.path() / (name + ".hpp"), header);
    write_file(work.path() / (name + ".cpp"), source);
    write_file(work.path() / "shim.cpp", shim);
    compile(work.path(), name, variant, object);
  }
  return object;
}

/// One pointer per array into one buffer for all.
std::vector<double*> slices(std::vector<double>& buffer, const std::vector<int>& sizes) {
  std::vector<double*> result;
  double* at = buffer.data();
  for (const int size : sizes) {
    result.push_back(at);
    at += size;
  }
  return result;
}

}  // namespace

CompiledModel::CompiledModel(const fs::path& folder, const std::string& name, Variant variant)
    : manifest_(read_manifest(folder / (name + ".json"))) {
  const fs::path object = shared_object(folder, name, manifest_, variant);
  void* handle = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    throw std::runtime_error(dlerror());
  }
  library_ = std::shared_ptr<void>(handle, [](void* library) { dlclose(library); });
}

template <class Function>
Function CompiledModel::symbol(const std::string& name) const {
  void* address = dlsym(library_.get(), name.c_str());
  if (address == nullptr) {
    throw std::runtime_error("no symbol " + name);
  }
  return reinterpret_cast<Function>(address);
}

Measurement CompiledModel::measure(const std::string& function, const Inputs& inputs) const {
  const FunctionInfo& info = manifest_.function(function);
  TREEDYN_EXPECT(inputs.size() == info.inputs.size());
  std::vector<const double*> in;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    TREEDYN_EXPECT(inputs[k].size() == static_cast<std::size_t>(info.inputs[k]));
    in.push_back(inputs[k].data());
  }
  const auto size =
      static_cast<std::size_t>(std::accumulate(info.outputs.begin(), info.outputs.end(), 0));
  Measurement result{std::vector<double>(size), std::vector<double>(size), {}, 0};
  const std::vector<double*> out = slices(result.values, info.outputs);
  const std::vector<double*> bound = slices(result.bounds, info.outputs);
  using Call = int (*)(const double* const*, double* const*, double* const*);
  result.status = symbol<Call>("call_" + function)(in.data(), out.data(), bound.data());
  if (dlsym(library_.get(), "operations") != nullptr) {
    symbol<void (*)(long*)>("operations")(result.operations.data());
  }
  return result;
}

std::vector<double> CompiledModel::call(const std::string& function, const Inputs& inputs) const {
  return measure(function, inputs).values;
}

void generate(const fs::path& model, const std::vector<std::string>& options,
              const fs::path& folder) {
  std::vector<std::string> command{TREEDYN_EXECUTABLE, "generate", "--name",
                                   "generated",        "-o",       folder.string()};
  if (!model.empty()) {
    command.push_back(model.string());
  }
  command.insert(command.end(), options.begin(), options.end());
  const Outcome outcome = run(command);
  if (outcome.status != 0) {
    throw std::runtime_error("treedyn generate " + model.string() + ": " + outcome.err);
  }
}

namespace {

/// A folder of the cache for the output of this tool for this model and these options: the tool is
/// a function of them (the tests of determinism show it), so what stands there need not be made
/// again.
fs::path cached_output(const fs::path& model, const std::vector<std::string>& options) {
  static const std::string tool = read_file(TREEDYN_EXECUTABLE);
  std::string key = tool + model.string() + read_file(model);
  for (const std::string& option : options) {
    key += '\n' + option;
  }
  return fs::path(TREEDYN_TEST_CACHE) / content_hash(key);
}

}  // namespace

CompiledModel generate_and_compile(const fs::path& model, const std::vector<std::string>& options,
                                   Variant variant) {
  const fs::path output = cached_output(model, options);
  if (!fs::exists(output)) {
    const fs::path partial = output.string() + fmt::format(".{}", getpid());
    generate(model, options, partial);
    std::error_code made_by_another_test;
    fs::rename(partial, output, made_by_another_test);
  }
  return {output, "generated", variant};
}

}  // namespace treedyn::support
