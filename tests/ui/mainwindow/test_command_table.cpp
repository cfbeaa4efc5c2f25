#include <QSet>
#include <QTest>

#include "tests/ui/mainwindow/hand.h"
#include "ui/help/search_entries.h"
#include "ui/mainwindow/commands.h"
#include "ui/mainwindow/document_files.h"

namespace geargraph {
namespace {

/// In which nothing that has a condition is possible.
CommandState nothingPossible() {
  CommandState now;
  now.hasSiblings = false;
  now.isTransient = true;
  now.whyNoLoad = now.whyNoGear = now.whyNoWeld = now.whyNoSplit = now.whyNoDerivation = now.whyNoPowerFlow =
      "Not here.";
  return now;
}

/// In which all is possible but what depends on the selection, and with something selected.
CommandState possibleWith(int links, int joints, bool isGround) {
  CommandState now;
  now.canUndo = now.canRedo = now.hasLinks = now.isEngaged = true;
  now.hasFile = now.isModified = now.hasMatrix = true;
  now.links = links;
  now.joints = joints;
  now.selected = links + joints;
  now.isGroundSelected = isGround;
  return now;
}

bool isPossible(const Command& command, const CommandState& now) {
  return command.whyNot == nullptr || command.whyNot(now).isEmpty();
}

}  // namespace

/// The table of commands, and the actions that are made from it.
class CommandTableTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { test::setUpProgram(); }

  void everyCommandHasWhatIsShownOfIt() {
    QSet<QString> names;
    for (const Command& command : commandTable()) {
      const QString name = command.name;
      QVERIFY2(name.contains('.') && !names.contains(name), command.name);
      names << name;
      QVERIFY2(!command.text.isEmpty() && !command.tip.isEmpty(), command.name);
    }
    QCOMPARE(names.size(), static_cast<int>(kCommandCount));
  }

  void whatIsNotPossibleSaysWhyAndBecomesPossible() {
    const CommandState states[] = {possibleWith(1, 0, false), possibleWith(0, 1, false)};
    int conditions = 0;
    for (const Command& command : commandTable()) {
      if (command.whyNot == nullptr) continue;
      ++conditions;
      const QString why = command.whyNot(nothingPossible());
      QVERIFY2(why.endsWith('.'), command.name);
      QVERIFY2(isPossible(command, states[0]) || isPossible(command, states[1]), command.name);
    }
    QVERIFY(conditions >= 25);
  }

  // The ground alone can be named and loaded, and nothing that would move or delete it.
  void theGroundIsNeitherDeletedNorDriven() {
    const CommandState ground = possibleWith(1, 0, true);
    QStringList impossible;
    for (const Command& command : commandTable())
      if (!isPossible(command, ground)) impossible << command.name;
    impossible.sort();
    QCOMPARE(impossible,
             (QStringList{"edit.copy", "edit.cut", "edit.delete", "edit.duplicate", "mechanism.drive",
                          "mechanism.flip", "mechanism.ground", "mechanism.hold"}));
  }

  void aLessonKeepsItsAnswersAndItsDocument() {
    CommandState lesson = possibleWith(1, 0, false);
    lesson.isTransient = true;
    lesson.areAnswersOpen = false;
    QStringList impossible;
    for (const Command& command : commandTable())
      if (!isPossible(command, lesson)) impossible << command.name;
    impossible.sort();
    QCOMPARE(impossible, (QStringList{"file.save", "file.saveAs", "learn.derivation", "mechanism.findTeeth",
                                      "mechanism.flip"}));
  }

  void actionsAreMadeFromTheTable() {
    const auto window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    QSet<QKeySequence> keys;
    for (const Command& command : commandTable()) {
      const QAction* action = window->actions()[command.id];
      QCOMPARE(action->objectName(), QString(command.name));
      QCOMPARE(action->isCheckable(), command.isCheckable);
      QCOMPARE(action->icon().isNull(), QString(command.icon).isEmpty());
      QCOMPARE(action->property(kSearchWords).toString(), QString(command.searchWords));
      QCOMPARE(action->shortcuts(), command.keys);
      for (const QKeySequence& key : command.keys) {
        QVERIFY2(!keys.contains(key), qPrintable(key.toString()));
        keys << key;
      }
      if (action->isEnabled()) QVERIFY2(action->toolTip().startsWith(command.tip), command.name);
      QVERIFY2(action->isEnabled() || command.whyNot != nullptr, command.name);
    }
    for (const QAction* tool : window->actions().tools->actions()) {
      QVERIFY(!keys.contains(tool->shortcut()));
      keys << tool->shortcut();
    }
  }

  // Also those that the user has not chosen since: an answer of the analysis enables the export.
  void actionsFollowTheDocument() {
    const auto window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    QAction* handout = window->actions()[CommandId::exportHandout];
    QVERIFY(handout->isEnabled());
    window->actions()[CommandId::selectAll]->trigger();
    window->actions()[CommandId::remove]->trigger();
    QTRY_VERIFY(!handout->isEnabled());
    QVERIFY(handout->toolTip().contains("nothing drawn"));
    window->actions()[CommandId::undo]->trigger();
    QTRY_VERIFY(handout->isEnabled());
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::CommandTableTest)

#include "test_command_table.moc"
