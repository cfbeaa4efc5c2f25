#include "core/mechanism/placement/planet_groups.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "core/foundations/base/disjoint_sets.h"

namespace geargraph {
namespace {

class PlanetFinder {
 public:
  PlanetFinder(const Mechanism& mechanism, const Placement& placement, PlanetScope scope)
      : m_mechanism(mechanism),
        m_scope(scope),
        m_tree(*placement.tree),
        m_classes(*placement.classes),
        m_groups(m_classes.classes.size()),
        m_members(m_classes.classes.size()),
        m_meshesOf(mechanism.links.size()) {
    for (std::size_t m = 0; m < m_tree.meshes.size(); ++m) {
      m_meshesOf[m_tree.meshes[m].tail].push_back(static_cast<int>(m));
      m_meshesOf[m_tree.meshes[m].head].push_back(static_cast<int>(m));
    }
  }

  std::vector<std::vector<PlanetGroup>> find() {
    markPlanets();
    joinByMeshes();
    for (const int link : m_tree.order) {
      const int c = classOf(link);
      if (c >= 0 && m_isPlanet[c]) m_members[m_groups.root(c)].insert(link);
    }
    std::map<std::string, std::size_t> setOf;
    std::vector<std::vector<PlanetGroup>> sets;
    for (std::size_t c = 0; c < m_isPlanet.size(); ++c) {
      if (!m_isPlanet[c] || m_groups.root(c) != c) continue;
      if (m_classes.classes[c].rootLink == 0 && !isRoundOneAxis(static_cast<int>(c))) continue;
      const auto [group, signature] = described(static_cast<int>(c));
      const auto [found, isNew] = setOf.try_emplace(signature, sets.size());
      if (isNew) sets.emplace_back();
      sets[found->second].push_back(group);
    }
    // A wheel on the ground beside one other is no planet of it, unless there are several.
    std::erase_if(sets, [&](const auto& set) {
      const AxisGroupOrdinal own = classOf(set.front().links.front());
      return set.size() < 2 && set.front().meshes.size() < 2 && m_classes.classes[own].rootLink == 0;
    });
    return sets;
  }

 private:
  [[nodiscard]] int classOf(int link) const { return m_classes.classOfLink(link); }

  /// Axes that carry nothing; of those that one may stand for in a drawing, only passive ones.
  void markPlanets() {
    const bool isDrawn = m_scope == PlanetScope::drawn;
    m_isPlanet.assign(m_classes.classes.size(), false);
    for (std::size_t c = 0; c < m_isPlanet.size(); ++c)
      m_isPlanet[c] = !isDrawn || m_classes.classes[c].rootLink != 0;
    for (const auto& other : m_classes.classes) {
      if (other.rootLink != 0) m_isPlanet[classOf(other.rootLink)] = false;
    }
    if (!isDrawn) return;
    std::set<JointId> driven;
    for (const Input& input : m_mechanism.inputs.value_or(std::vector<Input>{})) driven.insert(input.joint);
    for (std::size_t j = 0; j < m_tree.joints.size(); ++j) {
      if (driven.contains(m_mechanism.turningJoints[j].id)) m_isPlanet[m_classes.classOf[j]] = false;
    }
  }

  /// On the ground, planets mesh with wheels whose axes are on the ground too: these are no group with them.
  void joinByMeshes() {
    for (const auto [tail, head] : m_tree.meshes) {
      const int a = classOf(tail);
      const int b = classOf(head);
      if (a < 0 || b < 0 || a == b || !m_isPlanet[a] || !m_isPlanet[b]) continue;
      const LinkOrdinal carrier = m_classes.classes[a].rootLink;
      if (carrier == 0 || carrier != m_classes.classes[b].rootLink) continue;
      m_groups.join(a, b);
    }
  }

  /// Wheels on the ground are planets of a train whose carrier is held if all that they mesh with is coaxial.
  bool isRoundOneAxis(int first) {
    std::set<int> axes;
    for (const int link : m_members[first]) {
      for (const MeshOrdinal mesh : m_meshesOf[link]) {
        const auto [tail, head] = m_tree.meshes[mesh];
        axes.insert(classOf(tail == link ? head : tail));
      }
    }
    return axes.size() == 1;
  }

  /// A mesh as a link of the group sees it; partners outside of the group by position.
  [[nodiscard]] std::string wordOf(int mesh, int link, const std::set<int>& members) const {
    const auto [tail, head] = m_tree.meshes[mesh];
    const GearMesh& drawn = m_mechanism.gearMeshes[mesh];
    const bool isTail = tail == link;
    const int partner = isTail ? head : tail;
    const int own = isTail ? drawn.tailTeeth : drawn.headTeeth;
    const int other = isTail ? drawn.headTeeth : drawn.tailTeeth;
    const std::string kind = drawn.kind ? std::string(meshKindName(*drawn.kind)) : "-";
    return (members.contains(partner) ? "own" : std::to_string(partner)) + "/" + kind + "/" +
           std::to_string(own) + "/" + std::to_string(other);
  }

  [[nodiscard]] std::string wordsOf(int link, const std::set<int>& members) const {
    std::vector<std::string> words;
    for (const MeshOrdinal mesh : m_meshesOf[link]) words.push_back(wordOf(mesh, link, members));
    std::sort(words.begin(), words.end());
    std::string all;
    for (const std::string& word : words) all += word + " ";
    return all;
  }

  std::pair<PlanetGroup, std::string> described(int first) {
    const std::set<int>& members = m_members[first];
    std::vector<std::pair<std::string, int>> links;
    for (const int link : members) links.emplace_back(wordsOf(link, members), link);
    std::sort(links.begin(), links.end());
    PlanetGroup group;
    std::string signature = std::to_string(m_classes.classes[first].rootLink) + ": ";
    for (const auto& [words, link] : links) {
      group.links.push_back(link);
      group.joints.push_back(m_tree.joint[link]);
      signature += words + "| ";
      std::vector<std::pair<std::string, int>> meshes;
      for (const MeshOrdinal mesh : m_meshesOf[link]) meshes.emplace_back(wordOf(mesh, link, members), mesh);
      std::sort(meshes.begin(), meshes.end());
      for (const auto& [word, mesh] : meshes) {
        if (std::find(group.meshes.begin(), group.meshes.end(), mesh) == group.meshes.end()) {
          group.meshes.push_back(mesh);
        }
      }
    }
    return {group, signature};
  }

  const Mechanism& m_mechanism;
  PlanetScope m_scope;
  const JointTree& m_tree;
  const AxisGroups& m_classes;
  ByClass<bool> m_isPlanet;
  DisjointSets m_groups;
  ByClass<std::set<int>> m_members;  ///< links, by the group's root
  ByLink<std::vector<MeshOrdinal>> m_meshesOf;
};

}  // namespace

std::vector<std::vector<PlanetGroup>> equalPlanets(const Mechanism& mechanism, const Placement& placement,
                                                   PlanetScope scope) {
  std::vector<std::vector<PlanetGroup>> sets = planetSets(mechanism, placement, scope);
  std::erase_if(sets, [](const auto& set) { return set.size() < 2; });
  return sets;
}

std::vector<std::vector<PlanetGroup>> planetSets(const Mechanism& mechanism, const Placement& placement,
                                                 PlanetScope scope) {
  return PlanetFinder(mechanism, placement, scope).find();
}

}  // namespace geargraph
