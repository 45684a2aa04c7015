#include "common/utf8.hpp"

namespace treedyn {

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const auto follows = [&](std::size_t k) {
    return (byte(k) & 0xc0U) == 0x80U;
  };
  const unsigned lead = byte(0);
  if (lead < 0x80U) {
    return 1;
  }
  if (lead >= 0xc2U && lead <= 0xdfU) {
    return follows(1) ? 2 : 0;
  }
  if (lead >= 0xe0U && lead <= 0xefU) {
    const bool canonical =
        (lead != 0xe0U || byte(1) >= 0xa0U) && (lead != 0xedU || byte(1) < 0xa0U);
    return canonical && follows(1) && follows(2) ? 3 : 0;
  }
  if (lead >= 0xf0U && lead <= 0xf4U) {
    const bool canonical =
        (lead != 0xf0U || byte(1) >= 0x90U) && (lead != 0xf4U || byte(1) < 0x90U);
    return canonical && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

}  // namespace treedyn
