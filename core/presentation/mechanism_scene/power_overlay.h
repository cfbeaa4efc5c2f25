#pragma once

#include <set>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/mechanism_scene/train_power.h"
#include "core/presentation/scene3d/scene_view.h"

namespace geargraph {

/// The arrows of power over a picture of the solids, in logical pixels from its upper left corner: as wide as
/// their power, in the colours of the bands, what circulates in accent within them, what is not determined as
/// dashed lines. Beside their tips which links they go from and to, and their power; a legend on the upper
/// left from `top` on. `base`: where the base frame is seen (basePose()). Labels of `highlighted` elements
/// come first. Cost: O(arrows^2) for up to 40 arrows, beyond that O(arrows).
[[nodiscard]] DisplayList powerOver(const ScenePower& power, const LabelGround& ground, const Pose& base,
                                    double top, const std::set<ElementId>& highlighted = {});

/// Where the base frame of a stage is in this view.
[[nodiscard]] Pose basePose(const MechanismScene& stage, const SceneView& view);

}  // namespace geargraph
