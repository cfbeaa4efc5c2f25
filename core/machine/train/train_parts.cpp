#include "core/machine/train/train_parts.h"

namespace geargraph {

TrainParts trainParts(const Mechanism& mechanism, const GearTrain& train, GearCache& cache, double tolerance,
                      const std::stop_token& stop) {
  TrainParts result;
  for (std::size_t g = 0; g < train.gears.size() && !stop.stop_requested(); ++g) {
    const TrainGear& gear = train.gears[g];
    auto solid = cache.solid(gear.spec, tolerance);
    if (solid) {
      result.parts.push_back({gear.link, gear.name, gear.pose, *std::move(solid), static_cast<int>(g)});
    } else {
      append(result.diagnostics, solid.error());
    }
  }
  for (const LinkBody& body : train.bodies) {
    if (stop.stop_requested()) break;
    result.parts.push_back({body.link, "body of link " + std::to_string(mechanism.linkLabel(body.link)),
                            Eigen::Isometry3d::Identity(),
                            (tolerance < kMaxTolerance ? body.fine : body.coarse)->solid()});
  }
  return result;
}

}  // namespace geargraph
