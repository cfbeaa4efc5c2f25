#pragma once

#include <QIcon>
#include <QString>

#include "core/foundations/base/diagnostic.h"
#include "core/presentation/drawing/palette.h"

namespace geargraph::inline theme {

/// An icon of resources/icons, drawn in a colour of the theme. The drawing says `currentColor` where it means
/// that colour.
[[nodiscard]] QIcon icon(const QString& name, ColorRole role, Theme theme);
[[nodiscard]] QPixmap iconPixmap(const QString& name, ColorRole role, Theme theme, int pixels,
                                 qreal devicePixelRatio);

/// The icon of a finding's severity; the shapes differ, not only the colours.
[[nodiscard]] QString severityIconName(Severity severity);
[[nodiscard]] ColorRole severityRole(Severity severity);

/// The program's own icon.
[[nodiscard]] QIcon applicationIcon();

}  // namespace geargraph::inline theme
