#include "formulate/origins.hpp"

#include <array>
#include <utility>
#include <vector>

#include "common/provenance.hpp"
#include "formulate/find_limbs.hpp"
#include "formulate/scene_numbers.hpp"

namespace treedyn::formulate {

namespace {

using OriginList = std::vector<std::pair<Real, Provenance>>;

constexpr Dimension kMassUnit = {1, 0, 0};
constexpr Dimension kLengthUnit = {0, 1, 0};
constexpr Dimension kInertiaUnit = {1, 2, 0};
constexpr Dimension kGravityUnit = {0, 1, -2};

/// Numbers of a tree one after the other.
class Collection {
 public:
  void add(const Real& number, const Origin& origin, const Dimension& dimension) {
    numbers_.push_back({number, {{origin}, dimension}});
    has_one_ = has_one_ || (abs(number.plain()) == 1 && dimension != Dimension{});
  }
  /// Those that follow are of another description.
  void begin_scene() {
    know_dimensions();
    has_one_ = false;
  }
  template <class Array>
  void add(const Array& numbers, int link, ModelPart part, const Dimension& dimension) {
    int component = 0;
    for (const Real& number : numbers) {
      add(number, {link, part, component++}, dimension);
    }
  }
  /// Of turns all entries are one number to the reader.
  template <class Array>
  void add_turn(const Array& numbers, int link, ModelPart part) {
    for (const Real& number : numbers) {
      add(number, {link, part, 0}, {});
    }
  }
  void add(const model::Inertia& inertia, int link) {
    constexpr std::array<std::size_t, 6> kPlaces = {0, 1, 2, 4, 5, 8};
    add(inertia.mass, {link, ModelPart::kMass, 0}, kMassUnit);
    add(inertia.com, link, ModelPart::kCom, kLengthUnit);
    for (std::size_t k = 0; k < kPlaces.size(); ++k) {
      add(inertia.about_com[kPlaces[k]], {link, ModelPart::kInertia, static_cast<int>(k)},
          kInertiaUnit);
    }
  }

  [[nodiscard]] OriginList numbers() && {
    know_dimensions();
    return std::move(numbers_);
  }

 private:
  void know_dimensions() {
    for (; known_ < numbers_.size(); ++known_) {
      Dimension& dimension = numbers_[known_].second.dimension;
      dimension.is_known = dimension.is_known && !has_one_;
    }
  }

  OriginList numbers_;
  std::size_t known_ = 0;  ///< of how many it is decided whether dimensions are known
  bool has_one_ = false;
};

}  // namespace

void note_provenance(const Seen& seen) {
  Collection all;
  for (int i = 0; i < seen.tree.size(); ++i) {
    const model::Link& link = seen.tree.links[static_cast<std::size_t>(i)];
    all.add_turn(link.joint.axis, i, ModelPart::kTurn);
    all.add_turn(link.joint.rotation, i, ModelPart::kTurn);
    all.add(link.joint.offset, i, ModelPart::kPlace, kLengthUnit);
    all.add(link.inertia, i);
  }
  for (const model::Frame& frame : seen.tree.frames) {
    all.add_turn(frame.rotation, frame.link, ModelPart::kPoint);
    all.add(frame.origin, frame.link, ModelPart::kPoint, kLengthUnit);
  }
  for (const std::vector<model::Point>* points : {&seen.tree.points, &seen.options.points}) {
    for (const model::Point& point : *points) {
      all.add_turn(point.rotation, point.link, ModelPart::kPoint);
      all.add(point.at, point.link, ModelPart::kPoint, kLengthUnit);
    }
  }
  all.add(seen.options.gravity, -1, ModelPart::kGravity, kGravityUnit);
  if (seen.scene) {
    all.begin_scene();
    model::Scene scene = *seen.scene;
    each_number(scene, [&](std::span<Real> numbers, const SceneMeaning& meaning) {
      for (const Real& number : numbers) {
        all.add(number, {meaning.link, ModelPart::kScene, static_cast<int>(meaning.what)},
                meaning.dimension);
      }
    });
  }
  std::vector<int> like(seen.tree.links.size());
  for (const std::vector<int>& links : similar_links(seen.tree)) {
    for (const int link : links) {
      like[static_cast<std::size_t>(link)] = links.front();
    }
  }
  begin_provenance(std::move(all).numbers(), like);
}

}  // namespace treedyn::formulate
