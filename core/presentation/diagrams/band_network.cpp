#include "core/presentation/diagrams/band_network.h"

#include <algorithm>
#include <cmath>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/disjoint_sets.h"

namespace geargraph {
namespace {

constexpr double kTouching = 1.5;  ///< px: the end of a line on another one

CanvasPoint nearestOn(CanvasPoint p, CanvasPoint from, CanvasPoint to) {
  const CanvasPoint along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  return from + share * along;
}

/// Places and the lines between neighbouring ones.
class Tree {
 public:
  int place(CanvasPoint p) {
    for (std::size_t i = 0; i < m_places.size(); ++i)
      if (distance(m_places[i], p) < kTouching) return static_cast<int>(i);
    m_places.push_back(p);
    return static_cast<int>(m_places.size()) - 1;
  }
  void connect(int a, int b) {
    if (a != b) m_candidates.push_back({a, b, distance(at(a), at(b))});
  }
  [[nodiscard]] CanvasPoint at(int place) const { return m_places[static_cast<std::size_t>(place)]; }
  [[nodiscard]] int size() const { return static_cast<int>(m_places.size()); }

  /// Keeps the shortest connections that join what can be joined, then bridges.
  void grow() {
    m_edges.assign(m_places.size(), {});
    DisjointSets joined(m_places.size());
    const auto take = [&](const Candidate& each) {
      if (joined.areJoined(each.a, each.b)) return;
      joined.join(each.a, each.b);
      m_edges[static_cast<std::size_t>(each.a)].push_back(each.b);
      m_edges[static_cast<std::size_t>(each.b)].push_back(each.a);
    };
    sortAndTake(m_candidates, take);
    std::vector<Candidate> bridges;
    for (int a = 0; a < size(); ++a)
      for (int b = 0; b < a; ++b)
        if (!joined.areJoined(a, b)) bridges.push_back({a, b, distance(at(a), at(b))});
    sortAndTake(bridges, take);
  }

  [[nodiscard]] const std::vector<int>& neighbours(int place) const {
    return m_edges[static_cast<std::size_t>(place)];
  }

 private:
  struct Candidate {
    int a;
    int b;
    double length;
  };
  template <class Take>
  static void sortAndTake(std::vector<Candidate>& candidates, Take take) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.length < y.length; });
    for (const Candidate& each : candidates) take(each);
  }

  std::vector<CanvasPoint> m_places;
  std::vector<Candidate> m_candidates;
  std::vector<std::vector<int>> m_edges;
};

/// What goes from each place to its parent in the tree.
struct Flows {
  std::vector<int> order;  ///< parents before children
  std::vector<int> parent;
  std::vector<double> power;
  std::vector<double> circulating;
};

Flows flowsOf(const Tree& tree, const std::vector<double>& power, const std::vector<double>& circulating) {
  Flows flows{{0}, std::vector<int>(power.size(), -1), power, circulating};
  for (std::size_t i = 0; i < flows.order.size(); ++i) {
    const int place = flows.order[i];
    for (const int next : tree.neighbours(place)) {
      if (next == flows.parent[static_cast<std::size_t>(place)]) continue;
      flows.parent[static_cast<std::size_t>(next)] = place;
      flows.order.push_back(next);
    }
  }
  for (auto place = flows.order.rbegin(); place != flows.order.rend(); ++place) {
    const int parent = flows.parent[static_cast<std::size_t>(*place)];
    if (parent < 0) continue;
    flows.power[static_cast<std::size_t>(parent)] += flows.power[static_cast<std::size_t>(*place)];
    flows.circulating[static_cast<std::size_t>(parent)] +=
        flows.circulating[static_cast<std::size_t>(*place)];
  }
  return flows;
}

}  // namespace

CanvasPoint BandNetwork::nearest(CanvasPoint place) const {
  GEARGRAPH_REQUIRE(!m_lines.empty());
  CanvasPoint best = m_lines.front().from;
  for (const Line& line : m_lines) {
    const CanvasPoint on = nearestOn(place, line.from, line.to);
    if (distance(on, place) < distance(best, place) - 1e-9) best = on;
  }
  return best;
}

CanvasPoint BandNetwork::nearestEnd(CanvasPoint place, double most) const {
  const CanvasPoint on = nearest(place);
  for (const Line& line : m_lines) {
    if (distanceToSegment(on, line.from, line.to) > 1e-6) continue;
    const CanvasPoint end = distance(line.from, on) < distance(line.to, on) ? line.from : line.to;
    if (distance(end, on) <= most) return end;
  }
  return on;
}

std::vector<BandNetwork::Run> BandNetwork::runs(const std::vector<Entry>& entries) const {
  Tree tree;
  std::vector<CanvasPoint> places;
  for (const Line& line : m_lines) places.insert(places.end(), {line.from, line.to});
  for (const Entry& entry : entries) places.push_back(entry.at);
  for (const CanvasPoint place : places) tree.place(place);
  if (tree.size() == 0) return {};
  // Each line in pieces between the places on it.
  for (const Line& line : m_lines) {
    std::vector<std::pair<double, int>> on;
    for (int place = 0; place < tree.size(); ++place)
      if (distanceToSegment(tree.at(place), line.from, line.to) < kTouching)
        on.emplace_back(dot(tree.at(place) - line.from, line.to - line.from), place);
    std::sort(on.begin(), on.end());
    for (std::size_t i = 1; i < on.size(); ++i) tree.connect(on[i - 1].second, on[i].second);
  }
  tree.grow();
  const auto count = static_cast<std::size_t>(tree.size());
  std::vector<double> power(count);
  std::vector<double> circulating(count);
  std::vector<char> isEntry(count);
  double largest = 0;
  for (const Entry& entry : entries) {
    const auto at = static_cast<std::size_t>(tree.place(entry.at));
    power[at] += entry.power;
    circulating[at] += entry.circulating;
    isEntry[at] = 1;
    largest = std::max(largest, std::abs(entry.power));
  }
  const Flows flows = flowsOf(tree, power, circulating);
  const double least = 1e-6 * largest;
  const auto flowBetween = [&](int from, int to, const std::vector<double>& of) {
    return flows.parent[static_cast<std::size_t>(from)] == to ? of[static_cast<std::size_t>(from)]
                                                              : -of[static_cast<std::size_t>(to)];
  };
  const auto active = [&](int place) {
    std::vector<int> on;
    for (const int next : tree.neighbours(place))
      if (std::abs(flowBetween(place, next, flows.power)) > least) on.push_back(next);
    return on;
  };
  const auto isThrough = [&](int place) {
    return isEntry[static_cast<std::size_t>(place)] == 0 && active(place).size() == 2;
  };
  std::vector<Run> runs;
  for (int start = 0; start < tree.size(); ++start) {
    if (isThrough(start)) continue;
    for (int next : active(start)) {
      if (flowBetween(start, next, flows.power) < 0) continue;  // begins at its other end
      Run run{{tree.at(start)},
              flowBetween(start, next, flows.power),
              flowBetween(start, next, flows.circulating)};
      int before = start;
      while (true) {
        run.course.push_back(tree.at(next));
        if (!isThrough(next)) break;
        const std::vector<int> both = active(next);
        const int after = both.front() == before ? both.back() : both.front();
        before = next;
        next = after;
      }
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace geargraph
