#include "emit/names.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>

#include <fmt/format.h>

#include "common/identifier.hpp"
#include "common/index.hpp"

namespace treedyn::emit {

using program::Kind;
using program::Ref;

namespace {

constexpr std::size_t kLongestBody = 16;
constexpr std::size_t kLongestJoint = 22;
constexpr std::size_t kLongestCommentName = 60;

std::string joined_words(const std::vector<std::string>& words, std::size_t letters) {
  std::string result;
  for (const std::string& word : words) {
    result += result.empty() ? "" : "_";
    result += word.substr(0, letters);
  }
  return result;
}

/// As many letters of every word as fit; empty if not even one does.
std::string shorter_words(const std::string& identifier, std::size_t longest) {
  const std::vector<std::string> words = split(identifier, '_');
  for (std::size_t letters = longest; letters > 0; --letters) {
    std::string candidate = joined_words(words, letters);
    if (candidate.size() <= longest) {
      return candidate;
    }
  }
  return {};
}

std::string without_link_ending(const std::string& identifier) {
  constexpr std::string_view kEnding = "_link";
  if (identifier.size() > kEnding.size() && identifier.ends_with(kEnding)) {
    return identifier.substr(0, identifier.size() - kEnding.size());
  }
  return identifier;
}

/// True if a comment can hold character `k` of a text: it ends no comment and begins none, joins no
/// lines, and is no command or tag of tools that read comments.
bool is_harmless(std::string_view text, std::size_t k) {
  constexpr std::string_view kAlways = "_.,:;+-/()[]{}=^%!|&~#'\">";
  const char c = text[k];
  const char before = k > 0 ? text[k - 1] : '\0';
  const char after = k + 1 < text.size() ? text[k + 1] : '\0';
  switch (c) {
    case ' ':
      return before != '\0' && after != '\0' && after != ' ';
    case '*':
      return before != '/' && after != '/';
    case '?':
      return before != '?' && after != '?';
    case '<':
      return after == ' ' || after == '=';
    default:
      return is_word_byte(c) || kAlways.find(c) != std::string_view::npos;
  }
}

}  // namespace

std::string for_comment(std::string_view text, std::size_t longest) {
  std::string result(text);
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (!is_harmless(text, k)) {
      result[k] = '_';
    }
  }
  if (result.size() > longest) {
    result = result.substr(0, longest - 3) + "...";
  }
  return result;
}

std::vector<std::string> shortened(const std::vector<std::string>& identifiers,
                                   std::size_t longest) {
  const std::set<std::string> originals(identifiers.begin(), identifiers.end());
  std::vector<std::string> result;
  std::set<std::string> taken;
  for (const std::string& identifier : identifiers) {
    std::string name = without_link_ending(identifier);
    name = originals.contains(name) ? identifier : name;
    if (name.size() > longest) {
      name = shorter_words(name, longest);
    }
    const bool is_anothers = name != identifier && originals.contains(name);
    if (name.empty() || is_anothers || !taken.insert(name).second) {
      int n = static_cast<int>(result.size());
      do {
        name = fmt::format("b{}", n++);
      } while (originals.contains(name) || !taken.insert(name).second);
    }
    result.push_back(name);
  }
  return result;
}

std::string short_body(const std::string& identifier) {
  return identifier.size() <= kLongestBody ? identifier : shorter_words(identifier, kLongestBody);
}

std::string element_text(const program::Array& array, int element) {
  if (array.type.empty()) {
    return array.lane < 0 ? fmt::format("{}[{}]", array.name, element)
                          : fmt::format("{}[{}][{}]", array.name, element, array.lane);
  }
  return array.fields.empty() ? fmt::format("{}.value[{}]", array.name, element)
                              : fmt::format("{}.{}", array.name, array.fields[to_index(element)]);
}

Vocabulary vocabulary(const model::Tree& tree) {
  Vocabulary words;
  std::vector<std::string> bodies;
  for (const model::Link& link : tree.links) {
    bodies.push_back(identifier_part(link.name));
    words.body_comments.push_back(for_comment(link.name, kLongestCommentName));
  }
  std::vector<std::string> joints;
  for (const int link : tree.coordinates) {
    joints.push_back(tree.links[to_index(link)].joint.identifier);
  }
  words.bodies = shortened(bodies, kLongestBody);
  words.joints = shortened(joints, kLongestJoint);
  return words;
}

std::string common_words(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& word : split(names.front(), '_')) {
    const bool everywhere = std::ranges::all_of(names, [&](const std::string& name) {
      const std::vector<std::string> words = split(name, '_');
      return std::ranges::find(words, word) != words.end();
    });
    if (everywhere && !word.empty()) {
      result += (result.empty() ? "" : "_") + word;
    }
  }
  return result;
}

LocalNames::LocalNames(const program::Function& function, const Vocabulary& words,
                       const std::vector<Ref>& operations)
    : function_(function),
      words_(words),
      names_(function.graph.size()),
      stems_(function.graph.size()) {
  for (const program::Array& array : function.signature.arrays()) {
    taken_.insert(array.name);
  }
  taken_.insert("w");                             // the workspace
  taken_.insert(function.signature.name + "_0");  // what stores zeros
  if (words.constants) {
    const std::vector<std::string> constants = words.constants->names();
    taken_.insert(constants.begin(), constants.end());
  }
  for (const Ref value : operations) {
    const Kind kind = function.graph.node(value).kind;
    std::string name = kind == Kind::kSin || kind == Kind::kCos ? trigonometric(value) : "";
    if (const std::string joints = angle(value); !joints.empty()) {
      name = "q_" + joints;
    }
    if (name.empty()) {
      name = hinted(value);
    }
    if (!name.empty()) {
      claim(value, name);
    }
  }
  name_angles(operations);
  name_outputs();
  find_stems(operations);
}

/// The angle of s_shank, which is no sum of q alone: angle_shank.
void LocalNames::name_angles(const std::vector<Ref>& operations) {
  for (const Ref value : operations) {
    const program::Node& node = function_.graph.node(value);
    const std::string& name = names_[program::node_index(value)];
    if ((node.kind == Kind::kSin || node.kind == Kind::kCos) && !name.empty() &&
        function_.graph.node(node.a).kind > Kind::kInput &&
        names_[program::node_index(node.a)].empty()) {
      claim(std::abs(node.a), "angle" + name.substr(1));
    }
  }
}

std::string LocalNames::element_stem(std::size_t output) const {
  std::size_t element = output;
  for (const program::Array& array : function_.signature.outputs) {
    const auto size = to_index(array.size);
    if (element < size) {
      return array.fields.empty() ? fmt::format("{}_{}", identifier_part(array.name), element)
                                  : array.fields[element];
    }
    element -= size;
  }
  return {};
}

/// An output that other values are made of, too.
void LocalNames::name_outputs() {
  for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
    const Ref value = function_.outputs[output];
    if (value != 0 && names_[program::node_index(value)].empty()) {
      claim(value, (value < 0 ? "neg_" : "") + element_stem(output));
    }
  }
}

/// The one named value or output that a value is needed for.
void LocalNames::find_stems(const std::vector<Ref>& operations) {
  const std::string several = "*";
  const std::size_t digits = fmt::formatted_size("{}", function_.graph.size());
  const auto need = [&](Ref value, const std::string& user) {
    std::string& stem = stems_[program::node_index(value)];
    stem = stem.empty() || stem == user ? user : several;
  };
  for (std::size_t output = 0; output < function_.outputs.size(); ++output) {
    need(function_.outputs[output], element_stem(output));
  }
  std::for_each(operations.rbegin(), operations.rend(), [&](Ref value) {
    const std::string& own = names_[program::node_index(value)];
    program::for_each_operand(function_.graph.node(value), [&](Ref operand) {
      need(operand, own.empty() ? stems_[program::node_index(value)] : own);
    });
  });
  for (const Ref value : operations) {
    std::string& stem = stems_[program::node_index(value)];
    stem = stem == several || stem.size() + 1 + digits > kLongestLocal ? body_stem(value) : stem;
    stem += "_";
  }
}

/// Made of time alone: no angle of a joint.
bool LocalNames::is_of_time(Ref value) const {
  const program::Graph& graph = function_.graph;
  const std::vector<Ref> roots = {value};
  int times = 0;
  const bool others = std::ranges::any_of(program::reachable(graph, roots), [&](Ref k) {
    const program::Node& node = graph.node(k);
    const bool is_input = node.kind == Kind::kInput;
    const bool is_time = is_input && function_.signature.inputs[to_index(node.a)].name == "t";
    times += is_time ? 1 : 0;
    return is_input && !is_time;
  });
  return times > 0 && !others;
}

std::string LocalNames::trigonometric(Ref value) const {
  const program::Node& node = function_.graph.node(value);
  const program::Node& angle = function_.graph.node(node.a);
  const char* letter = node.kind == Kind::kSin ? "s" : "c";
  if (angle.kind == Kind::kInput) {
    const program::Array& array = function_.signature.inputs[to_index(angle.a)];
    const std::vector<std::string> time = {array.name};
    const std::vector<std::string>& elements = !array.fields.empty() ? array.fields
                                               : array.name == "t"   ? time
                                                                     : words_.joints;
    if (to_index(angle.b) < elements.size()) {
      return fmt::format("{}_{}", letter, elements[to_index(angle.b)]);
    }
  }
  if (const std::string joints = this->angle(std::abs(node.a)); !joints.empty()) {
    return fmt::format("{}_{}", letter, joints);
  }
  if (is_of_time(std::abs(node.a))) {
    return fmt::format("{}_t", letter);
  }
  const int body = function_.graph.hint(value).body;
  if (function_.graph.hint(value).symbol == nullptr && body >= 0) {
    return fmt::format("{}_{}", letter, words_.bodies[to_index(body)]);
  }
  return {};
}

namespace {

/// The elements of input array `array` that are added up with these signs; false if `value` is
/// anything else.
bool add_terms(const program::Graph& graph, Ref value, int array, std::map<int, int>& signs) {
  const program::Node& node = graph.node(value);
  if (node.kind == Kind::kInput) {
    return node.a == array && signs.emplace(node.b, value < 0 ? -1 : 1).second;
  }
  return node.kind == Kind::kAdd && add_terms(graph, value < 0 ? -node.a : node.a, array, signs) &&
         add_terms(graph, value < 0 ? -node.b : node.b, array, signs);
}

}  // namespace

std::string LocalNames::angle(Ref value) const {
  const auto& inputs = function_.signature.inputs;
  std::map<int, int> signs;
  if (function_.graph.node(value).kind != Kind::kAdd || inputs.empty() ||
      inputs.front().name != "q" || !add_terms(function_.graph, value, 0, signs)) {
    return {};
  }
  std::string name;
  std::string short_name;
  for (const auto& [element, sign] : signs) {
    const std::string minus = sign < 0       ? (name.empty() ? "minus_" : "_minus_")
                              : name.empty() ? ""
                                             : "_";
    const auto k = to_index(element);
    name += minus + (k < words_.joints.size() ? words_.joints[k] : fmt::format("q{}", element));
    short_name += fmt::format("{}q{}", minus, element);
  }
  return name.size() + 2 <= kLongestLocal ? name : short_name;
}

/// "omega_forearm_x"; with "neg_" before it where the graph knows the opposite of the value.
std::string LocalNames::hinted(Ref value) const {
  const bool is_opposite = function_.graph.hint(value).symbol == nullptr;
  const program::Hint& hint = function_.graph.hint(is_opposite ? -value : value);
  if (hint.symbol == nullptr) {
    return {};
  }
  std::string name = (is_opposite ? "neg_" : "") + std::string(hint.symbol);
  if (hint.body >= 0) {
    name += "_" + words_.bodies[to_index(hint.body)];
  }
  if (hint.component != nullptr) {
    name += fmt::format("_{}", hint.component);
  }
  return name.size() <= kLongestLocal ? name : std::string();
}

void LocalNames::claim(Ref value, const std::string& name) {
  std::string unique = name;
  if (is_reserved(unique)) {
    unique += "_";
  }
  for (int n = 2; !taken_.insert(unique).second; ++n) {
    unique = fmt::format("{}_{}", name, n);
  }
  if (unique.size() <= kLongestLocal) {
    names_[program::node_index(value)] = unique;
  }
}

std::string LocalNames::body_stem(Ref value) const {
  const int body = function_.graph.hint(value).body;
  return body < 0 ? std::string("t") : fmt::format("t_{}", words_.bodies[to_index(body)]);
}

void LocalNames::assign(Ref value) {
  std::string& name = names_[program::node_index(value)];
  if (!name.empty()) {
    return;
  }
  const std::string& stem = stems_[program::node_index(value)];
  int& number = last_number_[stem];
  do {
    name = fmt::format("{}{}", stem, ++number);
  } while (is_reserved(name) || !taken_.insert(name).second);
}

int LocalNames::width(Ref value) const {
  const std::string& name = names_[program::node_index(value)];
  if (!name.empty()) {
    return static_cast<int>(name.size());
  }
  const auto most_digits = static_cast<int>(fmt::formatted_size("{}", function_.graph.size()));
  return static_cast<int>(stems_[program::node_index(value)].size()) + most_digits;
}

}  // namespace treedyn::emit
