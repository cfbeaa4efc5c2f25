#pragma once

#include <span>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"
#include "core/presentation/requests/edit_members.h"

namespace geargraph {

/// One edit that `serve` knows: its name, its members and what it does.
struct DocumentEdit {
  std::string_view name;
  std::span<const RequestMember> members;
  Expected<Mechanism> (*apply)(Mechanism mechanism, EditMembers& of);
};

/// All edits, in the order of the help.
[[nodiscard]] std::span<const DocumentEdit> documentEdits();

/// The document after the edits of a JSON array, applied in order, all or none. Each is an object with the
/// edit's name as the member "edit", and its parameters (resources/schema/README.md); elements are given by
/// ids. Fails like the edits of core, and with `schema` for an unknown edit, a member that the edit does not
/// have, and a missing member; the diagnostic's pointer leads to it.
[[nodiscard]] Expected<Mechanism> withDocumentEdits(Mechanism mechanism, const JsonValue& edits);

/// The names of all edits: "addLink, addTurningJoint, ...".
[[nodiscard]] std::string documentEditNames();

}  // namespace geargraph
