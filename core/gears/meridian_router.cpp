#include "core/gears/meridian_router.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <numeric>
#include <queue>
#include <random>
#include <utility>

#include "core/gears/meridian_search.h"

namespace geargraph {
namespace {

constexpr double kSpread = 15;  // columns' widths

using Places = MeridianSearch::Places;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// One round: nets are laid in an order, each by shortest ways among what is left.
class Round {
 public:
  /// Landings and rows are dearer by chance, by up to `spread`: other rounds choose others.
  Round(const MeridianGrid& grid, const std::vector<MeridianNet>& nets, const MeridianOwners& owners,
        const std::vector<std::vector<int>>& wheels, MeridianSearch& search, unsigned seed, double spread)
      : m_grid(grid),
        m_nets(nets),
        m_owners(owners),
        m_wheels(wheels),
        m_routes(nets.size()),
        m_search(search),
        m_random(seed),
        m_spread(spread),
        m_endAt(grid.owner.size(), -1) {}

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
  int reach(int net, const std::vector<MeridianLanding>& landings, Places& sources);
  void findEnds(int net, const std::vector<MeridianLanding>& landings);
  /// Does the way that ends there keep out of the room that the landing itself needs?
  [[nodiscard]] bool isClear(int end, const MeridianLanding& landing) const;
  [[nodiscard]] double chance() {
    return m_spread * static_cast<double>(m_random()) / static_cast<double>(std::minstd_rand::max());
  }
  [[nodiscard]] Places laid(int net) const {
    Places sources;
    for (const int c : m_routes[at(net)].cells) sources.emplace_back(c, 0);
    return sources;
  }
  void claim(int net, int cell) {
    if (m_owners.of(cell) == net && m_grid.owner[at(cell)] != net) return;
    m_owners.give(cell, net);
    m_routes[at(net)].cells.push_back(cell);
  }
  void take(int net, const MeridianLanding& landing) {
    for (const int c : landing.cells) claim(net, c);
    m_owners.block(landing.keptFree);
  }
  [[nodiscard]] bool open(int net, const MeridianLanding& landing) const {
    return std::all_of(landing.cells.begin(), landing.cells.end(),
                       [&](int c) { return m_owners.isOpen(c, net); }) &&
           m_owners.isFree(landing.keptFree);
  }

  const MeridianGrid& m_grid;
  const std::vector<MeridianNet>& m_nets;
  MeridianOwners m_owners;
  const std::vector<std::vector<int>>& m_wheels;  ///< by net: cells where its wheels lie
  std::vector<MeridianRoute> m_routes;
  MeridianSearch& m_search;
  std::minstd_rand m_random;
  double m_spread;
  std::vector<double> m_rowExtra;
  struct End {
    int landing, next;
  };
  std::vector<End> m_ends;   ///< of the search at hand
  Places m_places;           ///< of these ends
  std::vector<int> m_endAt;  ///< by cell: the last end that lies there, -1
};

bool Round::isClear(int end, const MeridianLanding& landing) const {
  for (int c = end; c >= 0; c = m_search.from(c)) {
    if (landing.keptFree.contains(c)) return false;
  }
  return true;
}

void Round::findEnds(int net, const std::vector<MeridianLanding>& landings) {
  for (const auto& [cell, extra] : m_places) m_endAt[at(cell)] = -1;
  m_ends.clear();
  m_places.clear();
  for (std::size_t l = 0; l < landings.size(); ++l) {
    if (!open(net, landings[l])) continue;
    const double extra = landings[l].cost + chance();
    for (const int c : landings[l].cells) {
      const int end = static_cast<int>(m_ends.size());
      m_ends.push_back({static_cast<int>(l), std::exchange(m_endAt[at(c)], end)});
      m_places.emplace_back(c, extra);
    }
  }
}

// Ways are tried from the cheapest on, and the search goes only as far as that needs: once its front is
// dearer than a way, no cheaper one will come.
int Round::reach(int net, const std::vector<MeridianLanding>& landings, Places& sources) {
  m_rowExtra.clear();
  for (int r = 0; r < m_grid.rows; ++r) m_rowExtra.push_back(chance() / kSpread);
  findEnds(net, landings);
  if (m_ends.empty()) return -1;
  const bool canBeFound =
      m_search.begin(m_owners, {m_wheels[at(net)], m_routes[at(net)].cells}, m_rowExtra, sources, m_places);
  if (!canBeFound) return -1;
  using Way = std::pair<double, int>;  // what it costs, its end
  std::priority_queue<Way, std::vector<Way>, std::greater<>> ways;
  while (!m_search.isDone() || !ways.empty()) {
    if (ways.empty() || (!m_search.isDone() && !m_search.isBeyond(ways.top().first))) {
      for (const int cell : m_search.settleLot()) {
        for (int e = m_endAt[at(cell)]; e >= 0; e = m_ends[at(e)].next)
          ways.push({m_search.cost(cell) + m_places[at(e)].second, e});
      }
      continue;
    }
    const int way = ways.top().second;
    ways.pop();
    const int end = m_places[at(way)].first, l = m_ends[at(way)].landing;
    const MeridianLanding& landing = landings[at(l)];
    if (!isClear(end, landing)) continue;
    for (int c = end; c >= 0; c = m_search.from(c)) claim(net, c);
    take(net, landing);
    sources = laid(net);
    return l;
  }
  return -1;
}

bool Round::support(int net) {
  Places sources = laid(net);
  m_routes[at(net)].support = reach(net, m_nets[at(net)].supports, sources);
  return m_routes[at(net)].support >= 0;
}

bool Round::layNet(int net) {
  const MeridianNet& wanted = m_nets[at(net)];
  MeridianRoute& route = m_routes[at(net)];
  route.landing.assign(wanted.groups.size(), -1);
  if (wanted.groups.empty()) return true;
  // The first landing is whichever the way to the next leads from.
  Places sources;
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

using Routes = std::optional<std::vector<MeridianRoute>>;

Routes routed(const MeridianGrid& grid, const std::vector<MeridianNet>& nets, int tries) {
  std::vector<int> order(nets.size());
  std::iota(order.begin(), order.end(), 0);
  std::minstd_rand random(1);
  MeridianSearch search(grid);
  const MeridianBits bits(grid);
  const MeridianOwners owners(grid, bits);
  std::vector<std::vector<int>> wheels(nets.size());
  for (std::size_t cell = 0; cell < grid.owner.size(); ++cell) {
    if (grid.owner[cell] >= 0) wheels[at(grid.owner[cell])].push_back(static_cast<int>(cell));
  }
  for (int i = 0; i < tries; ++i) {
    Round round(grid, nets, owners, wheels, search, static_cast<unsigned>(i + 1), i == 0 ? 0 : kSpread);
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

/// What was asked last, with the answers. Thread-safe.
class RouteMemory {
 public:
  /// Who asks for what another thread is at waits for its answer.
  Routes find(const MeridianGrid& grid, const std::vector<MeridianNet>& nets, int tries) {
    std::packaged_task<Routes()> work;
    std::shared_future<Routes> answer;
    {
      const std::lock_guard lock(m_mutex);
      const auto known = std::find_if(m_known.begin(), m_known.end(), [&](const Known& k) {
        return k.tries == tries && k.grid == grid && k.nets == nets;
      });
      if (known != m_known.end()) {
        std::rotate(m_known.begin(), known, known + 1);  // the newest is in front
        answer = m_known.front().routes;
      } else {
        work = std::packaged_task<Routes()>([&] { return routed(grid, nets, tries); });
        answer = work.get_future().share();
        if (m_known.size() == kMost) m_known.pop_back();
        m_known.push_front({grid, nets, tries, answer});
      }
    }
    if (work.valid()) work();
    return answer.get();
  }

 private:
  static constexpr std::size_t kMost = 64;  // a drag to and fro
  struct Known {
    MeridianGrid grid;
    std::vector<MeridianNet> nets;
    int tries;
    std::shared_future<Routes> routes;
  };
  std::mutex m_mutex;
  std::deque<Known> m_known;
};

}  // namespace

Routes routeMeridian(const MeridianGrid& grid, const std::vector<MeridianNet>& nets, int tries) {
  static RouteMemory memory;
  return memory.find(grid, nets, tries);
}

}  // namespace geargraph
