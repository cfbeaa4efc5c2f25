#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

// Elements as JSON objects with the members of the document, for edits that are given as JSON. `Element` is
// Link, Axis, TurningJoint, GearMesh, Wheel, Coupling, ShiftState or Load; of elementFrom() it is Axis,
// Wheel, Coupling or Load.

/// The element as a document has it, in one line.
template <class Element>
[[nodiscard]] std::string elementJson(const Element& element);

/// Chooses members of an object by their names.
using MemberFilter = std::function<bool(std::string_view name)>;

/// The element that an object describes; members for which `isMember` is false do not count. Rejects schema
/// for a value of the wrong type, a required member that is missing, and a member that such an element does
/// not have; pointers begin with `pointer`. What the elements are together is not checked here
/// (wellFormedDiagnostics()). Cost: O(members).
template <class Element>
[[nodiscard]] Expected<Element> elementFrom(JsonValue members, const MemberFilter& isMember,
                                            const std::string& pointer);

/// The element with members of the object `changes` instead of its own; null removes a member. Rejects as
/// elementFrom(), except that members which the element had already and the program does not know stay.
template <class Element>
[[nodiscard]] Expected<Element> withMembers(const Element& element, JsonValue changes,
                                            const MemberFilter& isMember, const std::string& pointer);

/// The document with members of the object `changes` instead of its own, in the same way. Rejects what
/// readMechanism() rejects. Cost: O(document).
[[nodiscard]] Expected<Mechanism> withDocumentMembers(const Mechanism& mechanism, JsonValue changes,
                                                      const MemberFilter& isMember);

}  // namespace geargraph
