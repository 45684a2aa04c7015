#include "description/run_time_fields.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/identifiers.hpp"
#include "model/parameters.hpp"

namespace treedyn::description {

namespace {

model::ParameterKind quantity_of(const std::string& name, const Location& where,
                                 const std::string& what) {
  const auto& names = model::quantity_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw InputError(where, fmt::format("{}: '{}' cannot be known at run time only; expected {}",
                                        what, shown(name), fmt::join(names, ", ")));
  }
  return static_cast<model::ParameterKind>(found - names.begin());
}

/// The moving link of that name. What is fixed to a link has no numbers of its own.
int moving_link(const model::Tree& tree, const std::string& name, const Location& where) {
  const auto frame =
      std::find_if(tree.frames.begin(), tree.frames.end(),
                   [&](const model::Frame& candidate) { return candidate.name == name; });
  if (frame == tree.frames.end()) {
    throw InputError(where, fmt::format("runtime: there is no link '{}'; expected one of the model",
                                        shown(name)));
  }
  if (frame->link == model::kGround) {
    throw InputError(where, fmt::format("runtime: link '{}' does not move; expected one that does",
                                        shown(name)));
  }
  const model::Link& link = tree.links[static_cast<std::size_t>(frame->link)];
  if (link.name != name) {
    throw InputError(where, fmt::format("runtime: link '{}' is fixed to link '{}'; expected that "
                                        "one, whose numbers are those of both",
                                        shown(name), shown(link.name)));
  }
  return frame->link;
}

class Declarations {
 public:
  explicit Declarations(model::Tree& tree) : tree_(tree) {}

  void add(const std::string& link, const std::string& quantity, const Location& where) {
    const int i = moving_link(tree_, link, where);
    const std::string what = fmt::format("link '{}': runtime", shown(link));
    add(i, quantity_of(quantity, where, what), where);
  }
  /// What is no number of a link.
  void add(const std::string& name, const Location& where) {
    if (name != "gravity") {
      throw InputError(
          where, fmt::format("runtime: '{}' cannot be known at run time only; expected gravity, or "
                             "LINK.mass, LINK.com, LINK.inertia on the command line",
                             shown(name)));
    }
    add(model::kGround, model::ParameterKind::kGravity, where);
  }
  void check() const { check_identifiers(named_, "run-time parameter"); }

 private:
  void add(int link, model::ParameterKind quantity, const Location& where) {
    for (model::Parameter& parameter : model::parameters_of(tree_, link, quantity)) {
      const std::string name = parameter.component == 0
                                   ? parameter.declared
                                   : fmt::format("{} {}", parameter.declared, parameter.component);
      named_.push_back({name, parameter.identifier, where});
      tree_.parameters.push_back(std::move(parameter));
    }
  }

  model::Tree& tree_;
  std::vector<Named> named_;
};

}  // namespace

void resolve_parameters(const RawTree& raw, const std::vector<std::string>& list,
                        model::Tree& tree) {
  Declarations declarations(tree);
  for (const RawRuntime& runtime : raw.runtime) {
    const Location where = location(raw, runtime.quantity.where);
    if (runtime.link.text.empty()) {
      declarations.add(runtime.quantity.text, where);
    } else {
      declarations.add(runtime.link.text, runtime.quantity.text, where);
    }
  }
  for (const std::string& text : list) {
    const Location where{raw.file, 0, 0};
    const std::size_t dot = text.rfind('.');
    if (dot == std::string::npos) {
      declarations.add(text, where);
    } else {
      declarations.add(text.substr(0, dot), text.substr(dot + 1), where);
    }
  }
  declarations.check();
}

}  // namespace treedyn::description
