// The words of a command line as settings; the only place that knows CLI11.
#pragma once

#include <optional>
#include <string>

#include "cli/accuracy.hpp"
#include "cli/simulate.hpp"
#include "pipeline.hpp"

namespace treedyn {

/// Exit codes, INTERFACE.md 2.
inline constexpr int kFailure = 1;
inline constexpr int kUsage = 2;

/// What a command line asks for.
struct Settings {
  std::string command;  ///< "generate", "check", ...
  Request request;
  SimulateRequest simulation;
  AccuracyRequest accuracy;
  std::string output;
  std::string depfile;
  std::string stamp;
  std::string dump;
  std::string error_format = "text";
  std::string list_of;
  std::string derivation;
  bool base_parameters = false;
  bool json = false;
  bool equations = false;
  bool passes = false;
  bool errors = false;  ///< info --accuracy
  bool numeric = false;
  bool quiet = false;
  bool verbose = false;
};

/// A command to run, or what to print and return at once.
struct CommandLine {
  Settings settings;
  std::optional<int> status;  ///< set if there is nothing to run: 0 for --help, kUsage for mistakes
  std::string out;            ///< for standard output
  std::string error;          ///< for standard error
};

CommandLine read_command_line(int argc, const char* const* argv);

}  // namespace treedyn
