#pragma once

#include <string>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/schematic/schematic.h"
#include "core/theory/levers/speed_plan.h"

namespace geargraph {

/// Why Kutzbach's speed plan cannot be drawn, as a sentence; empty if it can.
[[nodiscard]] std::string whyNoSpeedPlan(const SpeedPlan& plan);

/// The functional schematic, and beside it at the same scale Kutzbach's speed plan: for each link a straight
/// line of peripheral velocity over radius, points where links meet at teeth and at axes that one of them
/// carries. A dotted line leads there from the teeth in the section where these are at the same height; where
/// the section is unrolled in another way they are not. Links and meshes can be picked. A plan that cannot
/// be drawn is a sentence.
/// @pre all of one mechanism; `unit` is the document's
[[nodiscard]] DisplayList speedPlanDrawing(const Mechanism& mechanism, const Placement& placement,
                                           const SpeedPlan& plan, const SchematicGeometry& section,
                                           const Emphases& emphases);

}  // namespace geargraph
