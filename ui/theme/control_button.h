#pragma once

#include <QToolButton>

namespace geargraph {

/// Creates a button of a panel ("Copy ▾"), owned by `parent`. `name`: its object name.
[[nodiscard]] QToolButton* controlButton(const QString& name, const QString& text, const QString& tip,
                                         QWidget* parent);

}  // namespace geargraph
