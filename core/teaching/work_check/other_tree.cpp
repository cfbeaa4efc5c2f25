// Matrices of another spanning tree than the one of the turning joints.

#include <algorithm>

#include "core/teaching/work_check/table_check.h"

namespace geargraph {
namespace {

using WholeNumbers = std::vector<std::vector<int>>;

/// The entries, if all are -1, 0 or 1.
std::optional<WholeNumbers> signsOf(const Vocabulary& vocabulary, const WrittenAmounts& amounts) {
  WholeNumbers signs;
  for (const auto& row : amounts) {
    auto& of = signs.emplace_back();
    for (const WrittenAmount& amount : row) {
      const Rational value = vocabulary.atTeeth(amount.value);
      if (amount.hasRatios || !(value.isZero() || value.abs() == Rational(1))) return std::nullopt;
      of.push_back(value.sign());
    }
  }
  return signs;
}

/// Positions among `count` things whose labels begin at `first`; the natural order where there are no labels.
std::optional<std::vector<int>> ordinals(const Vocabulary& vocabulary, const std::vector<WrittenCell>& labels,
                                         int first, int count, bool mayBeNatural) {
  std::vector<int> places;
  if (labels.empty() && mayBeNatural) {
    for (int i = 0; i < count; ++i) places.push_back(i);
    return places;
  }
  for (const WrittenCell& label : labels) {
    const int place = labelNumber(vocabulary, label.text).value_or(first - 1) - first;
    if (place < 0 || place >= count || std::find(places.begin(), places.end(), place) != places.end())
      return std::nullopt;
    places.push_back(place);
  }
  return places.empty() ? std::nullopt : std::optional(places);
}

/// Is the row a closed walk: does it leave every link as often as it reaches it?
bool isCycle(const Digraph& graph, const std::vector<int>& senses) {
  std::vector<int> sums(static_cast<std::size_t>(graph.nodeCount()), 0);
  for (int edge = 0; edge < graph.edgeCount(); ++edge) {
    sums[static_cast<std::size_t>(graph.edge(edge).head)] += senses[static_cast<std::size_t>(edge)];
    sums[static_cast<std::size_t>(graph.edge(edge).tail)] -= senses[static_cast<std::size_t>(edge)];
  }
  return std::all_of(sums.begin(), sums.end(), [](int sum) { return sum == 0; });
}

/// The edges of the tree whose fundamental cycles the rows are: each row has an edge that no other has.
/// Empty where it is the tree of the turning joints, for which the labels of the rows count.
std::optional<std::vector<int>> treeOfCycles(const Digraph& graph, const WholeNumbers& cycles) {
  std::vector<char> isChord(static_cast<std::size_t>(graph.edgeCount()), 0);
  for (std::size_t row = 0; row < cycles.size(); ++row) {
    if (!isCycle(graph, cycles[row])) return std::nullopt;
    int own = -1;
    for (int edge = graph.edgeCount() - 1; edge >= 0 && own < 0; --edge) {
      const auto column = static_cast<std::size_t>(edge);
      const auto users =
          std::count_if(cycles.begin(), cycles.end(), [&](const auto& c) { return c[column] != 0; });
      if (users == 1 && cycles[row][column] != 0) own = edge;
    }
    if (own < 0) return std::nullopt;
    isChord[static_cast<std::size_t>(own)] = 1;
  }
  std::vector<int> tree;
  bool isOther = false;
  for (int edge = 0; edge < graph.edgeCount(); ++edge) {
    if (isChord[static_cast<std::size_t>(edge)] != 0) continue;
    tree.push_back(graph.edgeLabel(edge));
    isOther = isOther || edge >= graph.t();
  }
  if (!isOther) return std::nullopt;
  return tree;
}

/// Z of the tree of its rows' edges: each column is the walk from its link to the ground.
bool isPathMatrix(const Digraph& graph, const WholeNumbers& entries, const std::vector<int>& edges,
                  const std::vector<int>& links) {
  for (std::size_t column = 0; column < links.size(); ++column) {
    std::vector<int> sums(static_cast<std::size_t>(graph.nodeCount()), 0);
    for (std::size_t row = 0; row < edges.size(); ++row) {
      sums[static_cast<std::size_t>(graph.edge(edges[row]).head)] += entries[row][column];
      sums[static_cast<std::size_t>(graph.edge(edges[row]).tail)] -= entries[row][column];
    }
    sums[0] -= 1;
    sums[static_cast<std::size_t>(links[column]) + 1] += 1;
    if (std::any_of(sums.begin(), sums.end(), [](int sum) { return sum != 0; })) return false;
  }
  return true;
}

}  // namespace

std::optional<std::vector<int>> otherTree(const Vocabulary& vocabulary, PaperMatrix kind,
                                          const WrittenTable& table, const WrittenAmounts& amounts) {
  const Digraph& graph = vocabulary.source().graph();
  const bool isCycles = kind == PaperMatrix::cycleBasis;
  const bool isTree = kind == PaperMatrix::spanningTree;
  const bool isPath = kind == PaperMatrix::path;
  const int height = isPath ? graph.t() : graph.c();
  const int width = isCycles ? graph.edgeCount() : isTree ? graph.t() : graph.n();
  if (!(isCycles || isTree || isPath) || table.rows() != height || table.columns() != width || height == 0)
    return std::nullopt;
  const auto signs = signsOf(vocabulary, amounts);
  const int firstEdge = graph.edgeLabel(0);
  const auto columns = ordinals(vocabulary, table.columnLabels, isPath ? 1 : firstEdge,
                                isPath ? graph.n() : graph.edgeCount(), isCycles || isPath);
  if (!signs || !columns || static_cast<int>(columns->size()) != width) return std::nullopt;
  if (isPath) {
    const auto edges = ordinals(vocabulary, table.rowLabels, firstEdge, graph.edgeCount(), false);
    if (!edges || !isPathMatrix(graph, *signs, *edges, *columns)) return std::nullopt;
    std::vector<int> tree;
    for (const int edge : *edges) tree.push_back(graph.edgeLabel(edge));
    return tree;
  }
  const auto chords =
      isTree ? ordinals(vocabulary, table.rowLabels, firstEdge, graph.edgeCount(), false) : std::nullopt;
  if (isTree && !chords) return std::nullopt;
  WholeNumbers cycles(static_cast<std::size_t>(height),
                      std::vector<int>(static_cast<std::size_t>(graph.edgeCount()), 0));
  for (std::size_t row = 0; row < cycles.size(); ++row) {
    for (std::size_t column = 0; column < columns->size(); ++column)
      cycles[row][static_cast<std::size_t>((*columns)[column])] = (*signs)[row][column];
    if (!chords) continue;
    int& own = cycles[row][static_cast<std::size_t>((*chords)[row])];
    if (own != 0) return std::nullopt;  // the chord is among the tree's edges
    own = 1;
    if (isCycle(graph, cycles[row])) continue;
    own = -1;
  }
  return treeOfCycles(graph, cycles);
}

}  // namespace geargraph
