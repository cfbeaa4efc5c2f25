#include "core/theory/levers/mesh_groups.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace geargraph {
namespace {

/// Links joined into sets, each known by one of them.
class JoinedLinks {
 public:
  explicit JoinedLinks(std::size_t links) : m_next(links) { std::iota(m_next.begin(), m_next.end(), 0); }
  int rootOf(int link) {
    while (m_next[static_cast<std::size_t>(link)] != link) {
      int& next = m_next[static_cast<std::size_t>(link)];
      link = next = m_next[static_cast<std::size_t>(next)];
    }
    return link;
  }
  void join(int one, int other) { m_next[static_cast<std::size_t>(rootOf(one))] = rootOf(other); }

 private:
  std::vector<int> m_next;
};

template <class T>
void sortUnique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace

bool isOnAxis(const Placement& placement, AxisGroupOrdinal axis, LinkOrdinal link) {
  return placement.classes->classes[axis].rootLink == link ||
         (link != 0 && placement.classes->classOfLink(link) == axis);
}

std::string MeshGroup::teethText() const {
  std::string text;
  for (const Wheel& wheel : wheels) text += (text.empty() ? "" : " : ") + std::to_string(wheel.teeth);
  return text;
}

std::vector<MeshGroup> meshGroups(const Placement& placement, AxisGroupOrdinal mainAxis) {
  JoinedLinks joined(placement.tree->parent.size());
  std::vector<std::vector<int>> off;  // by mesh: its links off the main axis
  for (const auto& mesh : placement.meshes) {
    std::vector<int>& links = off.emplace_back();
    for (const LinkOrdinal link : {mesh->tail, mesh->head, mesh->carrier}) {
      if (!isOnAxis(placement, mainAxis, link)) links.push_back(link);
    }
    for (std::size_t i = 1; i < links.size(); ++i) joined.join(links[0], links[i]);
  }
  std::vector<MeshGroup> groups;
  std::map<int, std::size_t> groupOf;  // by the root of the links off the axis
  for (const MeshOrdinal mesh : placement.meshes.ordinals()) {
    const auto& links = off[static_cast<std::size_t>(int{mesh})];
    std::size_t at = groups.size();
    if (!links.empty()) at = groupOf.emplace(joined.rootOf(links[0]), at).first->second;
    if (at == groups.size()) groups.emplace_back();
    MeshGroup& group = groups[at];
    group.meshes.push_back(mesh);
    const MeshGeometry& geometry = *placement.meshes[mesh];
    for (const auto& [link, teeth] :
         {std::pair{geometry.tail, geometry.tailTeeth}, std::pair{geometry.head, geometry.headTeeth}}) {
      if (isOnAxis(placement, mainAxis, link)) group.wheels.push_back({link, teeth});
    }
    for (const LinkOrdinal link : {geometry.tail, geometry.head, geometry.carrier}) {
      if (isOnAxis(placement, mainAxis, link)) group.links.push_back(link);
    }
  }
  for (MeshGroup& group : groups) {
    sortUnique(group.links);
    std::sort(group.wheels.begin(), group.wheels.end(), [](const auto& a, const auto& b) {
      return std::pair(a.teeth, int{a.link}) < std::pair(b.teeth, int{b.link});
    });
    group.wheels.erase(std::unique(group.wheels.begin(), group.wheels.end()), group.wheels.end());
  }
  return groups;
}

}  // namespace geargraph
