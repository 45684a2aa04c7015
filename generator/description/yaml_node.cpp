#include "description/yaml_node.hpp"

#include <yaml.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/transformed.hpp"
#include "description/yaml_hints.hpp"

namespace treedyn::description {

namespace {

constexpr std::size_t kMostNestedNodes = 32;
constexpr std::size_t kMaxValues = 1'000'000;

int to_int(std::size_t n) { return static_cast<int>(std::min<std::size_t>(n, 2'000'000'000)); }

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

Place place(const yaml_mark_t& mark) { return {to_int(mark.line) + 1, to_int(mark.column) + 1}; }

/// Line and column of a byte; a column counts bytes here, for the text may be no UTF-8.
Place place_of_byte(const std::string& text, std::size_t offset) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  const auto line = std::count(text.begin(), end, '\n');
  const std::size_t start = text.rfind('\n', offset == 0 ? 0 : offset - 1);
  const std::size_t column = start == std::string::npos || line == 0 ? offset : offset - start - 1;
  return {static_cast<int>(line) + 1, to_int(column) + 1};
}

/// The 16 bits of an escape \u and four digits at `at`.
std::optional<unsigned> escaped_at(std::string_view text, std::size_t at) {
  constexpr std::size_t kDigits = 4;
  unsigned code = 0;
  if (at > text.size() || !text.substr(at).starts_with("\\u") || text.size() < at + 2 + kDigits) {
    return std::nullopt;
  }
  const char* const first = text.data() + at + 2;
  const bool is_code = std::from_chars(first, first + kDigits, code, 16).ptr == first + kDigits;
  return is_code ? std::optional(code) : std::nullopt;
}

/// JSON escapes a character beyond 16 bits by two surrogates, YAML by one \U. What follows
/// on the line is told two columns further left. Other files are left as they are.
std::string with_yaml_escapes(std::string text) {
  constexpr std::size_t kLength = 6;
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || (text[begin] != '{' && text[begin] != '[') ||
      text.find('\'') != std::string::npos) {
    return text;
  }
  for (std::size_t at = text.find("\\u"); at != std::string::npos; at = text.find("\\u", at + 1)) {
    const std::size_t before = text.find_last_not_of('\\', at);
    const std::size_t backslashes = before == std::string::npos ? at : at - before - 1;
    const std::optional<unsigned> high = escaped_at(text, at);
    const std::optional<unsigned> low = escaped_at(text, at + kLength);
    if (backslashes % 2 == 0 && high && low && *high >= 0xD800 && *high < 0xDC00 &&
        *low >= 0xDC00 && *low < 0xE000) {
      const unsigned code = 0x10000 + ((*high - 0xD800) << 10U) + (*low - 0xDC00);
      text.replace(at, 2 * kLength, fmt::format("\\U{:08X}", code));
    }
  }
  return text;
}

/// Finds lines of a text, asked for in ascending order. Linear in all.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// The bytes from the beginning of line `first` to the end of line `last`.
  std::string_view between(int first, int last) {
    while (line_ < first) {
      start_ = after(start_);
      ++line_;
    }
    std::size_t end = start_;
    for (int line = first; line <= last; ++line) {
      end = after(end);
    }
    return text_.substr(start_, end - start_);
  }

 private:
  [[nodiscard]] std::size_t after(std::size_t start) const {
    const std::size_t end = text_.find('\n', start);
    return end == std::string_view::npos ? text_.size() : end + 1;
  }

  std::string_view text_;
  int line_ = 1;
  std::size_t start_ = 0;
};

/// Where the characters of a folded value stand in the lines from that of `start` on: white space
/// may be others there. The last place is that of the end.
std::vector<Place> places_of(std::string_view value, std::string_view lines, Place start) {
  auto at = static_cast<std::size_t>(start.column - 1);
  std::vector<Place> places;
  for (const char c : value) {
    while (!is_blank(c) && at < lines.size() && lines[at] != c) {
      start = lines[at++] == '\n' ? Place{start.line + 1, 1} : Place{start.line, start.column + 1};
    }
    places.push_back(start);
    if (!is_blank(c)) {
      ++at;
      ++start.column;
    }
  }
  places.push_back(start);
  return places;
}

bool is_null(const std::string& text) {
  return text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL";
}

/// libyaml's parser and the event it made last.
class Events {
 public:
  Events(const std::string& text, const std::string& file) : text_(text), file_(file) {
    if (yaml_parser_initialize(&parser_) == 0) {
      throw InputError({file, 0, 0}, "out of memory");
    }
    const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
    yaml_parser_set_input_string(&parser_, bytes, text.size());
  }
  ~Events() {
    drop();
    yaml_parser_delete(&parser_);
  }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;

  const yaml_event_t& next() {
    drop();
    if (yaml_parser_parse(&parser_, &event_) == 0) {
      fail();
    }
    held_ = true;
    return event_;
  }

 private:
  void drop() {
    if (held_) {
      yaml_event_delete(&event_);
    }
    held_ = false;
  }

  [[noreturn]] void fail() const {
    const char* const problem = parser_.problem == nullptr ? "malformed" : parser_.problem;
    const bool of_bytes = parser_.error == YAML_READER_ERROR;
    const Place where =
        of_bytes ? place_of_byte(text_, parser_.problem_offset) : place(parser_.problem_mark);
    throw InputError(where.in(file_), yaml_message(text_, where, problem));
  }

  const std::string& text_;
  const std::string& file_;
  yaml_parser_t parser_{};
  yaml_event_t event_{};
  bool held_ = false;
};

/// Makes nodes of events with a stack of its own: no recursion.
class NodeBuilder {
 public:
  NodeBuilder(const std::string& text, const std::string& file) : lines_(text), file_(file) {}

  void add(const yaml_event_t& event) {
    switch (event.type) {
      case YAML_SCALAR_EVENT:
        scalar(event);
        break;
      case YAML_SEQUENCE_START_EVENT:
        open(event, NodeKind::kSequence, event.data.sequence_start.anchor,
             event.data.sequence_start.tag);
        break;
      case YAML_MAPPING_START_EVENT:
        open(event, NodeKind::kMapping, event.data.mapping_start.anchor,
             event.data.mapping_start.tag);
        break;
      case YAML_SEQUENCE_END_EVENT:
      case YAML_MAPPING_END_EVENT:
        close();
        break;
      case YAML_ALIAS_EVENT:
        fail(place(event.start_mark), "aliases are not supported; expected the value itself");
      default:
        break;
    }
  }

  Node take_root() { return std::move(root_); }

 private:
  [[noreturn]] void fail(const Place& where, const std::string& message) const {
    throw InputError(where.in(file_), message);
  }

  void refuse_properties(const yaml_event_t& event, const yaml_char_t* anchor,
                         const yaml_char_t* tag) const {
    if (anchor != nullptr || tag != nullptr) {
      fail(place(event.start_mark), "anchors and tags are not supported; expected a plain value");
    }
  }

  [[nodiscard]] bool expects_key() const {
    return !open_.empty() && open_.back().kind == NodeKind::kMapping && !has_key_;
  }

  void scalar(const yaml_event_t& event) {
    const auto& scalar = event.data.scalar;
    refuse_properties(event, scalar.anchor, scalar.tag);
    const std::string text(reinterpret_cast<const char*>(scalar.value), scalar.length);
    const Place where = place(event.start_mark);
    if (expects_key()) {
      key_ = {text, where};
      has_key_ = true;
      return;
    }
    Node node;
    node.empty = scalar.style == YAML_PLAIN_SCALAR_STYLE && is_null(text);
    node.text = text;
    node.where = where;
    if (scalar.style != YAML_PLAIN_SCALAR_STYLE) {
      ++node.where.column;  // of the first character, behind the quote
    }
    if (event.start_mark.line != event.end_mark.line) {
      const bool is_block =
          scalar.style == YAML_LITERAL_SCALAR_STYLE || scalar.style == YAML_FOLDED_SCALAR_STYLE;
      const Place first = is_block ? Place{node.where.line + 1, 1} : node.where;
      node.where.characters = std::make_shared<const std::vector<Place>>(
          places_of(text, lines_.between(first.line, to_int(event.end_mark.line) + 1), first));
    }
    attach(std::move(node));
  }

  void open(const yaml_event_t& event, NodeKind kind, const yaml_char_t* anchor,
            const yaml_char_t* tag) {
    const Place where = place(event.start_mark);
    refuse_properties(event, anchor, tag);
    if (expects_key()) {
      fail(where, "key is not a scalar; expected a word");
    }
    if (open_.size() == kMostNestedNodes) {
      fail(where, fmt::format("nested too deeply; expected at most {} levels", kMostNestedNodes));
    }
    Node node;
    node.kind = kind;
    node.where = where;
    node.key = std::exchange(key_, {});
    has_key_ = false;
    open_.push_back(std::move(node));
  }

  void close() {
    Node node = std::move(open_.back());
    open_.pop_back();
    if (node.kind == NodeKind::kMapping) {
      refuse_duplicate_keys(node);
    }
    key_ = node.key;
    has_key_ = true;
    attach(std::move(node));
  }

  void attach(Node node) {
    if (++values_ > kMaxValues) {
      fail(node.where, fmt::format("too many values; expected at most {}", kMaxValues));
    }
    node.key = std::exchange(key_, {});
    has_key_ = false;
    if (open_.empty()) {
      root_ = std::move(node);
    } else {
      open_.back().items.push_back(std::move(node));
    }
  }

  void refuse_duplicate_keys(const Node& mapping) const {
    std::vector<const Node*> sorted =
        transformed(mapping.items, [](const Node& item) { return &item; });
    std::ranges::stable_sort(
        sorted, [](const Node* a, const Node* b) { return a->key.text < b->key.text; });
    const auto twice = std::ranges::adjacent_find(
        sorted, [](const Node* a, const Node* b) { return a->key.text == b->key.text; });
    if (twice != sorted.end()) {
      const Text& second = (*std::next(twice))->key;
      fail(second.where, fmt::format("key '{}' is repeated, first in line {}; expected it once",
                                     shown(second.text), (*twice)->key.where.line));
    }
  }

  Lines lines_;
  const std::string& file_;
  std::vector<Node> open_;
  Node root_;
  Text key_;
  bool has_key_ = false;
  std::size_t values_ = 0;
};

}  // namespace

Node parse_yaml_node(const std::string& text, const std::string& file, const std::string& what) {
  const std::string yaml = with_yaml_escapes(text);
  Events events(yaml, file);
  NodeBuilder builder(yaml, file);
  int documents = 0;
  while (true) {
    const yaml_event_t& event = events.next();
    if (event.type == YAML_STREAM_END_EVENT) {
      break;
    }
    if (event.type == YAML_DOCUMENT_START_EVENT && ++documents > 1) {
      const Place where = place(event.start_mark);
      throw InputError(where.in(file), "second document; expected one");
    }
    builder.add(event);
  }
  if (documents == 0) {
    throw InputError({file, 1, 1}, "file is empty; expected " + what);
  }
  return builder.take_root();
}

const Node* find(const Node& mapping, std::string_view key) {
  const auto item =
      std::ranges::find_if(mapping.items, [key](const Node& n) { return n.key.text == key; });
  return item == mapping.items.end() ? nullptr : &*item;
}

}  // namespace treedyn::description
