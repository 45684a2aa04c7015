#include "program/packed.hpp"

#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "common/error.hpp"
#include "program/fingerprint.hpp"
#include "program/limb_code.hpp"

namespace treedyn::program {

namespace {

/// How the description of a function calls a dense matrix, and what it is called when packed.
void say_packed(std::string& brief, const Packing& packing) {
  const std::string_view packed = packing.mirrored ? "packed lower triangle" : "packed";
  const std::string of_user = fmt::format("{} x {}, ", packing.rows, packing.columns);
  constexpr std::string_view kDense = "row-major";
  for (const auto& [size, kept] : {std::pair<std::string, std::string>{"N x N, ", ""},
                                   std::pair<std::string, std::string>{of_user, of_user}}) {
    const std::string dense = fmt::format("{}{}", size, kDense);
    if (const auto at = brief.rfind(dense); at != std::string::npos) {
      brief.replace(at, dense.size(), fmt::format("{}{}", kept, packed));
      return;
    }
  }
}

/// True for the outputs that are zero in every state: at a point without pattern nothing is left of
/// them in 50 digits but rounding.
std::vector<bool> zeros(const Function& function) {
  const std::vector<Real> values = node_values<Real>(
      function.graph, function.outputs,
      [](int array, int element) { return Real(sample_input(array, element, 1)); },
      elementary_of_any<Real>, Numbers::kSeen);
  Real largest = 0;
  for (const Real& value : values) {
    largest = larger(largest, abs(value));
  }
  std::vector<bool> result;
  for (const Ref output : function.outputs) {
    const Real& value = values[static_cast<std::size_t>(std::abs(output))];
    result.push_back(abs(value) <= Real("1e-40") * largest);
  }
  return result;
}

}  // namespace

Packing stored_entries(const Function& dense, int rows, int columns) {
  const std::vector<bool> is_zero = zeros(dense);
  const auto entry = [&](int i, int j) {
    return dense.outputs[static_cast<std::size_t>(i * columns + j)];
  };
  Packing packing{.rows = rows, .columns = columns, .mirrored = rows == columns};
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < i && packing.mirrored; ++j) {
      packing.mirrored = entry(i, j) == entry(j, i);
    }
  }
  for (int i = 0; i < rows; ++i) {
    const int end = packing.mirrored ? i + 1 : columns;
    for (int j = 0; j < end; ++j) {
      if (!is_zero[static_cast<std::size_t>(i * columns + j)]) {
        packing.row.push_back(i);
        packing.column.push_back(j);
      }
    }
  }
  packing.is_zero = packing.row.empty();
  if (packing.is_zero) {
    packing.row.push_back(0);
    packing.column.push_back(0);
  }
  return packing;
}

Function packed(Function function, const std::string& matrix, const Packing& packing) {
  std::vector<Ref> outputs;
  std::size_t begin = 0;
  for (Array& array : function.signature.outputs) {
    const auto size = static_cast<std::size_t>(array.size);
    if (array.name == matrix) {
      TREEDYN_EXPECT(array.size == packing.rows * packing.columns);
      for (int k = 0; k < packing.size(); ++k) {
        const auto at = static_cast<std::size_t>(k);
        outputs.push_back(
            function.outputs[begin + static_cast<std::size_t>(packing.row[at] * packing.columns +
                                                              packing.column[at])]);
      }
      array.size = packing.size();
      say_packed(function.signature.brief, packing);
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
    code.trunk = packed(std::move(code.trunk), matrix, packing);
    function.limb_code = std::make_shared<const LimbCode>(std::move(code));
  }
  return function;
}

}  // namespace treedyn::program
