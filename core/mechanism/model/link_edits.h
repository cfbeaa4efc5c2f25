#pragma once

#include <span>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Two links welded to one, and one link divided in two: pure functions, as in edits.h. An input of a joint
// that goes moves with it or is dropped; withLinksWelded() and withLinkDivided() (theory/states) also keep
// the inputs a valid set.

/// Welds `other` to `kept`, which keeps its id, label and colour: joints, meshes, wheels, couplings, states,
/// loads and 3D files of `other` are those of `kept`. If one of them is the ground, that one is kept.
///
/// Turning joints stay a tree. A joint between the two goes. If both turn on a third link, the joint of
/// `other` goes, its input, limits and loads to that of `kept`, and their axes become one line: an axis
/// without a place takes that of the other one; of two places that of `kept` holds, and all that is connected
/// with `other` is moved there. Of meshes that are then equal one is left; a coupling between the two goes.
///
/// Rejects unknown-id; self-joint for one link, and for two that mesh with each other; schema for stated
/// masses, for loads that would act on the ground or in a joint that goes, and for limits that exclude each
/// other; turning-loop if the merged link would turn about two different axes.
/// Cost: O(n + t + c).
[[nodiscard]] Expected<Mechanism> withLinksMerged(Mechanism mechanism, LinkId kept, LinkId other);

/// Divides a link: these joints, meshes and couplings of it, with their wheels, are then those of a new link,
/// the last of its list. A new turning joint, the last of its list, lets the two turn about the axis on which
/// the link is carried: the new link on the link's carrier, or where the carrying joint itself is moved, the
/// link on that carrier. So this undoes a weld of coaxial links.
///
/// `at`: the place of the new node in the digraph. Rejects unknown-id; schema for the ground, for a link that
/// no joint carries, for elements that are not of this link, and if nothing would stay or go.
/// Cost: O(n + t + c).
[[nodiscard]] Expected<Mechanism> withLinkSplit(Mechanism mechanism, LinkId link,
                                                std::span<const ElementId> moving,
                                                std::optional<CanvasPoint> at = {});

/// What withLinkSplit() may take off a link so that the train falls apart there: the joints, meshes and
/// couplings of the link on the side that was drawn last. Empty if all that is on the link hangs together
/// elsewhere as well, or nothing does. Cost: O(n + t + c).
[[nodiscard]] std::vector<ElementId> lastSideOf(const Mechanism& mechanism, LinkId link);

}  // namespace geargraph
