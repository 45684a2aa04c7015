#include "description/run_time_fields.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "common/decimal.hpp"
#include "description/identifiers.hpp"
#include "description/read.hpp"
#include "description/vectors.hpp"
#include "model/parameters.hpp"

namespace treedyn::description {

namespace {

using Kind = model::ParameterKind;

/// What messages begin with: of the command line the place says it.
const char* prefix(const Location& where) { return where.line > 0 ? "runtime: " : ""; }

std::string expected(const std::vector<const char*>& names) {
  return fmt::format("{}; of one component com.x or inertia.xx", fmt::join(names, ", "));
}

model::Declared quantity_of(const std::string& name, bool of_point, const Location& where,
                            const std::string& what) {
  const std::optional<model::Declared> found = model::find_quantity(name);
  if (!found || found->quantity == Kind::kGravity ||
      (found->quantity == Kind::kPoint) != of_point) {
    throw InputError(where, fmt::format("{}: '{}' cannot be known at run time only; expected {}",
                                        what, shown(name),
                                        of_point ? "at; of one component at.x"
                                                 : expected({"mass", "com", "inertia", "offset"})));
  }
  return *found;
}

/// True for the only link with inertia on the last link of a base on axes, if it is in its frame:
/// the numbers of both are the same.
bool is_whole_base(const RawTree& raw, const model::Tree& tree, const model::Frame& frame) {
  const auto has_inertia = [&](const model::Frame& other) {
    const auto link = std::ranges::find_if(
        raw.links, [&](const RawLink& candidate) { return candidate.name.text == other.name; });
    return other.link == frame.link && link != raw.links.end() && link->inertia;
  };
  return frame.origin == Vector3{} && frame.rotation == identity() && has_inertia(frame) &&
         std::ranges::count_if(tree.frames, has_inertia) == 1;
}

/// The moving link of that name. What is fixed to a link has no numbers of its own.
int moving_link(const RawTree& raw, const model::Tree& tree, const std::string& name,
                const std::string& quantity, const Location& where) {
  const auto frame = std::ranges::find(tree.frames, name, &model::Frame::name);
  if (frame == tree.frames.end()) {
    throw InputError(where, fmt::format("{}there is no link '{}'; expected one of the model",
                                        prefix(where), shown(name)));
  }
  if (frame->link == model::kGround) {
    throw InputError(where, fmt::format("{}link '{}' does not move; expected one that does",
                                        prefix(where), shown(name)));
  }
  const model::Link& link = tree.links[static_cast<std::size_t>(frame->link)];
  if (link.name == name) {
    return frame->link;
  }
  if (!is_base_link(tree, frame->link)) {
    throw InputError(where, fmt::format("{}link '{}' is fixed to link '{}'; expected that "
                                        "one, whose numbers are those of both",
                                        prefix(where), shown(name), shown(link.name)));
  }
  if (quantity.starts_with("offset") || !is_whole_base(raw, tree, *frame)) {
    throw InputError(where, fmt::format("{3}link '{0}' is fixed to base link '{1}' and is "
                                        "not all of it; expected mass, com or inertia of the only "
                                        "link with inertia there, in its frame, or --runtime "
                                        "{1}.{2}, which scenes do not take",
                                        shown(name), link.name, shown(quantity), prefix(where)));
  }
  return frame->link;
}

class Declarations {
 public:
  Declarations(const RawTree& raw, model::Tree& tree) : raw_(raw), tree_(tree) {}

  void add_of_link(const std::string& link, const std::string& quantity, const Location& where) {
    const int i = moving_link(raw_, tree_, link, quantity, where);
    const std::string what =
        fmt::format("link '{}'{}", shown(link), where.line > 0 ? ": runtime" : "");
    add(i, quantity_of(quantity, false, where, what), where);
  }
  void add_of_point(const std::string& point, const std::string& quantity, const Location& where) {
    const auto found = std::ranges::find(tree_.points, point, &model::Point::name);
    if (found == tree_.points.end()) {
      throw InputError(
          where, fmt::format("{}there is no point '{}'; expected one of the model's own points",
                             prefix(where), shown(point)));
    }
    const std::string what =
        fmt::format("point '{}'{}", shown(point), where.line > 0 ? ": runtime" : "");
    add(static_cast<int>(found - tree_.points.begin()), quantity_of(quantity, true, where, what),
        where);
  }
  /// What is no number of a link or point.
  void add(const std::string& name, const Location& where) {
    const std::optional<model::Declared> found = model::find_quantity(name);
    if (!found || found->quantity != Kind::kGravity) {
      throw InputError(
          where,
          fmt::format("{}'{}' cannot be known at run time only; expected gravity, or LINK.mass, "
                      "LINK.com, LINK.inertia, LINK.offset, POINT.at on the command line",
                      prefix(where), shown(name)));
    }
    add(model::kGround, *found, where);
  }
  void check() const { check_identifiers(named_, "run-time parameter"); }

 private:
  void add(int link, const model::Declared& declared, const Location& where) {
    for (model::Parameter& parameter : model::parameters_of(tree_, link, declared)) {
      named_.push_back({parameter.declared, parameter.identifier, where});
      tree_.parameters.push_back(std::move(parameter));
    }
  }

  const RawTree& raw_;
  model::Tree& tree_;
  std::vector<Named> named_;
};

/// Where a declaration of the command line is split: in front of the quantity, and the component
/// behind it. Nothing without a quantity.
std::size_t split(const std::string& text, const model::Tree& tree) {
  const std::size_t last = text.rfind('.');
  const std::size_t before =
      last == std::string::npos || last == 0 ? std::string::npos : text.rfind('.', last - 1);
  if (before == std::string::npos) {
    return last;
  }
  const auto is_link = [&](std::size_t size) {
    return std::ranges::count(tree.frames, text.substr(0, size), &model::Frame::name) > 0;
  };
  return model::find_quantity(text.substr(before + 1)) || (is_link(before) && !is_link(last))
             ? before
             : last;
}

}  // namespace

void resolve_parameters(const RawTree& raw, const std::vector<std::string>& list,
                        model::Tree& tree) {
  Declarations declarations(raw, tree);
  for (const RawRuntime& runtime : raw.runtime) {
    const Location where = location(raw, runtime.quantity.where);
    if (runtime.of_point) {
      declarations.add_of_point(runtime.owner.text, runtime.quantity.text, where);
    } else if (runtime.owner.text.empty()) {
      declarations.add(runtime.quantity.text, where);
    } else {
      declarations.add_of_link(runtime.owner.text, runtime.quantity.text, where);
    }
  }
  for (const std::string& text : list) {
    const Location where{"--runtime", 0, 0};
    const std::size_t dot = split(text, tree);
    if (dot == std::string::npos || text.starts_with("gravity.")) {
      declarations.add(text, where);
      continue;
    }
    const std::string quantity = text.substr(dot + 1);
    const auto found = model::find_quantity(quantity);
    if (found && found->quantity == Kind::kPoint) {
      declarations.add_of_point(text.substr(0, dot), quantity, where);
    } else {
      declarations.add_of_link(text.substr(0, dot), quantity, where);
    }
  }
  declarations.check();
}

}  // namespace treedyn::description
