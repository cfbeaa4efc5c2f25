#include "core/gears/meridian_router.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>
#include <random>
#include <utility>

namespace geargraph {
namespace {

constexpr double kFar = 1e300;
constexpr double kSpread = 15;  // columns' widths

using Sources = std::vector<std::pair<int, double>>;  ///< cells, and what it costs to begin there

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// One round: nets are laid in an order, each by shortest ways among what is left.
class Round {
 public:
  /// Landings and rows are dearer by chance, by up to `spread`: other rounds choose others.
  Round(const MeridianGrid& grid, const std::vector<MeridianNet>& nets, unsigned seed, double spread)
      : m_grid(grid),
        m_nets(nets),
        m_owner(grid.owner),
        m_routes(nets.size()),
        m_random(seed),
        m_spread(spread) {}

  /// The net that found no way; -1: all did.
  int lay(const std::vector<int>& order) {
    for (const int net : order) {
      if (!layNet(net)) return net;
    }
    for (const int net : order) {
      if (!m_nets[at(net)].needsSupport) support(net);
    }
    return -1;
  }
  std::vector<MeridianRoute> take() { return std::move(m_routes); }

 private:
  bool layNet(int net);
  bool support(int net);
  /// Joins what the net has with the nearest landing; the landing's position, -1: no way.
  int reach(int net, const std::vector<MeridianLanding>& landings, Sources& sources);
  void search(int net, const Sources& sources);
  [[nodiscard]] double chance() {
    return m_spread * static_cast<double>(m_random()) / static_cast<double>(std::minstd_rand::max());
  }
  [[nodiscard]] Sources laid(int net) const {
    Sources sources;
    for (const int c : m_routes[at(net)].cells) sources.emplace_back(c, 0);
    return sources;
  }
  void claim(int net, int cell) {
    if (m_owner[at(cell)] == net && m_grid.owner[at(cell)] != net) return;
    m_owner[at(cell)] = net;
    m_routes[at(net)].cells.push_back(cell);
  }
  void take(int net, const MeridianLanding& landing) {
    for (const int c : landing.cells) claim(net, c);
    for (const int c : landing.keptFree) m_owner[at(c)] = MeridianGrid::kBlocked;
  }
  [[nodiscard]] bool open(int net, int cell) const {
    return m_owner[at(cell)] == MeridianGrid::kFree || m_owner[at(cell)] == net;
  }
  [[nodiscard]] bool open(int net, const MeridianLanding& landing) const {
    const auto isFree = [&](int c) { return m_owner[at(c)] == MeridianGrid::kFree; };
    return std::all_of(landing.cells.begin(), landing.cells.end(), [&](int c) { return open(net, c); }) &&
           std::all_of(landing.keptFree.begin(), landing.keptFree.end(), isFree);
  }

  const MeridianGrid& m_grid;
  const std::vector<MeridianNet>& m_nets;
  std::vector<int> m_owner;
  std::vector<MeridianRoute> m_routes;
  std::minstd_rand m_random;
  double m_spread;
  std::vector<double> m_rowExtra;
  std::vector<double> m_cost;
  std::vector<int> m_from;
};

void Round::search(int net, const Sources& sources) {
  m_rowExtra.clear();
  for (int r = 0; r < m_grid.rows; ++r) m_rowExtra.push_back(chance() / kSpread);
  m_cost.assign(m_owner.size(), kFar);
  m_from.assign(m_owner.size(), -1);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const auto& [cell, cost] : sources) {
    if (cost >= m_cost[at(cell)]) continue;
    m_cost[at(cell)] = cost;
    queue.push({cost, cell});
  }
  while (!queue.empty()) {
    const auto [cost, cell] = queue.top();
    queue.pop();
    if (cost > m_cost[at(cell)]) continue;
    const int column = m_grid.columnOf(cell);
    const int row = m_grid.rowOf(cell);
    const auto step = [&](int next, double price) {
      if (!open(net, next) || cost + price >= m_cost[at(next)]) return;
      m_cost[at(next)] = cost + price;
      m_from[at(next)] = cell;
      queue.push({cost + price, next});
    };
    const double along = m_grid.width[at(column)] * (1 + m_grid.rowCost[at(row)] + m_rowExtra[at(row)]);
    if (column > 0) step(m_grid.cell(column - 1, row), along);
    if (column + 1 < m_grid.columns) step(m_grid.cell(column + 1, row), along);
    if (!m_grid.plates[at(column)]) continue;
    if (row > 0) step(cell - 1, m_grid.rowCost[at(row)]);
    if (row + 1 < m_grid.rows) step(cell + 1, m_grid.rowCost[at(row)]);
  }
}

int Round::reach(int net, const std::vector<MeridianLanding>& landings, Sources& sources) {
  search(net, sources);
  struct Way {
    double cost;
    int landing, end;
  };
  std::vector<Way> ways;
  for (std::size_t l = 0; l < landings.size(); ++l) {
    if (!open(net, landings[l])) continue;
    const double extra = landings[l].cost + chance();
    for (const int c : landings[l].cells) {
      if (m_cost[at(c)] < kFar) ways.push_back({m_cost[at(c)] + extra, static_cast<int>(l), c});
    }
  }
  std::stable_sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.cost < b.cost; });
  for (const Way& way : ways) {
    const MeridianLanding& landing = landings[at(way.landing)];
    const auto crosses = [&](int cell) {
      return std::find(landing.keptFree.begin(), landing.keptFree.end(), cell) != landing.keptFree.end();
    };
    bool clear = true;  // of the room that the landing itself needs
    for (int c = way.end; c >= 0 && clear; c = m_from[at(c)]) clear = !crosses(c);
    if (!clear) continue;
    for (int c = way.end; c >= 0; c = m_from[at(c)]) claim(net, c);
    take(net, landing);
    sources = laid(net);
    return way.landing;
  }
  return -1;
}

bool Round::support(int net) {
  Sources sources = laid(net);
  m_routes[at(net)].support = reach(net, m_nets[at(net)].supports, sources);
  return m_routes[at(net)].support >= 0;
}

bool Round::layNet(int net) {
  const MeridianNet& wanted = m_nets[at(net)];
  MeridianRoute& route = m_routes[at(net)];
  route.landing.assign(wanted.groups.size(), -1);
  if (wanted.groups.empty()) return true;
  // The first landing is whichever the way to the next leads from.
  Sources sources;
  for (const MeridianLanding& landing : wanted.groups.front()) {
    if (!open(net, landing)) continue;
    const double extra = landing.cost + chance();
    for (const int c : landing.cells) sources.emplace_back(c, extra);
  }
  if (sources.empty()) return false;
  const auto start = [&] {
    const auto& landings = wanted.groups.front();
    const auto touched = [&](const MeridianLanding& l) {
      return std::any_of(l.cells.begin(), l.cells.end(), [&](int c) {
        return std::find(route.cells.begin(), route.cells.end(), c) != route.cells.end();
      });
    };
    const auto found = std::find_if(landings.begin(), landings.end(), [&](const MeridianLanding& l) {
      return open(net, l) && (route.cells.empty() || touched(l));
    });
    if (found == landings.end()) return false;
    route.landing.front() = static_cast<int>(found - landings.begin());
    take(net, *found);
    sources = laid(net);
    return true;
  };
  for (std::size_t g = 1; g < wanted.groups.size(); ++g) {
    route.landing[g] = reach(net, wanted.groups[g], sources);
    if (route.landing[g] < 0) return false;
    if (route.landing.front() < 0 && !start()) return false;
  }
  if (wanted.needsSupport) {
    route.support = reach(net, wanted.supports, sources);
    if (route.support < 0) return false;
  }
  return route.landing.front() >= 0 || start();
}

}  // namespace

std::optional<std::vector<MeridianRoute>> routeMeridian(const MeridianGrid& grid,
                                                        const std::vector<MeridianNet>& nets, int tries) {
  std::vector<int> order(nets.size());
  std::iota(order.begin(), order.end(), 0);
  std::minstd_rand random(1);
  for (int i = 0; i < tries; ++i) {
    Round round(grid, nets, static_cast<unsigned>(i + 1), i == 0 ? 0 : kSpread);
    const int failed = round.lay(order);
    if (failed < 0) return round.take();
    if (i % 4 == 3) {  // out of the circles that moving one forward runs in
      for (std::size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
    } else {
      const auto place = std::find(order.begin(), order.end(), failed);
      std::rotate(order.begin(), place, place + 1);
    }
  }
  return std::nullopt;
}

}  // namespace geargraph
