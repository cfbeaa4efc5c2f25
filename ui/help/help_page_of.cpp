#include "ui/help/help_page_of.h"

#include <QCoreApplication>
#include <QVariant>
#include <QWidget>
#include <algorithm>

namespace geargraph {
namespace {

struct Entry {
  const char* objectName;
  const char* page;
  const char* purpose;  ///< to be translated; null for what tells it itself
};

constexpr Entry kEntries[] = {
    {"drawings", "drawing",
     QT_TRANSLATE_NOOP("HelpPages", "The mechanism drawn in four ways; a click on a tab chooses one.")},
    {"toolBar", "drawing#tools",
     QT_TRANSLATE_NOOP("HelpPages", "Tools for drawing, undo and redo, the motion, and the search field.")},
    {"noticeBar", "the-window#windows-and-files",
     QT_TRANSLATE_NOOP("HelpPages", "What has to be known about the file of this window.")},
    {"startPage", "first-steps",
     QT_TRANSLATE_NOOP("HelpPages", "Begin a mechanism, or open a recent document or an example.")},
    {"statusLine", "the-window#the-status-bar",
     QT_TRANSLATE_NOOP("HelpPages", "What the tool expects next, and the counts of the mechanism.")},
    {"courseDialog", "lessons-and-exercises#the-course", nullptr},
    {"paperCheck", "lessons-and-exercises#check-your-own-matrices", nullptr},
    {"exercisesDialog", "lessons-and-exercises#exercises", nullptr},
    {"insertSet", "drawing#change-what-is-drawn", nullptr},
    {"printDialog", "exporting-and-printing", nullptr},
    {"exportDialog", "exporting-and-printing#all-formats", nullptr},
    {"pictureDialog", "exporting-and-printing", nullptr},
    {"csvDialog", "digraph-and-matrices#copy-and-export", nullptr},
    {"historyDialog", "the-window#windows-and-files", nullptr},
    {"crashReport", "the-window#windows-and-files", nullptr},
    {"shapes", "exporting-and-printing#solids-and-models", nullptr},
    {"shortcutSheet", "keys", nullptr},
    {"about", "first-steps", nullptr},
    {"helpWindow", "first-steps#find-your-way", nullptr},
    {"tour", "the-window", nullptr},
};

const Entry* entryOf(const QString& objectName) {
  const auto* found = std::find_if(std::begin(kEntries), std::end(kEntries), [&](const Entry& entry) {
    return objectName == QLatin1String(entry.objectName);
  });
  return found == std::end(kEntries) ? nullptr : found;
}

}  // namespace

QString helpPageOf(const QWidget* widget) {
  for (const QWidget* each = widget; each != nullptr; each = each->parentWidget()) {
    const QString own = each->property(kHelpPage).toString();
    if (!own.isEmpty()) return own;
    if (const Entry* entry = entryOf(each->objectName())) return QLatin1String(entry->page);
  }
  return {};
}

QString purposeOf(const QWidget& widget) {
  const QString own = widget.property(kPurpose).toString();
  if (!own.isEmpty()) return own;
  const Entry* entry = entryOf(widget.objectName());
  if (entry == nullptr || entry->purpose == nullptr) return {};
  return QCoreApplication::translate("HelpPages", entry->purpose);
}

QStringList namedPages() {
  QStringList pages;
  for (const Entry& entry : kEntries) pages << QLatin1String(entry.page);
  return pages;
}

}  // namespace geargraph
