#pragma once

#include <set>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// What Copy takes: the selected links and the ends of the selected arrows, all arrows among them, with their
/// axes, wheels, inputs, couplings and loads. It is a document of its own: its ground is that of `mechanism`,
/// whether selected or not; arrows to the ground come along where the ground is among the selected or is an
/// end of a selected arrow. Cost: O(n + t + c).
[[nodiscard]] Mechanism fragmentOf(const Mechanism& mechanism, const std::set<ElementId>& selected);

/// Does it hold anything but the ground?
[[nodiscard]] bool isEmptyFragment(const Mechanism& fragment);

/// What Paste makes: the fragment's elements behind those that are there, under new ids and with their names;
/// its ground is the ground here. Axes come as new ones, as they are placed. Where pasted nodes would lie on
/// others they are moved right and down together, so that pasting twice gives two copies in sight.
///
/// The new elements are the last of their lists. Refuses schema: a fragment with nothing in it.
[[nodiscard]] Expected<Mechanism> withFragment(Mechanism mechanism, const Mechanism& fragment);

/// The elements of `after` that `before` has not: what a paste selects. Cost: O(n + t + c).
[[nodiscard]] std::set<ElementId> elementsAdded(const Mechanism& before, const Mechanism& after);

}  // namespace geargraph::inline model
