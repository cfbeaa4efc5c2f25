#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace geargraph {

/// A simple undirected graph with coloured vertices 0..colours.size()-1; colours are small numbers from 0 on.
struct ColouredGraph {
  std::vector<int> colours;
  std::vector<std::pair<int, int>> edges;
};

/// What nauty says of a graph.
struct CanonicalGraph {
  /// Equal for two graphs if and only if they are isomorphic with their colours. Not the same in all versions
  /// of nauty: never stored.
  std::vector<std::uint64_t> form;
  std::vector<int> order;   ///< the vertex at each canonical place: equal forms map order[i] to order[i]
  std::vector<int> orbits;  ///< by vertex: the first vertex that a symmetry takes it to
};

/// The canonical form of a graph (McKay and Piperno, Practical graph isomorphism II, J. Symbolic Computation
/// 60, 2014). Thread-safe: the library keeps its work space per thread.
///
/// Cost: some microseconds for a dozen vertices; exponential for graphs made to be hard.
[[nodiscard]] CanonicalGraph canonicalGraph(const ColouredGraph& graph);

}  // namespace geargraph
