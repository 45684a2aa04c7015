#include "cli/pages.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "common/transformed.hpp"
#include "version.hpp"

namespace treedyn {

namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// All options and positionals of a command, `--help` excepted.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options(
      [](const CLI::Option* option) { return !option->check_lname("help"); });
}

/// Backslashes, and points and quotes at the beginning of a line, mean something to roff.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
  }
  return "\\&" + result;
}

/// `early|late` as "early late"; empty if an option takes something else.
std::string choices_of(const CLI::Option& option) {
  std::string type = option.get_type_name();
  if (type.find('|') == std::string::npos) {
    return {};
  }
  std::ranges::replace(type, '|', ' ');
  return type;
}

std::string names_of(const CLI::Option& option, const char* between) {
  std::vector<std::string> names =
      transformed(option.get_snames(), [](const std::string& name) { return "-" + name; });
  for (const std::string& name : option.get_lnames()) {
    names.push_back("--" + name);
  }
  return fmt::format("{}", fmt::join(names, between));
}

/// "-o, --output DIR", "--effort N=2000"
std::string words_of(const CLI::Option& option) {
  const std::string words =
      option.get_positional() ? option.get_name(true) : names_of(option, ", ");
  const std::string type =
      option.get_positional() && choices_of(option).empty() ? "" : option.get_type_name();
  const std::string value = option.get_default_str();
  return words + (type.empty() ? "" : " " + type) + (value.empty() ? "" : "=" + value);
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH TREEDYN 1 \"\" \"treedyn {}\" \"User Commands\"\n.SH NAME\ntreedyn \\- {}\n"
      ".SH SYNOPSIS\n.B treedyn\n.I COMMAND\n[options]\n.SH COMMANDS\n",
      kVersion, roff(app.get_description()));
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format(".SS {}\n{}\n", roff("treedyn " + command->get_name()),
                        roff(command->get_description()));
    for (const CLI::Option* option : options_of(*command)) {
      text +=
          fmt::format(".TP\n.B {}\n{}\n", roff(words_of(*option)), roff(option->get_description()));
    }
  }
  return text +
         ".SH EXIT STATUS\n0: success; 1: files, models, points or writing, a check that "
         "differs, findings of vet, a motion that ends early, a --target of accuracy that is not "
         "reached; 2: wrong usage.\n";
}

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    std::vector<std::string> options;
    std::string words;
    std::string choices;
    for (const CLI::Option* option : options_of(*command)) {
      const std::string of_option = choices_of(*option);
      if (option->get_positional()) {
        words += (words.empty() ? "" : " ") + of_option;
        continue;
      }
      options.push_back(names_of(*option, " "));
      if (!of_option.empty()) {
        choices += fmt::format("        {}) words='{}' ;;\n", names_of(*option, "|"), of_option);
      }
    }
    cases += fmt::format("    {})\n      words='{}{}{}'\n", command->get_name(), words,
                         words.empty() ? "" : " ", fmt::join(options, " "));
    cases += choices.empty()
                 ? "      ;;\n"
                 : fmt::format("      case $before in\n{}      esac\n      ;;\n", choices);
  }
  return fmt::format(R"(# bash completion for treedyn
_treedyn() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words
  case $COMP_CWORD in
    1) words='{}' ;;
    *) case ${{COMP_WORDS[1]}} in
{}    esac ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}}
complete -o default -F _treedyn treedyn
)",
                     fmt::join(names, " "), cases);
}

}  // namespace treedyn
