#pragma once

#include "ui/document/document.h"

namespace geargraph::inline canvas {

// What brakes and clutches do, as steps of the undo list: to be applied, or only tried (MenuPreview).

/// A new brake holds the link.
[[nodiscard]] Edit holdEdit(const Mechanism& now, LinkId link);
/// A new clutch makes both links turn as one.
[[nodiscard]] Edit tieEdit(LinkId one, LinkId other);
[[nodiscard]] Edit engageEdit(const Mechanism& now, CouplingId coupling, bool engaged);
/// Engages the brake of the link, a new one where it has none, or releases it.
[[nodiscard]] Edit toggleBrakeEdit(const Mechanism& now, LinkId link);

}  // namespace geargraph::inline canvas
