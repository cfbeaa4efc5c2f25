#pragma once

#include "core/presentation/drawing/display_list.h"
#include "core/presentation/drawing/emphasis.h"
#include "core/presentation/lever_drawing/lever_picture.h"

namespace geargraph::inline lever_drawing {

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

}  // namespace geargraph::inline lever_drawing
