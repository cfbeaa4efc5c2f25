#include "core/mechanism/graph/matrices.h"

#include <algorithm>
#include <bit>
#include <mutex>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

Heading nodeHeading(const Digraph& graph, LinkOrdinal node) {
  const int label = graph.nodeLabel(node);
  return {label, std::to_string(label), graph.nodeId(node)};
}

Heading edgeHeading(const Digraph& graph, int edge) {
  const int label = graph.edgeLabel(edge);
  return {label, std::to_string(label), graph.edgeId(edge)};
}

Heading cycleHeading(const Digraph& graph, MeshOrdinal mesh) {
  Heading heading = edgeHeading(graph, graph.t() + mesh);
  heading.text.insert(0, 1, 'C');
  return heading;
}

/// Γ⁰, or Γ where the ground's row is left out. Rows are collected when the first one is asked for.
class Incidence final : public IntegerMatrix {
 public:
  Incidence(DigraphPtr graph, MatrixKind kind)
      : m_graph(std::move(graph)), m_kind(kind), m_firstNode(kind == MatrixKind::incidence ? 0 : 1) {}

  [[nodiscard]] MatrixKind kind() const override { return m_kind; }
  [[nodiscard]] int rows() const override { return m_graph->nodeCount() - m_firstNode; }
  [[nodiscard]] int columns() const override { return m_graph->edgeCount(); }
  [[nodiscard]] Heading rowHeading(int row) const override {
    return nodeHeading(*m_graph, row + m_firstNode);
  }
  [[nodiscard]] Heading columnHeading(int column) const override { return edgeHeading(*m_graph, column); }
  [[nodiscard]] int entry(int row, int column) const override {
    const DigraphEdge& edge = m_graph->edge(column);
    const LinkOrdinal node = row + m_firstNode;
    return (edge.head == node ? 1 : 0) - (edge.tail == node ? 1 : 0);
  }
  void rowEntries(int row, std::vector<MatrixEntry>& entries) const override {
    std::call_once(m_collected, [this] { collect(); });
    const auto node = static_cast<std::size_t>(row + m_firstNode);
    entries.assign(m_edges.begin() + m_start[node], m_edges.begin() + m_start[node + 1]);
  }
  [[nodiscard]] std::optional<int> partition() const override {
    if (m_kind == MatrixKind::incidence) return std::nullopt;
    return m_graph->t();
  }

 private:
  void collect() const {
    m_start.assign(static_cast<std::size_t>(m_graph->nodeCount()) + 1, 0);
    for (int e = 0; e < m_graph->edgeCount(); ++e) {
      ++startBehind(m_graph->edge(e).tail);
      ++startBehind(m_graph->edge(e).head);
    }
    for (std::size_t i = 1; i < m_start.size(); ++i) m_start[i] += m_start[i - 1];
    m_edges.resize(static_cast<std::size_t>(m_graph->edgeCount()) * 2);
    std::vector<int> next = m_start;
    const auto put = [&](LinkOrdinal node, int edge, int value) {
      m_edges[static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++)] = {edge, value};
    };
    for (int e = 0; e < m_graph->edgeCount(); ++e) {  // in edge order, so every row is sorted
      put(m_graph->edge(e).tail, e, -1);
      put(m_graph->edge(e).head, e, +1);
    }
  }
  int& startBehind(LinkOrdinal node) const { return m_start[static_cast<std::size_t>(node) + 1]; }

  DigraphPtr m_graph;
  MatrixKind m_kind;
  int m_firstNode;
  mutable std::once_flag m_collected;
  mutable std::vector<int> m_start;  ///< by node: where its edges begin in m_edges
  mutable std::vector<MatrixEntry> m_edges;
};

/// What the four matrices of the tree share.
class TreeMatrix : public IntegerMatrix {
 protected:
  TreeMatrix(DigraphPtr graph, SpanningTreePtr tree) : m_graph(std::move(graph)), m_tree(std::move(tree)) {
    GEARGRAPH_REQUIRE(m_graph && m_tree && m_tree->nodeCount() == m_graph->nodeCount());
  }
  [[nodiscard]] const Digraph& graph() const { return *m_graph; }
  [[nodiscard]] const SpanningTree& tree() const { return *m_tree; }

  /// T(mesh, joint), Eq. (4).
  [[nodiscard]] int treeBlockEntry(MeshOrdinal mesh, JointOrdinal joint) const {
    const DigraphEdge& edge = graph().meshEdge(mesh);
    return tree().pathEntry(joint, edge.head) - tree().pathEntry(joint, edge.tail);
  }
  /// The non-zeros of a row of T, sorted.
  void treeBlockRow(MeshOrdinal mesh, std::vector<MatrixEntry>& entries) const {
    const DigraphEdge& edge = graph().meshEdge(mesh);
    entries.clear();
    const int meeting = tree().commonAncestor(edge.head, edge.tail);
    const auto walk = [&](LinkOrdinal node, int sign) {
      for (; node != meeting; node = tree().parent(node)) {
        const JointOrdinal joint = tree().jointToParent(node);
        entries.push_back({joint, sign * tree().directionToGround(joint)});
      }
    };
    walk(edge.head, +1);
    walk(edge.tail, -1);
    std::sort(entries.begin(), entries.end(),
              [](const MatrixEntry& a, const MatrixEntry& b) { return a.column < b.column; });
  }

 private:
  DigraphPtr m_graph;
  SpanningTreePtr m_tree;
};

class Path final : public TreeMatrix {
 public:
  Path(DigraphPtr graph, SpanningTreePtr sharedTree) : TreeMatrix(std::move(graph), std::move(sharedTree)) {
    const std::span<const int> order = tree().preorder();
    m_isInPreorder = std::is_sorted(order.begin(), order.end());
  }

  [[nodiscard]] MatrixKind kind() const override { return MatrixKind::path; }
  [[nodiscard]] int rows() const override { return graph().t(); }
  [[nodiscard]] int columns() const override { return graph().n(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return edgeHeading(graph(), row); }
  [[nodiscard]] Heading columnHeading(int column) const override { return nodeHeading(graph(), column + 1); }
  [[nodiscard]] int entry(int row, int column) const override { return tree().pathEntry(row, column + 1); }
  void rowEntries(int row, std::vector<MatrixEntry>& entries) const override {
    entries.clear();
    UniformRow uniform;
    (void)uniformRow(row, uniform);
    for (std::size_t i = 0; i < uniform.columns.size(); ++i) {
      for (std::uint64_t word = uniform.columns[i]; word != 0; word &= word - 1) {
        entries.push_back({static_cast<int>(i) * 64 + std::countr_zero(word), uniform.value});
      }
    }
  }
  /// Cost: O(n / 8 + nodes below the joint).
  bool uniformRow(int row, UniformRow& uniform) const override {
    uniform.value = tree().directionToGround(row);
    const auto size = static_cast<std::size_t>(columns());
    uniform.columns.assign((size + 63) / 64, 0);
    std::uint64_t* const words = uniform.columns.data();
    const std::span<const int> nodes = tree().below(row);
    if (m_isInPreorder) {
      const auto first = static_cast<std::size_t>(nodes.front() - 1);
      setBits(words, first, first + nodes.size());
      return true;
    }
    if (nodes.size() < size / 16) {
      for (const LinkOrdinal node : nodes) {
        words[(node - 1) / 64] |= std::uint64_t{1} << (static_cast<unsigned>(node - 1) % 64);
      }
      return true;
    }
    // Many nodes: marks are only stored, never read back, so that one does not wait for the one before.
    uniform.marks.assign((size + 63) / 64 * 64, 0);
    std::uint8_t* const marks = uniform.marks.data();
    for (const LinkOrdinal node : nodes) marks[node - 1] = 1;
    for (std::size_t column = 0; column < uniform.marks.size(); column += 8) {
      std::uint64_t eight = 0;
      for (unsigned k = 0; k < 8; ++k) eight |= std::uint64_t{marks[column + k]} << (8 * k);
      constexpr std::uint64_t kGather =
          0x0102040810204080;  // brings the lowest bit of each byte into the highest
      words[column / 64] |= ((eight * kGather) >> 56U) << (column % 64);
    }
    return true;
  }

 private:
  static void setBits(std::uint64_t* words, std::size_t first, std::size_t last) {
    while (first < last) {
      const std::size_t end = std::min(last, (first / 64 + 1) * 64);
      words[first / 64] |= (~std::uint64_t{0} >> (64 - (end - first))) << (first % 64);
      first = end;
    }
  }

  bool m_isInPreorder = false;  ///< links are numbered along the tree, so those below a joint are one run
};

/// T, or C = [T | U] where the unit block of the meshes follows.
class CycleBasis final : public TreeMatrix {
 public:
  CycleBasis(DigraphPtr graph, SpanningTreePtr tree, MatrixKind kind)
      : TreeMatrix(std::move(graph), std::move(tree)), m_kind(kind) {}

  [[nodiscard]] MatrixKind kind() const override { return m_kind; }
  [[nodiscard]] int rows() const override { return graph().c(); }
  [[nodiscard]] int columns() const override { return withUnitBlock() ? graph().edgeCount() : graph().t(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return cycleHeading(graph(), row); }
  [[nodiscard]] Heading columnHeading(int column) const override { return edgeHeading(graph(), column); }
  [[nodiscard]] int entry(int row, int column) const override {
    if (column < graph().t()) return treeBlockEntry(row, column);
    return column - graph().t() == row ? 1 : 0;
  }
  void rowEntries(int row, std::vector<MatrixEntry>& entries) const override {
    treeBlockRow(row, entries);
    if (withUnitBlock()) entries.push_back({graph().t() + row, 1});
  }
  [[nodiscard]] std::optional<int> partition() const override {
    if (!withUnitBlock()) return std::nullopt;
    return graph().t();
  }

 private:
  [[nodiscard]] bool withUnitBlock() const { return m_kind == MatrixKind::cycleBasis; }

  MatrixKind m_kind;
};

class Cutset final : public TreeMatrix {
 public:
  Cutset(DigraphPtr graph, SpanningTreePtr tree) : TreeMatrix(std::move(graph), std::move(tree)) {}

  [[nodiscard]] MatrixKind kind() const override { return MatrixKind::cutset; }
  [[nodiscard]] int rows() const override { return graph().t(); }
  [[nodiscard]] int columns() const override { return graph().edgeCount(); }
  [[nodiscard]] Heading rowHeading(int row) const override { return edgeHeading(graph(), row); }
  [[nodiscard]] Heading columnHeading(int column) const override { return edgeHeading(graph(), column); }
  [[nodiscard]] int entry(int row, int column) const override {
    if (column < graph().t()) return column == row ? 1 : 0;
    return -treeBlockEntry(column - graph().t(), row);
  }
  void rowEntries(int row, std::vector<MatrixEntry>& entries) const override {
    entries.assign(1, {row, 1});
    for (MeshOrdinal mesh = 0; mesh < graph().c(); ++mesh) {
      const int value = -treeBlockEntry(mesh, row);
      if (value != 0) entries.push_back({graph().t() + mesh, value});
    }
  }
  [[nodiscard]] std::optional<int> partition() const override { return graph().t(); }
};

}  // namespace

IntegerMatrixPtr incidenceMatrix(DigraphPtr graph) {
  return std::make_shared<Incidence>(std::move(graph), MatrixKind::incidence);
}

IntegerMatrixPtr reducedIncidenceMatrix(DigraphPtr graph) {
  return std::make_shared<Incidence>(std::move(graph), MatrixKind::reducedIncidence);
}

IntegerMatrixPtr pathMatrix(DigraphPtr graph, SpanningTreePtr tree) {
  return std::make_shared<Path>(std::move(graph), std::move(tree));
}

IntegerMatrixPtr spanningTreeMatrix(DigraphPtr graph, SpanningTreePtr tree) {
  return std::make_shared<CycleBasis>(std::move(graph), std::move(tree), MatrixKind::spanningTree);
}

IntegerMatrixPtr cycleBasisMatrix(DigraphPtr graph, SpanningTreePtr tree) {
  return std::make_shared<CycleBasis>(std::move(graph), std::move(tree), MatrixKind::cycleBasis);
}

IntegerMatrixPtr cutsetMatrix(DigraphPtr graph, SpanningTreePtr tree) {
  return std::make_shared<Cutset>(std::move(graph), std::move(tree));
}

IntegerMatrixPtr matrixOf(MatrixKind kind, const DigraphPtr& graph, const SpanningTreePtr& tree) {
  if (kind == MatrixKind::incidence) return incidenceMatrix(graph);
  if (kind == MatrixKind::reducedIncidence) return reducedIncidenceMatrix(graph);
  if (!tree) return nullptr;
  switch (kind) {
    case MatrixKind::path:
      return pathMatrix(graph, tree);
    case MatrixKind::spanningTree:
      return spanningTreeMatrix(graph, tree);
    case MatrixKind::cycleBasis:
      return cycleBasisMatrix(graph, tree);
    case MatrixKind::cutset:
      return cutsetMatrix(graph, tree);
    default:
      GEARGRAPH_REQUIRE(false);
  }
}

}  // namespace geargraph
