#pragma once

#include <optional>
#include <vector>

#include "core/presentation/diagrams/lever_layout.h"
#include "core/presentation/diagrams/lever_picture.h"
#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"

namespace geargraph {

/// What is shown of a lever diagram besides its bars.
struct LeverLook {
  bool speeds = true;
  bool torques = true;
  bool numbers = true;  ///< at the arrows
  /// px on the sheet for 1 rad/s; none: the greatest speed has a fixed length.
  std::optional<double> speedScale = {};
};

/// A point of a bar on the sheet.
struct LeverSpot {
  int lever = 0;       ///< of the plan
  int point = 0;       ///< of the lever
  int bar = 0;         ///< from the left
  CanvasPoint at;      ///< its exact place on the bar
  CanvasPoint center;  ///< of its disc: there, or beside the bar where points nearly coincide
  CanvasPoint tip;     ///< of its speed; `at` where no speeds are shown
};

/// A lever diagram and where its points are.
struct LeverSheet {
  DisplayList drawing;
  std::vector<LeverSpot> spots;  ///< bar by bar from the left, each from the top
  double speedScale = 0;         ///< px on the sheet for 1 rad/s; 0 where no speeds are shown
};

/// leverDrawing() by a layout that is known already. Cost: near linear in points.
/// @pre the layout is leverLayout() of the mechanism and the picture's plan
[[nodiscard]] LeverSheet leverSheet(const Mechanism& mechanism, const LeverPicture& picture,
                                    const LeverLayout& layout, const Emphases& emphases,
                                    const LeverLook& look = {});

/// The lever diagram: a vertical bar a lever with its points at their exact places, shared points level on
/// bands of their links' colours, the ground and held links as pivots, letters of couplings at their links.
/// With a motion arrows to the right are speeds and a straight line runs through their tips; with loads
/// arrows to the left of the bars are the torques of the links on the lever. What only the document's tooth
/// counts put on a lever is dashed. Without a lever a sentence says why. Points of equal links that turn as
/// one are one disc.
///
/// No text touches another text, a disc or a letter. Links and couplings can be picked.
/// Cost: leverLayout(), and near linear in points. @pre all of one mechanism
[[nodiscard]] DisplayList leverDrawing(const Mechanism& mechanism, const LeverPicture& picture,
                                       const Emphases& emphases);

}  // namespace geargraph
