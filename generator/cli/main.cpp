// The command line: options to pipeline, results to the user. Nothing else prints.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <new>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/base_parameters.hpp"
#include "cli/check.hpp"
#include "cli/command_line.hpp"
#include "cli/dump.hpp"
#include "cli/info.hpp"
#include "cli/numeric.hpp"
#include "cli/simulate.hpp"
#include "cli/vet.hpp"
#include "common/decimal.hpp"
#include "pipeline.hpp"
#include "stages/function_accuracy.hpp"
#include "stages/stages.hpp"
#include "system/files.hpp"

namespace {

using namespace treedyn;  // NOLINT(google-build-using-namespace): this is its program

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }
void print_error(const std::string& text) { std::fputs(text.c_str(), stderr); }

Warn warn_of(const Settings& settings) {
  return [quiet = settings.quiet](const Warning& warning) {
    if (!quiet) {
      print_error(fmt::format("{}: warning: {}\n", to_string(warning.where), warning.message));
    }
  };
}

void print_warnings(const Settings& settings, const std::vector<Warning>& warnings) {
  std::ranges::for_each(warnings, warn_of(settings));
}

Trace trace_of(const Settings& settings) {
  return [verbose = settings.verbose](const std::string& line) {
    if (verbose) {
      print_error(line + "\n");
    }
  };
}

std::vector<std::string> paths(const Settings& settings, const std::string& name) {
  std::vector<std::string> result;
  for (const std::string& file : emit::file_names(name, settings.request.language)) {
    result.push_back((std::filesystem::path(settings.output) / file).string());
  }
  return result;
}

std::atomic<bool> interrupted = false;

/// A line on a terminal after the first second, and whether to go on.
class Progress {
 public:
  bool operator()(double part) {
    using std::chrono::steady_clock;
    const steady_clock::time_point now = steady_clock::now();
    if (on_terminal_ && now - shown_ > std::chrono::milliseconds(200) &&
        now - start_ > std::chrono::seconds(1)) {
      const double spent = std::chrono::duration<double>(now - start_).count();
      const double left = part > 0 ? spent * (1 - part) / part : 0;
      print_error(fmt::format("\r{:3.0f} %, {:.0f} s left   ", 100 * part, left));
      shown_ = now;
    }
    return !interrupted;
  }
  void end() const {
    print_error(shown_ == std::chrono::steady_clock::time_point{} ? ""
                                                                  : "\r                    \r");
  }

 private:
  bool on_terminal_ = ::isatty(STDERR_FILENO) == 1;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_;
};

/// Lines for a reader who wants them, else a part of the way on a terminal.
class FunctionsDone {
 public:
  FunctionsDone(const Settings& settings, const Model& model)
      : settings_(settings),
        all_(model.functions.size() + model.equations.size() + (model.scene ? 1 : 0)) {}
  void operator()(const std::string& line) {
    trace_of(settings_)(line);
    done_ = std::min(done_ + 1, all_);
    if (!settings_.verbose && !settings_.quiet) {
      progress_(static_cast<double>(done_) / static_cast<double>(all_));
    }
  }
  void end() const { progress_.end(); }

 private:
  const Settings& settings_;
  std::size_t all_;
  std::size_t done_ = 0;
  Progress progress_;
};

/// The path that a file has without links; where they lead nowhere, the one that it was given.
std::filesystem::path place_of(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path place = fs::weakly_canonical(file, error);
  if (error) {
    place = fs::absolute(file, error);
  }
  return error ? fs::path(file) : place;
}

/// Files are read and written as different ones. \throws UsageError for one that is both, or that
/// is written twice
void refuse_overwriting(const std::vector<std::string>& read,
                        const std::vector<std::string>& written) {
  std::set<std::filesystem::path> taken;
  for (const std::string& file : read) {
    taken.insert(place_of(file));
  }
  for (const std::string& file : written) {
    if (!taken.insert(place_of(file)).second) {
      throw UsageError(fmt::format(
          "{}: would be overwritten by another file; expected another path", shown(file)));
    }
  }
}

int run_generate(const Settings& settings) {
  if (!settings.dump.empty()) {
    print(dump(settings.request, settings.dump));
    return 0;
  }
  const auto start = std::chrono::steady_clock::now();
  const Model model = read(settings.request);
  const std::vector<std::string> places = paths(settings, model.name);
  std::vector<std::string> written = places;
  for (const std::string& file : {settings.depfile, settings.stamp}) {
    if (!file.empty()) {
      written.push_back(file);
    }
  }
  refuse_overwriting(input_files(model, settings.request), written);
  print_warnings(settings, warnings_of(model, settings.request));
  if (model.scene) {
    if (const auto warning = warning_of_start(settings.request.scene.value_or(""), *model.scene)) {
      print_warnings(settings, {*warning});
    }
  }
  FunctionsDone done(settings, model);
  const std::vector<emit::File> files =
      generate(model, settings.request, std::ref(done), warn_of(settings));
  done.end();
  std::vector<OutputFile> outputs;
  for (std::size_t k = 0; k < files.size(); ++k) {
    outputs.push_back({places[k], files[k].text});
  }
  if (!settings.depfile.empty()) {
    const std::vector<std::string> targets =
        settings.stamp.empty() ? places : std::vector<std::string>{settings.stamp};
    outputs.push_back(
        {settings.depfile, depfile_text(targets, input_files(model, settings.request))});
  }
  if (!settings.stamp.empty()) {
    outputs.push_back({settings.stamp, "", true});
  }
  const int changed = write_files(outputs);
  trace_of(settings)(fmt::format("{} of {} files written", changed, outputs.size()));
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  trace_of(settings)(fmt::format("in all: {:.1f} s", time.count()));
  return 0;
}

/// \throws UsageError for an option that is for models without run-time parameters
void refuse_with_parameters(const Model& model, bool given, const char* option) {
  if (given && !model.tree.parameters.empty()) {
    throw UsageError(fmt::format(
        "{} is for models without run-time parameters; expected a model without, or no {}", option,
        option));
  }
}

int run_check(const Settings& settings) {
  const Model model = read(settings.request);
  refuse_with_parameters(model, settings.numeric, "--numeric");
  print_warnings(settings, warnings_of(model, settings.request));
  const std::vector<emit::File> files =
      generate(model, settings.request, trace_of(settings), warn_of(settings));
  const std::string report = check_files(files, settings.output);
  if (report.empty()) {
    return 0;
  }
  print(report);
  if (settings.numeric) {
    print(numeric_report(model, settings.request, files, settings.output));
  }
  print(fmt::format("to update: {}\n", report.starts_with("surplus: ")
                                           ? "remove what is surplus"
                                           : update_command(settings.request, settings.output)));
  return kFailure;
}

int run_outputs(const Settings& settings) {
  for (const std::string& path : paths(settings, read(settings.request).name)) {
    print(path + "\n");
  }
  return 0;
}

std::string errors_text(const Model& model, const Settings& settings) {
  constexpr int kStates = 200;
  const int states = settings.request.accuracy_samples;
  const accuracy::FunctionStudy study =
      function_accuracy(model, settings.request, states > 0 ? states : kStates, trace_of(settings));
  return settings.json ? accuracy::functions_json(study) : accuracy::functions_text(study);
}

std::string costs_text(const Model& model, const Settings& settings) {
  program::Programs programs = formulate_model(model, settings.request, trace_of(settings));
  separate_parameters(model, settings.request, programs);
  require_use_of_parameters(model, settings.request, programs);
  programs = in_scalar(std::move(programs), model, settings.request.target.scalar);
  return settings.json ? info_json(model, settings.request, programs)
                       : info_text(model, settings.request, programs);
}

int run_info(const Settings& settings) {
  const Model model = read(settings.request);
  refuse_with_parameters(model, settings.errors, "--accuracy");
  refuse_with_parameters(model, settings.passes, "--passes");
  print_warnings(settings, warnings_of(model, settings.request));
  print(settings.equations ? equations_text(model, settings.request)
        : !settings.derivation.empty()
            ? derivation_text(model, settings.request, settings.derivation)
        : settings.base_parameters ? base_parameters_text(model, settings.request, settings.json)
        : settings.passes          ? passes_text(model, settings.request)
        : settings.errors          ? errors_text(model, settings)
                                   : costs_text(model, settings));
  return 0;
}

int run_vet(const Settings& settings) {
  const std::vector<Finding> findings = vet(settings.request);
  print(findings_text(findings, settings.error_format));
  return findings.empty() ? 0 : kFailure;
}

int run_list(const Settings& settings) {
  print(settings.list_of == "functions" ? list_functions()
        : settings.list_of == "effects" ? list_effects()
                                        : list_integrators());
  return 0;
}

int run_simulate(const Settings& settings) {
  if (std::signal(SIGINT, [](int) { interrupted = true; }) == SIG_IGN) {  // as a script's `&` does
    std::signal(SIGINT, SIG_IGN);  // else what was computed is written
  }
  Progress progress;
  SimulateRequest request = settings.simulation;
  request.timed = settings.verbose;
  const SimulateResult result = simulate(request, std::ref(progress));
  progress.end();
  const auto warn = [&](const std::string& line) {
    if (!settings.quiet) {
      print_error(fmt::format("{}: warning: {}\n", settings.simulation.scene, line));
    }
  };
  std::ranges::for_each(warnings_of(result), warn);
  std::ranges::for_each(facts_of(result), trace_of(settings));
  std::ranges::for_each(status_lines(result.statuses), warn);
  print(write_simulation(settings.simulation, result));
  if (!result.recording.stopped.empty()) {
    throw InputError(
        {settings.simulation.scene, 0, 0},
        fmt::format("the motion ends at t = {:.6g} s: {}; expected it to last {:.6g} s",
                    result.recording.end, result.recording.stopped,
                    static_cast<double>(result.scene.duration)));
  }
  return 0;
}

int run_accuracy(const Settings& settings) {
  Progress progress;
  const std::optional<accuracy::Study> found =
      study_accuracy(settings.accuracy, trace_of(settings), std::ref(progress), warn_of(settings));
  progress.end();
  if (!found) {
    return 0;
  }
  const accuracy::Study& study = *found;
  print(write_accuracy(settings.accuracy, study));
  const std::optional<double>& target = settings.accuracy.target;
  const std::vector<std::string>& on = settings.accuracy.on;
  return !target || std::all_of(on.begin(), on.end(),
                                [&](const std::string& core) {
                                  return accuracy::cheapest(study, *accuracy::find_core(core),
                                                            *target);
                                })
             ? 0
             : kFailure;
}

int run(const Settings& settings) {
  static const std::map<std::string, int (*)(const Settings&)> commands = {
      {"generate", run_generate}, {"check", run_check},      {"outputs", run_outputs},
      {"info", run_info},         {"vet", run_vet},          {"list", run_list},
      {"simulate", run_simulate}, {"accuracy", run_accuracy}};
  return commands.at(settings.command)(settings);
}

/// The only place where exceptions end.
int run_and_report(const Settings& settings) {
  try {
    return run(settings);
  } catch (const InputError& error) {
    print_error(error.where().file.empty() ? fmt::format("treedyn: {}\n", error.message())
                                           : fmt::format("{}\n", error.what()));
  } catch (const UsageError& error) {
    print_error(fmt::format("treedyn: {}; see treedyn --help\n", error.what()));
    return kUsage;
  } catch (const std::bad_alloc&) {
    print_error("treedyn: out of memory\n");
  } catch (const std::exception& error) {
    print_error(fmt::format("treedyn: internal error: {}\n", error.what()));
  }
  return kFailure;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a full quota is an error of write(), reported like others
  const CommandLine line = read_command_line(argc, argv);
  print(line.out);
  print_error(line.error);
  const int status = line.status ? *line.status : run_and_report(line.settings);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    print_error("treedyn: cannot write to standard output\n");
    return kFailure;
  }
  return status;
}
