#pragma once

#include <span>
#include <vector>

#include "core/design/gearboxes/gearbox_wish.h"

namespace geargraph {

constexpr int kMinPlanets = 3;  ///< of a set, or pairs of planets
constexpr int kMaxPlanets = 6;

/// Tooth counts of one basic set.
struct SetTeeth {
  int sun = 0;
  int planet = 0;  ///< that meshes with the sun
  int outer = 0;   ///< of double planets: the one that meshes with the ring; else 0
  int ring = 0;
  [[nodiscard]] Rational k() const { return {ring, sun}; }
  friend auto operator<=>(const SetTeeth&, const SetTeeth&) = default;
};

/// Tooth counts of a whole set, of both parts of a Ravigneaux set, with the numbers of planets, or pairs, of
/// which that many go in equally spaced and clear each other: kMinPlanets to kMaxPlanets, never empty.
struct TeethOption {
  std::vector<SetTeeth> parts;
  std::vector<int> planets;
  friend auto operator<=>(const TeethOption&, const TeethOption&) = default;
};

/// The tooth counts within the limits whose ring ratios are within `window` of `k`, as a logarithm; of equal
/// ring ratios the one with the smallest ring. Nearest first, at most `most`.
/// Cost: O(ring^2) for simple sets, O(ring^3) of few for others.
[[nodiscard]] std::vector<TeethOption> teethNear(SetKind kind, std::span<const double> k,
                                                 const SetTeethWish& limits, double window, std::size_t most);

/// Do n equal planets of these teeth go in equally spaced, without touching each other?
[[nodiscard]] bool planetsFit(SetKind kind, const std::vector<SetTeeth>& parts, int planets);

}  // namespace geargraph
