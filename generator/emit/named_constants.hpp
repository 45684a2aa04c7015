// Numbers that functions take from a model: named constants at the beginning of the source.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/provenance.hpp"
#include "emit/literal.hpp"
#include "program/function.hpp"

namespace treedyn::emit {

struct Vocabulary;

/// Names like `link3_I2`: the first link of those whose masses (else whose places) the number is
/// made of, what it is by its unit (m, l, h, I, g, w, G; k: none; p: another one), a count in order
/// of use. They follow from structure alone. Numbers of the equations have none, nor have those
/// whose sources are not known (common/provenance.hpp).
class ConstantNames {
 public:
  /// \param functions  in the order of the text
  /// \param numbers    others that stand in it
  /// \param taken      names that are something else there
  ConstantNames(const std::vector<const program::Function*>& functions,
                const std::vector<Real>& numbers, const Vocabulary& words,
                std::set<std::string> taken);

  /// Null: a literal.
  [[nodiscard]] const std::string* find(const Real& constant) const;
  [[nodiscard]] std::vector<std::string> names() const;
  /// Their definitions, grouped by links, each under a comment that says what it is made of; empty
  /// if there are none.
  [[nodiscard]] std::string table(const Vocabulary& words, Scalar scalar) const;

 private:
  struct Entry {
    Real value;
    Provenance source;
    int link;
    char letter;
    int number;
    std::string name;
  };
  void add(const Real& value, const Vocabulary& words);

  std::vector<Entry> entries_;
  std::multimap<double, std::size_t> by_value_;
  std::map<std::pair<int, char>, int> counts_;
  std::set<std::string> taken_;
};

/// A number and what it is made of: "forearm_p1", "kg m^2: mass, com of forearm".
struct DescribedNumber {
  std::string name;
  std::string source;
};

/// What code computes of run-time parameters, named as constants are; `n1`, `n2`, .. where sources
/// are not known.
std::vector<DescribedNumber> described(const std::vector<Real>& numbers, const Vocabulary& words);

/// The name of a constant, or its literal. \pre constant >= 0
std::string number_text(const Vocabulary& words, const Real& constant, Scalar scalar);
/// The same of any sign.
std::string signed_number_text(const Vocabulary& words, const Real& constant, Scalar scalar);
/// Columns to keep free for it.
int number_width(const Vocabulary& words, const Real& constant, Scalar scalar);

}  // namespace treedyn::emit
