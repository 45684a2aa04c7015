#include "description/scene_fields.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

constexpr std::array<std::string_view, 6> kComments = {"title",  "law",  "note",
                                                       "source", "tags", "catches"};

bool contains(const auto& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

std::string described(const Node& node) {
  return node.key.text.empty() ? "entry" : fmt::format("'{}'", shown(node.key.text));
}

}  // namespace

SceneFields::SceneFields(const std::string& file, const Node& node, std::string what,
                         std::initializer_list<std::string_view> keys)
    : file_(file), node_(node), what_(std::move(what)) {
  if (node.kind != NodeKind::kMapping) {
    fail(node.where, fmt::format("is no mapping; expected the keys {}", fmt::join(keys, ", ")));
  }
  for (const Node& item : node.items) {
    if (!contains(keys, item.key.text) && !contains(kComments, item.key.text)) {
      fail(item.key.where, fmt::format("unknown key '{}'; expected one of {}", shown(item.key.text),
                                       fmt::join(keys, ", ")));
    }
  }
}

void SceneFields::fail(const Place& where, const std::string& message) const {
  throw InputError({file_, where.line, where.column}, fmt::format("{}: {}", what_, message));
}

const Node* SceneFields::find(std::string_view key) const {
  const auto item = std::find_if(node_.items.begin(), node_.items.end(),
                                 [key](const Node& n) { return n.key.text == key; });
  return item == node_.items.end() ? nullptr : &*item;
}

const Node& SceneFields::get(std::string_view key) const {
  const Node* const node = find(key);
  if (node == nullptr) {
    fail(node_.where, fmt::format("key '{}' is missing; expected it here", key));
  }
  return *node;
}

const Node& SceneFields::scalar(const Node& node) const {
  if (node.kind != NodeKind::kScalar || node.empty) {
    fail(node.where, fmt::format("{} is no single value; expected one", described(node)));
  }
  return node;
}

const std::vector<Node>& SceneFields::items(const Node& node) const {
  if (node.kind != NodeKind::kSequence) {
    fail(node.where, fmt::format("{} is no list; expected one", described(node)));
  }
  return node.items;
}

Real SceneFields::number_of(const Node& node) const {
  const Decimal decimal = read_decimal(scalar(node).text);
  if (!decimal) {
    fail(node.where, fmt::format("{} {}", described(node), describe(decimal.error, node.text)));
  }
  return decimal.value;
}

model::Vector3 SceneFields::vector_of(const Node& node) const {
  const std::vector<Node>& entries = items(node);
  if (entries.size() != 3) {
    fail(node.where,
         fmt::format("{} has {} entries; expected 3 numbers", described(node), entries.size()));
  }
  return {number_of(entries[0]), number_of(entries[1]), number_of(entries[2])};
}

std::string SceneFields::text(std::string_view key) const { return scalar(get(key)).text; }

std::string SceneFields::text_or(std::string_view key, const std::string& fallback) const {
  const Node* const node = find(key);
  return node == nullptr ? fallback : scalar(*node).text;
}

Real SceneFields::number(std::string_view key) const { return number_of(get(key)); }

Real SceneFields::number_or(std::string_view key, const Real& fallback) const {
  const Node* const node = find(key);
  return node == nullptr ? fallback : number_of(*node);
}

Real SceneFields::amount_or(std::string_view key, const Real& fallback) const {
  const Real value = number_or(key, fallback);
  if (value < 0) {
    fail(get(key).where, fmt::format("'{}' is negative; expected 0 or more", key));
  }
  return value;
}

int SceneFields::integer(std::string_view key, int least, int most) const {
  const Node& node = get(key);
  const Real value = number_of(node);
  if (value < least || value > most || value != floor(value)) {
    fail(node.where, fmt::format("{} is {}; expected an integer from {} to {}", described(node),
                                 shown(node.text), least, most));
  }
  return value.convert_to<int>();
}

model::Vector3 SceneFields::vector(std::string_view key) const { return vector_of(get(key)); }

model::Vector3 SceneFields::direction(std::string_view key) const {
  model::Vector3 value = vector(key);
  const Real length = sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
  if (length == 0) {
    fail(get(key).where, fmt::format("'{}' has zero length; expected a direction", key));
  }
  for (Real& entry : value) {
    entry /= length;
  }
  return value;
}

std::vector<Real> SceneFields::numbers(std::string_view key, std::size_t size) const {
  const Node& node = get(key);
  if (items(node).size() != size) {
    fail(node.where, fmt::format("{} has {} entries; expected {}, one a joint", described(node),
                                 node.items.size(), size));
  }
  std::vector<Real> result;
  for (const Node& item : node.items) {
    result.push_back(number_of(item));
  }
  return result;
}

const std::vector<Node>& SceneFields::list(std::string_view key) const {
  static const std::vector<Node> none;
  const Node* const node = find(key);
  return node == nullptr ? none : items(*node);
}

std::string called(std::string_view kind, const Node& node, std::size_t index) {
  for (const Node& item : node.items) {
    if (item.key.text == "name" && item.kind == NodeKind::kScalar && !item.text.empty()) {
      return fmt::format("{} '{}'", kind, shown(item.text));
    }
  }
  return fmt::format("{} {}", kind, index + 1);
}

}  // namespace treedyn::description
