#include "fuzz/nodes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "description/xml_element.hpp"

namespace treedyn::fuzz {

using description::Node;
using description::NodeKind;

namespace {

bool every_element(std::string_view /*father*/, std::string_view /*child*/) { return true; }

Node scalar(std::string key, std::string text) {
  Node node;
  node.key.text = std::move(key);
  node.text = std::move(text);
  return node;
}

Node nodes_of(const description::Element& element) {
  Node node;
  node.kind = NodeKind::kMapping;
  node.key.text = element.name;
  for (const auto& [name, value] : element.attributes) {
    node.items.push_back(scalar("@" + name, value));
  }
  std::ranges::transform(element.children, std::back_inserter(node.items), nodes_of);
  return node;
}

/// With escapes for what `needs` one.
template <class Needs, class Escape>
std::string escaped(const std::string& text, Needs needs, Escape escape) {
  std::string result;
  for (const char c : text) {
    result += needs(c) ? escape(static_cast<unsigned char>(c)) : std::string(1, c);
  }
  return result;
}

std::string in_quotes(const std::string& text) {
  return '"' +
         escaped(
             text,
             [](char c) { return c == '"' || c == '\\' || (static_cast<unsigned char>(c) < 0x20); },
             [](unsigned char c) { return fmt::format("\\x{:02x}", c); }) +
         '"';
}

std::string attribute(const Node& node) {
  const std::string value = escaped(
      node.text, [](char c) { return c == '"' || c == '<' || c == '&'; },
      [](unsigned char c) { return fmt::format("&#{};", c); });
  return fmt::format(" {}=\"{}\"", node.key.text.substr(1), value);
}

bool is_attribute(const Node& node) {
  return node.kind == NodeKind::kScalar && node.key.text.starts_with("@");
}

std::string xml(const Node& node) {
  std::string attributes;
  std::string children;
  for (const Node& item : node.items) {
    (is_attribute(item) ? attributes : children) +=
        is_attribute(item) ? attribute(item) : xml(item);
  }
  return fmt::format("<{0}{1}>{2}</{0}>\n", node.key.text, attributes, children);
}

std::string yaml(const Node& node) {
  if (node.kind == NodeKind::kScalar) {
    return node.empty ? "null" : in_quotes(node.text);
  }
  const bool mapping = node.kind == NodeKind::kMapping;
  std::string result = mapping ? "{" : "[";
  for (const Node& item : node.items) {
    result += result.size() > 1 ? ",\n " : "";
    result += mapping ? in_quotes(item.key.text) + ": " : "";
    result += yaml(item);
  }
  return result + (mapping ? "}" : "]");
}

/// All nodes but the root.
void collect(Node& node, std::vector<Node*>& all) {
  for (Node& item : node.items) {
    all.push_back(&item);
    collect(item, all);
  }
}

constexpr std::array kNumbers = {"0",     "-1",     "1e300", "-1e300",     "1e-300",  "1e20",
                                 "1e-20", "nan",    "inf",   "1/0",        "1e400",   "1e15",
                                 "1e-9",  "3.2e-8", "-0.0",  "1.5707963",  "sqrt(2)", "1e-160",
                                 "1e160", "0.1",    "1",     "1.00000001", "pi",      "1000000007"};
constexpr std::array kNames = {
    "",        "ground",    "class", "a b",  "\x07",   "=1+1",         "../../x",  "signbit",
    "x\ny",    "*/ #error", "$(rm)", "%s%n", "<x>",    "\xe5\x90\x8d", "\xff\xfe", "typeof",
    "base_px", "q",         "t",     "kDof", "status", "with\"quote",  "\\u0000x", "-",
    "all"};

}  // namespace

Node read_nodes(const std::string& text, bool is_xml) {
  return is_xml ? nodes_of(description::parse_xml(text, "seed.urdf", every_element))
                : description::parse_yaml_node(text, "seed.yaml");
}

std::string written(const Node& root, bool is_xml) {
  return is_xml ? xml(root) : yaml(root) + "\n";
}

void Mutator::change(Node& root) {
  std::vector<Node*> all;
  collect(root, all);
  if (all.empty()) {
    return;
  }
  Node& node = *all[below(all.size())];
  const auto inner = [&]() -> Node* {
    std::vector<Node*> fathers = {&root};
    std::ranges::copy_if(all, std::back_inserter(fathers),
                         [](const Node* other) { return !other->items.empty(); });
    return fathers[below(fathers.size())];
  };
  const auto some = [&](auto accept) -> Node* {
    std::vector<Node*> leaves;
    std::ranges::copy_if(all, std::back_inserter(leaves), [&](const Node* other) {
      return other->kind == NodeKind::kScalar && accept(*other);
    });
    return leaves.empty() ? &node : leaves[below(leaves.size())];
  };
  const auto leaf = [&] {
    return some([](const Node&) { return true; });
  };
  const auto number = [&] {
    return some([](const Node& other) {
      return other.text.find_first_of("0123456789") != std::string::npos;
    });
  };
  Node& father = *inner();
  const std::size_t at = below(father.items.size());
  switch (below(15)) {
    case 0:
      father.items.erase(father.items.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:  // an entry of a mapping has the same key then
      father.items.insert(father.items.begin() + static_cast<std::ptrdiff_t>(at),
                          Node(father.items[at]));
      break;
    case 2:
      std::swap(father.items[at], father.items[below(father.items.size())]);
      break;
    case 3: {  // what stands elsewhere, under the same key
      Node copy = *all[below(all.size())];
      copy.key = node.key;
      node = std::move(copy);
      break;
    }
    case 4:
      node.key.text = all[below(all.size())]->key.text;
      break;
    case 5: {
      Node wrapped;
      wrapped.kind = below(2) == 0 ? NodeKind::kSequence : NodeKind::kMapping;
      wrapped.key = node.key;
      wrapped.items = {node};
      node = std::move(wrapped);
      break;
    }
    case 6:
      leaf()->text =
          below(8) == 0 ? std::string(255 + below(2), 'n') : kNames[below(kNames.size())];
      break;
    case 7:  // a wrong reference, or somebody else's number
      leaf()->text = leaf()->text;
      break;
    default:
      number()->text = kNumbers[below(kNumbers.size())];
  }
}

}  // namespace treedyn::fuzz
