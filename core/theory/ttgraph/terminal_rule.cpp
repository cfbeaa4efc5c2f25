#include "core/theory/ttgraph/terminal_rule.h"

#include <cmath>

namespace geargraph {
namespace {

std::optional<int> againstEachOther(int sense) {
  return -sense;
}

std::optional<int> theSameWay(int sense) {
  return sense;
}

std::optional<int> asThePointSays(int /*sense*/) {
  return std::nullopt;
}

/// s = -cos(beta_i + beta_j + Sigma): of two threads that run the same way, the one drives the other aside as
/// it would drive a nut.
std::optional<int> asHandsSay(double sum) {
  return std::cos(sum) > 0 ? -1 : 1;
}

/// The teeth of the pinion push the rack square to themselves: forward, unless it slides so far aside of the
/// way in which the pinion rolls that they are past it.
std::optional<int> asPinionRolls(const SlidePose& pose) {
  const Vector3 rolling = unit(cross(pose.axis, pose.arm));
  const double aside = std::atan2(dot(pose.slide, pose.axis), dot(pose.slide, rolling));
  return std::cos(pose.helix + aside) > 0 ? 1 : -1;
}

/// A right-hand screw that turns on advances in its nut: the nut, which cannot turn, comes back.
std::optional<int> asNutComesBack(const SlidePose& pose) {
  const bool isRight = pose.helix > 0;
  return isRight == (dot(pose.axis, pose.slide) > 0) ? -1 : 1;
}

/// As bevels: between two half axes that point alike the gears turn against each other.
std::optional<int> asHalfAxesSay(int tail, int head) {
  return -tail * head;
}

constexpr TerminalRule kExternalTerminals{againstEachOther};
constexpr TerminalRule kInternalTerminals{theSameWay};
constexpr TerminalRule kBevelTerminals{asThePointSays};
constexpr TerminalRule kOpenStrandTerminals{theSameWay};
constexpr TerminalRule kPinTerminals{theSameWay};
constexpr TerminalRule kRackTerminals{.alongParallels = asThePointSays, .alongSlide = asPinionRolls};
constexpr TerminalRule kScrewTerminals{.alongParallels = asThePointSays, .alongSlide = asNutComesBack};
constexpr TerminalRule kCrossedTerminals{asThePointSays, asHandsSay};
constexpr TerminalRule kHypoidTerminals{.alongParallels = asThePointSays, .alongHalfAxes = asHalfAxesSay};

}  // namespace

KindTable<MeshKind, TerminalRule>& terminalRules() {
  static constinit KindTable<MeshKind, TerminalRule> table(
      &kExternalTerminals, &kInternalTerminals, &kBevelTerminals, &kOpenStrandTerminals, &kPinTerminals,
      &kRackTerminals, &kScrewTerminals, &kCrossedTerminals, &kCrossedTerminals, &kBevelTerminals,
      &kHypoidTerminals);
  return table;
}

}  // namespace geargraph
