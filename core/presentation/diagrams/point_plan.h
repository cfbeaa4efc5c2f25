#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/theory/levers/lever_plan.h"

namespace geargraph {

/// Why a plan of points cannot be drawn, as a sentence; empty if it can.
[[nodiscard]] std::string whyNoPointPlan(const Mechanism& mechanism, const LeverPlan& plan);

/// The plane as a coupling projects it.
struct PlanProjection {
  ShiftElementOrdinal coupling = 0;
  double progress = 1;  ///< of the points on their ways, 0 to 1
};

/// The coupling that the document engaged last, if its links are at different points of the plan; that is the
/// projection which is left. @pre both of one mechanism
[[nodiscard]] std::optional<ShiftElementOrdinal> projectingCoupling(const Mechanism& mechanism,
                                                                    const LeverPlan& plan);

/// A plan and where its points are.
struct PointPlanSheet {
  struct Spot {
    std::vector<LinkOrdinal> links;
    CanvasPoint center;
  };
  DisplayList drawing;
  std::vector<Spot> spots;
};

/// The points of a train with two freedoms on its main axis in their plane: gear sets as lines, the ground as
/// a filled point, each coupling as the dotted line along which engaging it projects the plane. The plane is
/// affine: only ratios on lines mean something, so width and height are scaled to the sheet. Of more or fewer
/// freedoms a sentence says how many there are.
///
/// With a projection the points move along the line of its coupling onto one line, the lever that is left;
/// there links at one point turn as one. What coincides is decided in fractions.
/// @pre all of one mechanism; the plan may have held rows, not those of the projection, whose links are at
/// different points
[[nodiscard]] PointPlanSheet pointPlanSheet(const Mechanism& mechanism, const LeverPlan& plan,
                                            const std::optional<PlanProjection>& projection,
                                            const Emphases& emphases);
/// The same with the projection that is left.
[[nodiscard]] DisplayList pointPlanDrawing(const Mechanism& mechanism, const LeverPlan& plan,
                                           const Emphases& emphases);

}  // namespace geargraph
