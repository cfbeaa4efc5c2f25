#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/presentation/exporters/option_values.h"
#include "core/presentation/mechanism_scene/scene_labels.h"
#include "core/presentation/mechanism_scene/scene_picture.h"
#include "core/theory/analysis/analysis.h"

namespace geargraph {

/// The options of `export --view 3d` for a stage: camera, time, section, exploded view, hidden links,
/// overlays, and the animation. Labels are those of the snapshot's mechanism.
[[nodiscard]] std::variant<SceneRendering, UsageError> renderingFrom(const OptionValues& given,
                                                                     const MechanismScenePtr& stage,
                                                                     const AnalysisSnapshot& snapshot);

/// Width and height from "WxH", each at least kLeastPictureSide and at most `most`.
[[nodiscard]] std::optional<std::pair<int, int>> pictureSize(std::string_view text, int most);
/// The error message for a text that pictureSize() rejects.
[[nodiscard]] std::string wrongSize(std::string_view text, int most);

/// The overlays chosen by --show. @pre renderingUsageError() returns std::nullopt
[[nodiscard]] OverlayChoice overlayOf(const OptionValues& given);

/// Checks the options as far as possible without a mechanism; std::nullopt if they are valid.
[[nodiscard]] std::optional<UsageError> renderingUsageError(const OptionValues& given);

}  // namespace geargraph
