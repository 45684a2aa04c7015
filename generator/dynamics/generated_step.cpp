#include "dynamics/generated_step.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "dynamics/shared_library.hpp"
#include "emit/template_file.hpp"

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

struct GeneratedStep::Library {
  explicit Library(const std::vector<emit::File>& files)
      : code("the generated step", files, {"-ffp-contract=off"}) {}

  SharedLibrary code;
  int (*step)(const long double* const*,
              long double* const*) = code.find<decltype(step)>("treedyn_step");
  int (*events)(int, long double*) = code.find<decltype(events)>("treedyn_event_of_step");
  long (*repeated)(int) = code.find<decltype(repeated)>("treedyn_repeated");
  void (*repeat)(const long double* const*, long) = code.find<decltype(repeat)>("treedyn_repeat");
};

GeneratedStep::GeneratedStep(const std::string& name, const std::vector<emit::File>& files,
                             program::Stepper stepper)
    : stepper_(std::move(stepper)) {
  for (const program::StepPhase& phase : stepper_.phases) {
    repeated_.resize(std::max(repeated_.size(), program::repeated_costs(stepper_, phase).size()));
  }
  std::vector<emit::File> sources = files;
  sources.push_back({"adapter.cpp", adapter(name, stepper_.signature, repeated_.size())});
  library_ = std::make_unique<Library>(sources);
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
    library_->repeat(in.data(), count);
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
  const int status = library_->step(pointers(in_).data(), pointers(out_).data());
  for (std::size_t what = 0; what < repeated_.size(); ++what) {
    repeated_[what] = library_->repeated(static_cast<int>(what));
  }
  // a step with events tells every integration; the first belongs to all
  long& advances = repeated_[static_cast<std::size_t>(program::Repeated::kAdvance)];
  advances = std::max(advances - 1, 0L);
  events_.clear();
  SteppedEvent event;
  while ((event.number = library_->events(static_cast<int>(events_.size()), &event.at)) >= 0) {
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
