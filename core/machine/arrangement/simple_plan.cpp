// Bodies of trains that are too large to be routed: nothing is compared with anything beyond its own axis.

#include <algorithm>
#include <map>

#include "core/machine/arrangement/body_planner.h"
#include "core/machine/solids/gear_body.h"

namespace geargraph::inline arrangement {

/// Bearings of an axis stand in a row outside of its wheels, on the bearings' side: nearest the one whose
/// link has its wheels nearest to that end, so that the shafts of the others, which come from farther in, are
/// the inner ones.
void BodyPlanner::placeInRow(int axisClass) {
  AxisLayout& layout = axis(axisClass);
  const int side = layout.bearingSide;
  double end = -1e300;  // of all wheels, towards the bearings' side
  std::map<int, double> depths;
  for (const Stretch& s : layout.wheels) {
    const double edge = side < 0 ? -s.low : s.high;
    end = std::max(end, edge);
    const auto [known, isNew] = depths.try_emplace(s.link, edge);
    if (!isNew) known->second = std::max(known->second, edge);
  }
  const auto depthOf = [&](int link) {
    const auto found = depths.find(link);
    return found == depths.end() ? -1e300 : found->second;
  };
  std::vector<Bearing*> row;
  for (Bearing& bearing : layout.bearings) row.push_back(&bearing);
  std::stable_sort(row.begin(), row.end(),
                   [&](const Bearing* a, const Bearing* b) { return depthOf(a->child) > depthOf(b->child); });
  double at = end + layout.gap() + layout.width() / 2;
  for (Bearing* bearing : row) {
    if (!layout.wheels.empty()) {
      bearing->at = side * at;
      at += layout.width() + layout.gap();
    }
    bearing->placed = true;
  }
}

/// A straight arm from each carrier's axis to each bearing that it holds; the frame's stand on feet. Cost:
/// O(gears + joints), of each axis O(its shafts^2).
Arrangement BodyPlanner::planSimply() {
  m_plan.isSimple = true;
  for (std::size_t g = 0; g < m_train.gears.size(); ++g) {
    const TrainGear& gear = m_train.gears[g];
    if (gear.spec.kind != GearKind::internal) continue;
    AxisLayout& layout = axis(gear.axisClass);
    const double plate = layout.coordinate(gear.pose.translation()) +
                         layout.bearingSide * (gear.spec.faceWidth / 2 + layout.gap() + layout.width() / 2);
    m_plan.cups.push_back({static_cast<int>(g), layout.bearingSide, plate});
    layout.wheels.push_back({plate - layout.width() / 2, plate + layout.width() / 2, gear.link});
  }
  for (std::size_t c = 0; c < m_plan.axes.size() && !isStopped(); ++c) {
    placeInRow(static_cast<int>(c));
    for (const Bearing& bearing : m_plan.axes[c].bearings) {
      const int home = m_placement.classes->classOfLink(bearing.parent);
      if (bearing.parent == 0 || home == static_cast<int>(c)) continue;
      const double level = axis(home).coordinate(m_plan.axes[c].at(bearing.at));
      addArm({bearing.parent, home, level, static_cast<int>(c), bearing.at, bearing.child});
    }
  }
  for (std::size_t link = 1; link < m_heldBy.size() && !isStopped(); ++link)
    addShaft(m_placement.classes->classOfLink(static_cast<int>(link)), static_cast<int>(link));
  addFixedHubs();
  for (std::size_t c = 0; c < m_plan.axes.size() && !isStopped(); ++c) nestShafts(static_cast<int>(c));
  return std::move(m_plan);
}

}  // namespace geargraph::inline arrangement
