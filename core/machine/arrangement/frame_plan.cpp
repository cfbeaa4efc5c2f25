// How the frame holds its bearings: by bars in one plane, or on feet of their own.

#include <algorithm>
#include <cmath>

#include "core/machine/arrangement/body_planner.h"

namespace geargraph::inline arrangement {

using Eigen::Vector3d;

/// The axis that a link's arms start from: its own. The ground's is the one of those that most others are
/// parallel to that has most bearings, so that one arm does for them; the last of these.
int BodyPlanner::homeOf(int link) const {
  const int own = m_placement.classes->classOfLink(link);
  if (own >= 0) return own;
  const auto& held = m_heldBy[static_cast<std::size_t>(link)];
  int home = held.back().first;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> most{0, 0};
  for (auto it = held.rbegin(); it != held.rend(); ++it) {
    const auto alike = std::count_if(held.begin(), held.end(),
                                     [&](const auto& other) { return parallel(it->first, other.first); });
    const auto here =
        std::count_if(held.begin(), held.end(), [&](const auto& other) { return it->first == other.first; });
    const std::pair count(alike, here);
    if (count > most) home = it->first;
    most = std::max(most, count);
  }
  return home;
}

/// Keeps places beside the wheels free for carriers that found none the last time, and what their arms go
/// round; on these axes.
std::vector<int> BodyPlanner::reserveRoom() {
  std::vector<int> axes;
  for (const auto& [link, level] : m_tries.roundBearings) {
    if (m_tries.roomFor.contains(link)) continue;  // that did not help
    const int home = m_placement.classes->classOfLink(link);
    AxisLayout& own = axis(home);
    Stretch room{level - own.width() / 2, level + own.width() / 2, kReserved};
    double low = 1e300, high = -1e300;  // of the wheels
    for (const Stretch& s : own.wheels) {
      low = std::min(low, s.low);
      high = std::max(high, s.high);
    }
    if (own.isBelow(high, level)) room.low = std::min(room.low, high);
    if (own.isBelow(level, low)) room.high = std::max(room.high, low);
    own.taken.push_back(room);
    axes.push_back(home);
  }
  for (const int link : m_tries.roomFor) {
    const int home = m_placement.classes->classOfLink(link);
    if (home < 0) continue;
    axis(home).take(axis(home).outerSlot(), kReserved);
    axes.push_back(home);
    for (const auto& [c, b] : m_heldBy[static_cast<std::size_t>(link)]) {
      if (c == home || !parallel(home, c)) continue;
      axis(c).take(carried(home, axis(home).taken.back().low + axis(home).width() / 2, c), kReserved);
      axes.push_back(c);
    }
  }
  return axes;
}

/// The straight bars that join the bearings of a round: a frame's from each to the nearest, a carrier's from
/// its own axis, unless another eye stands in the way, which it then starts from.
std::vector<BodyPlanner::Bar> BodyPlanner::barsOf(int link, int home, const std::vector<Bearing*>& round,
                                                  double level) const {
  const auto place = [&](int c) { return axis(c).at(carried(home, level, c)); };
  const auto isShorter = [&](double a, double b) { return axis(home).isBelow(a, b); };
  struct Open {
    Bar bar;
    double length = 0;
  };
  std::vector<Open> open;
  for (const Bearing* b : round) {
    const int c = classOf(*b);
    const auto isSame = [c](const Open& each) { return each.bar.to == c; };
    if (c != home && std::none_of(open.begin(), open.end(), isSame))
      open.push_back({{home, c}, (place(c) - place(home)).norm()});
  }
  const double room = 3.5 * axis(home).module;  // an eye and its play
  std::vector<Bar> bars;
  std::vector<int> joined{home};
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end(), [&](const Open& a, const Open& b) {
      return isShorter(a.length, b.length);
    });
    Bar bar = next->bar;
    open.erase(next);
    for (const int other : joined) {
      const Vector3d way = place(bar.to) - place(bar.from), arm = place(other) - place(bar.from);
      const double along = arm.dot(way) / way.squaredNorm();
      if (other != bar.from && along > 0 && along < 1 && (arm - along * way).norm() < room) bar.from = other;
    }
    bars.push_back(bar);
    joined.push_back(bar.to);
    for (Open& each : open) {
      const double length = (place(each.bar.to) - place(bar.to)).norm();
      if (link == 0 && isShorter(length, each.length)) each = {{bar.to, each.bar.to}, length};
    }
  }
  return bars;
}

/// Outside of everything on all of these axes, on the bearings' side.
double BodyPlanner::outmostLevel(int home, const std::vector<Bearing*>& round) const {
  const int side = axis(home).bearingSide;
  double outmost = axis(home).outerSlot();
  for (const Bearing* b : round) {
    const int c = classOf(*b);
    for (const double x : axis(c).slotCandidates())
      if (axis(home).isBelow(side * outmost, side * carried(c, x, home))) outmost = carried(c, x, home);
  }
  return outmost;
}

/// Where a bearing of the frame can stand on feet of its own, beside the wheels that it holds.
std::optional<double> BodyPlanner::boltPlace(const Bearing& bearing) const {
  const int c = classOf(bearing);
  const AxisLayout& layout = axis(c);
  std::vector<double> places{bearing.at};
  for (const double x : layout.slotCandidates()) places.push_back(x);
  std::erase_if(places, [&](double x) {
    return isStopped() || !layout.slotIsFree(x) || !layout.nests(bearing, x) || !shaftPasses(bearing, x);
  });
  if (places.empty()) return std::nullopt;
  const Stretch held = heldStretch(c, bearing.child);
  const double near = held.low <= held.high ? (held.low + held.high) / 2 : bearing.at;
  return *std::min_element(places.begin(), places.end(), [&](double a, double b) {
    return std::abs(a - near) < std::abs(b - near) - 1e-9 * layout.module;
  });
}

void BodyPlanner::boltDown(Bearing& bearing, double place) {
  bearing.at = place;
  bearing.placed = true;
  axis(classOf(bearing)).take(place, bearing.parent);
}

void BodyPlanner::boltDownOrSay(Bearing& bearing) {
  const auto place = boltPlace(bearing);
  if (!place) m_plan.blocked.push_back({bearing.parent, bearing.child});
  const int c = classOf(bearing);
  boltDown(bearing, place ? *place : axis(c).freeSlot(bearing.at));
}

}  // namespace geargraph::inline arrangement
