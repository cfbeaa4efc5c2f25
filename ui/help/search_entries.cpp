#include "ui/help/search_entries.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>
#include <unordered_map>

#include "core/foundations/base/translation.h"
#include "core/presentation/manual/manual.h"
#include "ui/help/word_match.h"

namespace geargraph {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("search", text);
}

QString shownEntry(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

void addCommands(const QMenu& menu, const QString& path, std::vector<SearchEntry>& entries) {
  for (QAction* action : menu.actions()) {
    const QString text = plainText(action->text());
    if (action->isSeparator() || !action->isVisible() || text.isEmpty()) continue;
    if (const QMenu* inner = action->menu()) {
      addCommands(*inner, text + QStringLiteral(": "), entries);
      continue;
    }
    SearchEntry entry;
    entry.title = path + text;
    entry.side = action->shortcut().toString(QKeySequence::NativeText);
    if (entry.side.isEmpty()) entry.side = action->text().section(QLatin1Char('\t'), 1);
    entry.haystack = foldedText(entry.title + QLatin1Char(' ') + plainText(menu.title()));
    entry.synonyms = foldedText(action->property(kSearchWords).toString());
    entry.action = action;
    entries.push_back(std::move(entry));
  }
}

SearchEntry elementEntry(const QString& title, const QString& side, const ElementId& element) {
  SearchEntry entry;
  entry.title = title;
  entry.side = side;
  entry.haystack = foldedText(title);
  entry.element = element;
  return entry;
}

}  // namespace

QString plainText(const QString& menuText) {
  QString text = menuText.section(QLatin1Char('\t'), 0, 0);
  text.remove(QLatin1Char('&'));
  if (text.endsWith(QStringLiteral("…"))) text.chop(1);
  return text;
}

std::vector<SearchEntry> commandEntries(const QMenuBar& menus) {
  std::vector<SearchEntry> entries;
  for (const QAction* top : menus.actions()) {
    if (top->menu() != nullptr) addCommands(*top->menu(), {}, entries);
  }
  return entries;
}

std::vector<SearchEntry> elementEntries(const Mechanism& mechanism) {
  std::vector<SearchEntry> entries;
  std::unordered_map<LinkId, QString> labels;
  for (int i = 0; i <= mechanism.n(); ++i) {
    const Link& link = mechanism.links[static_cast<std::size_t>(i)];
    const QString label = QString::number(mechanism.linkLabel(i));
    labels.emplace(link.id, label);
    QString title = i == 0 ? tr("Link 0, the ground") : tr("Link %1").arg(label);
    if (!link.name.empty()) title += QStringLiteral(": ") + shownEntry(link.name);
    entries.push_back(elementEntry(title, {}, link.id));
  }
  const QString arrow = QStringLiteral("%1 → %2");
  for (int i = 0; i < mechanism.t(); ++i) {
    const TurningJoint& joint = mechanism.turningJoints[static_cast<std::size_t>(i)];
    entries.push_back(elementEntry(tr("Turning joint %1").arg(mechanism.jointLabel(i)),
                                   arrow.arg(labels[joint.tail], labels[joint.head]), joint.id));
  }
  for (int i = 0; i < mechanism.c(); ++i) {
    const GearMesh& mesh = mechanism.gearMeshes[static_cast<std::size_t>(i)];
    entries.push_back(elementEntry(tr("Gear mesh %1").arg(mechanism.meshLabel(i)),
                                   arrow.arg(labels[mesh.tail], labels[mesh.head]), mesh.id));
  }
  for (const CanvasNote& note : mechanism.view.notes)
    entries.push_back(elementEntry(tr("Note: %1").arg(shownEntry(note.text).simplified()), {}, note.id));
  return entries;
}

std::vector<SearchEntry> termEntries() {
  std::vector<SearchEntry> entries;
  for (const Definition& definition : glossary()) {
    SearchEntry entry;
    entry.title = shownEntry(translated(definition.name));
    entry.side = shownEntry(definition.symbol);
    entry.haystack = foldedText(entry.title + QLatin1Char(' ') + entry.side);
    entry.term = definition.term;
    entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<SearchEntry> pageEntries() {
  constexpr qsizetype kSummary = 160;
  std::vector<SearchEntry> entries;
  for (const ManualPage& page : manualPages()) {
    const bool isGlossary = &page == &manualPages().back();
    for (const ManualSection& section : page.sections) {
      if (isGlossary && section.level > 1) continue;
      SearchEntry entry;
      entry.title = shownEntry(section.title);
      if (section.level > 1) entry.side = shownEntry(page.title);
      entry.haystack = foldedText(entry.title + QLatin1Char(' ') + entry.side);
      const QString words = shownEntry(section.words).simplified();
      entry.synonyms = foldedText(words);
      entry.summary = words.size() <= kSummary
                          ? words
                          : words.left(kSummary).section(QLatin1Char(' '), 0, -2) + QStringLiteral(" …");
      entry.page = shownEntry(page.id);
      if (section.level > 1) entry.page += QLatin1Char('#') + shownEntry(section.anchor);
      entries.push_back(std::move(entry));
    }
  }
  return entries;
}

QAction* commandAt(const QMenuBar& menus, const QString& path) {
  QList<QAction*> actions = menus.actions();
  QAction* found = nullptr;
  for (const QString& name : path.simplified().split(QStringLiteral(" > "))) {
    const auto action = std::find_if(actions.begin(), actions.end(),
                                     [&](const QAction* each) { return plainText(each->text()) == name; });
    if (action == actions.end()) return nullptr;
    found = *action;
    actions = found->menu() != nullptr ? found->menu()->actions() : QList<QAction*>();
  }
  return found;
}

}  // namespace geargraph
