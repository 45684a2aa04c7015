// The entries of a mapping of a scene file, read once each with its kind checked.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/yaml_node.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// A mapping whose keys are known; comments (title, law, note, source, tags, catches) are skipped.
/// Every member throws InputError with the place of the entry and what was expected.
class SceneFields {
 public:
  /// \param what  how messages call the mapping: "constraint 'foot'"
  SceneFields(const std::string& file, const Node& node, std::string what,
              std::initializer_list<std::string_view> keys);

  [[noreturn]] void fail(const Place& where, const std::string& message) const;
  [[nodiscard]] const Node* find(std::string_view key) const;
  [[nodiscard]] const Node& get(std::string_view key) const;
  [[nodiscard]] const Place& where() const { return node_.where; }
  [[nodiscard]] const std::string& file() const { return file_; }

  [[nodiscard]] std::string text(std::string_view key) const;
  [[nodiscard]] std::string text_or(std::string_view key, const std::string& fallback) const;
  [[nodiscard]] Real number(std::string_view key) const;
  [[nodiscard]] Real number_or(std::string_view key, const Real& fallback) const;
  /// A number that is not negative.
  [[nodiscard]] Real amount_or(std::string_view key, const Real& fallback) const;
  [[nodiscard]] int integer(std::string_view key, int least, int most) const;
  [[nodiscard]] model::Vector3 vector(std::string_view key) const;
  /// `vector` divided by its length, which is not zero.
  [[nodiscard]] model::Vector3 direction(std::string_view key) const;
  /// Exactly `size` numbers.
  [[nodiscard]] std::vector<Real> numbers(std::string_view key, std::size_t size) const;
  /// The entries of a list; none if the key is missing.
  [[nodiscard]] const std::vector<Node>& list(std::string_view key) const;

  [[nodiscard]] const Node& scalar(const Node& node) const;
  [[nodiscard]] Real number_of(const Node& node) const;
  [[nodiscard]] model::Vector3 vector_of(const Node& node) const;
  [[nodiscard]] const std::vector<Node>& items(const Node& node) const;

 private:
  const std::string& file_;
  const Node& node_;
  std::string what_;
};

/// "kind 'name'" if the mapping has a name, else "kind 3".
std::string called(std::string_view kind, const Node& node, std::size_t index);

}  // namespace treedyn::description
