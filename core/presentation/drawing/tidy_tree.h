#pragma once

#include <span>
#include <vector>

namespace geargraph {

/// The place of a node of a drawn forest: its distance from its root, and its row.
struct TidyPlace {
  int column = 0;
  double row = 0;
};

/// A forest drawn from its roots to the right, as Reingold and Tilford draw trees: neighbours in a column are
/// at least a row apart, a node is centred between its first and last child, subtrees are as close as that
/// allows, in the order of their nodes, and equal subtrees have equal shapes. Rows are multiples of 1/2 where
/// depth allows; the first root's tree is the uppermost.
///
/// `parent`, by node: -1 for a root. `order`: every node once, after its parent, siblings in drawing order.
/// `sizes`, by node: its extent along its column, half of it on either side; empty: one row each.
/// Cost: linear in the nodes.
[[nodiscard]] std::vector<TidyPlace> tidyForest(std::span<const int> parent, std::span<const int> order,
                                                std::span<const double> sizes = {});

}  // namespace geargraph
