#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/machine/solids/gear_solid.h"
#include "core/machine/train/train.h"

namespace geargraph {

/// A solid that is part of a link.
struct LinkPart {
  LinkOrdinal link = 0;  ///< its position in the document
  std::string name;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< to the base frame, reference pose
  std::shared_ptr<const Solid> solid;
  GearOrdinal gear = -1;  ///< of the train; -1: the link's body
};

struct TrainParts {
  std::vector<LinkPart> parts;
  Diagnostics diagnostics;  ///< about gears that could not be made, which are left out
};

/// The solids of all gears, then of all bodies, as parts of their links, for views and files. `tolerance` in
/// modules; bodies have kBodyTolerance, or kMaxTolerance for a tolerance from there on. Incomplete if
/// `stop` was requested meanwhile.
[[nodiscard]] TrainParts trainParts(const Mechanism& mechanism, const GearTrain& train, GearCache& cache,
                                    double tolerance, const std::stop_token& stop = {});

}  // namespace geargraph
