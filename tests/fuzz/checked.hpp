// What a reader must guarantee of any model that it accepts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "description/read.hpp"
#include "model/tree.hpp"

namespace treedyn::fuzz {

/// Stops the program if a later stage could trip over `tree`: order, unit axes, rotations, sizes,
/// finite numbers.
void expect_checked(const model::Tree& tree);

using Reader =
    std::function<model::Tree(const std::string& text, const description::ReadOptions& options)>;

/// Reads the bytes with every option; stops the program unless each tree is checked and each
/// refusal an InputError.
void expect_checked_or_refused(const std::uint8_t* data, std::size_t size, const Reader& reader);

}  // namespace treedyn::fuzz
