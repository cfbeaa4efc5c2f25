#include "core/theory/statics/circulation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/foundations/base/position_index.h"

namespace geargraph {
namespace {

/// Groups that are united, each named by one of its members.
class Groups {
 public:
  explicit Groups(int count) : m_leader(static_cast<std::size_t>(count)) {
    std::iota(m_leader.begin(), m_leader.end(), 0);
  }
  [[nodiscard]] int of(int member) {
    int& leader = m_leader[static_cast<std::size_t>(member)];
    if (leader != member) leader = of(leader);
    return leader;
  }
  void unite(int one, int other) { m_leader[static_cast<std::size_t>(of(one))] = of(other); }

 private:
  std::vector<int> m_leader;
};

/// Nodes, and the power from one to another.
class FlowGraph {
 public:
  explicit FlowGraph(int nodes) : m_edges(static_cast<std::size_t>(nodes)) {}

  void add(int from, int to, Real power) { m_edges[from].push_back({to, std::move(power)}); }

  /// The cycle whose least edge is greatest, as its nodes; empty where there is none.
  [[nodiscard]] std::vector<int> widestCycle() const {
    std::vector<const Real*> widths;
    for (const auto& edges : m_edges)
      for (const Edge& edge : edges) widths.push_back(&edge.power);
    std::sort(widths.begin(), widths.end(), [](const Real* a, const Real* b) { return isLess(*a, *b); });
    std::vector<int> widest;
    std::size_t from = 0;
    std::size_t to = widths.size();
    while (from < to) {  // the greatest width whose edges and wider ones still have a cycle
      const std::size_t middle = from + (to - from) / 2;
      std::vector<int> cycle = cycleOf(*widths[middle]);
      if (cycle.empty()) {
        to = middle;
      } else {
        widest = std::move(cycle);
        from = middle + 1;
      }
    }
    return widest;
  }

  /// Takes the least power of the cycle from all of its edges; returns it.
  Real subtract(const std::vector<int>& cycle) {
    std::vector<Edge*> edges;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      auto& from = m_edges[cycle[i]];
      const int to = cycle[(i + 1) % cycle.size()];
      edges.push_back(&*std::find_if(from.begin(), from.end(), [&](const Edge& e) { return e.to == to; }));
    }
    const Edge* const least = *std::min_element(
        edges.begin(), edges.end(), [](const Edge* a, const Edge* b) { return isLess(a->power, b->power); });
    const Real power = least->power;
    for (Edge* const edge : edges) edge->power = edge == least ? Real() : edge->power - power;
    for (auto& from : m_edges) std::erase_if(from, [](const Edge& edge) { return edge.power.sign() <= 0; });
    return power;
  }

 private:
  struct Edge {
    int to = 0;
    Real power;
  };

  [[nodiscard]] static bool isLess(const Real& a, const Real& b) { return (a - b).sign() < 0; }

  /// Some cycle of edges that are at least so wide.
  [[nodiscard]] std::vector<int> cycleOf(const Real& width) const {
    enum class Mark : char { open, active, done };
    ByLink<Mark> marks(m_edges.size(), Mark::open);
    std::vector<std::pair<int, std::size_t>> walk;  // a node, and its next edge
    for (std::size_t start = 0; start < m_edges.size(); ++start) {
      if (marks[start] != Mark::open) continue;
      walk = {{static_cast<int>(start), 0}};
      marks[start] = Mark::active;
      while (!walk.empty()) {
        auto& [node, next] = walk.back();
        const auto& edges = m_edges[node];
        while (next < edges.size() && isLess(edges[next].power, width)) ++next;
        if (next == edges.size()) {
          marks[node] = Mark::done;
          walk.pop_back();
          continue;
        }
        const int to = edges[next++].to;
        Mark& mark = marks[to];
        if (mark == Mark::active) {
          std::vector<int> cycle;
          for (auto at = walk.rbegin(); at == walk.rbegin() || std::prev(at)->first != to; ++at)
            cycle.push_back(at->first);
          std::reverse(cycle.begin(), cycle.end());
          return cycle;
        }
        if (mark == Mark::done) continue;
        mark = Mark::active;
        walk.emplace_back(to, 0);
      }
    }
    return {};
  }

  ByLink<std::vector<Edge>> m_edges;
};

class Finder {
 public:
  Finder(const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
         const StaticsProblem& problem, const StaticsSolution& lossless, const PowerFlow& flow)
      : m_mechanism(mechanism),
        m_model(model),
        m_placement(placement),
        m_problem(problem),
        m_lossless(lossless),
        m_flow(flow),
        m_isPlanet(static_cast<std::size_t>(model.n()) + 1, 0),
        m_sets(model.c()),
        m_shafts(model.n() + 1) {}

  std::optional<std::vector<Circulation>> run() {
    findPlanets();
    const SpanningTree& tree = m_model.tree();
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link)
      if (m_isPlanet[link] == 0 && tree.parent(link) != 0) return std::nullopt;
    if (!uniteSets()) return std::nullopt;
    uniteShafts();
    FlowGraph graph = graphOfSets();
    std::vector<Circulation> circulations;
    while (static_cast<int>(circulations.size()) < kMaxCirculations) {
      const std::vector<int> cycle = graph.widestCycle();
      if (cycle.empty()) break;
      circulations.push_back(circulationOf(cycle, graph.subtract(cycle)));
    }
    return circulations;
  }

 private:
  void findPlanets() {
    const SpanningTree& tree = m_model.tree();
    ByLink<char> other(m_isPlanet.size(), 0);  // links that are none
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link) other[tree.parent(link)] = 1;
    for (const auto& geometry : m_placement.meshes)
      for (const LinkOrdinal gear : {geometry->tail, geometry->head}) {
        const bool onCarrier = geometry->carrier != 0 && tree.parent(gear) == geometry->carrier;
        (onCarrier ? m_isPlanet : other)[gear] = 1;
      }
    const auto place = [&](const TorquePlace& at) {
      other[at.inJoint() ? tree.child(at.joint) : at.link] = 1;
    };
    for (const AppliedTorque& load : m_problem.torques) place(load.place);
    for (const AppliedForce& load : m_problem.forces) other[load.link] = 1;
    for (const TorquePlace& balance : m_problem.balances) place(balance);
    const PositionIndex<LinkTag> links(m_mechanism.links);
    for (const ShiftElementOrdinal coupling : m_problem.engaged)
      for (const LinkId& link : m_mechanism.couplings[coupling].links) other[links.at(link)] = 1;
    for (std::size_t link = 0; link < other.size(); ++link)
      if (other[link] != 0) m_isPlanet[link] = 0;
  }

  /// By planets, and by self-stresses, whose meshes share a load in unknown parts. False where couplings or
  /// balances share it too.
  bool uniteSets() {
    std::map<int, int> ofPlanet;
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh) {
      const MeshGeometry& geometry = *m_placement.meshes[mesh];
      for (const LinkOrdinal gear : {geometry.tail, geometry.head}) {
        if (m_isPlanet[gear] == 0) continue;
        m_sets.unite(mesh, ofPlanet.try_emplace(gear, mesh).first->second);
      }
    }
    for (const auto& stress : m_lossless.selfStresses)
      for (const auto& [unknown, weight] : stress) {
        if (unknown >= m_model.c()) return false;
        m_sets.unite(unknown, stress.front().first);
      }
    return true;
  }

  void uniteShafts() {
    const PositionIndex<LinkTag> links(m_mechanism.links);
    for (const int position : m_problem.engaged) {
      const ShiftElement& coupling = m_mechanism.couplings[position];
      if (coupling.kind != ShiftElementKind::brake)
        m_shafts.unite(links.at(coupling.links.front()), links.at(coupling.links.back()));
    }
  }

  /// Nodes: the sets, by mesh, then the shafts, by link.
  FlowGraph graphOfSets() {
    std::map<std::pair<int, int>, Real> delivered;  // by set and shaft
    const SpanningTree& tree = m_model.tree();
    const auto add = [&](int set, const PowerPort& port) {
      if (port.link == 0 || m_isPlanet[port.link] != 0) return;
      delivered[{set, m_shafts.of(port.link)}] += port.power;
    };
    ByLink<int> setOfPlanet(m_isPlanet.size(), -1);
    for (const ElementPower& element : m_flow.elements) {
      if (element.kind != ElementPower::Kind::mesh) continue;
      for (const PowerPort& port : element.ports) {
        add(m_sets.of(element.position), port);
        setOfPlanet[port.link] = m_sets.of(element.position);
      }
    }
    for (const ElementPower& element : m_flow.elements) {
      if (element.kind != ElementPower::Kind::joint) continue;
      const LinkOrdinal child = tree.child(element.position);
      if (m_isPlanet[child] == 0) continue;
      for (const PowerPort& port : element.ports) add(setOfPlanet[child], port);
    }
    double largest = 0;
    for (const auto& [ends, power] : delivered) largest = std::max(largest, std::abs(power.number()));
    constexpr double kRounding = 1e-9;
    FlowGraph graph(m_model.c() + m_model.n() + 1);
    for (const auto& [ends, power] : delivered) {
      if (power.isZero() || (!power.isExact() && std::abs(power.number()) < kRounding * largest)) continue;
      const int shaft = m_model.c() + ends.second;
      power.sign() > 0 ? graph.add(ends.first, shaft, power) : graph.add(shaft, ends.first, -power);
    }
    return graph;
  }

  Circulation circulationOf(const std::vector<int>& cycle, Real power) {
    Circulation circulation{std::move(power), {}, {}};
    const auto isOn = [&](LinkOrdinal node) {
      return std::find(cycle.begin(), cycle.end(), node) != cycle.end();
    };
    for (MeshOrdinal mesh = 0; mesh < m_model.c(); ++mesh)
      if (isOn(m_sets.of(mesh))) circulation.meshes.push_back(mesh);
    for (LinkOrdinal link = 1; link <= m_model.n(); ++link)
      if (m_isPlanet[link] == 0 && isOn(m_model.c() + m_shafts.of(link))) circulation.links.push_back(link);
    return circulation;
  }

  const Mechanism& m_mechanism;
  const KinematicModel& m_model;
  const Placement& m_placement;
  const StaticsProblem& m_problem;
  const StaticsSolution& m_lossless;
  const PowerFlow& m_flow;
  ByLink<char> m_isPlanet;
  Groups m_sets;
  Groups m_shafts;
};

}  // namespace

std::optional<std::vector<Circulation>> circulationsOf(
    const Mechanism& mechanism, const KinematicModel& model, const Placement& placement,
    const StaticsProblem& problem, const StaticsSolution& lossless, const PowerFlow& flow) {
  return Finder(mechanism, model, placement, problem, lossless, flow).run();
}

}  // namespace geargraph
