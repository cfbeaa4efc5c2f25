#pragma once

#include <functional>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// The document after the edits of a JSON array, applied in order, all or none. Each is an object with the
/// edit's name as the member "edit", and its parameters (resources/schema/README.md); elements are given by
/// ids. Fails like the edits of core, and with `schema` for an unknown edit or a missing member; the
/// diagnostic's pointer leads to it.
[[nodiscard]] Expected<Mechanism> withServedEdits(Mechanism mechanism, const JsonValue& edits);

/// The names of all edits: "addLink, addTurningJoint, ...".
[[nodiscard]] std::string servedEditNames();

}  // namespace geargraph::cli
