#include "ui/help/help_page_of.h"

#include <QCoreApplication>
#include <QVariant>
#include <QWidget>
#include <algorithm>

namespace geargraph::inline ui_help {
namespace {

struct Entry {
  const char* objectName;
  const char* page;
  const char* purpose;  ///< to be translated; null for what tells it itself
};

constexpr Entry kEntries[] = {
    {"dock.matrices", "digraph-and-matrices",
     QT_TRANSLATE_NOOP(
         "HelpPages",
         "Every matrix of the Matroid method. Rest the mouse on an entry to have it explained.")},
    {"dock.problems", "problems",
     QT_TRANSLATE_NOOP("HelpPages", "What is wrong with the mechanism, and how to mend it.")},
    {"dock.view3d", "teeth-axes-and-3d#the-3d-view",
     QT_TRANSLATE_NOOP("HelpPages",
                       "The gears in motion. Drag a gear to turn the train, drag elsewhere to orbit.")},
    {"dock.inputs", "inputs-and-results",
     QT_TRANSLATE_NOOP("HelpPages", "The speeds of the motors, and how fast every joint turns with them.")},
    {"dock.gearbox", "gearboxes",
     QT_TRANSLATE_NOOP("HelpPages", "Brakes and clutches, what is engaged, and the states of a gearbox.")},
    {"dock.properties", "teeth-axes-and-3d",
     QT_TRANSLATE_NOOP("HelpPages", "Teeth, axes and names of what is selected.")},
    {"dock.speeds", "inputs-and-results#motion",
     QT_TRANSLATE_NOOP("HelpPages", "Speeds over one period of the motion.")},
    {"dock.derivation", "matroid-method",
     QT_TRANSLATE_NOOP("HelpPages", "Both methods worked out step by step for this mechanism.")},
    {"dock.forces", "forces-and-dynamics",
     QT_TRANSLATE_NOOP("HelpPages", "Loads, and the torques, forces and powers that they cause.")},
    {"dock.dynamics", "forces-and-dynamics#dynamics",
     QT_TRANSLATE_NOOP("HelpPages", "Masses, the inertia at each motor, and the motion that torques cause.")},
    {"dock.lesson", "lessons-and-exercises",
     QT_TRANSLATE_NOOP("HelpPages",
                       "A lesson: what is asked, your answer, hints, and the reason where it is wrong.")},
    {"digraph", "drawing",
     QT_TRANSLATE_NOOP("HelpPages",
                       "The mechanism as a directed graph: links as circles, turning joints as solid arrows, "
                       "gear meshes as dashed ones.")},
    {"ttgraph", "t-t-graph-method",
     QT_TRANSLATE_NOOP("HelpPages",
                       "The mechanism after Tsai and Tokad, with levels, chords and transfer vertices.")},
    {"schematic", "drawing#in-the-schematic",
     QT_TRANSLATE_NOOP("HelpPages", "The mechanism in section, as in textbooks. You can draw here, too.")},
    {"drawings", "drawing",
     QT_TRANSLATE_NOOP("HelpPages", "The mechanism drawn in three ways; a click on a tab chooses one.")},
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

QString purposeOf(const QString& objectName) {
  const Entry* entry = entryOf(objectName);
  if (entry == nullptr || entry->purpose == nullptr) return {};
  return QCoreApplication::translate("HelpPages", entry->purpose);
}

QStringList namedPages() {
  QStringList pages;
  for (const Entry& entry : kEntries) pages << QLatin1String(entry.page);
  return pages;
}

}  // namespace geargraph::inline ui_help
