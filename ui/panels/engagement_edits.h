#pragma once

#include "ui/document/document.h"

namespace geargraph::inline panels {

/// Releases every brake and clutch; the joints that come free are driven as fast as they turn.
[[nodiscard]] Edit releaseAllEdit();

}  // namespace geargraph::inline panels
