#include <QLineEdit>
#include <QPlainTextEdit>
#include <QUndoStack>
#include <random>

#include "core/mechanism/document_format/mechanism_file.h"
#include "tests/ui/canvas/view_driver.h"

using namespace geargraph;

namespace {

/// Somebody who hits the drawing with mouse and keys without a plan, always the same way for one seed.
class Monkey {
 public:
  Monkey(ViewDriver& driver, unsigned seed) : m_driver(driver), m_random(seed) {}

  void act() {
    switch (below(10)) {
      case 0:
      case 1:
        m_driver.key(static_cast<Qt::Key>(toolKey(static_cast<ToolKind>(below(kToolCount)))));
        break;
      case 2:
      case 3:
      case 4:
        m_driver.drag(somewhere(), somewhere(), below(2) == 0 ? modifiers() : Qt::KeyboardModifiers());
        break;
      case 5:
      case 6:
        m_driver.click(somewhere(), modifiers());
        break;
      case 7:
        pressAKey();
        break;
      case 8:
        interruptedDrag();
        break;
      default:
        below(4) == 0 ? m_driver.document.undoStack().undo() : m_driver.document.undoStack().redo();
    }
    for (QLineEdit* editor : m_driver.view.viewport()->findChildren<QLineEdit*>()) {
      if (!editor->isVisible()) continue;
      QTest::keyClicks(editor, "name");
      QTest::keyClick(editor, below(2) == 0 ? Qt::Key_Return : Qt::Key_Escape);
    }
    for (QPlainTextEdit* editor : m_driver.view.viewport()->findChildren<QPlainTextEdit*>()) {
      if (!editor->isVisible()) continue;
      QTest::keyClicks(editor, "note");
      QTest::keyClick(editor, below(2) == 0 ? Qt::Key_Return : Qt::Key_Escape);
    }
  }

 private:
  unsigned below(unsigned limit) { return static_cast<unsigned>(m_random() % limit); }

  Qt::KeyboardModifiers modifiers() {
    constexpr std::array<Qt::KeyboardModifier, 4> kAll{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier,
                                                       Qt::AltModifier};
    return kAll[below(4)];
  }

  /// On a link or an arrow, mostly; else anywhere on the sheet.
  CanvasPoint somewhere() {
    const std::vector<Outline>& outlines = m_driver.view.displayList().outlines;
    if (below(4) == 0 || outlines.empty()) {
      return {static_cast<double>(below(900)) - 450, static_cast<double>(below(600)) - 300};
    }
    return extentOf(outlines[below(static_cast<unsigned>(outlines.size()))].shape).center;
  }

  void pressAKey() {
    constexpr std::array<Qt::Key, 12> kKeys{Qt::Key_Delete, Qt::Key_Up,   Qt::Key_X,    Qt::Key_F2,
                                            Qt::Key_Left,   Qt::Key_Down, Qt::Key_F,    Qt::Key_Escape,
                                            Qt::Key_Space,  Qt::Key_L,    Qt::Key_Plus, Qt::Key_A};
    m_driver.key(kKeys[below(kKeys.size())], modifiers());
  }

  /// The document or the tool changes while the button is down.
  void interruptedDrag() {
    const CanvasPoint end = somewhere();
    m_driver.press(somewhere());
    m_driver.move(somewhere());
    switch (below(4)) {
      case 0:
        m_driver.document.undoStack().undo();
        break;
      case 1:
        m_driver.key(Qt::Key_Escape);
        break;
      case 2:
        m_driver.key(Qt::Key_T);
        break;
      default:
        m_driver.key(Qt::Key_Delete);
    }
    m_driver.move(end);
    m_driver.release(end);
  }

  ViewDriver& m_driver;
  std::mt19937 m_random;
};

}  // namespace

class RandomGesturesTest : public QObject {
  Q_OBJECT
 private slots:
  void whateverIsDoneCanBeUndoneAndRedone_data() {
    QTest::addColumn<bool>("robot");
    QTest::newRow("from nothing") << false;
    QTest::newRow("from the robot") << true;
  }
  void whateverIsDoneCanBeUndoneAndRedone() {
    QFETCH(bool, robot);
    int steps = 0;
    for (unsigned seed = 1; seed <= 6; ++seed) {
      ViewDriver d(robot ? std::optional(placedRobot()) : std::nullopt);
      const MechanismPtr first = d.document.mechanism();
      Monkey monkey(d, seed);
      for (int i = 0; i < 800; ++i) {
        monkey.act();
        checkDrawing(d);
        steps = std::max(steps, d.steps());
      }
      const MechanismPtr last = d.document.mechanism();
      QUndoStack& history = d.document.undoStack();
      const int place = history.index();
      while (history.canUndo()) history.undo();
      QVERIFY(*d.document.mechanism() == *first);
      while (history.index() < place) history.redo();
      QVERIFY(*d.document.mechanism() == *last);
      const Expected<Mechanism> reread = readMechanism(writeMechanism(*last));
      QVERIFY(reread.has_value() && *reread == *last);
    }
    QVERIFY2(steps > 30, qPrintable(QString::number(steps)));  // the monkey did draw
  }

 private:
  /// Every link is drawn once and every selected element exists.
  static void checkDrawing(const ViewDriver& d) {
    const Mechanism& mechanism = d.mechanism();
    std::size_t discs = 0;
    for (const Outline& outline : d.view.displayList().outlines) {
      discs += std::holds_alternative<Circle>(outline.shape) ? 1U : 0U;
    }
    QCOMPARE(discs, mechanism.links.size());
    for (const ElementId& element : d.selection.selected()) QVERIFY(labelOf(mechanism, element).has_value());
    for (const ElementId& element : d.selection.hovered()) QVERIFY(labelOf(mechanism, element).has_value());
  }
};

QTEST_MAIN(RandomGesturesTest)
#include "test_random_gestures.moc"
