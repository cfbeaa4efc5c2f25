#pragma once

#include <QToolButton>

namespace geargraph::inline theme {

/// A button of a panel: "Copy ▾".
[[nodiscard]] QToolButton* controlButton(const QString& name, const QString& text, const QString& tip,
                                         QWidget* parent);

}  // namespace geargraph::inline theme
