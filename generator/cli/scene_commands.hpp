// Commands that read a scene: `simulate` and `accuracy`.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/command_line.hpp"

namespace treedyn {

/// --quiet and --verbose, of every command.
void add_talk(CLI::App& command, Settings& settings);

void add_accuracy(CLI::App& app, Settings& settings);
void add_simulate(CLI::App& app, Settings& settings);

/// Processors, integrators and steps that stand in the lists twice count once.
void tidy_study(AccuracyRequest& request);

}  // namespace treedyn
