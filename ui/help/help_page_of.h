#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace geargraph::inline ui_help {

/// Property of a widget that says which page is about it ("glossary#rank"); empty: that of its name.
constexpr const char* kHelpPage = "helpPage";

/// The page about a widget, "page" or "page#anchor": its own, else that of the nearest widget around it that
/// has one; empty where none has. Panels, drawings and dialogs have theirs by their object names.
[[nodiscard]] QString helpPageOf(const QWidget* widget);

/// What the panel or drawing of this object name is for, in a sentence; empty for others.
[[nodiscard]] QString purposeOf(const QString& objectName);

/// Every page that is named in the table, to be checked.
[[nodiscard]] QStringList namedPages();

}  // namespace geargraph::inline ui_help
