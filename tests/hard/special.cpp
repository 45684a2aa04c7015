#include <map>

#include "hard/quantities.hpp"

namespace treedyn::hard {

namespace {

const std::map<std::string, Special>& table() {
  static const std::map<std::string, Special> result = {};
  return result;
}

}  // namespace

Special special_quantity(const std::string& name) {
  const auto row = table().find(name);
  return row == table().end() ? nullptr : row->second;
}

}  // namespace treedyn::hard
