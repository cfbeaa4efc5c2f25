#pragma once

#include <stop_token>
#include <vector>

#include "core/design/atlas/chain.h"

namespace geargraph {

/// Every tree of this many links and any number of axes, up to isomorphism, as chains without meshes: grown
/// by one link at a time on an axis that is there or on a new one. 1, 1, 2, 4, 9, 22 for 1..6 links.
/// Empty if `stop` was requested.
[[nodiscard]] std::vector<Chain> axisTrees(int links, const std::stop_token& stop = {});

/// Every nondegenerate chain of this many links and freedoms, up to isomorphism of the displacement graph.
/// Links are named so that carriers of many gear pairs come first. Ordered in groups of the same rotation
/// graph; groups by the fewest axes, chains of a group by their axes.
///
/// Meshes are added one at a time, and isomorphic chains are dropped at every level: what is degenerate with
/// some meshes is so with more. Empty if `stop` was requested.
/// Cost: 0.02 s for 6 links, 0.3 s for 7, 5 s for 8. @pre 3 <= links <= 9, 1 <= dof <= links - 2
[[nodiscard]] std::vector<std::vector<Chain>> enumerateChains(int links, int dof,
                                                              const std::stop_token& stop = {});

/// The minimal degenerate chains of this many links, up to isomorphism: trains that cannot turn although each
/// of them without any of its gear pairs could. Their links - 1 meshes lock all links, and no fewer lock any.
/// Named, grouped and ordered as those of enumerateChains(). Empty if `stop` was requested.
/// Cost: as there. @pre 4 <= links <= 9
[[nodiscard]] std::vector<std::vector<Chain>> enumerateLockedChains(int links,
                                                                    const std::stop_token& stop = {});

}  // namespace geargraph
