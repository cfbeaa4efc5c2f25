#pragma once

#include "ui/document/document.h"

namespace geargraph {

// Edits of brakes and clutches, to be applied or only previewed (MenuPreview).

/// Adds an engaged brake that holds the link.
[[nodiscard]] Edit brakeEdit(const Mechanism& now, LinkId link);
/// Adds an engaged clutch that makes both links turn as one.
[[nodiscard]] Edit clutchEdit(LinkId one, LinkId other);
/// Adds a freewheel: `one` may not turn faster than `other`. States find out whether it locks.
[[nodiscard]] Edit freewheelEdit(LinkId one, LinkId other);
[[nodiscard]] Edit engageEdit(const Mechanism& now, ShiftElementId coupling, bool engaged);
/// Engages or releases the brake of the link; adds one if it has none.
[[nodiscard]] Edit toggleBrakeEdit(const Mechanism& now, LinkId link);

}  // namespace geargraph
