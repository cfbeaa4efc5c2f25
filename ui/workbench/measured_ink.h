#pragma once

#include <QColor>

namespace geargraph {

/// The colour of what is measured: that of the selection.
[[nodiscard]] QColor measuredInk(bool isDark);

}  // namespace geargraph
