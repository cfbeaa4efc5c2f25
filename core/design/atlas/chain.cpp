#include "core/design/atlas/chain.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "core/foundations/base/disjoint_sets.h"

namespace geargraph {
namespace {

/// The biconnected components of the graph of links and meshes (a mesh is joined to its gears and its
/// carrier), by the method of Tarjan without recursion; components that share a mesh belong to one part.
class PartFinder {
 public:
  explicit PartFinder(const Chain& chain)
      : m_links(chain.links),
        m_neighbours(static_cast<std::size_t>(chain.links) + chain.meshes.size()),
        m_depth(m_neighbours.size(), -1),
        m_low(m_neighbours.size()),
        m_meshes(static_cast<int>(chain.meshes.size())),
        m_partOf(chain.meshes.size()) {
    for (std::size_t m = 0; m < chain.meshes.size(); ++m) {
      const ChainMesh& mesh = chain.meshes[m];
      const int vertex = m_links + static_cast<int>(m);
      for (const int link : {mesh.tail, mesh.head, mesh.carrier}) {
        m_neighbours[static_cast<std::size_t>(link)].push_back(vertex);
        m_neighbours[static_cast<std::size_t>(vertex)].push_back(link);
      }
    }
  }

  std::vector<std::vector<int>> find() {
    for (int vertex = 0; vertex < static_cast<int>(m_neighbours.size()); ++vertex)
      if (depth(vertex) < 0) visit(vertex);
    std::map<int, std::vector<int>> parts;
    for (int m = 0; m < m_meshes; ++m) parts[m_partOf.root(m)].push_back(m);
    std::vector<std::vector<int>> all;
    for (auto& [first, meshes] : parts) all.push_back(std::move(meshes));
    return all;
  }

 private:
  struct Step {
    int vertex = 0;
    int parent = -1;
    std::size_t next = 0;  ///< neighbour to look at
  };

  int& depth(int vertex) { return m_depth[static_cast<std::size_t>(vertex)]; }
  int& low(int vertex) { return m_low[static_cast<std::size_t>(vertex)]; }

  void visit(int first) {
    std::vector<Step> steps{{first}};
    depth(first) = low(first) = 0;
    m_open.push_back(first);
    while (!steps.empty()) {
      Step& step = steps.back();
      const auto& neighbours = m_neighbours[static_cast<std::size_t>(step.vertex)];
      if (step.next < neighbours.size()) {
        const int other = neighbours[step.next++];
        if (other == step.parent) continue;
        if (depth(other) >= 0) {
          low(step.vertex) = std::min(low(step.vertex), depth(other));
          continue;
        }
        depth(other) = low(other) = static_cast<int>(steps.size());
        m_open.push_back(other);
        steps.push_back({other, step.vertex});
        continue;
      }
      const Step done = step;
      steps.pop_back();
      if (steps.empty()) continue;
      const int parent = steps.back().vertex;
      low(parent) = std::min(low(parent), low(done.vertex));
      if (low(done.vertex) >= depth(parent)) close(done.vertex, parent);
    }
    m_open.clear();
  }

  /// Everything visited from `vertex` on, and `parent`, is one component: its meshes are of one part.
  void close(int vertex, int parent) {
    int mesh = parent >= m_links ? parent - m_links : -1;
    int last = -1;
    while (last != vertex) {
      last = m_open.back();
      m_open.pop_back();
      if (last < m_links) continue;
      if (mesh >= 0) m_partOf.join(mesh, last - m_links);
      mesh = last - m_links;
    }
  }

  int m_links;
  std::vector<std::vector<int>> m_neighbours;
  std::vector<int> m_depth;
  std::vector<int> m_low;
  std::vector<int> m_open;
  int m_meshes;
  DisjointSets m_partOf;  ///< of meshes
};

}  // namespace

std::vector<ChainMesh> possibleMeshes(const Chain& chain) {
  const auto n = static_cast<std::size_t>(chain.links);
  std::vector<std::vector<int>> axesOf(n);
  for (std::size_t a = 0; a < chain.axes.size(); ++a)
    for (const int link : chain.axes[a])
      axesOf[static_cast<std::size_t>(link)].push_back(static_cast<int>(a));
  std::set<ChainMesh> meshes;
  for (int carrier = 0; carrier < chain.links; ++carrier) {
    const auto& axes = axesOf[static_cast<std::size_t>(carrier)];
    for (std::size_t a = 0; a < axes.size(); ++a) {
      for (std::size_t b = a + 1; b < axes.size(); ++b) {
        for (const int i : chain.axes[static_cast<std::size_t>(axes[a])]) {
          for (const int j : chain.axes[static_cast<std::size_t>(axes[b])])
            if (i != carrier && j != carrier) meshes.insert({std::min(i, j), std::max(i, j), carrier});
        }
      }
    }
  }
  return {meshes.begin(), meshes.end()};
}

Chain renamed(const Chain& chain, const std::vector<int>& newName) {
  const auto nameOf = [&](int link) { return newName[static_cast<std::size_t>(link)]; };
  Chain result{chain.links, {}, {}};
  for (const std::vector<int>& axis : chain.axes) {
    std::vector<int>& named = result.axes.emplace_back();
    for (const int link : axis) named.push_back(nameOf(link));
    std::sort(named.begin(), named.end());
  }
  for (const ChainMesh& mesh : chain.meshes) {
    const auto [tail, head] = std::minmax({nameOf(mesh.tail), nameOf(mesh.head)});
    result.meshes.push_back({tail, head, nameOf(mesh.carrier)});
  }
  std::sort(result.axes.begin(), result.axes.end());
  std::sort(result.meshes.begin(), result.meshes.end());
  return result;
}

Chain subchain(const Chain& chain, const std::vector<int>& kept) {
  std::vector<int> newName(static_cast<std::size_t>(chain.links), -1);
  for (std::size_t i = 0; i < kept.size(); ++i)
    newName[static_cast<std::size_t>(kept[i])] = static_cast<int>(i);
  const auto nameOf = [&](int link) { return newName[static_cast<std::size_t>(link)]; };
  Chain result{static_cast<int>(kept.size()), {}, {}};
  for (const std::vector<int>& axis : chain.axes) {
    std::vector<int> links;
    for (const int link : axis)
      if (nameOf(link) >= 0) links.push_back(nameOf(link));
    if (links.size() >= 2) result.axes.push_back(std::move(links));
  }
  for (const ChainMesh& mesh : chain.meshes) {
    const ChainMesh named{nameOf(mesh.tail), nameOf(mesh.head), nameOf(mesh.carrier)};
    if (std::min({named.tail, named.head, named.carrier}) >= 0) result.meshes.push_back(named);
  }
  return result;
}

bool isNonfractionated(const Chain& chain) {
  std::vector<int> all(chain.meshes.size());
  std::iota(all.begin(), all.end(), 0);
  return static_cast<int>(linksOf(chain, all).size()) == chain.links && partsOf(chain).size() == 1;
}

std::vector<std::vector<int>> partsOf(const Chain& chain) {
  return PartFinder(chain).find();
}

std::vector<int> linksOf(const Chain& chain, const std::vector<int>& meshes) {
  std::set<int> links;
  for (const int m : meshes) {
    const ChainMesh& mesh = chain.meshes[static_cast<std::size_t>(m)];
    links.insert({mesh.tail, mesh.head, mesh.carrier});
  }
  return {links.begin(), links.end()};
}

}  // namespace geargraph
