#include "core/machine/body_layout/profile_router.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

#include "core/machine/body_layout/profile_search.h"

namespace geargraph {
namespace {

constexpr double kOfOthers = 20;   // shared by the terminals of a group: what their cells cost other nets
constexpr double kContested = 10;  // the same of a cell that stood in a net's way, for every time it did
constexpr double kOccupied = 50;  // a cell that another net lies in, where a net looks for what is in its way

using Places = ProfileSearch::Places;

/// What cells cost a net in addition.
class Extras {
 public:
  explicit Extras(std::size_t cells) : m_costs(cells, 0), m_sums(cells + 1, 0) {}

  [[nodiscard]] const ByCell<double>& costs() const { return m_costs; }
  [[nodiscard]] double of(const RouteTerminal& terminal) const {
    double sum = m_sums[terminal.keptFree.end] - m_sums[terminal.keptFree.first];
    for (const int c : terminal.cells) sum += m_costs[c];
    return sum;
  }
  void add(CellOrdinal cell, double cost) { m_costs[cell] += cost; }
  /// To be called after the last add().
  void sumUp() { std::partial_sum(m_costs.begin(), m_costs.end(), m_sums.begin() + 1); }

 private:
  ByCell<double> m_costs;
  ByCell<double> m_sums;  ///< of all cells before this one
};

/// What nets want others to leave free: where wheels and pins can be reached, and what stood in their way.
class Preferences {
 public:
  Preferences(const ProfileGrid& grid, const ByNet<ProfileNet>& nets)
      : m_grid(grid), m_extras(nets.size(), Extras(grid.owner.size())) {
    for (std::size_t net = 0; net < nets.size(); ++net) {
      for (const auto& terminals : nets[net].groups) {
        for (const RouteTerminal& terminal : terminals)
          add(net, terminal.cells, kOfOthers / static_cast<double>(terminals.size()));
      }
    }
    sumUp();
  }

  [[nodiscard]] const ByNet<Extras>& ofOthers() const { return m_extras; }
  void add(NetOrdinal net, const std::vector<CellOrdinal>& inTheWay) {
    add(net, inTheWay, kContested);
    sumUp();
  }

 private:
  void add(NetOrdinal net, const std::vector<CellOrdinal>& cells, double cost) {
    for (const NetOrdinal other : m_extras.ordinals()) {
      for (const CellOrdinal c : cells) {
        if (other != net && m_grid.owner[c] == ProfileGrid::kFree) m_extras[other].add(c, cost);
      }
    }
  }
  void sumUp() {
    for (Extras& extras : m_extras) extras.sumUp();
  }

  const ProfileGrid& m_grid;
  ByNet<Extras> m_extras;
};

/// One round: nets are laid in an order, each by cheapest ways among what is left.
class WheelDisc {
 public:
  /// `extras`: by net. What is given outlives it. Finds no more ways once `stop` is requested.
  WheelDisc(const ProfileGrid& grid, const ByNet<ProfileNet>& nets, const ProfileOwners& owners,
            const ByNet<std::vector<CellOrdinal>>& wheels, ProfileSearch& search, const ByNet<Extras>& extras,
            const std::stop_token& stop)
      : m_grid(grid),
        m_nets(nets),
        m_owners(owners),
        m_wheels(wheels),
        m_routes(nets.size()),
        m_search(search),
        m_extras(extras),
        m_stop(stop),
        m_endAt(grid.owner.size(), -1) {}

  /// The net that found no way; -1: all did.
  int lay(const std::vector<NetOrdinal>& order) {
    for (const NetOrdinal net : order) {
      if (!layNet(net)) return net;
    }
    for (const NetOrdinal net : order) {
      if (!m_nets[net].needsSupport) support(net);
    }
    return -1;
  }
  bool layNet(NetOrdinal net);
  bool support(NetOrdinal net);
  /// Lays a net as it was laid before.
  void lay(NetOrdinal net, const ProfileRoute& route);
  [[nodiscard]] ProfileRoute& route(NetOrdinal net) { return m_routes[net]; }
  ByNet<ProfileRoute> take() { return std::move(m_routes); }
  /// Does somebody lie there, or keep it free, that did not before?
  [[nodiscard]] bool isOccupied(CellOrdinal cell) const { return m_owners.of(cell) != m_grid.owner[cell]; }

 private:
  /// Joins what the net has with the nearest terminal; the terminal's position, -1: no way.
  int reach(NetOrdinal net, const std::vector<RouteTerminal>& terminals, Places& sources);
  void findEnds(NetOrdinal net, const std::vector<RouteTerminal>& terminals);
  /// Does the way that ends there keep out of the room that the terminal itself needs?
  [[nodiscard]] bool isClear(int end, const RouteTerminal& terminal) const;
  /// What it costs to end there.
  [[nodiscard]] double price(NetOrdinal net, const RouteTerminal& terminal) const {
    return terminal.cost + m_extras[net].of(terminal);
  }
  [[nodiscard]] Places laid(NetOrdinal net) const {
    Places sources;
    for (const int c : m_routes[net].cells) sources.emplace_back(c, 0);
    return sources;
  }
  void claim(NetOrdinal net, CellOrdinal cell) {
    if (m_owners.of(cell) == net && m_grid.owner[cell] != net) return;
    m_owners.give(cell, net);
    m_routes[net].cells.push_back(cell);
  }
  void take(NetOrdinal net, const RouteTerminal& terminal) {
    for (const int c : terminal.cells) claim(net, c);
    m_owners.block(terminal.keptFree);
  }
  [[nodiscard]] bool open(NetOrdinal net, const RouteTerminal& terminal) const {
    return std::all_of(terminal.cells.begin(), terminal.cells.end(),
                       [&](int c) { return m_owners.isOpen(c, net); }) &&
           m_owners.isFree(terminal.keptFree);
  }

  const ProfileGrid& m_grid;
  const ByNet<ProfileNet>& m_nets;
  ProfileOwners m_owners;
  const ByNet<std::vector<CellOrdinal>>& m_wheels;  ///< cells where its wheels lie
  ByNet<ProfileRoute> m_routes;
  ProfileSearch& m_search;
  const ByNet<Extras>& m_extras;
  const std::stop_token& m_stop;
  struct End {
    int terminal, next;
  };
  std::vector<End> m_ends;  ///< of the search at hand
  Places m_places;          ///< of these ends
  ByCell<int> m_endAt;      ///< the last end that lies there, -1
};

bool WheelDisc::isClear(int end, const RouteTerminal& terminal) const {
  for (int c = end; c >= 0; c = m_search.from(c)) {
    if (terminal.keptFree.contains(c)) return false;
  }
  return true;
}

void WheelDisc::findEnds(NetOrdinal net, const std::vector<RouteTerminal>& terminals) {
  for (const auto& [cell, extra] : m_places) m_endAt[cell] = -1;
  m_ends.clear();
  m_places.clear();
  for (std::size_t l = 0; l < terminals.size(); ++l) {
    if (!open(net, terminals[l])) continue;
    const double extra = price(net, terminals[l]);
    for (const int c : terminals[l].cells) {
      const int end = static_cast<int>(m_ends.size());
      m_ends.push_back({static_cast<int>(l), std::exchange(m_endAt[c], end)});
      m_places.emplace_back(c, extra);
    }
  }
}

// Ways are tried from the cheapest on, and the search goes only as far as that needs: once its front is
// more expensive than a route, no cheaper one will come.
int WheelDisc::reach(NetOrdinal net, const std::vector<RouteTerminal>& terminals, Places& sources) {
  if (m_stop.stop_requested()) return -1;
  findEnds(net, terminals);
  if (m_ends.empty()) return -1;
  const bool canBeFound = m_search.begin(m_owners, {m_wheels[net], m_routes[net].cells},
                                         m_extras[net].costs(), sources, m_places);
  if (!canBeFound) return -1;
  using Way = std::pair<double, int>;  // what it costs, its end
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
  while (!m_search.isDone() || !ways.empty()) {
    if (m_stop.stop_requested()) return -1;
    if (ways.empty() || (!m_search.isDone() && !m_search.isBeyond(ways.top().first))) {
      for (const CellOrdinal cell : m_search.settleBucket()) {
        for (int e = m_endAt[cell]; e >= 0; e = m_ends[static_cast<std::size_t>(e)].next)
          ways.push({m_search.cost(cell) + m_places[static_cast<std::size_t>(e)].second, e});
      }
      continue;
    }
    const int way = ways.top().second;
    ways.pop();
    const int end = m_places[static_cast<std::size_t>(way)].first,
              l = m_ends[static_cast<std::size_t>(way)].terminal;
    const RouteTerminal& terminal = terminals[static_cast<std::size_t>(l)];
    if (!isClear(end, terminal)) continue;
    for (int c = end; c >= 0; c = m_search.from(c)) claim(net, c);
    take(net, terminal);
    sources = laid(net);
    return l;
  }
  return -1;
}

bool WheelDisc::support(NetOrdinal net) {
  Places sources = laid(net);
  m_routes[net].support = reach(net, m_nets[net].supports, sources);
  return m_routes[net].support >= 0;
}

void WheelDisc::lay(NetOrdinal net, const ProfileRoute& route) {
  const ProfileNet& wanted = m_nets[net];
  for (const int c : route.cells) claim(net, c);
  for (std::size_t g = 0; g < wanted.groups.size(); ++g)
    m_owners.block(wanted.groups[g][static_cast<std::size_t>(route.terminal[g])].keptFree);
  if (route.support >= 0) m_owners.block(wanted.supports[static_cast<std::size_t>(route.support)].keptFree);
}

bool WheelDisc::layNet(NetOrdinal net) {
  const ProfileNet& wanted = m_nets[net];
  ProfileRoute& route = m_routes[net];
  route.terminal.assign(wanted.groups.size(), -1);
  if (wanted.groups.empty()) return true;
  // The first terminal is whichever the way to the next leads from.
  Places sources;
  for (const RouteTerminal& terminal : wanted.groups.front()) {
    if (!open(net, terminal)) continue;
    const double extra = price(net, terminal);
    for (const int c : terminal.cells) sources.emplace_back(c, extra);
  }
  if (sources.empty()) return false;
  const auto start = [&] {
    const auto& terminals = wanted.groups.front();
    const auto touched = [&](const RouteTerminal& l) {
      return std::any_of(l.cells.begin(), l.cells.end(), [&](int c) {
        return std::find(route.cells.begin(), route.cells.end(), c) != route.cells.end();
      });
    };
    const auto found = std::find_if(terminals.begin(), terminals.end(), [&](const RouteTerminal& l) {
      return open(net, l) && (route.cells.empty() || touched(l));
    });
    if (found == terminals.end()) return false;
    route.terminal.front() = static_cast<int>(found - terminals.begin());
    take(net, *found);
    sources = laid(net);
    return true;
  };
  for (std::size_t g = 1; g < wanted.groups.size(); ++g) {
    route.terminal[g] = reach(net, wanted.groups[g], sources);
    if (route.terminal[g] < 0) return false;
    if (route.terminal.front() < 0 && !start()) return false;
  }
  if (wanted.needsSupport) {
    route.support = reach(net, wanted.supports, sources);
    if (route.support < 0) return false;
  }
  return route.terminal.front() >= 0 || start();
}

using Routes = std::optional<ByNet<ProfileRoute>>;

/// Each net again, among the others as they lie: what it went round for their sake it need not any more.
ByNet<ProfileRoute> straightened(const ProfileGrid& grid, const ByNet<ProfileNet>& nets,
                                 const ProfileOwners& owners, const ByNet<std::vector<CellOrdinal>>& wheels,
                                 ProfileSearch& search, ByNet<ProfileRoute> routes,
                                 const std::stop_token& stop) {
  const int count = static_cast<int>(nets.size());
  const ByNet<Extras> none(nets.size(), Extras(grid.owner.size()));
  for (NetOrdinal net = 0; net < count; ++net) {
    if (stop.stop_requested()) break;
    WheelDisc round(grid, nets, owners, wheels, search, none, stop);
    for (int other = 0; other < count; ++other) {
      if (other != net) round.lay(other, routes[other]);
    }
    if (!round.layNet(net)) continue;
    if (!nets[net].needsSupport && !round.support(net) && routes[net].support >= 0) continue;
    routes[net] = std::move(round.route(net));
  }
  return routes;
}

}  // namespace

Routes routeProfiles(const ProfileGrid& grid, const ByNet<ProfileNet>& nets, int tries,
                     const std::stop_token& stop) {
  if (nets.size() * grid.owner.size() > kMaxRoutedCells) return std::nullopt;
  std::vector<NetOrdinal> order(nets.size());
  std::iota(order.begin(), order.end(), 0);
  ProfileSearch search(grid);
  const ProfileBits bits(grid);
  const ProfileOwners owners(grid, bits);
  ByNet<std::vector<CellOrdinal>> wheels(nets.size());
  for (std::size_t cell = 0; cell < grid.owner.size(); ++cell) {
    if (grid.owner[cell] >= 0) wheels[grid.owner[cell]].push_back(static_cast<int>(cell));
  }
  Preferences preferences(grid, nets);
  for (int i = 0; i < tries; ++i) {
    WheelDisc round(grid, nets, owners, wheels, search, preferences.ofOthers(), stop);
    const int failed = round.lay(order);
    if (stop.stop_requested()) return std::nullopt;
    if (failed < 0) return straightened(grid, nets, owners, wheels, search, round.take(), stop);
    // What is in its way? It would cross as little of others as it can, and they should leave that free.
    ByNet<Extras> occupied(nets.size(), Extras(grid.owner.size()));
    Extras& crossed = occupied[failed];
    for (int c = 0; c < static_cast<int>(grid.owner.size()); ++c) {
      if (round.isOccupied(c)) crossed.add(c, kOccupied);
    }
    crossed.sumUp();
    WheelDisc alone(grid, nets, owners, wheels, search, occupied, stop);
    if (!alone.layNet(failed)) return std::nullopt;  // not even where no other net is
    std::vector<CellOrdinal> inTheWay;
    for (int c = 0; c < static_cast<int>(grid.owner.size()); ++c) {
      if (round.isOccupied(c) && alone.isOccupied(c)) inTheWay.push_back(c);
    }
    preferences.add(failed, inTheWay);
    const auto place = std::find(order.begin(), order.end(), failed);
    std::rotate(order.begin(), place, place + 1);
  }
  return std::nullopt;
}

}  // namespace geargraph
