#pragma once

#include <vector>

#include "core/machine/body_layout/body_recipe.h"
#include "core/presentation/brep/brep.h"

namespace geargraph {

/// The parts of a body by their exact faces, in the base frame and the unit of its lengths. Like the shells
/// of madeBy() they overlap where they are joined. Cost: O(parts)
[[nodiscard]] std::vector<Brep> bodyBreps(const BodyRecipe& recipe);

}  // namespace geargraph
