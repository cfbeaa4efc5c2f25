#pragma once

#include "core/presentation/schematic/section.h"

namespace geargraph {

/// Draws the brakes and clutches of a part into free places of its section: two plates that face each other,
/// one on the link, the other on a hatched piece of the frame, or on the other link. A clutch is placed where
/// the two links face each other, else an arm leads from one link to a plate of the other. Couplings of links
/// that are not drawn are left out, as are the remaining ones if `stop` is requested.
void addCouplings(const DrawnPart& part, const SheetLayout& layout, Section& section,
                  const std::stop_token& stop = {});

}  // namespace geargraph
