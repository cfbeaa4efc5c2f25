#pragma once

#include "core/presentation/schematic/section.h"

namespace geargraph::inline schematic {

/// Draws the brakes and clutches of a part into its section, where nothing stands yet: two plates that face
/// each other, the one on the link, the other one on a hatched piece of the frame, or on the other link. A
/// clutch stands where both links face each other, else an arm of the one goes round to a plate of the other.
/// Couplings of links that are not drawn are left out, and those still to come when `stop` is requested.
void addCouplings(const DrawnPart& part, const SheetLayout& layout, Section& section,
                  const std::stop_token& stop = {});

}  // namespace geargraph::inline schematic
