// Builds networks whose items are all different.
#pragma once

#include <cstdint>

#include "optimise/network.hpp"

namespace treedyn::optimise {

/// Appends items in canonical form, each only once.
class NetworkBuilder {
 public:
  explicit NetworkBuilder(std::shared_ptr<ConstantTable> constants, std::size_t expected = 0);
  ~NetworkBuilder();
  NetworkBuilder(const NetworkBuilder&) = delete;
  NetworkBuilder& operator=(const NetworkBuilder&) = delete;

  Ref leaf(const Item& leaf);
  Ref constant(const Real& value);
  /// The sum of signed operands; equal operands are counted, constants added. Spoils `terms`.
  Ref sum(std::vector<Ref>& terms, int position);
  /// The product of signed operands; constants are multiplied. Spoils `factors`.
  Ref product(std::vector<Ref>& factors, int position);
  Ref quotient(Ref a, Ref b, int position);
  Ref function(Kind kind, Ref a, int position);

  /// Takes the network out. The builder is empty afterwards.
  Network finish(std::vector<Ref> outputs);

 private:
  Ref find_or_append(Kind kind, std::span<const Ref> operands, int position);
  template <class Equal, class Append>
  Ref find(std::uint64_t hash, Equal equal, Append append);
  void grow();
  [[nodiscard]] std::uint64_t hash_of(Ref item) const;
  [[nodiscard]] bool are_canonical(const std::vector<Ref>& terms) const;
  void merge_equal_terms(std::vector<Ref>& terms);
  void add_constants(std::vector<Ref>& terms);
  bool multiply_constants(std::vector<Ref>& factors);
  bool unpack_scaled(std::vector<Ref>& factors) const;

  Network network_;
  std::vector<Ref> table_;  // open addressing; looked up, never iterated
};

}  // namespace treedyn::optimise
