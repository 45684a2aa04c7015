// Names that generated code takes for itself.
#pragma once

#include <string_view>

namespace treedyn::emit {

/// True for a name that generated code may give to something of its own, in any language and with
/// any options: its types, namespaces, constants, helpers and macros, and what stands behind a
/// prefix in C99. Names of functions and their parts are not among them.
bool is_own_name(std::string_view name);

/// True for what a function in parts calls its parts: `mass_matrix_0`, `mass_matrix_1`,
/// `mass_matrix_limb_1`.
bool is_part_of(std::string_view name, std::string_view function);

}  // namespace treedyn::emit
