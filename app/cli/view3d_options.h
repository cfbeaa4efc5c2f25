#pragma once

#include <optional>
#include <string>
#include <variant>

#include "app/cli/arguments.h"
#include "core/presentation/train_stage/stage_labels.h"
#include "core/presentation/train_stage/stage_picture.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph::cli {

/// What `export --view 3d` shows of a stage: camera, moment, section, what is pulled apart, hidden, drawn
/// over, and the film. Labels are those of the snapshot's mechanism.
[[nodiscard]] std::variant<StageShot, UsageError> shotOf(const Arguments& arguments, const StagePtr& stage,
                                                         const AnalysisSnapshot& snapshot);

/// What --show lays over the picture. @pre wrongShot() found nothing
[[nodiscard]] OverlayChoice overlayOf(const Arguments& arguments);

/// What is wrong with the options already before there is a mechanism; nothing where all is well.
[[nodiscard]] std::optional<UsageError> wrongShot(const Arguments& arguments);

}  // namespace geargraph::cli
