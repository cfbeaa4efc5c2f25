#pragma once

#include <functional>
#include <string>

#include "core/foundations/base/expected.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::cli {

/// The document after the edits of a JSON array, in their order; all of them or none. Each is an object with
/// the member "edit", its name, and what that edit takes (resources/schema/README.md). Elements are named by
/// ids. Fails as the edits of core do, and with `schema` for an edit that is none or lacks a member; the
/// finding's pointer leads to it.
[[nodiscard]] Expected<Mechanism> withServedEdits(Mechanism mechanism, const JsonValue& edits);

/// "addLink, addTurningJoint, ..."
[[nodiscard]] std::string servedEditNames();

}  // namespace geargraph::cli
