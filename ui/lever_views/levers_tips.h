#pragma once

#include <QString>

#include "core/presentation/diagrams/lever_drawing.h"
#include "ui/lever_views/levers_service.h"

namespace geargraph {

/// What is known of a point under the mouse, and what would be if its couplings were engaged or let go, as
/// rich text. `newest`: has the states with their ratios, or not yet.
[[nodiscard]] QString leverTip(const DrawnLevers& drawn, const Mechanism& mechanism,
                               const AnalysisSnapshot& newest, const LeverSpot& spot);

/// The points of a link on all levers, a line each, for screen readers; empty if it is on none.
[[nodiscard]] QString pointsOfLink(const DrawnLevers& drawn, const Mechanism& mechanism, LinkId link);

/// "State 4: A and E. Output 5: 183/209 = 0.876 ...": what is engaged, and the ratio. @pre there is such a
/// state in both
[[nodiscard]] QString stateTip(const DrawnLevers& drawn, const Mechanism& mechanism, int state);

}  // namespace geargraph
