#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/design/collision/motion_diagnostics.h"
#include "core/foundations/base/diagnostic.h"
#include "core/foundations/files/json_writer.h"
#include "core/presentation/result_json/diagnostics_json.h"

namespace geargraph::cli {

/// One line per diagnostic, in the form of compilers: "robot.geargraph:12:5: error: ... [schema]".
[[nodiscard]] std::string diagnosticLines(std::string_view file, const Diagnostics& diagnostics);

/// Writes the member "motion": what the motion check has covered; null if there was nothing to check.
void writeMotionCheck(JsonWriter& json, const std::optional<MotionReport>& report);
/// The same as one line, in the form of diagnosticLines().
[[nodiscard]] std::string motionCheckLine(std::string_view file, const std::optional<MotionReport>& report);

}  // namespace geargraph::cli
