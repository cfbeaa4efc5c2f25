#pragma once

#include <string>
#include <vector>

#include "core/presentation/diagrams/power_picture.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph {

// The words and colours of power, the same in every view of it.

/// Two ends of a flow that differ by no more than this part of the greater one are drawn as one.
constexpr double kAsOneFlow = 0.02;
/// Below this part of the greatest power a flow is a hairline without a label.
constexpr double kLeastShownPower = 0.01;

/// The colour of a flow: that of the link which delivers most; where none does, of the one that takes most.
/// @pre the flow has ports
[[nodiscard]] Tint tintOfFlow(const DrawnFlow& flow, const Mechanism& mechanism);

/// "495.7 W"; "495.7 W*" where only the assumption of equal stiffness gives it; "? W" where nothing does.
[[nodiscard]] std::string flowText(double power, bool isKnown, bool isAssumed);
/// "49.6 %" of what is fed; empty where nothing is.
[[nodiscard]] std::string shareText(const PowerPicture& picture, double power);

/// A line of the legend: a mark as it is drawn, then words, the first of them bold.
struct LegendLine {
  enum class Mark { widest, circulating, unknown, none };
  Mark mark = Mark::none;
  std::string bold;  ///< may be empty
  std::string plain;
};

/// From top to bottom: the scale and who sees the powers, the greatest loops in which power circulates, what
/// "? W" and the asterisk mean where they are drawn. `largest`: W, of all that is drawn.
[[nodiscard]] std::vector<LegendLine> powerLegend(const PowerPicture& picture, double largest,
                                                  bool hasUnknown, bool hasAssumed);

}  // namespace geargraph
