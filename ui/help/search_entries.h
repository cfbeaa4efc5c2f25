#pragma once

#include <QPointer>
#include <QString>
#include <optional>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/derivation/glossary.h"
#include "ui/document/document.h"

class QAction;
class QMenuBar;

namespace geargraph {

/// A searchable entry: a command, an element of the document, a term, a heading of the manual, or the answer
/// to a question (search_answers.h).
struct SearchEntry {
  QString title;                     ///< "Turning joint 12"
  QString side;                      ///< shown at the right: a shortcut or a location
  QString haystack;                  ///< the searched text, folded
  QString synonyms;                  ///< synonyms, folded; searched if nothing else is found
  QPointer<QAction> action;          ///< of a command
  std::optional<ElementId> element;  ///< of an element
  std::optional<Term> term;          ///< of a term
  QString page;                      ///< of a heading of the manual: "drawing#tools"
  QString summary;                   ///< of a heading: the beginning of its section
  bool isAnswer = false;             ///< of a question: choosing it selects `elements`
  std::vector<ElementId> elements;   ///< of an answer, or of an edit
  std::optional<Edit> edit;          ///< what is done to the document
  QString detail;                    ///< of an answer or an edit
};

/// The property of an action that shows a panel, or hides it if it is in front. The search only shows it.
constexpr const char* kRevealsPanel = "revealsPanel";

/// The property of an action with its synonyms in English ("brake" for the gearbox panel), by which it is
/// found if nothing else is.
constexpr const char* kSearchWords = "searchWords";

/// The text of a menu entry without mnemonic and ellipsis: "&Open…" gives "Open".
[[nodiscard]] QString plainText(const QString& menuText);

/// All commands of the menus; those of submenus have the submenu's name as a prefix: "Open example: robot".
[[nodiscard]] std::vector<SearchEntry> commandEntries(const QMenuBar& menus);

/// Links, turning joints and meshes by label, name and ends. Cost: O(n + t + c).
[[nodiscard]] std::vector<SearchEntry> elementEntries(const Mechanism& mechanism);

[[nodiscard]] std::vector<SearchEntry> termEntries();

/// The pages and headings of the manual, found by their titles, else by the text below them. Those of the
/// glossary are left out, since they are terms.
[[nodiscard]] std::vector<SearchEntry> pageEntries();

/// The command at "File > Export picture", or the menu at "File > Open example"; null if there is none.
[[nodiscard]] QAction* commandAt(const QMenuBar& menus, const QString& path);

}  // namespace geargraph
