#pragma once

#include "core/mechanism/graph/digraph.h"
#include "core/mechanism/graph/integer_matrix.h"
#include "core/mechanism/graph/spanning_tree.h"

namespace geargraph {

/// Incidence node-edge matrix Γ⁰ [AU, Eq. (1)].
///
/// Shape    (n+1) × (t+c): links 0..n, then turning joints and meshes.
/// Entries  +1 where the edge's arrow ends, -1 where it begins.
/// Identity every column sums to 0.
/// Cost     O(n + t + c) once; a row O(its non-zeros).
[[nodiscard]] IntegerMatrixPtr incidenceMatrix(DigraphPtr graph);

/// Reduced incidence matrix Γ = [G | G*] [AU, Eq. (2)]: Γ⁰ without the ground's row.
///
/// Shape    n × (t+c), partitioned after column t: G the turning block, G* the mesh block. Identity G is
/// square and det G = ±1 exactly if the turning joints are a spanning tree.
[[nodiscard]] IntegerMatrixPtr reducedIncidenceMatrix(DigraphPtr graph);

/// Path matrix Z of the spanning tree [AU, Eq. (3)].
///
/// Shape    t × n: a row per turning joint, a column per link other than the ground.
/// Entries  On the walk from link l to the ground, Z(e,l) is +1 if joint e is passed in its direction, -1 if
/// against it, 0 if e is not on the walk. Identity G·Z = -I, so Z = -G⁻¹.
/// Cost     an entry O(1) from preorder intervals; nothing is stored.
[[nodiscard]] IntegerMatrixPtr pathMatrix(DigraphPtr graph, SpanningTreePtr tree);

/// Spanning-tree matrix T = G*ᵀ Zᵀ [AU, Eq. (4)].
///
/// Shape    c × t.
/// Entries  T(c,e) = Z(e, head of c) - Z(e, tail of c): +1 if the cycle of mesh c, walked tail to head along
/// the
///          mesh and back through the tree, runs along joint e in its direction, -1 if against it.
/// Cost     an entry O(1), a row O(length of the cycle).
[[nodiscard]] IntegerMatrixPtr spanningTreeMatrix(DigraphPtr graph, SpanningTreePtr tree);

/// Cycle-basis matrix C = [T | U] [AU, Eq. (5)]: a row per fundamental cycle, one mesh each.
///
/// Shape    c × (t+c), partitioned after column t. Identity Γ·Cᵀ = 0.
[[nodiscard]] IntegerMatrixPtr cycleBasisMatrix(DigraphPtr graph, SpanningTreePtr tree);

/// Fundamental cutset matrix Q = [U | -Tᵀ]: the row of joint e has the edges between the two components into
/// which the graph is separated without e. Not in the paper, which only names cutset equations.
///
/// Shape    t × (t+c), partitioned after column t. Identity C·Qᵀ = 0.
/// Cost     an entry O(1), a row O(c).
[[nodiscard]] IntegerMatrixPtr cutsetMatrix(DigraphPtr graph, SpanningTreePtr tree);

/// The matrix of this kind; null where it needs a tree and there is none.
[[nodiscard]] IntegerMatrixPtr matrixOf(MatrixKind kind, const DigraphPtr& graph,
                                        const SpanningTreePtr& tree);

}  // namespace geargraph
