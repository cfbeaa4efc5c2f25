#include "core/machine/body_layout/cross_shaft_bosses.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace geargraph {
namespace {

/// Would the link's shaft run within that of another on its axis, to the level beyond it, while that one runs
/// within the link's own wheels?
bool isAround(const PlanDraft& draft, AxisGroupOrdinal home, LinkOrdinal link, double level) {
  const AxisLayout& own = draft.axis(home);
  const auto wheels = own.wheelsOf(link);
  return wheels && std::any_of(own.bearings.begin(), own.bearings.end(), [&](const Bearing& other) {
           const auto passed = own.wheelsOf(other.child);
           if (other.child == link || !passed) return false;
           const double low = std::min(passed->low, other.at), high = std::max(passed->high, other.at);
           return own.overlap(wheels->low, wheels->high, low, high) &&
                  (own.isBelow(level, low) || own.isBelow(high, level));
         });
}

/// The bearing of the one shaft that a boss at the intersection holds: the one with wheels on both sides of
/// it; where several have theirs on one side, the nearest, on which the others run. The end: there is none.
std::vector<Bearing>::iterator heldByCrossShaftBoss(PlanDraft& draft, LinkOrdinal link,
                                                    AxisGroupOrdinal axisGroup, double at) {
  AxisLayout& target = draft.axis(axisGroup);
  std::vector<std::vector<Bearing>::iterator> passing, below, above;
  const auto none = target.bearings.end();
  for (auto b = target.bearings.begin(); b != none; ++b) {
    const auto wheels = target.wheelsOf(b->child);
    if (b->parent != link || b->placed) continue;
    if (!wheels) return none;
    const bool isPassing = target.isBelow(wheels->low, at) && target.isBelow(at, wheels->high);
    (isPassing ? passing : target.isBelow(at, wheels->high) ? above : below).push_back(b);
  }
  if (passing.size() == 1) return passing.front();
  if (!passing.empty() || below.empty() == above.empty() || below.size() + above.size() < 2) return none;
  const auto away = [&](const auto& b) {
    const auto wheels = target.wheelsOf(b->child);
    return std::max(wheels->low - at, at - wheels->high);
  };
  const auto& all = below.empty() ? above : below;
  return *std::min_element(all.begin(), all.end(),
                           [&](const auto& x, const auto& y) { return target.isBelow(away(x), away(y)); });
}

}  // namespace

bool placeCrossShaftBoss(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                         AxisGroupOrdinal axisGroup) {
  AxisLayout& own = draft.axis(home);
  AxisLayout& target = draft.axis(axisGroup);
  const auto intersection = draft.intersectionOf(home, axisGroup);
  if (link == 0 || !intersection) return false;
  const auto [level, at] = *intersection;
  const auto isOthers = [&](const Interval& s, double low, double high) {
    return s.link >= 0 && own.overlap(s.low, s.high, low, high);
  };
  const double half = target.width() / 2 + target.gap() / 2;
  const double reach = (kShaftRadius + 1.5) * own.module;
  for (const Interval& s : target.occupied) {
    if (isOthers(s, at - half, at + half)) return false;
  }
  for (const Interval& s : own.occupied) {
    if (isOthers(s, level - reach, level + reach)) return false;
    if (s.link == link && own.isBelow(s.low, level) && own.isBelow(level, s.high)) return false;
  }
  if (isAround(draft, home, link, level)) return false;
  const auto through = heldByCrossShaftBoss(draft, link, axisGroup, at);
  if (through == target.bearings.end()) return false;
  CrossShaftBossPlan boss{link, home, level, axisGroup, at, through->child, at, at};
  for (const Bearing& b : target.bearings) {  // what runs on the shaft stands on one side
    const auto wheels = target.wheelsOf(b.child);
    if (&b == &*through || b.parent != link) continue;
    if (!wheels || b.placed) return false;
    if (target.isBelow(wheels->low, at) && target.isBelow(at, wheels->high)) return false;
    boss.low = std::min(boss.low, wheels->low);
    boss.high = std::max(boss.high, wheels->high);
  }
  for (Bearing& b : target.bearings) {
    if (b.parent != link) continue;
    b.placed = true;
    b.at = at;
    b.form = &b == &*through ? BearingForm::boss : BearingForm::hidden;
  }
  const double cosine = std::abs(own.direction.dot(target.direction));
  through->wall = 1 + kShaftRadius * cosine;
  target.occupy(at, link);
  draft.plan.crossShaftBosses.push_back(boss);
  return true;
}

void trimCrossShaftBosses(PlanDraft& draft) {
  for (const CrossShaftBossPlan& boss : draft.plan.crossShaftBosses) {
    const double hole =
        draft.plan.shaftAt(boss.axisGroup, boss.at, boss.link) + 0.08 * draft.axis(boss.axisGroup).module;
    const double sine = draft.axis(boss.home).direction.cross(draft.axis(boss.axisGroup).direction).norm();
    const double cosine = std::abs(draft.axis(boss.home).direction.dot(draft.axis(boss.axisGroup).direction));
    for (const std::size_t s : draft.plan.shaftsOn[boss.home]) {
      ShaftSegment& shaft = draft.plan.shafts[s];
      if (shaft.link != boss.link) continue;
      const double off = (hole + 0.4 * draft.axis(boss.home).module + shaft.outer * cosine) / sine;
      if (std::abs(shaft.high - boss.level) < std::abs(shaft.low - boss.level)) {
        shaft.high = boss.level - off;
      } else {
        shaft.low = boss.level + off;
      }
    }
  }
}

}  // namespace geargraph
