// What `info` shows of a model, whichever the form.
#pragma once

#include <string>
#include <vector>

#include "pipeline.hpp"

namespace treedyn {

/// The rows of D: 'x' where the column's link is the row's link or carries it.
std::vector<std::string> reachability_rows(const model::Tree& tree);

/// Of the moving links, kg.
Real total_mass(const model::Tree& tree);

/// A function and the operations of one call.
struct Priced {
  program::Signature signature;
  program::Cost cost;

  [[nodiscard]] int values() const {
    int sum = 0;
    for (const program::Array& array : signature.outputs) {
      sum += array.size;
    }
    return sum;
  }
};
/// Every function that is written, in this order.
std::vector<Priced> priced(const Model& model, const Request& request,
                           const program::Programs& programs);

}  // namespace treedyn
