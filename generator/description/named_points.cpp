#include "description/named_points.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "common/closest.hpp"
#include "common/decimal.hpp"
#include "common/identifier.hpp"
#include "description/identifiers.hpp"
#include "description/read.hpp"
#include "description/vectors.hpp"

namespace treedyn::description {

namespace {

/// The point at `at` in the frame of a link of the file.
model::Point on_frame(const std::string& name, const model::Frame& frame, const Vector3& at) {
  Vector3 moved = frame.rotation * at;
  const Real scale = abs(at[0]) + abs(at[1]) + abs(at[2]);
  for (Real& entry : moved) {
    entry = negligible(entry, scale) ? Real(0) : entry;
  }
  return {name, to_identifier(name), frame.name, frame.link, frame.origin + moved, frame.rotation};
}

std::string some_sorted(std::vector<std::string_view> all) {
  std::ranges::sort(all);
  return some_names(all);
}

/// What is wrong with a link that is none of the model's frames.
std::string unknown_link(const model::Tree& tree, std::string_view point, std::string_view name) {
  if (name == "ground") {
    return fmt::format(
        "point '{}': 'ground' is in front of the base's joints; expected a link, as base_rx",
        shown(point));
  }
  return fmt::format("point '{}': link '{}' is unknown{}; expected one of {}", shown(point),
                     shown(name), did_you_mean(name, names_of(tree.frames)),
                     some_sorted(names_of(tree.frames)));
}

/// The elements of `--points`, one at a time.
class PointList {
 public:
  PointList(const model::Tree& tree, std::string_view list) : tree_(tree), list_(list) {}

  std::vector<model::Point> all() {
    std::vector<model::Point> result;
    std::vector<Named> names;
    for (bool more = !list_.empty(); more;) {
      more = next(result);
    }
    for (const model::Point& point : result) {
      names.push_back({point.name, point.identifier, {"--points", 0, 0}});
    }
    check_identifiers(names, "point");
    return result;
  }

 private:
  [[noreturn]] static void fail(const std::string& message) {
    throw InputError({"--points", 0, 0}, message);
  }

  /// Up to the next comma; false if there was none.
  bool take(std::string_view& word) {
    const std::size_t comma = list_.find(',');
    word = list_.substr(0, comma);
    list_ = comma == std::string_view::npos ? std::string_view{} : list_.substr(comma + 1);
    return comma != std::string_view::npos;
  }

  [[nodiscard]] const model::Frame& frame(std::string_view name, std::string_view point) const {
    const model::Frame* const found = find_frame(tree_, name);
    if (found == nullptr) {
      fail(unknown_link(tree_, point, name));
    }
    return *found;
  }

  bool next(std::vector<model::Point>& result) {
    std::string_view word;
    const bool more = take(word);
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    if (name.empty()) {
      fail("empty name; expected name, name=link or name=link:x,y,z");
    }
    if (equals == std::string_view::npos) {
      add_bare(name, result);
      return more;
    }
    const std::string_view link = word.substr(equals + 1);
    const std::size_t colon = link.rfind(':');
    if (find_frame(tree_, link) != nullptr || colon == std::string_view::npos) {
      result.push_back(on_frame(std::string(name), frame(link, name), {}));
      return more;
    }
    return add_at(name, link.substr(0, colon), link.substr(colon + 1), more, result);
  }

  void add_bare(std::string_view name, std::vector<model::Point>& result) const {
    const auto point = std::ranges::find(tree_.points, name, &model::Point::name);
    if (point != tree_.points.end()) {
      result.push_back(*point);
    } else if (name == "all" && find_frame(tree_, name) == nullptr) {
      const std::vector<model::Point> origins = points_of_links(tree_);
      result.insert(result.end(), origins.begin(), origins.end());
    } else if (const model::Frame* const frame = find_frame(tree_, name)) {
      result.push_back(on_frame(std::string(name), *frame, {}));
    } else {
      std::vector<std::string_view> known = names_of(tree_.points);
      const std::vector<std::string_view> links = names_of(tree_.frames);
      known.insert(known.end(), links.begin(), links.end());
      fail(fmt::format("'{}' is neither a point nor a link of the model{}; expected one of {}",
                       shown(name), did_you_mean(name, known), some_sorted(known)));
    }
  }

  /// `x` is the first coordinate, y and z follow in the list.
  bool add_at(std::string_view name, std::string_view link, std::string_view x, bool more,
              std::vector<model::Point>& result) {
    const model::Frame& on = frame(link, name);
    std::array<std::string_view, 3> words = {x, {}, {}};
    for (std::size_t k = 1; k < 3; ++k) {
      if (!more) {
        fail(fmt::format("point '{}' has {} number{}; expected 3", shown(name), k,
                         k == 1 ? "" : "s"));
      }
      more = take(words[k]);
    }
    Vector3 at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Decimal decimal = read_decimal(words[k]);
      if (!decimal) {
        fail(fmt::format("point '{}': {}", shown(name), describe(decimal.error, words[k])));
      }
      at[k] = decimal.value;
    }
    result.push_back(on_frame(std::string(name), on, at));
    return more;
  }

  const model::Tree& tree_;
  std::string_view list_;
};

}  // namespace

const model::Frame* find_frame(const model::Tree& tree, std::string_view name) {
  static const model::Frame ground{"ground", model::kGround, identity(), {}};
  const auto found = std::ranges::find(tree.frames, name, &model::Frame::name);
  if (found != tree.frames.end()) {
    return &*found;
  }
  return name == ground.name && base_of(tree) == Base::kFixed ? &ground : nullptr;
}

std::vector<model::Point> resolve_points(const model::Tree& tree, const std::string& list) {
  return PointList(tree, list).all();
}

std::vector<model::Point> points_of_links(const model::Tree& tree) {
  std::vector<model::Point> result;
  for (int i = 0; i < tree.size(); ++i) {
    const std::string& link = tree.links[static_cast<std::size_t>(i)].name;
    result.push_back({link, to_identifier(link), link, i, {}});
  }
  return result;
}

void resolve_named_points(const RawTree& raw, const NumberReader& numbers, model::Tree& tree) {
  std::vector<Named> names;
  for (const RawPoint& point : raw.points) {
    const model::Frame* const frame = find_frame(tree, point.link.text);
    if (frame == nullptr) {
      throw InputError(location(raw, point.link.where),
                       unknown_link(tree, point.name.text, point.link.text));
    }
    const Vector3 at =
        numbers.vector(point.at, fmt::format("point '{}': at", shown(point.name.text)));
    tree.points.push_back(on_frame(point.name.text, *frame, at));
    names.push_back(
        {point.name.text, tree.points.back().identifier, location(raw, point.name.where)});
  }
  check_identifiers(names, "point");
}

}  // namespace treedyn::description
