#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tests/core/support/trains.h"

namespace geargraph::test {

/// The same mechanism otherwise placed, sized, ordered, named or oriented: what is computed from it has to
/// follow.
struct Transformation {
  std::string name;
  Mechanism mechanism;
  bool keepsOrder = true;       ///< of the document's lists
  bool keepsDirections = true;  ///< of its axes, or turns them all together
  Rational length = 1;          ///< factor of lengths
  /// By joint of the original: -1 where its rate changes its sign; empty: none does.
  std::vector<int> jointSigns = {};
  std::vector<InternedString> linkIds = {};  ///< by link of the original: its id here; empty: as there
  std::vector<InternedString> axisIds = {};
  std::vector<InternedString> jointIds = {};
  std::vector<InternedString> meshIds = {};
};

/// Every length times `factor`: places, offsets, widths, bores. Exact.
[[nodiscard]] Mechanism withLengthsScaled(Mechanism mechanism, const Rational& factor);

/// The lists of links (behind the ground), axes, joints and meshes in another order.
[[nodiscard]] Mechanism reordered(Mechanism mechanism, std::uint64_t seed);

/// Every pitch point that follows from axes and teeth without a root, written down: so that a bevel pair
/// keeps its size when the train is scaled.
[[nodiscard]] Mechanism withPitchPointsWritten(Mechanism mechanism);

/// Moves, turns, scales, other orders, names and orientations of a mechanism.
/// @pre its pitch points are written down, so that bevel pairs are scaled, too
[[nodiscard]] std::vector<Transformation> transformationsOf(const Mechanism& mechanism, std::uint64_t seed);

}  // namespace geargraph::test
