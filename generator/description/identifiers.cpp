#include "description/identifiers.hpp"

#include <map>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "common/utf8.hpp"

namespace treedyn::description {

namespace {

constexpr std::size_t kMaxNameLength = 255;

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
      throw InputError(
          named.where,
          fmt::format("{}s '{}' and '{}' declare the same number; expected one of them", kind,
                      shown(other->second->name), shown(named.name)));
    }
    if (!is_new) {
      throw InputError(named.where,
                       fmt::format("{0}s '{1}' and '{2}' both become the identifier '{3}'; "
                                   "expected names that differ in letters or digits",
                                   kind, shown(other->second->name), shown(named.name),
                                   shown(named.identifier)));
    }
  }
}

}  // namespace treedyn::description
