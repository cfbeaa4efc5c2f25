#pragma once

#include <QPointer>
#include <QString>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/derivation/glossary.h"

class QAction;
class QMenuBar;

namespace geargraph::inline search {

/// One thing that can be found: a command, an element of the document, a term, or a heading of the manual.
struct SearchEntry {
  QString title;                     ///< "Turning joint 12"
  QString side;                      ///< at the right: a shortcut, or where it stands
  QString haystack;                  ///< folded: what is searched
  QString everydayWords;             ///< folded: what is searched where nothing else is found
  QPointer<QAction> action;          ///< of a command
  std::optional<ElementId> element;  ///< of an element
  std::optional<Term> term;          ///< of a term
  QString page;                      ///< of a heading of the manual: "drawing#tools"
  QString summary;                   ///< of a heading: how what stands below it begins
};

/// Property of an action that shows a panel, and hides it where it is in front. The search only shows it.
constexpr const char* kRevealsPanel = "revealsPanel";

/// A menu's text without its mnemonic and its dots: "&Open…" gives "Open".
[[nodiscard]] QString plainText(const QString& menuText);

/// Every command of the menus, those of submenus under the submenu's name: "Open example: robot".
[[nodiscard]] std::vector<SearchEntry> commandEntries(const QMenuBar& menus);

/// Links, turning joints and meshes by label, name and ends. Cost: O(n + t + c).
[[nodiscard]] std::vector<SearchEntry> elementEntries(const Mechanism& mechanism);

[[nodiscard]] std::vector<SearchEntry> termEntries();

/// Pages and headings of the manual, found by their titles, else by what stands below them. Those of the
/// glossary are terms, not headings.
[[nodiscard]] std::vector<SearchEntry> pageEntries();

/// The command at "File > Export picture", or the menu at "File > Open example"; null where there is none.
[[nodiscard]] QAction* commandAt(const QMenuBar& menus, const QString& path);

}  // namespace geargraph::inline search
