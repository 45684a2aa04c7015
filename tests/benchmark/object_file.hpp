// Sizes of compiled code.
#pragma once

#include <filesystem>
#include <string>

namespace treedyn::benchmark {

/// Bytes of the sections .text* of an object file; `size_program` is the size of its binutils.
long code_bytes(const std::string& size_program, const std::filesystem::path& object);

/// The same and the constants, sections .rodata*.
long flash_bytes(const std::string& size_program, const std::filesystem::path& object);

/// Bytes of the two largest frames in a file that -fstack-usage wrote: of a function and of the
/// largest part that it calls.
long stack_bytes(const std::filesystem::path& usage);

/// Instructions of an object file as `objdump` of its binutils lists them, tables apart.
long instructions(const std::string& objdump, const std::filesystem::path& object);

}  // namespace treedyn::benchmark
