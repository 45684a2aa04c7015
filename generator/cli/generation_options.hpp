// Options of commands that read a model and generate code. CLI11 is known here, in
// scene_commands, settings_file and command_line.cpp only.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "common/closest.hpp"
#include "request/request.hpp"

namespace treedyn {

/// The number that an option's text says. \throws CLI::ValidationError naming the option.
Real number(const std::string& option, const std::string& text);

/// The same above 0.
Real positive(const std::string& option, const std::string& text);

/// A whole number in decimal digits, zeros before it or not (CLI11 alone takes 010 for 8).
CLI::Validator whole(int least = std::numeric_limits<int>::min(),
                     int most = std::numeric_limits<int>::max());

/// A check whose words the option's type name already shows.
CLI::Validator one_of(const std::vector<std::string>& words);

/// An option of one word, which the help shows as `type`; `set` gets it.
CLI::Option* add_word(CLI::App& command, const std::string& name, const std::string& type,
                      const std::string& help, const std::function<void(const std::string&)>& set);
/// An option of a few words, which its type name shows; `set` gets the one that is given.
CLI::Option* add_choice(CLI::App& command, const std::string& name,
                        const std::vector<std::string>& words,
                        const std::function<void(const std::string&)>& set,
                        const std::string& help);

/// The names of rows of a table.
template <class List>
std::vector<std::string> words_of(const List& rows) {
  const std::vector<std::string_view> names = names_of(rows);
  return {names.begin(), names.end()};
}

/// MODEL and how it is read: --base, --snap, --mimic.
void add_model(CLI::App& command, Request& request);

/// All options of `generate`; MODEL is optional among them.
void add_generation(CLI::App& command, Request& request);

/// Sines in vectors where there is room for them, unless `--sincos` says otherwise.
/// \throws CLI::ValidationError for `--sincos vector` where there is none
void settle_vectors(Request& request);

}  // namespace treedyn
