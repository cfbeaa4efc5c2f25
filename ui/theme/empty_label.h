#pragma once

#include <QLabel>

namespace geargraph::inline theme {

/// What a panel says in its middle while it has nothing to show.
[[nodiscard]] QLabel* emptyLabel(QWidget* parent, const QString& text = {});

}  // namespace geargraph::inline theme
