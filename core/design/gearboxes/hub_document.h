#pragma once

#include "core/design/gearboxes/hub_search.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// A hub gear as a document: its sets in series on one axis, one stepped planet of each in its place, module
/// 2 mm; a brake for each sun, clutches A, B, ... that pass the motion through a set or exchange ring and
/// carrier, and a state for each gear, named by its position in the wish. The first gear is engaged and the
/// driver turns at 1 rad/s; ratios of states are driver over hub shell, those of the candidate the inverse.
/// Within the slack the wheels' pitch circles follow from the centre distance.
[[nodiscard]] Mechanism hubDocument(const HubCandidate& candidate);

}  // namespace geargraph
