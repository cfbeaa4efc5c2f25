#include "core/machine/body_layout/parallel_arms.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/machine/body_layout/pedestals.h"
#include "core/machine/body_layout/shaft_clearance.h"

namespace geargraph {

using Eigen::Vector3d;

namespace {

constexpr int kReserved = -2;  ///< in place of a link: kept free by reserveSlots()

/// Outside of everything on all of these axes, on the bearings' side.
double outmostLevel(const PlanDraft& draft, AxisGroupOrdinal home, const std::vector<Bearing*>& round) {
  const int side = draft.axis(home).bearingSide;
  double outmost = draft.axis(home).outerSlot();
  for (const Bearing* b : round) {
    const int c = draft.classOf(*b);
    for (const double x : draft.axis(c).slotCandidates())
      if (draft.axis(home).isBelow(side * outmost, side * draft.carried(c, x, home)))
        outmost = draft.carried(c, x, home);
  }
  return outmost;
}

/// Is a level free on the axes of all these bearings, and can straight arms reach them from the link's own?
bool fits(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, const std::vector<Bearing*>& round,
          double level) {
  std::vector<int> involved{home};
  for (const Bearing* b : round) {
    involved.push_back(draft.classOf(*b));
    const double at = draft.carried(home, level, involved.back());
    if (!draft.axis(involved.back()).nests(*b, at) || !shaftPasses(draft, *b, at)) return false;
    if (link != 0 && (meetsArms(draft, *b, at) || sweepsShafts(draft, link, home, level, involved.back())))
      return false;
  }
  for (const int c : involved) {
    if (!draft.axis(c).slotIsFree(draft.carried(home, level, c))) return false;
  }
  if (!round.empty() && !draft.axis(home).emerges(round.front()->parent, level)) return false;
  if (link != 0 && isTrapped(draft, link, home, level)) return false;
  const AxisLayout& own = draft.axis(home);
  const auto gears = draft.obstacles.inPlane(own.at(level), own.direction, own.width() / 2 + own.gap() / 2);
  const double margin = own.width() / 2 + 0.3 * own.module;
  const std::vector<AxisBar> bars = barsOf(draft, link, home, round, level);
  return std::all_of(bars.begin(), bars.end(), [&](const AxisBar& bar) {
    const Vector3d start = draft.axis(bar.from).at(draft.carried(home, level, bar.from));
    const Vector3d end = draft.axis(bar.to).at(draft.carried(home, level, bar.to));
    return draft.obstacles.isClear(gears, start, end, 2.5 * own.module) &&
           draft.obstacles.nonParallelCollisions(link, start, end, margin, own.direction) == 0;
  });
}

/// A level at which the link's arms lie in one plane, beside the wheels: the free one nearest to what is
/// drawn. The ground stands at the bearings' end, behind everything; carriers keep to the other. None where
/// there is none.
std::optional<double> commonLevel(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                                  const std::vector<Bearing*>& round) {
  const int side = draft.axis(home).bearingSide;
  std::vector<int> involved{home};
  std::vector<double> candidates;
  std::vector<double> edges;  // of what stands on the axes, towards the bearings' end
  for (const Bearing* b : round) {
    const int c = draft.classOf(*b);
    if (c != home) involved.push_back(c);
    candidates.push_back(draft.carried(c, b->at, home));
  }
  const double wanted = candidates.front();
  for (const int c : involved) {
    for (const double x : draft.axis(c).slotCandidates()) candidates.push_back(draft.carried(c, x, home));
    for (const Interval& s : draft.axis(c).occupied)
      edges.push_back(side * draft.carried(c, side < 0 ? s.low : s.high, home));
  }
  std::sort(edges.begin(), edges.end());
  const auto cost = [&](double x) {
    double sum = std::abs(x - wanted);
    if (link == 0 && std::abs(x - wanted) > kSameLevel * draft.axis(home).module) {
      const auto beyond = edges.end() - std::upper_bound(edges.begin(), edges.end(),
                                                         side * x + kSameLevel * draft.axis(home).module);
      sum += 1000 * draft.axis(home).module * static_cast<double>(beyond);
    } else if (draft.axis(home).isBelow(side * wanted, side * x)) {
      sum += 2 * draft.axis(home).module;
    }
    if (link != 0)
      sum += 1000 * draft.axis(home).module * static_cast<double>(enclosedBy(draft, link, home, x));
    return sum;
  };
  std::vector<std::pair<double, double>> byCost;
  for (const double x : candidates) {
    if (draft.isStopped()) return std::nullopt;
    byCost.emplace_back(std::round(cost(x) / (kEqual * draft.axis(home).module)), x);
  }
  std::sort(byCost.begin(), byCost.end(), [side](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : side * a.second < side * b.second;
  });
  std::transform(byCost.begin(), byCost.end(), candidates.begin(),
                 [](const auto& each) { return each.second; });
  const auto same = [&](double a, double b) { return std::abs(a - b) < 1e-6 * draft.axis(home).module; };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), same), candidates.end());
  constexpr std::size_t kTries = 40;
  for (std::size_t i = 0; i < std::min(candidates.size(), kTries); ++i) {
    if (draft.isStopped()) return std::nullopt;
    if (fits(draft, link, home, round, candidates[i])) return candidates[i];
  }
  return std::nullopt;
}

}  // namespace

int homeOf(const PlanDraft& draft, LinkOrdinal link) {
  const int own = draft.placement.classes->classOfLink(link);
  if (own >= 0) return own;
  const auto& held = draft.heldBy[static_cast<std::size_t>(link)];
  AxisGroupOrdinal home = held.back().first;
  std::pair<std::ptrdiff_t, std::ptrdiff_t> most{0, 0};
  for (auto it = held.rbegin(); it != held.rend(); ++it) {
    const auto alike = std::count_if(
        held.begin(), held.end(), [&](const auto& other) { return draft.parallel(it->first, other.first); });
    const auto here =
        std::count_if(held.begin(), held.end(), [&](const auto& other) { return it->first == other.first; });
    const std::pair count(alike, here);
    if (count > most) home = it->first;
    most = std::max(most, count);
  }
  return home;
}

void reserveSlots(PlanDraft& draft) {
  for (const auto& [link, level] : draft.tries.roundBearings) {
    if (draft.tries.slotsFor.contains(link)) continue;  // that did not help
    const AxisGroupOrdinal home = draft.placement.classes->classOfLink(link);
    AxisLayout& own = draft.axis(home);
    Interval reserved{level - own.width() / 2, level + own.width() / 2, kReserved};
    double low = 1e300, high = -1e300;  // of the wheels
    for (const Interval& s : own.wheels) {
      low = std::min(low, s.low);
      high = std::max(high, s.high);
    }
    if (own.isBelow(high, level)) reserved.low = std::min(reserved.low, high);
    if (own.isBelow(level, low)) reserved.high = std::max(reserved.high, low);
    own.occupied.push_back(reserved);
  }
  for (const LinkOrdinal link : draft.tries.slotsFor) {
    const AxisGroupOrdinal home = draft.placement.classes->classOfLink(link);
    if (home < 0) continue;
    draft.axis(home).occupy(draft.axis(home).outerSlot(), kReserved);
    for (const auto& [c, b] : draft.heldBy[static_cast<std::size_t>(link)]) {
      if (c == home || !draft.parallel(home, c)) continue;
      draft.axis(c).occupy(
          draft.carried(home, draft.axis(home).occupied.back().low + draft.axis(home).width() / 2, c),
          kReserved);
    }
  }
}

void releaseSlots(PlanDraft& draft) {
  for (AxisLayout& layout : draft.plan.axes)
    std::erase_if(layout.occupied, [](const Interval& s) { return s.link == kReserved; });
}

std::vector<std::vector<Bearing*>> roundsOf(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home) {
  std::vector<std::vector<Bearing*>> rounds;
  const auto& held = draft.heldBy[static_cast<std::size_t>(link)];
  for (std::size_t first = 0; first < held.size();) {
    const int c = held[first].first;
    AxisLayout& layout = draft.axis(c);
    std::vector<Bearing*> here;
    for (; first < held.size() && held[first].first == c; ++first) {
      Bearing& bearing = layout.bearings[held[first].second];
      if (!bearing.placed) here.push_back(&bearing);
    }
    if (!draft.parallel(home, c)) continue;
    const auto rounded = [&](double depth) { return std::round(depth / (kEqual * layout.module)); };
    const auto depth = [&](const Bearing* b) {
      if (draft.tries.slotsFor.contains(b->child) || draft.tries.roundBearings.contains(b->child))
        return 1e300;
      double nearest = -1e300;                     // a link without wheels has the inmost shaft
      for (const Interval& s : layout.occupied) {  // wheels and ring carriers
        if (s.link == b->child) nearest = std::max(nearest, layout.bearingSide * (s.low + s.high) / 2);
      }
      return nearest;
    };
    std::stable_sort(here.begin(), here.end(), [&](const Bearing* x, const Bearing* y) {
      return rounded(depth(x)) > rounded(depth(y));
    });
    for (std::size_t i = 0; i < here.size(); ++i) {
      if (rounds.size() <= i) rounds.emplace_back();
      rounds[i].push_back(here[i]);
    }
  }
  return rounds;
}

std::vector<AxisBar> barsOf(const PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home,
                            const std::vector<Bearing*>& round, double level) {
  const auto place = [&](int c) { return draft.axis(c).at(draft.carried(home, level, c)); };
  const auto isShorter = [&](double a, double b) { return draft.axis(home).isBelow(a, b); };
  struct Open {
    AxisBar bar;
    double length = 0;
  };
  std::vector<Open> open;
  for (const Bearing* b : round) {
    const int c = draft.classOf(*b);
    const auto isSame = [c](const Open& each) { return each.bar.to == c; };
    if (c != home && std::none_of(open.begin(), open.end(), isSame))
      open.push_back({{home, c}, (place(c) - place(home)).norm()});
  }
  const double room = 3.5 * draft.axis(home).module;  // a boss and its play
  std::vector<AxisBar> bars;
  std::vector<int> joined{home};
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end(), [&](const Open& a, const Open& b) {
      return isShorter(a.length, b.length);
    });
    AxisBar bar = next->bar;
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

void placeParallel(PlanDraft& draft, LinkOrdinal link, AxisGroupOrdinal home, std::vector<Bearing*> round) {
  if (link == 0) {  // what cannot reach the frame behind everything else is on a pedestal of its own
    const double behind = outmostLevel(draft, home, round);
    std::erase_if(round, [&](Bearing* b) {
      if (draft.isStopped()) return false;
      const int c = draft.classOf(*b);
      if (shaftPasses(draft, *b, draft.carried(home, behind, c))) return false;
      const auto place = pedestalPlace(draft, *b);
      if (place) putOnPedestal(draft, *b, *place);
      return place.has_value();
    });
    if (round.empty()) return;
    const auto isHome = [&](const Bearing* b) { return draft.classOf(*b) == home; };
    if (std::none_of(round.begin(), round.end(), isHome)) home = draft.classOf(*round.back());
  }
  const std::optional<double> found = commonLevel(draft, link, home, round);
  if (!found && link == 0) {
    for (Bearing* b : round) putOnPedestalOrReport(draft, *b);
    return;
  }
  if (!found) {
    draft.wantSlots.insert(link);
    draft.plan.blocked.push_back({link});
    for (const Bearing* b : round) draft.plan.blocked.back().push_back(b->child);
  }
  const double level = found ? *found : outmostLevel(draft, home, round);
  draft.axis(home).occupy(level, link);
  const std::vector<AxisBar> bars = barsOf(draft, link, home, round, level);
  for (Bearing* b : round) {
    const int c = draft.classOf(*b);
    b->at = draft.carried(home, level, c);
    b->placed = true;
    if (c == home) continue;
    draft.axis(c).occupy(b->at, link);
    const auto bar =
        std::find_if(bars.begin(), bars.end(), [c](const AxisBar& each) { return each.to == c; });
    draft.addArm({link, bar->from, draft.carried(home, level, bar->from), c, b->at, b->child});
  }
}

}  // namespace geargraph
