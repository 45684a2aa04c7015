// `treedyn accuracy`: what the accuracy of a scene's generated step costs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "accuracy/study.hpp"
#include "cli/accuracy_axes.hpp"
#include "pipeline.hpp"

namespace treedyn {

/// What to study: the options of the command line, checked.
struct AccuracyRequest {
  std::string scene;                              ///< path
  std::string output;                             ///< folder of the files; empty: text only
  std::vector<std::string> on = {"m4f", "host"};  ///< of accuracy::cores()
  std::vector<std::string> integrators;           ///< empty: the explicit ones with fixed steps
  std::vector<double> steps;     ///< s, parts of the time between comparisons; empty: a ladder
  std::optional<double> rate;    ///< Hz: only steps of which a whole number makes its period
  std::optional<double> target;  ///< of `error`
  int states = 8;                ///< in the band
  double spread = 0.01;          ///< of the band
  AccuracyAxes axes;
  std::string error = "joints";       ///< of accuracy::kErrors: of the target and the pictures
  std::optional<std::string> points;  ///< --points; default: those of the scene
  bool sizes = false;                 ///< what steps take of the processors
  bool time = false;                  ///< and of this machine
  accuracy::Limits limits;
  std::string parts;                 ///< folder of what is measured; empty: none
  bool joined = false;               ///< everything is there already
  std::string plan;                  ///< file of the commands of all settings that are not
  std::optional<long> part;          ///< the number of the only setting that is measured
  std::vector<std::string> command;  ///< words that measure the study, without those of a plan
};

using AccuracyTrace = std::function<void(const std::string&)>;
/// After each setting, with the part of all of them.
using AccuracyProgress = std::function<void(double)>;

/// Runs every setting over the band, or what `request` wants of it; nothing if that is not all.
/// \param warn  where the initial state was moved, not of one part
/// \throws InputError for mistakes in the scene or no compiler, or for parts that are missing
std::optional<accuracy::Study> study_accuracy(const AccuracyRequest& request,
                                              const AccuracyTrace& trace,
                                              const AccuracyProgress& progress, const Warn& warn);

/// Writes NAME_accuracy.csv, .json, .html and .svg, all or none; the text for standard output.
std::string write_accuracy(const AccuracyRequest& request, const accuracy::Study& study);

}  // namespace treedyn
