#pragma once

#include <cstdint>
#include <vector>

#include "core/mechanism/graph/integer_matrix.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::test {

/// The digraph of the paper's robot [AU, Fig. 2] with its teeth, ids equal to the paper's labels; axes a..e
/// without places (the example file has them).
[[nodiscard]] Mechanism robotTopology();

/// A mechanism of `n` moving links whose turning joints are a random tree, with joints pointing either way,
/// their order in the file shuffled, and `c` meshes between random pairs of links. Well formed; not a gear
/// train.
[[nodiscard]] Mechanism randomTree(std::uint64_t seed, int n, int c);

using Dense = std::vector<std::vector<int>>;

/// The matrix entry by entry.
[[nodiscard]] Dense dense(const IntegerMatrix& matrix);
/// The matrix row by row from its non-zeros.
[[nodiscard]] Dense denseFromRows(const IntegerMatrix& matrix);
[[nodiscard]] Dense product(const Dense& a, const Dense& b);
[[nodiscard]] Dense transposed(const Dense& a);
/// Columns first..last-1.
[[nodiscard]] Dense columnsOf(const Dense& a, int first, int last);

}  // namespace geargraph::test
