#pragma once

#include <optional>
#include <string_view>

#include "core/presentation/drawing/display_list.h"

namespace geargraph {

/// A drawing of a bundled example, as the program draws it: "VIEW/EXAMPLE" or "VIEW/EXAMPLE/MARKS".
///
/// VIEW is "digraph", "ttgraph" or "schematic"; MARKS are joined by "+" and are highlighted: "link.4",
/// "joint.8", "mesh.15" by id, "cycle.17" as the walk of the mesh's fundamental cycle, and "links" (the
/// moving ones), "joints", "meshes". std::nullopt if a name is not known.
/// Cost: that of the drawing, milliseconds for the examples.
[[nodiscard]] std::optional<DisplayList> manualPicture(std::string_view name);

}  // namespace geargraph
