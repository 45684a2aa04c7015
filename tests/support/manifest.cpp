#include "support/manifest.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "support/process.hpp"

namespace treedyn::support {

namespace {

using ManifestJson = nlohmann::json;

std::vector<int> sizes(const ManifestJson& arrays) {
  std::vector<int> result;
  for (const ManifestJson& array : arrays) {
    result.push_back(array.at("size").get<int>());
  }
  return result;
}

std::vector<std::string> names(const ManifestJson& items) {
  std::vector<std::string> result;
  for (const ManifestJson& item : items) {
    result.push_back(item.at("name").get<std::string>());
  }
  return result;
}

std::vector<bool> integers(const ManifestJson& arrays) {
  std::vector<bool> result;
  for (const ManifestJson& array : arrays) {
    result.push_back(array.value("type", "") == "int");
  }
  return result;
}

FunctionInfo function_info(const ManifestJson& entry) {
  FunctionInfo result{entry.at("name"),
                      names(entry.at("inputs")),
                      sizes(entry.at("inputs")),
                      names(entry.at("outputs")),
                      sizes(entry.at("outputs")),
                      integers(entry.at("inputs")),
                      integers(entry.at("outputs")),
                      entry.value("returns", "") == "status",
                      {}};
  const std::array<const char*, 6> kinds{"add", "mul", "div", "sqrt", "sin", "cos"};
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    result.operations[k] = entry.at("operations").at(kinds[k]).get<long>();
  }
  return result;
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& path) {
  const ManifestJson json = ManifestJson::parse(read_file(path));
  Manifest result{json.at("model").at("file"),
                  json.at("options").at("base"),
                  json.at("options").at("scalar"),
                  json.at("dof"),
                  names(json.at("joints")),
                  names(json.at("points")),
                  {}};
  for (const ManifestJson& entry : json.at("functions")) {
    result.functions.push_back(function_info(entry));
  }
  return result;
}

bool Manifest::has(const std::string& name) const {
  return std::any_of(functions.begin(), functions.end(),
                     [&](const FunctionInfo& f) { return f.name == name; });
}

const FunctionInfo& Manifest::function(const std::string& name) const {
  for (const FunctionInfo& f : functions) {
    if (f.name == name) {
      return f;
    }
  }
  throw std::out_of_range("no generated function " + name);
}

}  // namespace treedyn::support
