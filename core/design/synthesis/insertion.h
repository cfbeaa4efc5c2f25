#pragma once

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline synthesis {

/// The set's links, joints, meshes, couplings and states in the document, under ids that are free there; its
/// ground is the document's. Nodes are shifted by `at`, stated places beside what is there. A document of the
/// ground alone takes name and inputs, too; one with inputs gets the set's besides.
[[nodiscard]] Mechanism withInserted(Mechanism mechanism, const Mechanism& set, SheetPoint at);

/// Where a set's nodes do not lie on those of the document: right of them.
[[nodiscard]] SheetPoint freePlace(const Mechanism& mechanism);

}  // namespace geargraph::inline synthesis
