#pragma once

#include "ui/document/document.h"

namespace geargraph::inline panels {

/// An edit that releases all brakes and clutches. The joints that are freed become inputs at their current
/// speeds.
[[nodiscard]] Edit releaseAllEdit();

}  // namespace geargraph::inline panels
