// Short model texts for the tests of the readers.
#pragma once

#include <string>

#include <fmt/format.h>

#include "description/read.hpp"

namespace treedyn::description {

inline ReadOptions options(const char* snap = "1e-9", Base base = Base::kFixed,
                           Mimic mimic = Mimic::kReduce) {
  return {base, mimic, Real(snap)};
}

/// A tree description of one revolute link with the given entries for its joint and for itself.
inline std::string one_link(const std::string& joint, const std::string& link = "mass: 1") {
  return fmt::format(
      "name: m\nlinks:\n- name: a\n  father: ground\n  joint: {{name: j, {}}}\n  {}\n", joint,
      link);
}

/// A URDF of the links base and a with one joint j between them.
inline std::string one_joint(const std::string& joint, const std::string& link = "",
                             const std::string& type = "revolute") {
  return fmt::format(
      "<robot name=\"m\">\n<link name=\"base\"/>\n<link name=\"a\">{}</link>\n"
      "<joint name=\"j\" type=\"{}\"><parent link=\"base\"/><child "
      "link=\"a\"/>{}</joint>\n</robot>",
      link, type, joint);
}

inline model::Tree yaml(const std::string& text, const ReadOptions& how = options()) {
  return parse_model(text, "m.yaml", how);
}

inline model::Tree urdf(const std::string& text, const ReadOptions& how = options()) {
  return parse_model(text, "m.urdf", how);
}

/// The line that `main` prints for the text, "" if it is accepted.
inline std::string yaml_error(const std::string& text, const ReadOptions& how = options()) {
  try {
    yaml(text, how);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline std::string urdf_error(const std::string& text, const ReadOptions& how = options()) {
  try {
    urdf(text, how);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace treedyn::description
