#pragma once

#include "core/foundations/base/diagnostic.h"
#include "core/foundations/files/json_writer.h"

namespace geargraph {

/// The value of the member "diagnostics": severity, code, message, the ids by their lists; for collisions in
/// motion the time; for diagnostics about the text of the file pointer, line and column.
void writeDiagnostics(JsonWriter& json, const Diagnostics& diagnostics);

}  // namespace geargraph
