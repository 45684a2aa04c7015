// XML text as elements with attributes and places; what is not asked for is not kept.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "description/raw_tree.hpp"

namespace treedyn::description {

struct Element {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<Element> children;
  std::vector<Text> strays;  ///< names of children that are not wanted, the first 1000 of a file
  Place text;                ///< the first that is no space; line 0: none
  Place where;

  /// The value of an attribute, or nullptr.
  [[nodiscard]] const std::string* attribute(std::string_view key) const;
};

/// True if the child element is wanted; an unwanted element is skipped with everything in it.
using Wanted = bool (*)(std::string_view father, std::string_view child);

/// The root element. Document type declarations (and so entities) are refused, nesting is bounded.
/// Linear. \throws InputError
Element parse_xml(const std::string& text, const std::string& file, Wanted wanted);

}  // namespace treedyn::description
