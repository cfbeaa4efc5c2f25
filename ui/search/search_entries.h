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

/// One thing that can be found: a command, an element of the document, or a term.
struct SearchEntry {
  QString title;                     ///< "Turning joint 12"
  QString side;                      ///< at the right: a shortcut, or where it stands
  QString haystack;                  ///< folded: what is searched
  QString everydayWords;             ///< folded: what is searched where nothing else is found
  QPointer<QAction> action;          ///< of a command
  std::optional<ElementId> element;  ///< of an element
  std::optional<Term> term;          ///< of a term
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

}  // namespace geargraph::inline search
