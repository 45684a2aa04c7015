// Options of commands that read a model and generate code. CLI11 is known here, in
// scene_commands and in command_line.cpp only.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/error.hpp"
#include "request/request.hpp"

namespace treedyn {

/// The number that an option's text says. \throws CLI::ValidationError naming the option.
Real number(const std::string& option, const std::string& text);

/// The same above 0.
Real positive(const std::string& option, const std::string& text);

/// A check whose words the option's type name already shows.
CLI::Validator one_of(const std::vector<std::string>& words);

/// MODEL and how it is read: --base, --snap, --mimic.
void add_model(CLI::App& command, Request& request);

/// All options of `generate`; MODEL is optional among them.
void add_generation(CLI::App& command, Request& request);

/// Sines in vectors where there is room for them, unless `--sincos` says otherwise.
/// \throws CLI::ValidationError for `--sincos vector` where there is none
void settle_vectors(Request& request);

/// The words of a command line, behind `--settings FILE` the options that stand in FILE and are not
/// among the words. \param command  whose options they are
/// \param places  gets where these options stand
/// \throws InputError for a file that cannot be read, and for lines that are none of them
std::vector<std::string> with_settings(const std::vector<std::string>& words,
                                       const CLI::App& command,
                                       std::map<std::string, Location>& places);

}  // namespace treedyn
