#pragma once

#include <set>
#include <stop_token>
#include <vector>

#include "core/machine/body_layout/arrangement.h"

namespace geargraph {

/// Two links whose bodies collide.
struct BodyClash {
  int one = 0;  ///< the smaller
  int other = 0;
  std::set<int> heldByFrame;  ///< links whose bearings are held by the arms of the frame that collide
};

/// Pairs of links whose planned bodies collide with each other or with the gears of the other. On one axis,
/// where levels and sleeves keep bodies apart, only shafts that pass through wheels. In the reference pose,
/// as hulls of discs (disc_hull.h); rings, drums and ring-gear carriers, which are hollow, are left out.
/// Incomplete if `stop` was requested meanwhile. Cost: O(parts^2), most pairs by their bounding spheres.
[[nodiscard]] std::vector<BodyClash> bodyClashes(const Arrangement& plan, const GearTrain& train,
                                                 const std::stop_token& stop = {});

}  // namespace geargraph
