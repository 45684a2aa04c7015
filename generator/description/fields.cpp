#include "description/fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/transformed.hpp"

namespace treedyn::description {

namespace {

std::string_view kind(const Node& node) {
  switch (node.kind) {
    case NodeKind::kSequence:
      return "a list";
    case NodeKind::kMapping:
      return "a mapping";
    default:
      return node.empty ? "empty" : "a single value";
  }
}

}  // namespace

Fields::Fields(const std::string& file, const Node& node, std::string what, const Keys& keys,
               const Keys& ignored)
    : file_(file), node_(node), what_(std::move(what)) {
  if (node.kind != NodeKind::kMapping) {
    fail(node.where, fmt::format("is no mapping; expected the keys {}", fmt::join(keys, ", ")));
  }
  for (const Node& item : node.items) {
    if (!is_known(item.key.text, keys) && !is_known(item.key.text, ignored)) {
      fail(item.key.where,
           fmt::format("unknown key '{}'{}; expected one of {}", shown(item.key.text),
                       did_you_mean(item.key.text, keys), fmt::join(keys, ", ")));
    }
  }
}

void Fields::fail(const Place& where, const std::string& message) const {
  throw InputError(where.in(file_), fmt::format("{}: {}", what_, message));
}

const Node* Fields::find(std::string_view key) const { return description::find(node_, key); }

const Node& Fields::get(std::string_view key) const {
  const Node* const node = find(key);
  if (node == nullptr) {
    fail(node_.where, fmt::format("key '{}' is missing; expected it here", key));
  }
  return *node;
}

Text Fields::scalar(const Node& node) const {
  if (node.kind != NodeKind::kScalar || node.empty) {
    fail(node.where, fmt::format("{} is {}; expected a single value", described(node), kind(node)));
  }
  return {node.text, node.where};
}

std::optional<Text> Fields::optional_text(std::string_view key) const {
  const Node* const node = find(key);
  return node == nullptr ? std::nullopt : std::optional<Text>(scalar(*node));
}

std::optional<Numbers> Fields::numbers(std::string_view key) const {
  const Node* const node = find(key);
  return node == nullptr ? std::nullopt : std::optional<Numbers>(numbers(*node));
}

Numbers Fields::numbers(const Node& node) const {
  return {transformed(sequence(node), [this](const Node& item) { return scalar(item); }),
          node.where};
}

const std::vector<Node>& Fields::list(std::string_view key) const {
  static const std::vector<Node> none;
  const Node* const node = find(key);
  return node == nullptr ? none : sequence(*node);
}

const std::vector<Node>& Fields::sequence(const Node& node) const {
  if (node.kind != NodeKind::kSequence) {
    if (!node.items.empty() && node.items.front().key.text.starts_with('-')) {
      const Text& key = node.items.front().key;
      fail(key.where, fmt::format("'{0}' has no space behind '-'; expected '- {1}'",
                                  shown(key.text), shown(std::string_view(key.text).substr(1))));
    }
    fail(node.where, fmt::format("{} is {}; expected a list", described(node), kind(node)));
  }
  return node.items;
}

std::string described(const Node& node) {
  return node.key.text.empty() ? "entry" : fmt::format("'{}'", shown(node.key.text));
}

std::string called(std::string_view kind, const Node& node, std::size_t index) {
  for (const Node& item : node.items) {
    if (item.key.text == "name" && item.kind == NodeKind::kScalar && !item.text.empty()) {
      return fmt::format("{} '{}'", kind, shown(item.text));
    }
  }
  return fmt::format("{} {}", kind, index + 1);
}

const std::vector<Node>& parameters(const std::string& file, const Node& node) {
  if (node.kind != NodeKind::kMapping) {
    throw InputError(node.where.in(file), "parameters: is no mapping; expected name: value");
  }
  for (const Node& item : node.items) {
    if (item.kind != NodeKind::kScalar || item.empty) {
      throw InputError(
          item.where.in(file),
          fmt::format("parameter '{}' has no value; expected a number or an expression",
                      shown(item.key.text)));
    }
  }
  return node.items;
}

}  // namespace treedyn::description
