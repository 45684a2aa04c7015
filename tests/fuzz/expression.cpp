// Fuzz target: constant expressions and `--points` lists.
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/decimal.hpp"
#include "description/read.hpp"
#include "expressions/constant.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  treedyn::expressions::Constants constants;
  try {  // lines "name=expression" define parameters, the last line is evaluated
    std::size_t start = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', start)) {
      const std::string line = text.substr(start, end - start);
      const std::size_t equals = line.find('=');
      start = end + 1;
      if (equals != std::string::npos) {
        constants.define(line.substr(0, equals), line.substr(equals + 1));
      }
    }
    const treedyn::Real value = constants.evaluate(text.substr(start));
    TREEDYN_EXPECT(abs(value) <= treedyn::Real(1.0000001e300));
  } catch (const treedyn::TextError& error) {
    TREEDYN_EXPECT(error.offset() <= text.size());
  }
  const treedyn::Decimal decimal = treedyn::read_decimal(text);
  TREEDYN_EXPECT(!decimal || abs(decimal.value) <= treedyn::Real(1.0000001e300));
  return 0;
}
