#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace geargraph {

/// The property of a widget with its help page ("glossary#rank"); empty: the page of its object name.
constexpr const char* kHelpPage = "helpPage";
/// The property of a widget with its purpose, as a sentence; empty: that of its object name.
constexpr const char* kPurpose = "purpose";

/// The page about a widget, "page" or "page#anchor": its own, else that of the nearest ancestor with one;
/// empty if none has. Panels and drawings bring theirs (ui/workbench), other parts and dialogs have it by
/// object name.
[[nodiscard]] QString helpPageOf(const QWidget* widget);

/// The purpose of a part of the window, as a sentence; empty if it has none of its own.
[[nodiscard]] QString purposeOf(const QWidget& widget);

/// All pages by object name, for tests.
[[nodiscard]] QStringList namedPages();

}  // namespace geargraph
