#pragma once

#include <string>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/theory/levers/lever_plan.h"

namespace geargraph::inline lever_drawing {

/// Why a plan of points cannot be drawn, as a sentence; empty if it can.
[[nodiscard]] std::string whyNoPointPlan(const Mechanism& mechanism, const LeverPlan& plan);

/// The points of a train with two freedoms on its main axis in their plane: gear sets as lines, the ground as
/// a filled point, each coupling as the dotted line along which engaging it projects the plane. The plane is
/// affine: only ratios on lines mean something, so width and height are scaled to the sheet. Of more or fewer
/// freedoms a sentence says how many there are.
/// @pre all of one mechanism; the plan may have held rows
[[nodiscard]] DisplayList pointPlanDrawing(const Mechanism& mechanism, const LeverPlan& plan,
                                           const Emphases& emphases);

}  // namespace geargraph::inline lever_drawing
