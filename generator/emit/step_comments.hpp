// Comments between the statements of a function: which link they are about, and what they make.
#pragma once

#include <map>
#include <string>

#include "emit/statements.hpp"

namespace treedyn::emit {

/// Comment lines by the number of the statement that they stand in front of, where at least three
/// in a row begin to compute for another link: "// shank: inertia I, first moment h of (2)". What
/// these lead to is named as far as hints tell.
std::map<std::size_t, std::string> step_comments(const program::Function& function,
                                                 const Statements& statements,
                                                 const Vocabulary& words);

}  // namespace treedyn::emit
