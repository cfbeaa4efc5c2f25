#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Inserts the set's links, joints, meshes, couplings and states into the document under free ids; its ground
/// becomes the document's. Nodes are shifted by `at`, stated places are moved beside existing ones. An empty
/// document also takes the set's name and inputs; one with inputs gets the set's in addition.
[[nodiscard]] Mechanism withInserted(Mechanism mechanism, const Mechanism& set, CanvasPoint at);

/// A free place for a set's nodes in the digraph: right of those of the document.
[[nodiscard]] CanvasPoint freePlace(const Mechanism& mechanism);

}  // namespace geargraph
