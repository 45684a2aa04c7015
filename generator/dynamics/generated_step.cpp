#include "dynamics/generated_step.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "emit/template_file.hpp"
#include "system/compiler.hpp"
#include "system/files.hpp"

namespace treedyn {

namespace {

/// The call between C arrays of long double and the arrays of the step.
/// \param repeated  numbers of treedyn_again
std::string adapter(const std::string& name, const program::Signature& signature,
                    std::size_t repeated) {
  std::string before;
  std::string after;
  std::vector<std::string> arguments;
  const auto add = [&](const program::Array& array) {
    before +=
        fmt::format("  {} {}[{}];\n", array.integer ? "int" : "Scalar", array.name, array.size);
    arguments.push_back(array.name);
  };
  for (std::size_t k = 0; k < signature.inputs.size(); ++k) {
    const program::Array& array = signature.inputs[k];
    add(array);
    before += fmt::format("  load(in[{}], {}, {});\n", k, array.name, array.size);
  }
  for (std::size_t k = 0; k < signature.outputs.size(); ++k) {
    const program::Array& array = signature.outputs[k];
    add(array);
    after += fmt::format("  store({}, out[{}], {});\n", array.name, k, array.size);
  }
  return emit::fill(emit::template_text("generated_step.cpp"),
                    {{"name", name},
                     {"repeated", std::to_string(repeated)},
                     {"before", before},
                     {"arguments", fmt::format("{}", fmt::join(arguments, ", "))},
                     {"after", after}});
}

using Pointers = std::vector<long double*>;

Pointers pointers(const std::vector<GeneratedStep::Values*>& arrays) {
  Pointers result(arrays.size());
  std::ranges::transform(arrays, result.begin(),
                         [](GeneratedStep::Values* array) { return array->data(); });
  return result;
}

}  // namespace

/// A shared library; its file may vanish while it is in use.
class GeneratedStep::Library {
 public:
  using Step = int (*)(const long double* const*, long double* const*);
  using Events = int (*)(int, long double*);
  using RepeatedSoOften = long (*)(int);
  using Repeat = void (*)(const long double* const*, long);

  explicit Library(const std::string& path)
      : handle_(::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)),
        step_(find<Step>("treedyn_step")),
        events_(find<Events>("treedyn_event_of_step")),
        repeated_(find<RepeatedSoOften>("treedyn_repeated")),
        repeat_(find<Repeat>("treedyn_repeat")) {
    if (step_ == nullptr || events_ == nullptr || repeated_ == nullptr || repeat_ == nullptr) {
      throw InputError({}, "the generated step, compiled, cannot be loaded");
    }
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { ::dlclose(handle_); }
  [[nodiscard]] Step step() const { return step_; }
  [[nodiscard]] Events events() const { return events_; }
  [[nodiscard]] RepeatedSoOften repeated() const { return repeated_; }
  [[nodiscard]] Repeat repeat() const { return repeat_; }

 private:
  template <class Function>
  [[nodiscard]] Function find(const char* name) const {
    return handle_ == nullptr ? nullptr : reinterpret_cast<Function>(::dlsym(handle_, name));
  }

  void* handle_;
  Step step_;
  Events events_;
  RepeatedSoOften repeated_;
  Repeat repeat_;
};

GeneratedStep::GeneratedStep(const std::string& name, const std::vector<emit::File>& files,
                             program::Stepper stepper)
    : stepper_(std::move(stepper)) {
  for (const program::StepPhase& phase : stepper_.phases) {
    repeated_.resize(std::max(repeated_.size(), program::repeated_costs(stepper_, phase).size()));
  }
  const TemporaryFolder folder;
  const auto path = [&](const std::string& file) {
    return (folder.path() / file).string();
  };
  std::vector<std::string> command = find_compiler(path("version"));
  if (command.empty()) {
    throw InputError(
        {}, "the generated step: no C++ compiler found; expected $CXX, c++, g++ or clang++");
  }
  std::vector<OutputFile> sources = {
      {path("adapter.cpp"), adapter(name, stepper_.signature, repeated_.size())}};
  for (const emit::File& file : files) {
    sources.push_back({path(file.name), file.text});
  }
  write_files(sources);
  command.insert(command.end(), {"-std=c++11", "-O2", "-ffp-contract=off", "-shared", "-fPIC",
                                 path("adapter.cpp"), path(name + ".cpp"), "-o", path("step.so")});
  if (!succeeds(command, path("log"))) {
    throw InputError({}, "the generated step does not compile; expected a C++11 compiler");
  }
  library_ = std::make_unique<Library>(path("step.so"));
  for (const program::Array& array : stepper_.signature.arrays()) {
    values_[array.name].resize(static_cast<std::size_t>(array.size));
  }
  for (const program::Array& array : stepper_.signature.inputs) {
    in_.push_back(&at(array.name));
    if (has(array.name + "_next")) {
      carried_.emplace_back(&at(array.name + "_next"), in_.back());
    }
  }
  for (const program::Array& array : stepper_.signature.outputs) {
    out_.push_back(&at(array.name));
  }
}

GeneratedStep::~GeneratedStep() = default;

bool GeneratedStep::has(const std::string& name) const { return values_.contains(name); }

GeneratedStep::Values& GeneratedStep::at(const std::string& name) {
  const auto found = values_.find(name);
  TREEDYN_EXPECT(found != values_.end());
  return found->second;
}

double GeneratedStep::seconds() {
  constexpr double kBatch = 2e-3;  // s
  constexpr int kBatches = 10;
  const Pointers in = pointers(in_);
  const auto time = [&](long count) {
    const auto start = std::chrono::steady_clock::now();
    library_->repeat()(in.data(), count);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  long count = 1;
  while (time(count) < kBatch) {
    count *= 2;
  }
  double least = time(count);
  for (int k = 1; k < kBatches; ++k) {
    least = std::min(least, time(count));
  }
  return least / static_cast<double>(count);
}

int GeneratedStep::call() {
  const int status = library_->step()(pointers(in_).data(), pointers(out_).data());
  for (std::size_t what = 0; what < repeated_.size(); ++what) {
    repeated_[what] = library_->repeated()(static_cast<int>(what));
  }
  // a step with events tells every integration; the first belongs to all
  long& advances = repeated_[static_cast<std::size_t>(program::Repeated::kAdvance)];
  advances = std::max(advances - 1, 0L);
  events_.clear();
  SteppedEvent event;
  while ((event.number = library_->events()(static_cast<int>(events_.size()), &event.at)) >= 0) {
    events_.push_back(event);
  }
  for (const auto& [from, to] : carried_) {
    *to = *from;
  }
  return status;
}

std::string status_names(int status) {
  constexpr std::array<const char*, 8> kBits = {"rank_lost",    "row_given_up", "no_convergence",
                                                "event_missed", "not_a_number", "guard_undefined",
                                                "event_late",   "turned_far"};
  std::string result;
  for (std::size_t k = 0; k < kBits.size(); ++k) {
    if ((status >> k) % 2 != 0) {
      result += result.empty() ? "" : ", ";
      result += kBits[k];
    }
  }
  return result;
}

}  // namespace treedyn
