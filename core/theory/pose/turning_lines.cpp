#include "core/theory/pose/turning_lines.h"

#include "core/foundations/base/contract.h"

namespace geargraph {

std::vector<TurningLine> turningLines(const Placement& placement) {
  GEARGRAPH_REQUIRE(placement.tree.has_value());
  std::vector<TurningLine> lines;
  lines.reserve(placement.tree->axisOf.size());
  for (JointOrdinal joint = 0; joint < static_cast<int>(placement.tree->axisOf.size()); ++joint) {
    const AxisLine& line = placement.axes[placement.tree->axisOf[joint]];
    lines.push_back({Eigen::Vector3d(line.point.data()), Eigen::Vector3d(line.direction.data()),
                     placement.classes->classes[placement.classes->classOf[joint]].kind});
  }
  return lines;
}

}  // namespace geargraph
