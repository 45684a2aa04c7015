#include "description/read.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "description/resolve.hpp"
#include "description/urdf_reader.hpp"
#include "description/yaml_reader.hpp"

namespace treedyn::description {

namespace {

constexpr std::size_t kMaxFileSize = std::size_t{64} << 20;

[[noreturn]] void fail_to_read(const std::string& path) {
  throw InputError({path, 0, 0},
                   fmt::format("cannot be read ({}); expected a file", std::strerror(errno)));
}

std::string read_stream(std::FILE* stream, const std::string& path) {
  std::string text;
  std::array<char, 1 << 16> buffer = {};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stream)) {
    text.append(buffer.data(), count);
    if (text.size() > kMaxFileSize) {
      throw InputError({path, 0, 0}, fmt::format("file is too large; expected at most {} MiB",
                                                 kMaxFileSize >> 20));
    }
  }
  if (std::ferror(stream) != 0) {
    fail_to_read(path);
  }
  return text;
}

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() &&
         std::equal(
             end.begin(), end.end(), text.end() - static_cast<std::ptrdiff_t>(end.size()),
             [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// The format of a file, by the end of its name in letters of either case.
Format format_of(const std::string& path) {
  if (is_urdf(path)) {
    return Format::kUrdf;
  }
  if (path == "-" || ends_with(path, ".yaml") || ends_with(path, ".yml") ||
      ends_with(path, ".json")) {
    return Format::kYaml;
  }
  throw InputError({path, 0, 0},
                   ends_with(path, ".xacro")
                       ? "is a xacro file; expected the URDF that it makes: xacro FILE > robot.urdf"
                       : "unknown kind of file; expected *.urdf, *.yaml, *.yml or *.json");
}

RawTree parse_raw(const std::string& text, const std::string& path) {
  return format_of(path) == Format::kUrdf ? read_urdf(text, path) : read_yaml(text, path);
}

}  // namespace

bool is_urdf(const std::string& path) { return ends_with(path, ".urdf"); }

std::string read_text(const std::string& path) {
  if (path == "-") {
    return read_stream(stdin, path);
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (file == nullptr) {
    fail_to_read(path);
  }
  return read_stream(file.get(), path);
}

std::string read_model_text(const std::string& path) {
  static_cast<void>(format_of(path));
  return read_text(path);
}

model::Tree read_model(const std::string& path, const ReadOptions& options) {
  return parse_model(read_model_text(path), path, options);
}

model::Tree parse_model(const std::string& text, const std::string& path,
                        const ReadOptions& options) {
  return resolve(parse_raw(text, path), options).tree;
}

Vetted vet_model(const std::string& text, const std::string& path, const ReadOptions& options) {
  const RawTree raw = parse_raw(text, path);
  try {
    Vetted result = resolve(raw, options);
    for (const auto& more : {result.tree.warnings, joints_without_inertia(result.tree)}) {
      result.findings.insert(result.findings.end(), more.begin(), more.end());
    }
    return result;
  } catch (const InputError& error) {
    return {{}, raw.oddities, error};
  }
}

}  // namespace treedyn::description
