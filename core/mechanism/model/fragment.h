#pragma once

#include <set>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// The part of a mechanism that Copy takes: the selected links and the ends of the selected joints and
/// meshes, all joints and meshes between them, with their axes, wheels, inputs, couplings and loads. It is a
/// document of its own: its ground is that of `mechanism`, whether selected or not; joints and meshes of the
/// ground are included if the ground is selected or is an end of a selected one. Cost: O(n + t + c).
[[nodiscard]] Mechanism fragmentOf(const Mechanism& mechanism, const std::set<ElementId>& selected);

/// Has the fragment nothing but the ground?
[[nodiscard]] bool isEmptyFragment(const Mechanism& fragment);

/// Paste: appends the fragment's elements under new ids, with their names; its ground becomes the ground of
/// `mechanism`. Axes are added as new ones with their places. Pasted nodes that would cover others are moved
/// right and down together, so that two pastes give two visible copies.
///
/// The new elements are the last of their lists. Rejects schema if the fragment is empty.
[[nodiscard]] Expected<Mechanism> withFragment(Mechanism mechanism, const Mechanism& fragment);

/// The elements of `after` that are not in `before`: what is selected after a paste. Cost: O(n + t + c).
[[nodiscard]] std::set<ElementId> elementsAdded(const Mechanism& before, const Mechanism& after);

}  // namespace geargraph
