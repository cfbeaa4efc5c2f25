#pragma once

#include <span>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits of many elements at once, in one pass: one edit after the other would search the mechanism for each.

/// Exchanges tail and head of all these turning joints and meshes, as withFlipped() does for one. Rejects
/// unknown-id.
/// Cost: O(elements + joints + meshes).
[[nodiscard]] Expected<Mechanism> withAllFlipped(Mechanism mechanism, std::span<const ElementId> elements);

}  // namespace geargraph
