#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/cli/arguments.h"
#include "core/presentation/train_stage/stage_labels.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// The options of `export --view 3d` for a stage: camera, time, section, exploded view, hidden links,
/// overlays, and the animation. Labels are those of the snapshot's mechanism.
[[nodiscard]] std::variant<StageRendering, UsageError> renderingFrom(const Arguments& arguments,
                                                                     const StagePtr& stage,
                                                                     const AnalysisSnapshot& snapshot);

/// The overlays chosen by --show. @pre renderingUsageError() returns std::nullopt
[[nodiscard]] OverlayChoice overlayOf(const Arguments& arguments);

/// Checks the options as far as possible without a mechanism; std::nullopt if they are valid.
[[nodiscard]] std::optional<UsageError> renderingUsageError(const Arguments& arguments);

}  // namespace geargraph::cli
