// What is written for one model, and the three files that come of it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emit/checked.hpp"
#include "emit/literal.hpp"
#include "model/tree.hpp"
#include "program/packed.hpp"
#include "program/stepper.hpp"

namespace treedyn::emit {

enum class Language { kCpp, kC99 };

/// What files that are made for one processor say of it.
struct Processor {
  std::string brief;      ///< Cortex-M4F
  std::string flags;      ///< of the compiler
  bool in_order = false;  ///< g++ has to leave the order of statements alone
  std::vector<std::pair<std::string, double>> cycles;  ///< of a call, by function
};

/// Where the values of a packed matrix belong, as the header says it.
struct PackedMatrix {
  std::string what;       ///< A, or a function of the user
  std::string constants;  ///< begin of the names of its tables: kMassMatrix
  program::Packing packing;
};

/// Everything that the generated files say.
struct Unit {
  std::string name;  ///< file stem
  Language language = Language::kCpp;
  std::string given_space;   ///< C++: the namespace; empty: the file stem
  std::string given_prefix;  ///< C99: before every name that others see; empty: the file stem
  std::string section;       ///< a macro of the user in front of every function; empty: none
  const model::Tree* tree = nullptr;
  model::Vector3 gravity{};   ///< nominal, for run-time parameters
  std::vector<Real> derived;  ///< what functions take of them
  std::vector<model::Point> points;
  std::vector<program::Function> functions;
  std::vector<Checked> checked;            ///< behind `functions`: siblings of some
  std::vector<program::Staged> staged;     ///< behind `checked`
  std::vector<program::Stepper> steppers;  ///< behind `staged`
  Target target;
  bool self_test = false;            ///< known answers of `functions`, and what compares with them
  std::vector<PackedMatrix> packed;  ///< if the target is packed; A first
  std::vector<std::string> command;  ///< program and arguments that reproduce the files
  std::string tool;                  ///< "treedyn 0.1.0", for the manifest only
  std::string model_file;            ///< base name, "-" for standard input
  std::string model_sha256;
  std::vector<std::pair<std::string, std::string>> options;  ///< for the manifest; values are JSON
  std::optional<Processor> processor;                        ///< none: they are for any
  std::map<std::string, std::string> errors;  ///< of functions, for the manifest; values are JSON

  /// Of the C++ text; of one that becomes C a name that no list of names has.
  [[nodiscard]] std::string space() const {
    return language == Language::kC99 ? "c99_text" : given_space.empty() ? name : given_space;
  }
  [[nodiscard]] const std::string& prefix() const {
    return given_prefix.empty() ? name : given_prefix;
  }
};

/// Cycles with two digits, as tables of operations tell no more: 4400.
std::string cycles_text(double cycles);

/// Operations of all functions together, of the dearest calls.
program::Cost total_cost(const Unit& unit);

/// Calls `visit(signature, cost of one call)` for all functions in their order in the header.
/// \param all  a Unit, or program::Programs
template <class All, class Visit>
void each_cost(const All& all, const std::vector<Checked>& siblings, Visit visit) {
  for (const program::Function& function : all.functions) {
    visit(function.signature, program::cost(function));
  }
  for (const Checked& sibling : siblings) {
    visit(sibling.signature, cost(sibling));
  }
  for (const program::Staged& staged : all.staged) {
    visit(staged.signature, program::cost(staged));
  }
  for (const program::Stepper& stepper : all.steppers) {
    visit(stepper.signature, program::step_cost(stepper));
  }
}

struct File {
  std::string name;
  std::string text;
};

/// The names of the files that `emit_files` makes, in its order: header, source, manifest.
std::vector<std::string> file_names(const std::string& name, Language language);

/// NAME.hpp and NAME.cpp, or NAME.h and NAME.c, and NAME.json; header and source carry the digest
/// of both. The same unit gives the same bytes everywhere. \throws std::range_error if a constant
/// is too large for the scalar type, std::invalid_argument if `section` is a name in the code.
std::vector<File> emit_files(const Unit& unit);

}  // namespace treedyn::emit
