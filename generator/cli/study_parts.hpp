// A study of accuracy in parts: a folder with its references and what came of every setting, so
// that many processes make it, and one that was broken off goes on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "accuracy/study.hpp"
#include "cli/motions.hpp"

namespace treedyn {

/// What all settings are measured against.
struct KnownReference {
  accuracy::Reference reference;
  std::vector<Motion> exact;
};

/// The parts in a folder. Each is a file that is there as a whole or not at all, with numbers in
/// hexadecimal: what is read is what was written, bit by bit.
class StudyParts {
 public:
  /// What a part of another study does here.
  enum class Others { kRefused, kReplaced };

  /// \param folder  empty: nothing is kept
  /// \param study   everything that the numbers of a part follow from, as text
  StudyParts(std::string folder, const std::string& study, Others others);

  /// Nothing: the part is not there. \throws InputError for a part of a study that is refused
  [[nodiscard]] std::optional<KnownReference> reference() const;
  [[nodiscard]] std::optional<accuracy::Outcome> outcome(std::size_t number,
                                                         const accuracy::Setting& setting) const;
  void keep(const KnownReference& reference) const;
  void keep(std::size_t number, const accuracy::Outcome& outcome) const;

 private:
  [[nodiscard]] std::string path(const std::string& part) const;
  [[nodiscard]] std::optional<std::string> read(const std::string& part) const;
  /// \param value  what the part does not hold of it is there
  template <class Value>
  [[nodiscard]] std::optional<Value> found(const std::string& part, Value value) const;
  template <class Value>
  void keep_as(const std::string& part, const Value& value) const;
  void write(const std::string& part, const std::string& text) const;

  std::string folder_;
  std::string head_;  ///< the first line of its parts
  Others others_;
};

/// The parts in a folder are not needed any more, nor is the folder if nothing else is in it.
void remove_parts(const std::string& folder);

/// A file of commands, a line each, that measure these settings: `arguments` with `--part N`. The
/// words are quoted for a shell.
void write_plan(const std::string& path, const std::vector<std::string>& arguments,
                const std::vector<std::size_t>& numbers);

}  // namespace treedyn
