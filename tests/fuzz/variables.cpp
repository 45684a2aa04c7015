// Fuzz target: expressions with variables, and motions with their derivatives.
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/error.hpp"
#include "expressions/read_expression.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using treedyn::model::Quantity;
using treedyn::model::Variable;

std::optional<Variable> variable(std::string_view name, std::optional<std::string_view> index) {
  if (index) {
    return name == "q" ? std::optional(Variable{Quantity::kPosition, 0}) : std::nullopt;
  }
  return name == "t" ? std::optional(Variable{Quantity::kTime, 0}) : std::nullopt;
}

template <class Read>
void expect_value_or_place(const std::string& text, const Read& read) {
  try {
    read();
  } catch (const treedyn::TextError& error) {
    TREEDYN_EXPECT(error.offset() <= text.size());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const treedyn::expressions::Constants constants;
  expect_value_or_place(text, [&] {
    static_cast<void>(
        treedyn::expressions::read_expression(constants, text, {variable, ", t, q[a]"}));
  });
  expect_value_or_place(text, [&] {
    const auto motion = treedyn::expressions::read_motion(
        constants, text,
        {[](std::string_view name, std::optional<std::string_view> index) {
           return index ? std::nullopt : variable(name, index);
         },
         ", t"});
    TREEDYN_EXPECT(motion[2].size() < 1'000'000);
  });
  return 0;
}
