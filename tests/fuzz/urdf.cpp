// Fuzz target: the reader of URDF files on any bytes, with every option.
#include <cstddef>
#include <cstdint>
#include <string>

#include "description/read.hpp"
#include "fuzz/checked.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace treedyn::description;  // NOLINT(google-build-using-namespace)
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const Base base : {Base::kFixed, Base::kAxes}) {
    const bool fixed = base == Base::kFixed;
    const ReadOptions options{base, fixed ? Mimic::kReduce : Mimic::kIndependent,
                              fixed ? treedyn::Real(1e-9) : treedyn::Real(0)};
    try {
      treedyn::fuzz::expect_checked(parse_urdf(text, "fuzz.urdf", options));
    } catch (const treedyn::InputError&) {  // the only way to refuse
    }
  }
  return 0;
}
