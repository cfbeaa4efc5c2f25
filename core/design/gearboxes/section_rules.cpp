#include "core/design/gearboxes/section_rules.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>

#include "core/foundations/base/translation.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxDistributions = 4096;

using SectionGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS>;

struct SectionEdge {
  int a = 0;  ///< a link; or a fixed vertex, below 0: -1 - vertex
  int b = 0;
};

/// The parts of a gearbox's section as vertices: the links, a hub for each carrier of a link that has
/// several, housing and axis.
class SectionPlan {
 public:
  SectionPlan(const BasicSets& sets, const GearLayout& layout, int shafts)
      : m_next(shafts + 1) {  // 0 is the housing
    std::vector<int> carriers(static_cast<std::size_t>(shafts) + 1, 0);
    for (std::size_t set = 0; set < sets.size(); ++set) {
      if (!sets[set].sharesRing) ++carriers[static_cast<std::size_t>(carrierOf(layout, set))];
    }
    m_hubs.resize(static_cast<std::size_t>(shafts) + 1);
    int suns = 0;
    for (std::size_t set = 0; set < sets.size(); ++set) {
      const int carrier = carrierOf(layout, set);
      const int sun = layout.link(static_cast<int>(set), SetMember::sun);
      const int ring = layout.link(static_cast<int>(set), SetMember::ring);
      if (sets[set].sharesRing) {
        m_edges.push_back({suns, sun});
        continue;
      }
      int hubOf = carrier;
      if (carriers[static_cast<std::size_t>(carrier)] > 1) {
        const int hub = m_next++;
        m_hubs[static_cast<std::size_t>(carrier)].push_back(hub);
        m_fixed.emplace_back(hub, carrier);
        hubOf = -1 - hub;
      }
      m_edges.push_back({hubOf, ring});
      suns = hubOf;
      if (set + 1 < sets.size() && sets[set + 1].sharesRing) {  // two suns beside each other
        suns = -1 - m_next++;
        m_edges.push_back({hubOf, suns});
      }
      m_edges.push_back({suns, sun});
    }
  }

  void join(int a, int b) { m_edges.push_back({a, b}); }

  /// Input, output and housing around everything else: a triangle with the space outside it as a vertex.
  void joinEnds(int input, int output) {
    const int outside = m_next++;
    join(input, output);
    join(input, 0);
    join(output, 0);
    for (const int end : {input, output, 0}) join(-1 - outside, end);
  }

  /// Is there a way to distribute the ends among the hubs of their links without crossings?
  [[nodiscard]] bool canBeDrawn() const {
    std::vector<std::pair<std::size_t, bool>> open;  // edge, and whether its end b
    std::size_t ways = 1;
    for (std::size_t edge = 0; edge < m_edges.size(); ++edge) {
      for (const bool isSecond : {false, true}) {
        const int link = isSecond ? m_edges[edge].b : m_edges[edge].a;
        if (link <= 0 || m_hubs[static_cast<std::size_t>(link)].empty()) continue;
        open.emplace_back(edge, isSecond);
        ways *= m_hubs[static_cast<std::size_t>(link)].size() + 1;
        if (ways > kMaxDistributions) ways = kMaxDistributions;
      }
    }
    for (std::size_t way = 0; way < ways; ++way) {
      std::vector<SectionEdge> edges = m_edges;
      std::size_t rest = way;
      for (const auto& [edge, isSecond] : open) {
        int& end = isSecond ? edges[edge].b : edges[edge].a;
        const auto& hubs = m_hubs[static_cast<std::size_t>(end)];
        const std::size_t choice = rest % (hubs.size() + 1);
        rest /= hubs.size() + 1;
        if (choice > 0) end = -1 - hubs[choice - 1];
      }
      if (isPlanar(edges)) return true;
    }
    return false;
  }

 private:
  static int carrierOf(const GearLayout& layout, std::size_t set) {
    return layout.link(static_cast<int>(set), SetMember::carrier);
  }

  [[nodiscard]] bool isPlanar(const std::vector<SectionEdge>& edges) const {
    SectionGraph graph(static_cast<std::size_t>(m_next));
    const auto vertexOf = [](int end) { return static_cast<std::size_t>(end < 0 ? -1 - end : end); };
    for (const auto& [hub, link] : m_fixed)
      boost::add_edge(static_cast<std::size_t>(hub), static_cast<std::size_t>(link), graph);
    for (const SectionEdge& each : edges) {
      if (vertexOf(each.a) != vertexOf(each.b)) boost::add_edge(vertexOf(each.a), vertexOf(each.b), graph);
    }
    return boost::boyer_myrvold_planarity_test(graph);
  }

  int m_next;
  std::vector<std::vector<int>> m_hubs;      ///< by link: vertices, where it has several carriers
  std::vector<std::pair<int, int>> m_fixed;  ///< hub and its link
  std::vector<SectionEdge> m_edges;
};

}  // namespace

std::string_view sectionRuleName(SectionRule rule) {
  constexpr std::array<std::string_view, kSectionRuleCount> kNames = {"shafts-nest", "brakes-reach",
                                                                      "clutches-reach", "ends-reach"};
  return kNames[static_cast<std::size_t>(rule)];
}

std::string sectionRuleReason(SectionRule rule) {
  constexpr std::array<std::string_view, kSectionRuleCount> kReasons = {
      toTranslate("Shafts would have to cross each other."),
      toTranslate("A brake cannot reach the housing: other links enclose its link."),
      toTranslate("A clutch cannot reach both of its links without crossing others."),
      toTranslate("Input and output cannot come out at the two ends."),
  };
  return translated(kReasons[static_cast<std::size_t>(rule)]);
}

std::optional<SectionRule> brokenSectionRule(const BasicSets& sets, const GearLayout& layout, int shafts,
                                             std::span<const ElementLinks> elements) {
  SectionPlan section(sets, layout, shafts);
  if (!section.canBeDrawn()) return SectionRule::shaftsNest;
  for (const ElementLinks& each : elements) {
    if (each.isBrake()) section.join(each.a, 0);
  }
  if (!section.canBeDrawn()) return SectionRule::brakesReach;
  for (const ElementLinks& each : elements) {
    if (!each.isBrake()) section.join(each.a, each.b);
  }
  if (!section.canBeDrawn()) return SectionRule::clutchesReach;
  section.joinEnds(layout.input, layout.output);
  if (!section.canBeDrawn()) return SectionRule::endsReach;
  return std::nullopt;
}

}  // namespace geargraph
