#include "description/read.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include <fmt/format.h>

#include "description/resolve.hpp"
#include "description/urdf_reader.hpp"
#include "description/vet.hpp"
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
  std::array<char, 1 << 16> buffer;
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

std::string read_file(const std::string& path) {
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

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

RawTree read_raw(const std::string& path) {
  if (ends_with(path, ".urdf")) {
    return read_urdf(read_file(path), path);
  }
  if (path == "-" || ends_with(path, ".yaml") || ends_with(path, ".yml") ||
      ends_with(path, ".json")) {
    return read_yaml(read_file(path), path);
  }
  throw InputError({path, 0, 0}, "unknown kind of file; expected *.urdf, *.yaml, *.yml or *.json");
}

}  // namespace

model::Tree read_model(const std::string& path, const ReadOptions& options) {
  return resolve(read_raw(path), options).tree;
}

model::Tree parse_yaml(const std::string& text, const std::string& file,
                       const ReadOptions& options) {
  return resolve(read_yaml(text, file), options).tree;
}

model::Tree parse_urdf(const std::string& text, const std::string& file,
                       const ReadOptions& options) {
  return resolve(read_urdf(text, file), options).tree;
}

Vetted vet_model(const std::string& path, const ReadOptions& options) {
  Vetted result = resolve(read_raw(path), options);
  vet_tree(result);
  return result;
}

}  // namespace treedyn::description
