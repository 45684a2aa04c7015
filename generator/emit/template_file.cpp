#include "emit/template_file.hpp"

#include <set>

#include "common/error.hpp"

namespace treedyn::emit {

std::string fill(std::string_view text, const std::map<std::string, std::string>& slots) {
  std::string result;
  std::set<std::string> used;
  std::size_t at = 0;
  for (std::size_t open = text.find('@'); open != std::string_view::npos;
       open = text.find('@', at)) {
    const std::size_t close = text.find('@', open + 1);
    TREEDYN_EXPECT(close != std::string_view::npos);
    const std::string slot(text.substr(open + 1, close - open - 1));
    TREEDYN_EXPECT(slots.contains(slot));
    used.insert(slot);
    result += text.substr(at, open - at);
    result += slots.at(slot);
    at = close + 1;
    const bool own_line = (open == 0 || text[open - 1] == '\n') && at < text.size() &&
                          text[at] == '\n' && slots.at(slot).empty();
    at += own_line ? 1 : 0;
  }
  TREEDYN_EXPECT(used.size() == slots.size());
  return result.append(text.substr(at));
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

}  // namespace treedyn::emit
