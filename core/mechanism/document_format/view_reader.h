#pragma once

#include <string>
#include <vector>

#include "core/mechanism/document_format/json_object.h"

namespace geargraph::inline document_format {

/// The 3D files attached to a link, from its member `shapes`; diagnostics name the link.
[[nodiscard]] std::vector<LinkShape> readShapes(JsonDiagnostics& diagnostics, JsonValue list,
                                                const std::string& pointer, LinkId link);

/// What the editor remembers of its drawings, from the member `view` of the document.
[[nodiscard]] View readView(JsonDiagnostics& diagnostics, JsonValue value);

}  // namespace geargraph::inline document_format
