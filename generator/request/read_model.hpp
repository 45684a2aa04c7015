// From files to a model and what was asked of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene.hpp"
#include "model/tree.hpp"
#include "request/request.hpp"
#include "request/user_equations.hpp"

namespace treedyn {

/// Where the model came from.
struct Source {
  std::string file;  ///< base name, "-" for standard input
  std::string sha256;
};

/// The model and everything that was asked of it.
struct Model {
  Source source;
  std::string name;
  model::Tree tree;
  std::vector<model::Point> points;
  std::vector<std::string> functions;        ///< of the model alone
  UserFunctions equations;                   ///< functions that users wrote
  std::optional<model::Scene> scene;         ///< its tree is `tree`
  std::vector<std::string> scene_functions;  ///< empty: all that the scene needs
};

/// Text or file to tree, points and the list of functions.
/// \throws InputError for mistakes in the model, or a function that it does not have.
Model read(const Request& request);

/// \throws InputError if a function solves for accelerations that the tree does not determine
void require_solution(const model::Tree& tree, const std::string& function);

/// The request with the gravity and the base that a scene decides.
Request decided_request(const Model& model, Request request);

/// The files that were read; standard input is none.
std::vector<std::string> input_files(const Model& model, const Request& request);

/// Remarks on a model that do not stop the program.
std::vector<Warning> warnings_of(const Model& model, const Request& request);

/// What impacts stop and a generated step of the scene does not keep there.
std::vector<Warning> impacts_without_rest(const model::Scene& scene, const Location& where);

}  // namespace treedyn
