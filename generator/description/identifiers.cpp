#include "description/identifiers.hpp"

#include <map>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

namespace {

constexpr std::size_t kMaxNameLength = 255;

/// The length of the UTF-8 character at the front, 0 if there is none (overlong forms and
/// surrogates too).
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

/// Why a name cannot stand in a file or a comment, or nullptr.
const char* fault_of_name(std::string_view name) {
  if (name.empty()) {
    return "is empty; expected a word";
  }
  while (!name.empty()) {
    const auto byte = static_cast<unsigned char>(name.front());
    const std::size_t length = utf8_length(name);
    if (byte < 0x20 || byte == 0x7f) {
      return "has a control character; expected printable text";
    }
    if (length == 0) {
      return "is not UTF-8; expected printable text";
    }
    name.remove_prefix(length);
  }
  return nullptr;
}

}  // namespace

void check_name(const Location& where, std::string_view name, std::string_view kind) {
  if (name.size() > kMaxNameLength) {
    throw InputError(where, fmt::format("{} name of {} bytes is too long; expected at most {}",
                                        kind, name.size(), kMaxNameLength));
  }
  if (const char* const fault = fault_of_name(name)) {
    throw InputError(where, fmt::format("{} name '{}' {}", kind, shown(name), fault));
  }
}

namespace {

/// True of `link.com` and `link.com.x`.
bool has(const Named& whole, const Named& part) { return part.name.starts_with(whole.name + '.'); }

}  // namespace

void check_identifiers(const std::vector<Named>& names, const std::string& kind) {
  std::map<std::string, const Named*> taken;
  for (const Named& named : names) {
    const auto [other, is_new] = taken.emplace(named.identifier, &named);
    if (!is_new && other->second->name == named.name) {
      throw InputError(named.where,
                       fmt::format("{} '{}' is defined twice; expected different names", kind,
                                   shown(named.name)));
    }
    if (!is_new && (has(*other->second, named) || has(named, *other->second))) {
      throw InputError(named.where,
                       fmt::format("{}s '{}' and '{}' declare the same number; expected "
                                   "one of them",
                                   kind, shown(other->second->name), shown(named.name)));
    }
    if (!is_new) {
      throw InputError(
          named.where,
          fmt::format("{0}s '{1}' and '{2}' both become the identifier '{3}'; expected "
                      "names that differ in letters or digits",
                      kind, shown(other->second->name), shown(named.name),
                      shown(named.identifier)));
    }
  }
}

}  // namespace treedyn::description
