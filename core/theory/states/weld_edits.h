#pragma once

#include <optional>
#include <span>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Welds and splits of links after which the inputs are a valid set of the train as engaged: those that the
// others now determine are no longer driven, and a joint that becomes free is driven at its present speed.
// Inputs that the document leaves to the program stay so. Cost: two eliminations of the train.

/// withLinksMerged() (model/link_edits.h), inputs included.
[[nodiscard]] Expected<Mechanism> withLinksWelded(const Mechanism& mechanism, LinkId kept, LinkId other);

/// withLinkSplit() (model/link_edits.h), inputs included: the motion goes on, and the two parts may now be
/// driven at different speeds.
[[nodiscard]] Expected<Mechanism> withLinkDivided(const Mechanism& mechanism, LinkId link,
                                                  std::span<const ElementId> moving,
                                                  std::optional<CanvasPoint> at = {});

}  // namespace geargraph
