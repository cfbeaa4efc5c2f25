#include "core/presentation/schematic/shaft_plan.h"

#include <algorithm>

#include "core/presentation/schematic/shaft_planner.h"

namespace geargraph {

const SheetShaft* ShaftPlan::shaft(int axis, int link, double near) const {
  const SheetShaft* found = nullptr;
  const auto away = [&](const SheetShaft& s) { return std::max({s.low - near, near - s.high, 0.0}); };
  for (const SheetShaft& shaft : shafts) {
    if (shaft.axis != axis || shaft.link != link) continue;
    if (found == nullptr || away(shaft) < away(*found)) found = &shaft;
  }
  return found;
}

ShaftPlan shaftPlan(const DrawnPart& part, const DrawnTrain& train, SheetLayout& layout) {
  return ShaftPlanner(part, train, layout).plan();
}

}  // namespace geargraph
