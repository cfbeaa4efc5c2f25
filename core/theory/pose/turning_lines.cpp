#include "core/theory/pose/turning_lines.h"

#include "core/foundations/base/contract.h"

namespace geargraph {

std::vector<TurningLine> turningLines(const Placement& placement) {
  GEARGRAPH_REQUIRE(placement.tree.has_value());
  std::vector<TurningLine> lines;
  lines.reserve(placement.tree->axisOf.size());
  for (const AxisOrdinal axis : placement.tree->axisOf) {
    const AxisLine& line = placement.axes[axis];
    lines.push_back({Eigen::Vector3d(line.point.data()), Eigen::Vector3d(line.direction.data())});
  }
  return lines;
}

}  // namespace geargraph
