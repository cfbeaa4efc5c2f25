#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline graph {

/// A directed edge between two nodes, by their ordinals.
struct DigraphEdge {
  int tail = 0;
  int head = 0;
};

/// The mechanism's digraph [AU, Fig. 2]: a node per link (0 is the ground), then an edge per turning joint,
/// then an edge per gear mesh, all in the order of the document. Ordinals are positions 0..n and 0..t+c-1;
/// labels are the paper's numbers; both are assigned anew with every digraph. Elements are identified by
/// their stable ids.
class Digraph {
 public:
  /// Cost: O(n + t + c).
  /// @pre the mechanism is well formed
  explicit Digraph(const Mechanism& mechanism);

  [[nodiscard]] int n() const { return m_nodeCount - 1; }  ///< moving links
  [[nodiscard]] int t() const { return m_turningCount; }   ///< turning joints
  [[nodiscard]] int c() const { return static_cast<int>(m_edges.size()) - m_turningCount; }  ///< gear meshes
  [[nodiscard]] int nodeCount() const { return m_nodeCount; }
  [[nodiscard]] int edgeCount() const { return static_cast<int>(m_edges.size()); }

  [[nodiscard]] const DigraphEdge& edge(int ordinal) const {
    return m_edges[static_cast<std::size_t>(ordinal)];
  }
  [[nodiscard]] const DigraphEdge& turningEdge(int joint) const { return edge(joint); }
  [[nodiscard]] const DigraphEdge& meshEdge(int mesh) const { return edge(m_turningCount + mesh); }
  [[nodiscard]] std::span<const DigraphEdge> turningEdges() const {
    return {m_edges.data(), static_cast<std::size_t>(m_turningCount)};
  }
  [[nodiscard]] std::span<const DigraphEdge> meshEdges() const {
    return std::span(m_edges).subspan(static_cast<std::size_t>(m_turningCount));
  }

  /// By turning joint: the position of its axis in the document.
  [[nodiscard]] std::span<const int> axisOf() const {
    return std::span(m_numbers).first(static_cast<std::size_t>(m_turningCount));
  }
  /// The turning edges at a node, ascending.
  [[nodiscard]] std::span<const int> turningEdgesAt(int node) const {
    const int* const start = starts() + node;
    return {m_numbers.data() + start[0], m_numbers.data() + start[1]};
  }

  /// The paper's labels: 0..n of the nodes, n+1..n+t+c of the edges.
  [[nodiscard]] int nodeLabel(int node) const { return node; }
  [[nodiscard]] int edgeLabel(int ordinal) const { return n() + 1 + ordinal; }

  [[nodiscard]] LinkId nodeId(int node) const { return m_nodes[static_cast<std::size_t>(node)]; }
  [[nodiscard]] ElementId edgeId(int ordinal) const {
    return {ordinal < m_turningCount ? ElementKind::turningJoint : ElementKind::gearMesh,
            m_edgeIds[static_cast<std::size_t>(ordinal)]};
  }

  /// Ordinals by id. @pre the element is in the digraph
  [[nodiscard]] int nodeOf(LinkId link) const { return m_nodeOf.at(link); }

 private:
  void addEdges(const Mechanism& mechanism);
  void collectTurningEdges();
  /// By node, and one for the end: where its turning edges begin in m_numbers.
  [[nodiscard]] const int* starts() const { return m_numbers.data() + m_turningCount; }

  int m_nodeCount = 0;
  int m_turningCount = 0;
  std::vector<LinkId> m_nodes;
  std::vector<DigraphEdge> m_edges;  ///< turning edges first
  std::vector<Atom> m_edgeIds;
  std::vector<int> m_numbers;  ///< the axes by joint, starts(), and the turning edges node by node
  PositionIndex<LinkTag> m_nodeOf;
};

using DigraphPtr = std::shared_ptr<const Digraph>;

}  // namespace geargraph::inline graph
