// Fuzz target: the reader of URDF files on any bytes, with every option.
#include "fuzz/checked.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  treedyn::fuzz::expect_checked_or_refused(
      data, size, [](const std::string& text, const treedyn::description::ReadOptions& options) {
        return treedyn::description::parse_model(text, "fuzz.urdf", options);
      });
  return 0;
}
