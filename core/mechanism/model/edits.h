#pragma once

#include <span>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

// Edits are pure functions: they take the document by value and return the next one, or say why not. A
// refused edit (self-joint, unknown id, ...) changes nothing, because the caller still holds the value it
// had. Ids of new elements are the smallest whole numbers that no element of any list bears, so that the
// three kinds never look alike; the caller finds the new element at the end of its list.

/// A new link at a place of the digraph, tied to nothing yet.
[[nodiscard]] Expected<Mechanism> withLink(Mechanism mechanism, SheetPoint at, std::string name = {});

/// A turning joint from `tail` to `head` on an axis. An empty `axis` makes a new one, not placed yet.
/// Refuses self-joint, unknown-id, and turning-loop: a joint that would close a loop of turning joints.
[[nodiscard]] Expected<Mechanism> withTurningJoint(Mechanism mechanism, LinkId tail, LinkId head,
                                                   AxisId axis = {});

/// A gear mesh from `tail` to `head`. Refuses self-joint, unknown-id, schema (teeth out of 1..100,000).
[[nodiscard]] Expected<Mechanism> withGearMesh(Mechanism mechanism, LinkId tail, LinkId head,
                                               int tailTeeth = 20, int headTeeth = 20);

/// A new link with a gear that meshes with one on `gear`: it turns beside it on `carrier`, about a new axis.
/// The link, its joint and the mesh are the last of their lists. Refuses self-joint, unknown-id.
[[nodiscard]] Expected<Mechanism> withGearAttached(Mechanism mechanism, LinkId gear, LinkId carrier,
                                                   std::optional<SheetPoint> at);

/// Without these elements and all that needs them: a link takes its joints, meshes, wheels, couplings and
/// loads with it, a joint its input and its loads, an axis without use goes too. Refuses to remove
/// the ground.
[[nodiscard]] Expected<Mechanism> withoutElements(Mechanism mechanism, std::span<const ElementId> elements);

/// Tail and head exchanged, for a turning joint or a mesh (with its teeth and wheels).
[[nodiscard]] Expected<Mechanism> withFlipped(Mechanism mechanism, const ElementId& element);

/// Another name for a link, or another id for an axis (refuses duplicate-id and the empty one).
[[nodiscard]] Expected<Mechanism> withName(Mechanism mechanism, const ElementId& element,
                                           const std::string& name);

[[nodiscard]] Expected<Mechanism> withNodesMoved(Mechanism mechanism,
                                                 std::span<const std::pair<LinkId, SheetPoint>> nodes);

/// The same in the T-T graph, whose nodes are laid out until they are dragged.
[[nodiscard]] Expected<Mechanism> withTtNodesMoved(Mechanism mechanism,
                                                   std::span<const std::pair<LinkId, SheetPoint>> nodes);

[[nodiscard]] Expected<Mechanism> withTeeth(Mechanism mechanism, MeshId mesh, int tailTeeth, int headTeeth);

/// The kind that a mesh states, or none: then geometry tells it.
[[nodiscard]] Expected<Mechanism> withMeshKind(Mechanism mechanism, MeshId mesh,
                                               std::optional<MeshKind> kind);

[[nodiscard]] Expected<Mechanism> withPitchPoint(Mechanism mechanism, MeshId mesh,
                                                 std::optional<NumberTriple> pitchPoint);

/// Where an axis lies. Refuses schema: a direction of length 0, what limitDiagnostics() finds.
[[nodiscard]] Expected<Mechanism> withAxisPlaced(Mechanism mechanism, AxisId axis,
                                                 std::optional<NumberTriple> point,
                                                 std::optional<NumberTriple> direction);

/// The joint turns about another axis; an axis without use goes.
[[nodiscard]] Expected<Mechanism> withJointAxis(Mechanism mechanism, JointId joint, AxisId axis);

/// The joints turn about one new axis, which lies where that of the first of them does; axes nobody uses any
/// more go. @pre there are joints
[[nodiscard]] Expected<Mechanism> withNewAxis(Mechanism mechanism, std::span<const JointId> joints);

[[nodiscard]] Expected<Mechanism> withOffset(Mechanism mechanism, JointId joint, const Number& offset);

/// How far the joint may turn; no end: as far as it likes. Refuses schema: limitsProblem().
[[nodiscard]] Expected<Mechanism> withJointLimits(Mechanism mechanism, JointId joint,
                                                  const JointLimits& limits);

/// The driven joints with their speeds, in column order; none leaves the choice to the program.
[[nodiscard]] Expected<Mechanism> withInputs(Mechanism mechanism, std::optional<std::vector<Input>> inputs);

/// The link becomes the ground: it goes to the front of the list, and the labels follow. Refuses schema:
/// loads act on it.
[[nodiscard]] Expected<Mechanism> withGround(Mechanism mechanism, LinkId link);

}  // namespace geargraph::inline model
