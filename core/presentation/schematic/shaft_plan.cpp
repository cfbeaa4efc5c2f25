#include "core/presentation/schematic/shaft_plan.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/presentation/schematic/stacker.h"

namespace geargraph::inline schematic {
namespace {

constexpr double kBetweenColumns = 11;

std::size_t at(int position) {
  return static_cast<std::size_t>(position);
}

/// Something that takes room along parallel axes.
struct Thing {
  double before = 0;  ///< room it takes on either side of its place
  double after = 0;
  Extent box;  ///< what height it takes
};
/// A place along parallel axes and what stands there.
struct Slot {
  double at = 0;
  std::vector<Thing> things;
};
using Slots = std::map<long long, Slot>;  // by tenths of px

void add(Slots& slots, double place, const Thing& thing) {
  Slot& slot = slots[std::llround(place * 10)];
  slot.at = place;
  slot.things.push_back(thing);
}

double roomBetween(const Slot& a, const Slot& b) {
  double room = 4;
  for (const Thing& left : a.things) {
    for (const Thing& right : b.things) {
      const bool level = left.box.top() < right.box.bottom() + 4 && right.box.top() < left.box.bottom() + 4;
      if (level) room = std::max(room, left.after + right.before + kBetweenColumns);
    }
  }
  return room;
}

/// Where slots go: each as near to those before it as they allow.
std::vector<std::pair<double, double>> movedTogether(const Slots& slots) {
  std::vector<std::pair<double, double>> moved;  // from, to
  std::vector<const Slot*> before;
  for (const auto& [key, slot] : slots) {
    double to = moved.empty() ? 0 : moved.back().second + 1;
    for (std::size_t k = 0; k < before.size(); ++k) {
      to = std::max(to, moved[k].second + roomBetween(*before[k], slot));
    }
    moved.emplace_back(slot.at, to);
    before.push_back(&slot);
  }
  return moved;
}

}  // namespace

const SheetShaft* ShaftPlan::shaft(int axis, int link) const {
  for (const SheetShaft& shaft : shafts) {
    if (shaft.axis == axis && shaft.link == link) return &shaft;
  }
  return nullptr;
}

void Stacker::squeeze() {
  Slots slots;
  for (const SheetWheel& wheel : m_layout.wheels) {
    const double rim = wheel.isRing() ? wheel.radius + kRimHeight : wheel.radius;
    const double foot = wheel.isRing() ? wheel.radius : 0;
    add(slots, wheel.at, {kBarHalf, kBarHalf, boxOn(wheel.axis, wheel.at, wheel.at, foot, rim)});
    if (m_layout.axes[at(wheel.axis)].half) continue;
    add(slots, wheel.at, {kBarHalf, kBarHalf, boxOn(wheel.axis, wheel.at, wheel.at, -rim, -foot)});
  }
  for (const Item& item : m_items) {
    for (const Piece& piece : piecesOf(item)) {
      if (item.isCup && piece.box.halfWidth > 4) continue;  // the wall's upper part
      Thing thing{2, 2, piece.box};
      if (piece.owner < 0) {
        thing.before = thing.after = kShaftEnd;
        const SheetBearing& bearing = m_bearings[at(item.index)];
        if (bearing.driven) (freeEndOf(bearing) < 0 ? thing.before : thing.after) = kDrivenEnd;
      }
      add(slots, atOf(item), thing);
    }
  }
  const auto moved = movedTogether(slots);
  const auto shifted = [&](double place) {
    for (const auto& [from, to] : moved) {
      if (std::abs(from - place) < 0.2) return to;
    }
    return place;
  };
  for (SheetBearing& bearing : m_bearings) bearing.at = shifted(bearing.at);
  for (SheetCup& cup : m_cups) cup.at = shifted(cup.at);
  for (SheetWheel& wheel : m_layout.wheels) {
    wheel.at = shifted(wheel.at);
    wheel.low = shifted(wheel.low);
    wheel.high = shifted(wheel.high);
    wheel.barFrom.x = wheel.low - kBarHalf;
    wheel.barTo.x = wheel.high + kBarHalf;
  }
  standUp();
}

void Stacker::addShafts(ShaftPlan& plan, int axis) const {
  const std::vector<int>& links = linksOn(axis);
  const std::vector<Column>& columns = columnsOn(axis);
  std::vector<SheetShaft> shafts;
  for (const int link : links) {
    const Range range = rangeOf(axis, link);
    if (range.isEmpty()) continue;  // a ring that another axis's link carries
    shafts.push_back(
        {axis, link, range.low, range.high, 0, link != 0 && axisOfLink(m_placement, link) == axis});
  }
  const auto inside = [&](const SheetShaft& i, const SheetShaft& j) {
    return std::count_if(columns.begin(), columns.end(), [&](const Column& column) {
      return column.link == i.link && column.at > j.low - 5 && column.at < j.high + 5;
    });
  };
  // `inner` runs inside of `outer`: what stands on the outer one would cut it otherwise.
  const auto isInside = [&](const SheetShaft& inner, const SheetShaft& outer) {
    if (inner.low > outer.high + 3 || outer.low > inner.high + 3) return false;
    const auto cut = inside(outer, inner);
    const auto cuts = inside(inner, outer);
    if (cut != cuts) return cut > cuts;
    const double more = (inner.high - inner.low) - (outer.high - outer.low);
    return std::abs(more) > 1e-6 ? more > 0 : inner.link < outer.link;
  };
  for (std::size_t pass = 0; pass < shafts.size(); ++pass) {
    for (SheetShaft& outer : shafts) {
      for (const SheetShaft& inner : shafts) {
        const bool pair = &inner != &outer && isInside(inner, outer);
        if (pair && static_cast<std::size_t>(inner.lane) + 1 < shafts.size()) {
          outer.lane = std::max(outer.lane, inner.lane + 1);
        }
      }
    }
  }
  plan.shafts.insert(plan.shafts.end(), shafts.begin(), shafts.end());
}

ShaftPlan Stacker::plan() const {
  ShaftPlan plan;
  plan.bearings = m_bearings;
  for (SheetBearing& bearing : plan.bearings) bearing.freeEnd = freeEndOf(bearing);
  plan.cups = m_cups;
  for (std::size_t axis = 0; axis < m_layout.axes.size(); ++axis) addShafts(plan, static_cast<int>(axis));
  return plan;
}

}  // namespace geargraph::inline schematic
