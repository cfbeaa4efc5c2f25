#pragma once

#include <string_view>
#include <vector>

#include "core/foundations/base/expected.h"
#include "core/mechanism/model/mechanism.h"

namespace geargraph {

/// Replaces the 3D files attached to a link: a pure function, as in edits.h. Rejects unknown-id, and schema
/// for a path that leads out of the folder or a scale that is not above 0.
[[nodiscard]] Expected<Mechanism> withShapes(Mechanism mechanism, LinkId link, std::vector<LinkShape> shapes);

/// shown-only: one diagnostic with all links that have 3D files. Cost: O(n).
[[nodiscard]] Diagnostics shapeDiagnostics(const Mechanism& mechanism);

/// Is this a relative path that stays inside its folder, judged by its text alone: not empty, not absolute,
/// no address, and no ".." that leads out? True for "parts/../arm.stl".
[[nodiscard]] bool staysInFolder(std::string_view path);

}  // namespace geargraph
