// The manual page and the completion of the shell, from the help of the commands.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace treedyn {

/// treedyn.1, roff with the macros of man(7): every command with its options.
std::string manual_page(const CLI::App& app);

/// A script for bash (and zsh with bashcompinit): commands, options, words that an option takes,
/// files.
std::string bash_completion(const CLI::App& app);

}  // namespace treedyn
