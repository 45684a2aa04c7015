// What texts of equations call the symbols and equations of EQUATIONS.md.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "block/block.hpp"

namespace treedyn::equations {

/// The expression that `name` stands for, if any: "J_v", "omega".
std::optional<block::Expression> find_name(std::string_view name);

/// All names, for messages.
std::vector<std::string_view> known_names();

}  // namespace treedyn::equations
