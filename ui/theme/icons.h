#pragma once

#include <QIcon>
#include <QString>

#include "core/foundations/base/diagnostic.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph {

/// An icon of resources/icons in a colour of the theme, which replaces `currentColor` in the SVG.
[[nodiscard]] QIcon icon(const QString& name, ColorRole role, Theme theme);
[[nodiscard]] QPixmap iconPixmap(const QString& name, ColorRole role, Theme theme, int pixels,
                                 qreal devicePixelRatio);

/// The icon of a diagnostic's severity; icons differ in shape, not only in colour.
[[nodiscard]] QString severityIconName(Severity severity);
[[nodiscard]] ColorRole severityRole(Severity severity);

/// The icon of the program.
[[nodiscard]] QIcon applicationIcon();

}  // namespace geargraph
