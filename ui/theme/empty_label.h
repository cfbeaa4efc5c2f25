#pragma once

#include <QLabel>

namespace geargraph {

/// Creates the label, owned by `parent`, that a panel shows in its centre while it is empty.
[[nodiscard]] QLabel* emptyLabel(QWidget* parent, const QString& text = {});

}  // namespace geargraph
