#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace geargraph::inline ui_help {

/// The property of a widget with its help page ("glossary#rank"); empty: the page of its object name.
constexpr const char* kHelpPage = "helpPage";

/// The page about a widget, "page" or "page#anchor": its own, else that of the nearest ancestor with one;
/// empty if none has. Panels, drawings and dialogs have theirs by object name.
[[nodiscard]] QString helpPageOf(const QWidget* widget);

/// The purpose of the panel or drawing with this object name, as a sentence; empty for others.
[[nodiscard]] QString purposeOf(const QString& objectName);

/// All pages in the table, for tests.
[[nodiscard]] QStringList namedPages();

}  // namespace geargraph::inline ui_help
