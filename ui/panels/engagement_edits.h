#pragma once

#include "ui/document/document.h"

namespace geargraph {

/// An edit that releases all brakes and clutches. The joints that are freed become inputs at their current
/// speeds.
[[nodiscard]] Edit releaseAllEdit();

}  // namespace geargraph
