#pragma once

#include <QString>

#include "core/drawing/palette.h"

namespace geargraph {

/// The style sheet of the program in the colours of a theme. Widgets ask for a look by the dynamic property
/// "look": "chip" (a rounded button), "tool" (a tool of the tool bar), "card" (a framed note), "hint"
/// (secondary text), "title", "problem".
[[nodiscard]] QString styleSheetOf(Theme theme);

}  // namespace geargraph
