// --settings FILE: options that stand in a file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/error.hpp"

namespace treedyn {

/// The words of a command line, behind `--settings FILE` the options that stand in FILE and are not
/// among the words. \param command  whose options they are
/// \param places  gets where these options stand
/// \throws InputError for a file that cannot be read, and for lines that are none of them
std::vector<std::string> with_settings(const std::vector<std::string>& words,
                                       const CLI::App& command,
                                       std::map<std::string, Location>& places);

}  // namespace treedyn
