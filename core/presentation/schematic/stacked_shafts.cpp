#include <algorithm>

#include "core/presentation/schematic/stacker.h"

namespace geargraph::inline schematic {
namespace {

std::size_t at(int position) {
  return static_cast<std::size_t>(position);
}

}  // namespace

/// Where among the links on an axis one stands; -1 if it has nothing there.
int Stacker::shaftOn(const OnAxis& on, int link) {
  const auto found = std::lower_bound(on.links.begin(), on.links.end(), link);
  return found == on.links.end() || *found != link ? -1 : static_cast<int>(found - on.links.begin());
}

/// Does the link turn about the axis?
bool Stacker::isOwn(int axis, int link) const {
  return link != 0 && axisOfLink(m_placement, link) == axis;
}

Stacker::Range Stacker::rangeOf(int axis, int link) const {
  Range range;
  for (const Column& column : columnsOn(axis)) {
    if (column.link == link) range.include(column.at, column.at);
  }
  const bool own = isOwn(axis, link);
  for (const int joint : m_on[at(axis)].bearings) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    if (bearing.child == link) {
      range.include(bearing.at - kShaftEnd, bearing.at + kShaftEnd);
      if (bearing.driven) {
        const double end = bearing.at + kDrivenEnd * freeEndOf(bearing);
        range.include(end, end);
      }
    }
    if (bearing.parent == link && own) range.include(bearing.at, bearing.at);
  }
  if (!own && !range.isEmpty()) range.include(range.low - 12, range.high + 12);
  return range;
}

/// The end of the child's shaft beside which it holds nothing.
double Stacker::freeEndOf(const SheetBearing& bearing) const {
  double sum = 0;
  for (const Column& column : columnsOn(bearing.axis)) {
    if (column.link == bearing.child) sum += column.at - bearing.at;
  }
  return sum < 0 ? 1 : -1;
}

/// How many things on an axis cannot get past a shaft of another link, whichever of the two is hollow, as far
/// as one of the two links is among these: the others do not change while an item is moved.
int Stacker::conflictsOn(int axis, const Few<int>& moved) const {
  const OnAxis& on = m_on[at(axis)];
  listShafts(axis);
  const auto isInside = [](const Column& column, const Range& range) {
    return column.at > range.low - 5 && column.at < range.high + 5;
  };
  int conflicts = 0;
  for (const int link : moved) {
    const int own = shaftOn(on, link);
    if (own < 0) continue;
    for (OnShaft& shaft : m_shafts) shaft.cut = shaft.cutting = 0;
    for (const Column& column : on.columns) {
      if (column.shaft >= 0 && isInside(column, m_shafts[at(own)].range)) ++m_shafts[at(column.shaft)].cut;
      if (column.shaft != own) continue;
      for (OnShaft& shaft : m_shafts) shaft.cutting += isInside(column, shaft.range) ? 1 : 0;
    }
    for (std::size_t i = 0; i < m_shafts.size(); ++i) {
      const bool isCounted =
          on.links[i] < link && std::find(moved.begin(), moved.end(), on.links[i]) != moved.end();
      if (i != at(own) && !isCounted) conflicts += std::min(m_shafts[i].cut, m_shafts[i].cutting);
    }
  }
  return conflicts;
}

/// What all links have on an axis, at once.
void Stacker::listShafts(int axis) const {
  const OnAxis& on = m_on[at(axis)];
  m_shafts.assign(on.links.size(), {});
  for (const Column& column : on.columns) {
    if (column.shaft < 0) continue;
    OnShaft& shaft = m_shafts[at(column.shaft)];
    shaft.sum += column.at;
    ++shaft.columns;
    shaft.range.include(column.at, column.at);
  }
  for (const int joint : on.bearings) {
    const SheetBearing& bearing = m_bearings[at(joint)];
    OnShaft& child = m_shafts[at(shaftOn(on, bearing.child))];
    child.range.include(bearing.at - kShaftEnd, bearing.at + kShaftEnd);
    if (bearing.driven) {
      const double end = bearing.at + kDrivenEnd * (child.sum - child.columns * bearing.at < 0 ? 1 : -1);
      child.range.include(end, end);
    }
    const int parent = isOwn(axis, bearing.parent) ? shaftOn(on, bearing.parent) : -1;
    if (parent >= 0) m_shafts[at(parent)].range.include(bearing.at, bearing.at);
  }
  for (std::size_t i = 0; i < m_shafts.size(); ++i) {
    Range& range = m_shafts[i].range;
    if (!isOwn(axis, on.links[i]) && !range.isEmpty()) range.include(range.low - 12, range.high + 12);
  }
}

}  // namespace geargraph::inline schematic
