// Numbers, vectors and directions of a scene file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "description/fields.hpp"
#include "expressions/constant.hpp"
#include "model/tree.hpp"

namespace treedyn::description {

/// A mapping of a scene file whose numbers are decimals or, where there are `constants`, constant
/// expressions. Errors as those of `Fields`.
class SceneFields : public Fields {
 public:
  /// Of a case file: decimals; comments (title, law, note, source, tags, catches) are skipped.
  SceneFields(const std::string& file, const Node& node, std::string what, const Keys& keys);
  /// \param constants  outlives the object
  SceneFields(const std::string& file, const Node& node, std::string what, const Keys& keys,
              const expressions::Constants& constants);

  /// The same whose numbers may be known at run time only, may not, or are nominal ones of those.
  [[nodiscard]] SceneFields at_run_time() const { return with(Numbers::kRunTime); }
  [[nodiscard]] SceneFields fixed() const { return with(Numbers::kFixed); }
  [[nodiscard]] SceneFields nominal() const { return with(Numbers::kNominal); }
  [[nodiscard]] bool is_at_run_time() const { return numbers_ == Numbers::kRunTime; }

  /// A name that can stand in files and comments. \param kind  what it names
  [[nodiscard]] Text name(std::string_view key, std::string_view kind) const;
  [[nodiscard]] std::string text_or(std::string_view key, const std::string& fallback) const;
  [[nodiscard]] Real number(std::string_view key) const { return number_of(get(key)); }
  [[nodiscard]] Real number_or(std::string_view key, const Real& fallback) const;
  /// A number that is not negative.
  [[nodiscard]] Real amount(std::string_view key) const;
  [[nodiscard]] Real amount_or(std::string_view key, const Real& fallback) const;
  /// A number above zero.
  [[nodiscard]] Real positive(std::string_view key) const;
  [[nodiscard]] int integer(std::string_view key, int least, int most) const;
  [[nodiscard]] model::Vector3 vector(std::string_view key) const { return vector_of(get(key)); }
  [[nodiscard]] model::Vector3 vector_or(std::string_view key, const model::Vector3& other) const;
  /// `vector` divided by its length, which is not zero.
  [[nodiscard]] model::Vector3 direction(std::string_view key) const;
  /// Exactly `size` numbers.
  [[nodiscard]] std::vector<Real> numbers_of_joints(std::string_view key, std::size_t size) const;

  [[nodiscard]] Real number_of(const Node& node) const;
  [[nodiscard]] model::Vector3 vector_of(const Node& node) const;
  /// A vector divided by its length. \throws InputError if it is zero
  [[nodiscard]] model::Vector3 direction_of(const Node& node) const;
  /// Exactly three entries. \throws InputError
  [[nodiscard]] const std::vector<Node>& triple(const Node& node) const;

 private:
  enum class Numbers { kFixed, kRunTime, kNominal };
  [[nodiscard]] SceneFields with(Numbers numbers) const {
    SceneFields result = *this;
    result.numbers_ = numbers;
    return result;
  }

  const expressions::Constants* constants_ = nullptr;
  Numbers numbers_ = Numbers::kFixed;
};

}  // namespace treedyn::description
