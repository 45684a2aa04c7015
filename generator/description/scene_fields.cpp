#include "description/scene_fields.hpp"

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/transformed.hpp"
#include "description/identifiers.hpp"

namespace treedyn::description {

SceneFields::SceneFields(const std::string& file, const Node& node, std::string what,
                         const Keys& keys)
    : Fields(file, node, std::move(what), keys,
             {"title", "law", "note", "source", "tags", "catches"}) {}

SceneFields::SceneFields(const std::string& file, const Node& node, std::string what,
                         const Keys& keys, const expressions::Constants& constants)
    : Fields(file, node, std::move(what), keys), constants_(&constants) {}

const std::vector<Node>& SceneFields::triple(const Node& node) const {
  const std::vector<Node>& entries = sequence(node);
  if (entries.size() != 3) {
    fail(node.where, fmt::format("{} has {} entries; expected 3", described(node), entries.size()));
  }
  return entries;
}

Real SceneFields::number_of(const Node& node) const {
  const Text text = scalar(node);
  const Decimal decimal = read_decimal(text.text);
  if (decimal) {
    return decimal.value;
  }
  if (decimal.error != DecimalError::kSyntax || constants_ == nullptr) {
    fail(node.where, fmt::format("{}: {}", described(node), describe(decimal.error, text.text)));
  }
  try {
    const Real value = constants_->evaluate(text.text, numbers_ != Numbers::kFixed);
    return numbers_ == Numbers::kNominal ? value.plain() : value;
  } catch (const TextError& problem) {
    const Place where = node.where.at(problem.offset());
    fail(where, fmt::format("{}: {}", described(node), problem.what()));
  }
}

model::Vector3 SceneFields::vector_of(const Node& node) const {
  const std::vector<Node>& entries = triple(node);
  return {number_of(entries[0]), number_of(entries[1]), number_of(entries[2])};
}

model::Vector3 SceneFields::vector_or(std::string_view key, const model::Vector3& other) const {
  return find(key) == nullptr ? other : vector(key);
}

Text SceneFields::name(std::string_view key, std::string_view kind) const {
  Text name = text(key);
  check_name(name.where.in(file()), name.text, kind);
  return name;
}

std::string SceneFields::text_or(std::string_view key, const std::string& fallback) const {
  return optional_text(key).value_or(Text{fallback, {}}).text;
}

Real SceneFields::number_or(std::string_view key, const Real& fallback) const {
  return find(key) == nullptr ? fallback : number(key);
}

Real SceneFields::amount(std::string_view key) const {
  Real value = number(key);
  if (value.plain() < 0) {
    fail(get(key).where,
         fmt::format("'{}' is {:.6g}; expected 0 or more", key, value.convert_to<double>()));
  }
  return value;
}

Real SceneFields::amount_or(std::string_view key, const Real& fallback) const {
  return find(key) == nullptr ? fallback : amount(key);
}

Real SceneFields::positive(std::string_view key) const {
  Real value = number(key);
  if (value.plain() <= 0) {
    fail(get(key).where,
         fmt::format("'{}' is {:.6g}; expected a number above 0", key, value.convert_to<double>()));
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

model::Vector3 SceneFields::direction_of(const Node& node) const {
  model::Vector3 value = vector_of(node);
  const Real length = sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
  if (length == 0) {
    fail(node.where, fmt::format("{} has zero length; expected a direction", described(node)));
  }
  for (Real& entry : value) {
    entry /= length;
  }
  return value;
}

model::Vector3 SceneFields::direction(std::string_view key) const { return direction_of(get(key)); }

std::vector<Real> SceneFields::numbers_of_joints(std::string_view key, std::size_t size) const {
  const Node& node = get(key);
  if (sequence(node).size() != size) {
    fail(node.where, fmt::format("{} has {} entries; expected {}, one a joint", described(node),
                                 node.items.size(), size));
  }
  return transformed(node.items, [&](const Node& item) { return number_of(item); });
}

}  // namespace treedyn::description
