#pragma once

#include <stop_token>
#include <vector>

#include "core/foundations/base/ordinal.h"

namespace geargraph {

/// The problem of stacking planes of wheels along parallel axes: any order in which nothing overlaps is
/// valid.
struct StackPlanes {
  struct Wheel {
    int plane = 0;
    LinkOrdinal link = 0;
    AxisGroupOrdinal axisGroup = 0;
    double offset = 0;  ///< of its middle from that of its plane
  };
  /// A wheel through which another parallel axis passes, so that no shaft is possible there.
  struct BlockedPlane {
    int plane = 0;
    AxisGroupOrdinal axisGroup = 0;  ///< the other axis
    double offset = 0;
  };
  /// A link whose arms hold the axes of wheels: the arms are on one side of all of these.
  struct Carrier {
    LinkOrdinal link = 0;
    AxisGroupOrdinal axisGroup = 0;  ///< about whose line it turns
    std::vector<int> planes;         ///< of the wheels that it carries
  };

  std::vector<double> thickness;         ///< by plane: of its wheels
  double gap = 0;                        ///< between planes whose wheels would overlap
  std::vector<std::vector<bool>> meets;  ///< by pair: at one level, wheels of the two planes would overlap
  std::vector<Wheel> wheels;
  std::vector<BlockedPlane> covers;
  std::vector<Carrier> carriers;
};

/// The number of enclosures: cases of a link with wheels or arms on both sides of those of another link on
/// the same axis, or of a wheel that its axis passes through, so that one could only be reached through the
/// other. `heights`: of the planes' middles.
[[nodiscard]] int enclosedCount(const StackPlanes& planes, const std::vector<double>& heights);

/// The heights of the planes' middles in the order with the smallest enclosedCount(), of those the lowest
/// stack, of those the first, so that equal problems have equal results. Up to six planes by exhaustive
/// search; more by local search, moving one plane at a time to its best place until nothing improves or
/// `stop` is requested.
/// Cost: O(p!) or O(rounds * p^2) times O(wheels^2 on an axis).
[[nodiscard]] std::vector<double> stackedHeights(const StackPlanes& planes, const std::stop_token& stop = {});

}  // namespace geargraph
