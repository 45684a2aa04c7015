#include "cli/settings_file.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/read.hpp"

namespace treedyn {

namespace fs = std::filesystem;

namespace {

/// True if the word of a command line is this option, with its value or without.
bool is_word_of(const CLI::Option& option, const std::string& word) {
  const bool is_long = word.starts_with("--");
  return word.size() > 1 && word.front() == '-' &&
         option.check_name(is_long ? word.substr(0, word.find('=')) : word.substr(0, 2));
}

bool is_given(const CLI::Option& option, const std::vector<std::string>& words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return is_word_of(option, word); });
}

/// A file that is read stands beside the settings that name it.
std::string in_folder_of(const std::string& file, const std::string& option,
                         const std::string& value) {
  const bool is_read = (option == "equations" || option == "scene") && value != "-";
  return is_read ? (fs::path(file).parent_path() / value).string() : value;
}

/// The options of a settings file that are not given on the command line.
std::vector<std::string> settings_words(const std::string& file, const CLI::App& command,
                                        const std::vector<std::string>& given,
                                        std::map<std::string, Location>& places) {
  std::vector<std::string> result;
  std::istringstream text(description::read_text(file));
  int at = 0;
  for (std::string line; std::getline(text, line);) {
    ++at;
    if (at == 1 && line.starts_with("\xEF\xBB\xBF")) {  // a byte order mark
      line.erase(0, 3);
    }
    const auto refuse = [&](const std::string& what) {
      throw InputError({file, at, 0}, "settings: " + what);
    };
    std::istringstream one(line);
    for (const CLI::ConfigItem& item : CLI::ConfigTOML().from_config(one)) {
      if (line.find('=') == std::string::npos || !item.parents.empty() || item.inputs.empty()) {
        refuse(fmt::format("'{}' is not usable; expected a line like scalar = \"float\"",
                           shown(line)));
      }
      const CLI::Option* const option = command.get_option_no_throw("--" + item.name);
      if (option == nullptr || item.name == "settings" || item.name == "help") {
        refuse(
            fmt::format("--{0} is no option of {1} that may stand here; expected one of "
                        "treedyn {1} --help",
                        shown(item.name), command.get_name()));
      }
      if (is_given(*option, result)) {
        refuse(fmt::format("--{} stands here twice; expected it once", item.name));
      }
      const std::string value = fmt::format("{}", fmt::join(item.inputs, ","));
      if (value.empty()) {
        refuse(fmt::format("--{} has no value; expected one", item.name));
      }
      if (!is_given(*option, given)) {
        result.push_back(fmt::format("--{}={}", item.name, in_folder_of(file, item.name, value)));
        places["--" + item.name] = {file, at, 0};
      }
    }
  }
  return result;
}

}  // namespace

std::vector<std::string> with_settings(const std::vector<std::string>& words,
                                       const CLI::App& command,
                                       std::map<std::string, Location>& places) {
  constexpr std::string_view kOption = "--settings";
  std::vector<std::string> result;
  for (std::size_t k = 0; k < words.size(); ++k) {
    result.push_back(words[k]);
    const std::string_view word = words[k];
    const bool has_value = word.starts_with(kOption) && word.substr(kOption.size(), 1) == "=";
    if (!has_value && (word != kOption || k + 1 == words.size())) {
      continue;
    }
    const std::string file(has_value ? word.substr(kOption.size() + 1) : words[k + 1]);
    const std::vector<std::string> more = settings_words(file, command, words, places);
    if (!has_value) {
      result.push_back(words[++k]);
    }
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

}  // namespace treedyn
