// What to generate, and the words that say so: command line, manifest, Make rule.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "description/read.hpp"
#include "emit/unit.hpp"
#include "formulate/formulate.hpp"

namespace treedyn {

/// A wrong use of the command line that shows only when the model is read.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// How the generated step of a scene goes, instead of what the scene says.
struct StepChoice {
  std::optional<std::string> integrator;
  std::optional<Real> step;  ///< s
  std::optional<int> cuts;
  std::optional<bool> compensated;
};

/// What to generate: the options of the command line, checked.
struct Request {
  std::string model;                 ///< path, "-" for standard input; empty: the scene's own
  std::optional<std::string> scene;  ///< path of a scene file
  description::ReadOptions read;
  std::optional<std::string> name;  ///< file stem; default: the model's own
  emit::Language language = emit::Language::kCpp;
  std::optional<std::string> space;    ///< namespace of C++; default: the file stem
  std::optional<std::string> prefix;   ///< of C99; default: the file stem
  std::string section;                 ///< macro in front of every function; empty: none
  std::optional<std::string> points;   ///< --points; default: the model's own
  std::vector<std::string> functions;  ///< empty: the default set
  std::vector<std::string> equations;  ///< files with equations of the user
  std::vector<std::string> settings;   ///< files of options that have been taken in
  model::Vector3 gravity = {0, 0, Real("-9.81")};
  emit::Target target;
  std::optional<bool> vectors;  ///< of angles, instead of where they can be (`room_for_vectors`)
  std::string core;  ///< the processor that it is for, one of accuracy::cores(); empty: any
  int effort = formulate::Options{}.effort;
  formulate::ForwardDynamics forward_dynamics = formulate::ForwardDynamics::kCheapest;
  std::vector<formulate::Pass> without;  ///< passes that are switched off
  bool share_limbs = false;              ///< equal limbs share code
  bool metres = false;                   ///< all values in SI units, inside functions as well
  bool self_test = false;                ///< known answers and a function that compares with them
  bool checked = false;                  ///< functions that can fail have siblings with a status
  int accuracy_samples = 0;              ///< states in which errors are measured; 0: none
  StepChoice stepping;                   ///< of a scene
};

/// True if sines are placed late unless something else is asked for: processors that execute in
/// order spill fewer values then.
bool has_late_sines(const std::string& core);

/// True if the angles of a function can be worked on together, in vectors: those of one state,
/// before all that needs them, in C++.
bool room_for_vectors(const Request& request);

/// The option that lets limbs share code: --share-limbs, or --limb-lanes.
const char* sharing_option(const Request& request);

/// How a command names its files.
enum class Paths { kAsGiven, kBaseNames };

/// The command line that reproduces a request: only options that are not the defaults, no folder.
std::vector<std::string> generate_command(const Request& request, Paths paths);

/// The command that brings a folder up to date, quoted for a shell.
std::string update_command(const Request& request, const std::string& folder);

/// The options as the manifest states them, defaults included: names and JSON values.
std::vector<std::pair<std::string, std::string>> manifest_options(const Request& request);

/// A Make rule: the outputs depend on the inputs, each of which has an empty rule (as of gcc -MP),
/// so that make goes on where one is gone. \throws InputError for a control character in a path
std::string depfile_text(const std::vector<std::string>& outputs,
                         const std::vector<std::string>& inputs);

}  // namespace treedyn
