#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/foundations/base/position_index.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// A directed edge between two nodes, by their ordinals.
struct DigraphEdge {
  LinkOrdinal tail = 0;
  LinkOrdinal head = 0;
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
  [[nodiscard]] const DigraphEdge& turningEdge(JointOrdinal joint) const { return edge(joint); }
  [[nodiscard]] const DigraphEdge& meshEdge(MeshOrdinal mesh) const { return edge(m_turningCount + mesh); }
  [[nodiscard]] SpanByJoint<const DigraphEdge> turningEdges() const {
    return SpanByJoint<const DigraphEdge>(edges().first(static_cast<std::size_t>(m_turningCount)));
  }
  [[nodiscard]] SpanByMesh<const DigraphEdge> meshEdges() const {
    return SpanByMesh<const DigraphEdge>(edges().subspan(static_cast<std::size_t>(m_turningCount)));
  }

  /// The axes of the turning joints.
  [[nodiscard]] SpanByJoint<const int> axisOf() const {
    return SpanByJoint<const int>(std::span(m_numbers).first(static_cast<std::size_t>(m_turningCount)));
  }
  /// The turning edges at a node, ascending.
  [[nodiscard]] std::span<const int> turningEdgesAt(LinkOrdinal node) const {
    const int* const start = starts() + node;
    return {m_numbers.data() + start[0], m_numbers.data() + start[1]};
  }

  /// The paper's labels: 0..n of the nodes, n+1..n+t+c of the edges.
  [[nodiscard]] int nodeLabel(LinkOrdinal node) const { return node; }
  [[nodiscard]] int edgeLabel(int ordinal) const { return n() + 1 + ordinal; }

  [[nodiscard]] LinkId nodeId(LinkOrdinal node) const { return m_nodes[node]; }
  [[nodiscard]] ElementId edgeId(int ordinal) const {
    return {ordinal < m_turningCount ? ElementKind::turningJoint : ElementKind::gearMesh,
            m_edgeIds[static_cast<std::size_t>(ordinal)]};
  }

  /// Ordinals by id. @pre the element is in the digraph
  [[nodiscard]] LinkOrdinal nodeOf(LinkId link) const { return m_nodeOf.at(link); }

 private:
  void addEdges(const Mechanism& mechanism);
  void collectTurningEdges();
  [[nodiscard]] std::span<const DigraphEdge> edges() const { return m_edges; }
  /// By node, and one for the end: where its turning edges begin in m_numbers.
  [[nodiscard]] const int* starts() const { return m_numbers.data() + m_turningCount; }

  int m_nodeCount = 0;
  int m_turningCount = 0;
  ByLink<LinkId> m_nodes;
  std::vector<DigraphEdge> m_edges;  ///< turning edges first
  std::vector<InternedString> m_edgeIds;
  std::vector<int> m_numbers;  ///< the axes by joint, starts(), and the turning edges node by node
  PositionIndex<LinkTag> m_nodeOf;
};

using DigraphPtr = std::shared_ptr<const Digraph>;

}  // namespace geargraph
