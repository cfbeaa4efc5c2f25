#pragma once

#include "core/mechanism/document_format/json_object.h"
#include "core/mechanism/model/member_info.h"

namespace geargraph {

/// What the editor remembers of its drawings, from the member of the document that `info` describes.
[[nodiscard]] View readView(JsonDiagnostics& diagnostics, const MemberInfo& info, JsonValue value);

}  // namespace geargraph
