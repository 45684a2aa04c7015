#include "cli/settings_file.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
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
  return std::ranges::any_of(words,
                             [&](const std::string& word) { return is_word_of(option, word); });
}

/// A file that is read stands beside the settings that name it.
std::string in_folder_of(const std::string& file, const std::string& option,
                         const std::string& value) {
  const bool is_read = (option == "equations" || option == "scene") && value != "-";
  return is_read ? (fs::path(file).parent_path() / value).string() : value;
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

/// What stands behind `name =`: a value, values with commas or spaces between them, or a list of
/// them in brackets; in quotes as they stand; a comment behind.
class SettingValues {
 public:
  /// \param refuse  throws
  SettingValues(std::string_view text, const std::function<void(const std::string&)>& refuse)
      : rest_(text), refuse_(refuse) {}

  std::vector<std::string> all() {
    std::vector<std::string> result;
    const bool is_list = rest_.starts_with('[');
    rest_.remove_prefix(is_list ? 1 : 0);
    bool comma_may_follow = false;
    while (more(is_list, !result.empty() && !comma_may_follow)) {
      if (rest_.front() != ',') {
        result.push_back(one(is_list));
        comma_may_follow = true;
        continue;
      }
      if (!comma_may_follow) {
        refuse_("has a comma without a value before it; expected one");
      }
      comma_may_follow = false;
      rest_.remove_prefix(1);
    }
    return result;
  }

 private:
  /// False at the end of the values.
  bool more(bool is_list, bool behind_comma) {
    rest_ = trimmed(rest_);
    const bool at_end = rest_.empty() || rest_.front() == '#';
    if (!is_list) {
      if (at_end && behind_comma) {
        refuse_("has no value behind its last comma; expected one");
      }
      return !at_end;
    }
    if (at_end) {
      refuse_("has a list without end; expected a ] in the same line");
    }
    if (rest_.front() != ']') {
      return true;
    }
    rest_ = trimmed(rest_.substr(1));
    if (!rest_.empty() && rest_.front() != '#') {
      refuse_("has more behind its list; expected nothing or a comment");
    }
    return false;
  }

  std::string one(bool is_list) {
    const char quote = rest_.front();
    const bool is_quoted = quote == '"' || quote == '\'';
    const auto ends = [&](char c) {
      return is_blank(c) || c == ',' || c == '#' || (is_list && c == ']');
    };
    std::size_t size = 0;
    if (is_quoted) {
      size = rest_.find(quote, 1);
      if (size == rest_.npos) {
        refuse_(fmt::format("has a value without its second {}; expected one", quote));
      }
      ++size;
    }
    const std::string_view value = rest_.substr(0, size);
    std::size_t end = size;
    while (end < rest_.size() && !ends(rest_[end])) {
      ++end;
    }
    const std::string_view bare = rest_.substr(size, end - size);
    if ((is_quoted && !bare.empty()) || bare.find_first_of("\"'") != bare.npos) {
      refuse_("has a quote within a value; expected the whole value in quotes");
    }
    rest_.remove_prefix(end);
    return std::string(is_quoted ? value.substr(1, value.size() - 2) : bare);
  }

  std::string_view rest_;
  const std::function<void(const std::string&)>& refuse_;
};

/// The options of a settings file that are not given on the command line.
std::vector<std::string> settings_words(const std::string& file, const CLI::App& command,
                                        const std::vector<std::string>& given,
                                        std::map<std::string, Location>& places) {
  std::vector<std::string> result;
  std::istringstream text(description::read_text(file));
  int at = 0;
  for (std::string whole; std::getline(text, whole);) {
    ++at;
    if (at == 1 && whole.starts_with("\xEF\xBB\xBF")) {  // a byte order mark
      whole.erase(0, 3);
    }
    const std::string_view line = trimmed(whole);
    if (line.empty() || line.front() == '#' || line.front() == ';') {
      continue;
    }
    const auto refuse = [&](const std::string& what) {
      throw InputError({file, at, 0}, "settings: " + what);
    };
    const std::size_t equals = line.find('=');
    if (equals == line.npos || line.front() == '[') {
      refuse(
          fmt::format("'{}' is not usable; expected a line like scalar = \"float\"", shown(whole)));
    }
    const std::string name(trimmed(line.substr(0, equals)));
    const CLI::Option* const option = command.get_option_no_throw("--" + name);
    if (option == nullptr || name == "settings" || name == "help") {
      refuse(fmt::format(
          "--{0} is no option of {1} that may stand here; expected one of treedyn {1} --help",
          shown(name), command.get_name()));
    }
    if (is_given(*option, result)) {
      refuse(fmt::format("--{} stands here twice; expected it once", name));
    }
    const std::function<void(const std::string&)> refuse_value = [&](const std::string& what) {
      refuse(fmt::format("--{} {}", name, what));
    };
    std::vector<std::string> values =
        SettingValues(trimmed(line.substr(equals + 1)), refuse_value).all();
    if (name != "equations") {  // which are several files, others one list
      values = {fmt::format("{}", fmt::join(values, ","))};
    }
    if (values.empty() || std::ranges::find(values, "") != values.end()) {
      refuse_value("has no value; expected one");
    }
    if (!is_given(*option, given)) {
      for (const std::string& value : values) {
        result.push_back(fmt::format("--{}={}", name, in_folder_of(file, name, value)));
      }
      places["--" + name] = {file, at, 0};
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
