#include "program/packed.hpp"

#include <string_view>
#include <utility>

#include "common/error.hpp"
#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

/// How the description of a function calls a dense matrix.
constexpr std::string_view kDense = "N x N, row-major";

}  // namespace

Packing lower_triangle(const Function& dense, int n) {
  Packing packing;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      if (dense.outputs[static_cast<std::size_t>(i * n + j)] != 0) {
        packing.row.push_back(i);
        packing.column.push_back(j);
      }
    }
  }
  return packing;
}

Function packed(Function function, const std::string& matrix, int n, const Packing& packing) {
  std::vector<Ref> outputs;
  std::size_t begin = 0;
  for (Array& array : function.signature.outputs) {
    const auto size = static_cast<std::size_t>(array.size);
    if (array.name == matrix) {
      TREEDYN_EXPECT(array.size == n * n);
      for (int k = 0; k < packing.size(); ++k) {
        const auto at = static_cast<std::size_t>(k);
        outputs.push_back(function.outputs[begin + static_cast<std::size_t>(packing.row[at] * n +
                                                                            packing.column[at])]);
      }
      array.size = packing.size();
      std::string& brief = function.signature.brief;
      if (const auto at = brief.find(kDense); at != std::string::npos) {
        brief.replace(at, kDense.size(), "packed lower triangle");
      }
    } else {
      for (std::size_t k = 0; k < size; ++k) {
        outputs.push_back(function.outputs[begin + k]);
      }
    }
    begin += size;
  }
  function.outputs = std::move(outputs);
  if (function.limb_code) {
    LimbCode code = *function.limb_code;
    code.trunk = packed(std::move(code.trunk), matrix, n, packing);
    function.limb_code = std::make_shared<const LimbCode>(std::move(code));
  }
  return function;
}

}  // namespace treedyn::program
