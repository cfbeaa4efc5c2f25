#include "tests/bench/gear_field.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/machine/solids/gear_solid.h"

namespace geargraph::bench {

Scene gearField(int count, int shapes) {
  Scene scene;
  for (int shape = 0; shape < std::min(count, shapes); ++shape) {
    const GearSpec spec = standardGear(GearKind::external, 60, 2, 20 - 0.05 * shape);
    const auto solid = [spec](double tolerance) { return gearSolid(spec, tolerance).value(); };
    scene.solids.push_back(std::make_shared<const Solid>(solid(kMaxTolerance)));
    DetailLevels& levels = scene.levels.emplace_back();
    levels.unit = spec.module;
    levels.error = kMaxTolerance;
    for (const double error : {kFarTolerance, kScreenTolerance}) {
      levels.finer.push_back({error, std::make_shared<const DeferredSolid>([=] { return solid(error); })});
    }
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    Instance instance;
    instance.solid = static_cast<std::size_t>(i) % scene.solids.size();
    instance.pose.translation() = Eigen::Vector3d(126.0 * (i % side), 126.0 * (i / side), 10.0 * (i % 3));
    instance.pose.rotate(Eigen::AngleAxisd(0.3 * i, Eigen::Vector3d::UnitZ()));
    instance.colour = Rgb::fromHex(i % 2 == 0 ? 0x0072B2 : 0xD55E00);
    instance.element = LinkId(std::to_string(i));
    scene.instances.push_back(instance);
  }
  return scene;
}

}  // namespace geargraph::bench
