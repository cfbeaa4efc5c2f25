#pragma once

#include <span>
#include <variant>
#include <vector>

#include "core/presentation/print_kit/print_kit.h"

namespace geargraph {

/// The parts laid on as few plates as shelves take: by the bounds of each part, turned by a quarter where
/// that is flatter, or by as much as makes a part that is too long fit. An error names the first part that is
/// larger than the plate. Cost: O(parts^2) and a look at every vertex.
[[nodiscard]] std::variant<std::vector<KitPlate>, KitFailure> platesFor(std::span<const KitPart> parts,
                                                                        const KitOptions& options);

/// The smallest box around a part on its plate, about the origin of its print frame turned by `turn`.
[[nodiscard]] Eigen::AlignedBox2d footprint(const KitPart& part, double turn);

}  // namespace geargraph
