#pragma once

#include <set>
#include <string>

#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/graph/integer_matrix.h"
#include "core/mechanism/graph/spanning_tree.h"

namespace geargraph {

/// The explanation of a matrix entry in words.
struct CellExplanation {
  std::string title;  ///< "C16, joint 10: −1"
  std::string text;   ///< one or two sentences, then the paper's equation: "… (from 1 to 0). Eq. (5)"
};

/// Explains an entry by the paper's rule for its matrix.
///
/// Cost: O(length of the walk that the entry is about).
/// @pre row and column are in the matrix of this kind; `tree` is not null if the kind needs one (all but the
/// two incidence matrices)
[[nodiscard]] CellExplanation explainCell(MatrixKind kind, const Digraph& graph, const SpanningTree* tree,
                                          int row, int column);

/// The elements that a row of the matrix is about: the link, the joint, for T and C the whole cycle with its
/// mesh, for Q the edges of the cutset.
///
/// Cost: O(length of the cycle), for a cutset O(c).
/// @pre as for explainCell()
[[nodiscard]] std::set<ElementId> elementsOfRow(MatrixKind kind, const Digraph& graph,
                                                const SpanningTree* tree, int row);

/// "−1", "0", "1": with the Unicode minus sign.
[[nodiscard]] std::string printedEntry(int value);

}  // namespace geargraph
