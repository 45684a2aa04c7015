// The text of an expression, grouped exactly as the graph groups it.
#pragma once

#include <functional>
#include <string>

#include "program/schedule.hpp"

namespace treedyn::emit {

/// How a statement refers to a value that is not written in place: name, array element or literal.
/// Called with positive values only.
using Atom = std::function<std::string(program::Ref)>;

/// `a * b + c` for the operation behind `value`, inlined operands written in place; a negative
/// value costs at most three more columns than a positive one.
std::string expression(const program::Graph& graph, const program::Schedule& schedule,
                       const Atom& atom, program::Ref value);

/// Calls `visit` for everything that `expression` asks `atom` for.
void for_each_atom(const program::Graph& graph, const program::Schedule& schedule,
                   program::Ref value, const std::function<void(program::Ref)>& visit);

}  // namespace treedyn::emit
