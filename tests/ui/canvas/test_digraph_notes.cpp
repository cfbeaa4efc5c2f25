#include <QApplication>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSignalSpy>

#include "core/mechanism/model/notes.h"
#include "tests/ui/canvas/view_driver.h"
#include "ui/canvas/note_editor.h"
#include "ui/canvas/tt_graph_view.h"

using namespace geargraph;

namespace {

constexpr CanvasPoint kEmpty{300, 480};

NoteEditor* editorOf(const ViewDriver& d) {
  for (auto* editor : d.view.viewport()->findChildren<NoteEditor*>()) {
    if (editor->isVisible()) return editor;
  }
  return nullptr;
}

void type(NoteEditor& editor, const QString& text, Qt::Key end = Qt::Key_Return) {
  QTest::keyClicks(&editor, text);
  QTest::keyClick(&editor, end);
}

const std::vector<CanvasNote>& notesOf(const ViewDriver& d) {
  return d.mechanism().view.notes;
}

Mechanism noted() {
  return *withNote(placedRobot(), kEmpty, "sun");
}

}  // namespace

/// Notes on the sheet: written, changed, moved, copied and deleted by mouse and by keys.
class DigraphNotesTest : public QObject {
  Q_OBJECT
 private slots:
  void aClickWithTheToolWritesOne() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_N);
    d.click(kEmpty);
    QVERIFY(editorOf(d) != nullptr);
    type(*editorOf(d), QStringLiteral("the sun"));
    QCOMPARE(notesOf(d).size(), std::size_t{1});
    QCOMPARE(notesOf(d)[0].text, std::string("the sun"));
    QVERIFY(std::hypot(notesOf(d)[0].at.x - kEmpty.x, notesOf(d)[0].at.y - kEmpty.y) < 2);
    QVERIFY(d.selection.isSelected(NoteId("N1")));
    QCOMPARE(d.view.tool(), ToolKind::select);  // the next click is not one more note
    QCOMPARE(d.document.undoStack().undoText(), QStringLiteral("Add note"));
    d.document.undoStack().undo();
    QVERIFY(notesOf(d).empty());
    d.document.undoStack().redo();
    QCOMPARE(notesOf(d).size(), std::size_t{1});
  }

  void escapeAndAnEmptyTextWriteNone() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_N);
    d.click(kEmpty);
    type(*editorOf(d), QStringLiteral("gone"), Qt::Key_Escape);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    d.click(kEmpty);
    type(*editorOf(d), QStringLiteral("  "));
    QCOMPARE(d.steps(), 0);
    QVERIFY(notesOf(d).empty());
  }

  /// The wrong way first: on a link, on an arrow.
  void onALinkTheToolWritesNone() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_N);
    d.click(d.center(3));
    d.click(d.middle(JointId("11")));
    QVERIFY(editorOf(d) == nullptr);
    QCOMPARE(d.steps(), 0);
    QVERIFY(d.view.hint().startsWith(QStringLiteral("Note: click on an empty area")));
  }

  void clickingElsewhereTakesTheText() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_N);
    d.click(kEmpty);
    QTest::keyClicks(editorOf(d), QStringLiteral("kept"));
    d.view.setFocus();
    QCOMPARE(notesOf(d).size(), std::size_t{1});
    QCOMPARE(notesOf(d)[0].text, std::string("kept"));
  }

  void aDoubleClickChangesTheText() {
    ViewDriver d(noted());
    d.click(kEmpty);
    QTest::mouseDClick(d.view.viewport(), Qt::LeftButton, {}, d.onScreen(kEmpty));
    QVERIFY(editorOf(d) != nullptr);
    QCOMPARE(editorOf(d)->toPlainText(), QStringLiteral("sun"));
    QTest::keyClicks(editorOf(d), QStringLiteral("ring"));
    QTest::keyClick(editorOf(d), Qt::Key_Return, Qt::ShiftModifier);
    type(*editorOf(d), QStringLiteral("gear"));
    QCOMPARE(notesOf(d)[0].text, std::string("ring\ngear"));
    QCOMPARE(d.steps(), 1);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    d.key(Qt::Key_F2);  // an emptied note goes
    editorOf(d)->clear();
    type(*editorOf(d), QString());
    QVERIFY(notesOf(d).empty());
    QCOMPARE(d.document.undoStack().undoText(), QStringLiteral("Delete note"));
  }

  void selectedTextIsNotDragged() {
    ViewDriver d(noted());
    d.view.openNoteEditor({}, NoteId("N1"));
    NoteEditor& editor = *editorOf(d);
    QCOMPARE(editor.textCursor().selectedText(), QStringLiteral("sun"));
    const QPoint on = editor.cursorRect().center() - QPoint(1, 0);
    QTest::mousePress(editor.viewport(), Qt::LeftButton, {}, on);
    QVERIFY(!editor.textCursor().hasSelection());
    QTest::mouseMove(editor.viewport(), on - QPoint(60, 0));  // would not come back from a drag
    QCOMPARE(editor.textCursor().selectedText(), QStringLiteral("sun"));
    QTest::mouseRelease(editor.viewport(), Qt::LeftButton, {}, on - QPoint(60, 0));
    QTest::mouseClick(editor.viewport(), Qt::LeftButton, {}, on - QPoint(60, 0));
    QTest::mousePress(editor.viewport(), Qt::LeftButton, Qt::ShiftModifier, on + QPoint(40, 0));
    QTest::mouseRelease(editor.viewport(), Qt::LeftButton, Qt::ShiftModifier, on + QPoint(40, 0));
    QCOMPARE(editor.textCursor().selectedText(), QStringLiteral("sun"));
  }

  void tooLongATextIsCutAndSaid() {
    ViewDriver d(noted());
    QSignalSpy hints(&d.view, &DrawingView::hintChanged);
    d.view.openNoteEditor({}, NoteId("N1"));
    editorOf(d)->setPlainText(QString(1'200, QLatin1Char('x')));
    QCOMPARE(editorOf(d)->toPlainText().size(), 1'000);
    QCOMPARE(hints.last().first().toString(), QStringLiteral("A note has at most 1,000 characters."));
    QTest::keyClick(editorOf(d), Qt::Key_Return);
    QCOMPARE(notesOf(d)[0].text.size(), std::size_t{1'000});
  }

  void draggingMovesItAsOneStep() {
    ViewDriver d(noted());
    const quint64 mechanics = d.document.mechanicsRevision();
    d.drag(kEmpty, {400, 500}, Qt::AltModifier);
    QVERIFY(std::hypot(notesOf(d)[0].at.x - 400, notesOf(d)[0].at.y - 500) < 2);
    QCOMPARE(d.steps(), 1);
    QCOMPARE(d.document.undoStack().undoText(), QStringLiteral("Move note"));
    QCOMPARE(d.document.mechanicsRevision(), mechanics);  // nothing is analysed anew
    d.key(Qt::Key_Right);
    QVERIFY(notesOf(d)[0].at.x > 405);
    d.document.undoStack().undo();
    d.document.undoStack().undo();
    QCOMPARE(notesOf(d)[0].at, kEmpty);
  }

  void itMovesWithLinksThatAreSelected() {
    ViewDriver d(noted());
    const CanvasPoint link = d.center(3);
    d.click(d.center(3));
    d.click(kEmpty, Qt::ShiftModifier);
    d.drag(link, link + CanvasPoint{60, 0}, Qt::AltModifier);
    QVERIFY(std::abs(notesOf(d)[0].at.x - kEmpty.x - 60) < 2);
    QVERIFY(std::abs(d.center(3).x - link.x - 60) < 2);
    QCOMPARE(d.steps(), 1);
    d.press(d.center(3));
    d.move(d.center(3) + CanvasPoint{50, 50});
    d.key(Qt::Key_Escape);
    QCOMPARE(d.steps(), 1);  // both are back
  }

  void deleteRemovesItAndSelectAllTakesIt() {
    ViewDriver d(noted());
    d.click(kEmpty);
    d.key(Qt::Key_Delete);
    QVERIFY(notesOf(d).empty());
    QCOMPARE(d.mechanism().n(), 7);
    d.document.undoStack().undo();
    d.key(Qt::Key_A, Qt::ControlModifier);
    QVERIFY(d.selection.isSelected(NoteId("N1")));
  }

  void keysAloneWriteOneAndComeBackToIt() {
    ViewDriver d(placedRobot());
    d.key(Qt::Key_N);
    d.key(Qt::Key_Return);
    QVERIFY(editorOf(d) != nullptr);
    type(*editorOf(d), QStringLiteral("by keys"));
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCOMPARE(notesOf(d).size(), std::size_t{1});
    d.key(Qt::Key_Escape);
    d.key(Qt::Key_PageUp);  // the last element
    QVERIFY(d.selection.isSelected(NoteId("N1")));
    QCOMPARE(d.view.describe(NoteId("N1")), QStringLiteral("Note: by keys"));
    d.key(Qt::Key_Return);
    QVERIFY(editorOf(d) != nullptr);
    QCOMPARE(editorOf(d)->accessibleName(), QStringLiteral("Text of the note"));
  }

  void theMenuOffersIt() {
    ViewDriver d(noted());
    const std::unique_ptr<QMenu> onSheet(d.view.contextMenuAt(d.onScreen({40, 560})));
    const std::unique_ptr<QMenu> onNote(d.view.contextMenuAt(d.onScreen(kEmpty)));
    const auto entry = [](const QMenu& menu, const QString& text) {
      const auto all = menu.actions();
      const auto found =
          std::find_if(all.begin(), all.end(), [&](QAction* each) { return each->text().startsWith(text); });
      return found == all.end() ? nullptr : *found;
    };
    QVERIFY(entry(*onNote, QStringLiteral("Change the text")) != nullptr);
    entry(*onSheet, QStringLiteral("New note here"))->trigger();
    QVERIFY(editorOf(d) != nullptr);
    type(*editorOf(d), QStringLiteral("menu"));
    QCOMPARE(notesOf(d).size(), std::size_t{2});
  }

  void theTtGraphHasNone() {
    DriverOf<TtGraphView> d(noted());
    d.selection.select({NoteId("N1"), LinkId("2")});
    d.key(Qt::Key_Delete);  // nothing that is not seen
    QCOMPARE(d.mechanism().view.notes.size(), std::size_t{1});
    QVERIFY(d.mechanism().find(LinkId("2")) == nullptr);
    d.document.undoStack().undo();
    d.key(Qt::Key_A, Qt::ControlModifier);
    QVERIFY(!d.selection.isSelected(NoteId("N1")));
    d.key(Qt::Key_N);
    d.click({5, 5});
    QVERIFY(d.view.viewport()->findChildren<NoteEditor*>().isEmpty());
    QCOMPARE(d.view.hint(), QStringLiteral("Notes are written on the sheet of the digraph"));
  }

  void rightToLeftTextStaysInItsBox() {
    ViewDriver d(*withNote(placedRobot(), kEmpty, "ترس شمسی و حلقه"));
    d.view.setLayoutDirection(Qt::RightToLeft);
    QImage picture(d.view.viewport()->size(), QImage::Format_RGB32);
    d.view.viewport()->render(&picture);
    const QRect box = d.view.boxOf(NoteId("N1"));
    QVERIFY(box.isValid());
    // Just outside of the box nothing is inked.
    const QColor sheet = picture.pixelColor(box.left() - 6, box.center().y());
    for (int y = box.top(); y < box.bottom(); ++y) {
      QCOMPARE(picture.pixelColor(box.left() - 4, y), sheet);
      QCOMPARE(picture.pixelColor(box.right() + 4, y), sheet);
    }
  }
};

QTEST_MAIN(DigraphNotesTest)
#include "test_digraph_notes.moc"
