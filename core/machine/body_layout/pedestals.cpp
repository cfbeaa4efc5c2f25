#include "core/machine/body_layout/pedestals.h"

#include <algorithm>
#include <cmath>

#include "core/machine/body_layout/shaft_clearance.h"

namespace geargraph {

std::optional<double> pedestalPlace(const PlanDraft& draft, const Bearing& bearing) {
  const int c = draft.classOf(bearing);
  const AxisLayout& layout = draft.axis(c);
  std::vector<double> places{bearing.at};
  for (const double x : layout.slotCandidates()) places.push_back(x);
  std::erase_if(places, [&](double x) {
    return draft.isStopped() || !layout.slotIsFree(x) || !layout.nests(bearing, x) ||
           !shaftPasses(draft, bearing, x);
  });
  if (places.empty()) return std::nullopt;
  const Interval held = heldInterval(draft, c, bearing.child);
  const double near = held.low <= held.high ? (held.low + held.high) / 2 : bearing.at;
  return *std::min_element(places.begin(), places.end(), [&](double a, double b) {
    return std::abs(a - near) < std::abs(b - near) - 1e-9 * layout.module;
  });
}

void putOnPedestal(PlanDraft& draft, Bearing& bearing, double place) {
  bearing.at = place;
  bearing.placed = true;
  draft.axis(draft.classOf(bearing)).occupy(place, bearing.parent);
}

void putOnPedestalOrReport(PlanDraft& draft, Bearing& bearing) {
  const auto place = pedestalPlace(draft, bearing);
  if (!place) draft.plan.blocked.push_back({bearing.parent, bearing.child});
  const int c = draft.classOf(bearing);
  putOnPedestal(draft, bearing, place ? *place : draft.axis(c).freeSlot(bearing.at));
}

}  // namespace geargraph
