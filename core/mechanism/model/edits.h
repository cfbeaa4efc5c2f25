#pragma once

#include <span>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Edits are pure functions: they take the document by value and return the next one, or an error. A rejected
// edit (self-joint, unknown id, ...) changes nothing, because the caller still has the old value. Ids of new
// elements are the smallest whole numbers that no link, turning joint or mesh has, so that the three kinds
// cannot be confused; the new element is the last of its list.

/// A new link at a place in the digraph's drawing, not connected yet.
[[nodiscard]] Expected<Mechanism> withLink(Mechanism mechanism, CanvasPoint at, std::string name = {});

/// A turning joint from `tail` to `head` on an axis. An empty `axis` makes a new one, not placed yet.
/// Rejects self-joint, unknown-id, and turning-loop: a joint that would close a loop of turning joints.
[[nodiscard]] Expected<Mechanism> withTurningJoint(Mechanism mechanism, LinkId tail, LinkId head,
                                                   AxisId axis = {});

/// A gear mesh from `tail` to `head`. Rejects self-joint, unknown-id, schema (teeth out of 1..100,000).
[[nodiscard]] Expected<Mechanism> withGearMesh(Mechanism mechanism, LinkId tail, LinkId head,
                                               int tailTeeth = 20, int headTeeth = 20);

/// A new link with a gear that meshes with one on `gear`: the new link turns on `carrier` about a new axis.
/// The link, its joint and the mesh are the last of their lists. Rejects self-joint, unknown-id.
[[nodiscard]] Expected<Mechanism> withGearAttached(Mechanism mechanism, LinkId gear, LinkId carrier,
                                                   std::optional<CanvasPoint> at);

/// Removes these elements and all that depends on them: with a link its joints, meshes, wheels, couplings and
/// loads, with a joint its input and its loads; unused axes too. Rejects removing the ground.
[[nodiscard]] Expected<Mechanism> withoutElements(Mechanism mechanism, std::span<const ElementId> elements);

/// Exchanges tail and head of a turning joint or a mesh (with its teeth and wheels).
[[nodiscard]] Expected<Mechanism> withFlipped(Mechanism mechanism, const ElementId& element);

/// Renames a link, or changes the id of an axis (rejects duplicate-id and an empty id).
[[nodiscard]] Expected<Mechanism> withName(Mechanism mechanism, const ElementId& element,
                                           const std::string& name);

[[nodiscard]] Expected<Mechanism> withNodesMoved(Mechanism mechanism,
                                                 std::span<const std::pair<LinkId, CanvasPoint>> nodes);

/// The same in the T-T graph, whose nodes are laid out automatically until they are dragged.
[[nodiscard]] Expected<Mechanism> withTtNodesMoved(Mechanism mechanism,
                                                   std::span<const std::pair<LinkId, CanvasPoint>> nodes);

/// Sets the tooth counts and nothing else; withTeethFitted() (fitting) keeps the geometry consistent. Rejects
/// unknown-id, schema.
[[nodiscard]] Expected<Mechanism> withTeeth(Mechanism mechanism, MeshId mesh, int tailTeeth, int headTeeth);

/// Sets the stated kind of a mesh; none: it follows from the geometry.
[[nodiscard]] Expected<Mechanism> withMeshKind(Mechanism mechanism, MeshId mesh,
                                               std::optional<MeshKind> kind);

/// The helix of a mesh's teeth, of the tail's gear: degrees from 0 on below 90, none: straight teeth (or what
/// the kind makes of it). Rejected: other angles.
[[nodiscard]] Expected<Mechanism> withHelixAngle(Mechanism mechanism, MeshId mesh,
                                                 std::optional<Number> degrees);
[[nodiscard]] Expected<Mechanism> withHand(Mechanism mechanism, MeshId mesh, std::optional<Hand> hand);
[[nodiscard]] Expected<Mechanism> withHerringbone(Mechanism mechanism, MeshId mesh, bool herringbone);
/// Lets the strands of a belt cross, or no longer. @pre its kind can
[[nodiscard]] Expected<Mechanism> withCrossed(Mechanism mechanism, MeshId mesh, bool crossed);
[[nodiscard]] Expected<Mechanism> withPitchPoint(Mechanism mechanism, MeshId mesh,
                                                 std::optional<NumberTriple> pitchPoint);

/// States the point and direction of an axis; none leaves them to the program. Rejects schema: a direction of
/// length 0, and what limitDiagnostics() finds.
[[nodiscard]] Expected<Mechanism> withAxisPlaced(Mechanism mechanism, AxisId axis,
                                                 std::optional<NumberTriple> point,
                                                 std::optional<NumberTriple> direction);

/// Puts the joint on another axis; an axis that is no longer used is removed.
[[nodiscard]] Expected<Mechanism> withJointAxis(Mechanism mechanism, JointId joint, AxisId axis);

/// Puts the joints on one new axis, placed like that of the first of them; axes that are no longer used are
/// removed. @pre `joints` is not empty
[[nodiscard]] Expected<Mechanism> withNewAxis(Mechanism mechanism, std::span<const JointId> joints);

[[nodiscard]] Expected<Mechanism> withOffset(Mechanism mechanism, JointId joint, const Number& offset);

/// Sets the limits of the joint; an end without a number is unlimited. Rejects schema: limitsProblem().
[[nodiscard]] Expected<Mechanism> withJointLimits(Mechanism mechanism, JointId joint,
                                                  const JointLimits& limits);

/// The driven joints with their speeds, in column order; none leaves the choice to the program.
[[nodiscard]] Expected<Mechanism> withInputs(Mechanism mechanism, std::optional<std::vector<Input>> inputs);

/// Makes the link the ground: it moves to the front of the list, which changes the labels. Rejects schema if
/// loads act on it.
[[nodiscard]] Expected<Mechanism> withGround(Mechanism mechanism, LinkId link);

}  // namespace geargraph
