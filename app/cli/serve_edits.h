#pragma once

#include <span>
#include <string>

#include "app/cli/serve_members.h"
#include "core/foundations/base/expected.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// One edit that `serve` knows: its name, its members and what it does.
struct ServedEdit {
  std::string_view name;
  std::span<const ServedMember> members;
  Expected<Mechanism> (*apply)(Mechanism mechanism, EditMembers& of);
};

/// All edits, in the order of the help.
[[nodiscard]] std::span<const ServedEdit> servedEdits();

/// The document after the edits of a JSON array, applied in order, all or none. Each is an object with the
/// edit's name as the member "edit", and its parameters (resources/schema/README.md); elements are given by
/// ids. Fails like the edits of core, and with `schema` for an unknown edit, a member that the edit does not
/// have, and a missing member; the diagnostic's pointer leads to it.
[[nodiscard]] Expected<Mechanism> withServedEdits(Mechanism mechanism, const JsonValue& edits);

/// The names of all edits: "addLink, addTurningJoint, ...".
[[nodiscard]] std::string servedEditNames();

}  // namespace geargraph::cli
