#pragma once

#include <span>
#include <vector>

namespace geargraph::inline drawing {

/// Where a node of a drawn forest stands: its distance from its root, and its row.
struct TidyPlace {
  int column = 0;
  double row = 0;
};

/// A forest drawn from its roots to the right, as Reingold and Tilford draw trees: neighbours in a column are
/// a row apart or more, a node stands in the middle of its first and last child, subtrees lie as close as
/// that allows, in the order of their nodes, and equal subtrees look alike. Rows are multiples of 1/2 where
/// depth allows; the first root's tree is the uppermost.
///
/// `parent`, by node: -1 for a root. `order`: every node once, behind its parent, siblings in the order in
/// which they are drawn.
/// `sizes`, by node: how much of its column it takes, half of it on either side; empty: a row each.
/// Cost: linear in the nodes.
[[nodiscard]] std::vector<TidyPlace> tidyForest(std::span<const int> parent, std::span<const int> order,
                                                std::span<const double> sizes = {});

}  // namespace geargraph::inline drawing
