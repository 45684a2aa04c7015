#include "description/names.hpp"

#include <map>

#include <fmt/format.h>

#include "common/decimal.hpp"

namespace treedyn::description {

void check_identifiers(const std::vector<Named>& names, const std::string& kind) {
  std::map<std::string, const Named*> taken;
  for (const Named& named : names) {
    const auto [other, is_new] = taken.emplace(named.identifier, &named);
    if (!is_new && other->second->name == named.name) {
      throw InputError(named.where,
                       fmt::format("{} '{}' is defined twice; expected different names", kind,
                                   shown(named.name)));
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
