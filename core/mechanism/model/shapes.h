#pragma once

#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph::inline model {

/// The 3D files that are attached to a link, in place of those it had: a pure function, as in edits.h.
/// Rejects unknown-id, and schema for a path that leads out of the folder or a scale that is not above 0.
[[nodiscard]] Expected<Mechanism> withShapes(Mechanism mechanism, LinkId link, std::vector<LinkShape> shapes);

/// A path that stays in the folder that it starts from, by its words: not empty, not from the root of a disk
/// or of an address, and no ".." that leads out. "parts/../arm.stl" stays.
[[nodiscard]] bool staysInFolder(std::string_view path);

}  // namespace geargraph::inline model
