// Which numbers of a robot a number is made of.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/real.hpp"
#include "common/recipe.hpp"

namespace treedyn {

/// What a number says of a link: kPlace and kTurn where its joint sits on the father,
/// kPoint where points and fixed frames are.
enum class ModelPart : std::uint8_t {
  kMass,
  kCom,
  kInertia,
  kPlace,
  kTurn,
  kPoint,
  kGravity,
  kScene
};

/// One number of a robot.
struct Origin {
  int link = -1;  ///< -1: of no link
  ModelPart part = ModelPart::kMass;
  int component = 0;  ///< x y z; xx xy xz yy yz zz; of a scene a model::SceneNumber
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const Origin&) const = default;
};

/// kg^mass m^length s^time; not known of numbers of robots in which some mass or length is exactly
/// 1, as that is a one of the equations.
struct Dimension {
  int mass = 0;
  int length = 0;
  int time = 0;
  bool is_known = true;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const Dimension&) const = default;
};

/// All that a number is made of.
struct Provenance {
  std::vector<Origin> origins;  ///< ascending
  Dimension dimension;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 sees a pointer in <=>
  auto operator<=>(const Provenance&) const = default;
};

/// The source of a number that is seen as another one, or of its negative. None: of the equations,
/// or not known. What has cancelled is not in it: how a number changes with those of the robot is
/// worked out from the operations that made it, at the stand-ins. O(n log n) for n operations
std::optional<Provenance> provenance_of(const Real& number);

/// All that a thread knows of numbers. What a task found out in another thread is learned when it
/// is done (common/parallel.hpp).
class Sources;
std::shared_ptr<Sources> copy_of_sources();
/// \return those that the thread had
std::shared_ptr<Sources> exchange_sources(std::shared_ptr<Sources> of_thread);
/// Learns those of a task; of two ways to one number that of the caller counts. Of another robot,
/// or of more of its numbers, those of the task replace what was known. O(n)
void learn_sources(const Sources& of_task);

/// The numbers of the robot that is worked on, and of its scene behind them, the same one twice if
/// several parts share a stand-in. What is known of another robot is forgotten.
/// \param like  for each link the first one that is like it: what is equal in such links may
/// cancel, as may equal lengths and angles; of other equal numbers it is told that they were there.
/// Empty: no link is like another
void begin_provenance(const std::vector<std::pair<Real, Provenance>>& numbers,
                      const std::vector<int>& like = {});

/// What was made of two numbers, by an operation with two operands.
void note_result(RecipeKind kind, const Real& a, const Real& b, const Real& result);
/// A root, sine or cosine.
void note_result(RecipeKind kind, const Real& of, const Real& result);
/// A number without unit that was made of others, nobody says how.
void note_ratio(std::span<const Real> of, const Real& result);

}  // namespace treedyn
