#pragma once

#include <vector>

#include "core/machine/body_layout/arrangement.h"
#include "core/mechanism/placement/disc_hull.h"

namespace geargraph {

enum class HullKind { gear, shaft, bearing, arm, standoff };

/// A gear or a planned part of a body as the convex hull of discs.
struct BodyHull {
  HullKind kind = HullKind::gear;
  LinkOrdinal link = 0;
  AxisGroupOrdinal axisGroup = -1;  ///< that it is placed on; -1: a standoff (HullKind::standoff)
  int other = -1;  ///< the axis class at an arm's other end, if parallel; the one that a standoff reaches
  DiscHull discs;
  int held = -1;  ///< of an arm to a non-parallel axis, and of its pedestal: the link that it holds

  [[nodiscard]] bool isOn(int c) const { return axisGroup == c || other == c; }
};

/// Which parts get hulls, and by how much they are reduced.
struct HullOptions {
  double inset = 0;      ///< modules by which shafts, bearings and arms are reduced
  bool isWhole = false;  ///< also hollow parts (rings, their carriers, drums, flat bevels), as if solid
};

/// Hulls of the gears and of the planned shafts, bearings and arms. Cost: O(parts).
[[nodiscard]] std::vector<BodyHull> bodyHulls(const Arrangement& plan, const GearTrain& train,
                                              const HullOptions& options);

}  // namespace geargraph
