// A function whose limbs share code, as text.
#pragma once

#include <string>

#include "emit/body.hpp"
#include "program/limb_code.hpp"

namespace treedyn::emit {

/// Order and statements of the trunk's code; its statements are those of all bodies together, each
/// once.
/// \pre function.limb_code
Body limb_body(const program::Function& function, const Vocabulary& words, const Target& target);

/// True if every angle of the function is one of limbs together.
bool has_angles_of_limbs_alone(const program::Function& function, const Target& target);

/// The types of what the limbs have together, and their sines and cosines; empty if no limbs are
/// lanes of vectors.
std::string limb_vectors(const std::vector<program::Function>& functions, const Target& target,
                         const std::string& text);

/// The constants of the limbs, a function for each phase, and the function that calls them, for
/// every limb or with the limbs as the lanes of vectors.
/// \pre function.limb_code
std::string limb_text(const program::Function& function, const Vocabulary& words,
                      const Target& target);

}  // namespace treedyn::emit
