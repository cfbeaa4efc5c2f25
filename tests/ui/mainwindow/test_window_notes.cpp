#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/notes.h"
#include "core/presentation/drawing/svg_writer.h"
#include "tests/ui/mainwindow/hand.h"
#include "ui/canvas/digraph_view.h"
#include "ui/canvas/note_editor.h"
#include "ui/help/search_field.h"
#include "ui/mainwindow/document_files.h"
#include "ui/mainwindow/presentation.h"
#include "ui/mainwindow/status_line.h"
#include "ui/panels/properties_panel.h"

namespace geargraph {

/// Notes on the sheet, from the window: the tool, the clipboard, properties, search, files and pictures.
class WindowNotesTest : public QObject {
  Q_OBJECT

  std::unique_ptr<MainWindow> window;

  [[nodiscard]] const std::vector<CanvasNote>& notes() { return window->document().mechanism()->view.notes; }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&window->digraph(), key, modifiers);
  }
  NoteEditor* editor() {
    for (auto* each : window->digraph().viewport()->findChildren<NoteEditor*>()) {
      if (each->isVisible()) return each;
    }
    return nullptr;
  }
  void write(const QString& text) {
    window->actions().tool[static_cast<std::size_t>(ToolKind::note)]->trigger();
    press(Qt::Key_Return);
    QVERIFY(editor() != nullptr);
    QTest::keyClicks(editor(), text);
    QTest::keyClick(editor(), Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

 private slots:
  void initTestCase() { test::setUpProgram(); }
  void init() {
    window = test::openedWindow(robotExamplePath());
    QVERIFY(window != nullptr);
    window->digraph().setFocus();
  }
  void cleanup() { window.reset(); }

  /// The wrong way first: with another drawing in front.
  void theToolBringsTheDigraphToTheFront() {
    QVERIFY(window->showDrawing(QStringLiteral("schematic")));
    window->actions().tool[static_cast<std::size_t>(ToolKind::note)]->trigger();
    QCOMPARE(&window->drawing(), static_cast<DrawingView*>(&window->digraph()));
    QCOMPARE(window->digraph().tool(), ToolKind::note);
    QVERIFY(window->statusLine().text().startsWith(QStringLiteral("Note: click")));
  }

  void nothingIsAnalysedAnewForOne() {
    const SnapshotPtr before = window->analysis().snapshot();
    write(QStringLiteral("sun"));
    QCOMPARE(notes().size(), std::size_t{1});
    QTRY_VERIFY(window->isSettled());
    QCOMPARE(window->analysis().snapshot().get(), before.get());
    QCOMPARE(window->actions().tool[static_cast<std::size_t>(ToolKind::select)]->isChecked(), true);
  }

  void theSearchFindsTheToolAndTheNote() {
    write(QStringLiteral("the wrist starts here"));
    window->selection().clear();
    auto* search = window->findChild<SearchField*>(QStringLiteral("search"));
    const auto ask = [&](const QString& query) {
      QTest::keyClick(window.get(), Qt::Key_K, Qt::ControlModifier);
      QTRY_VERIFY(search->hasFocus());
      QTest::keyClicks(search, query);
      QTest::keyClick(search, Qt::Key_Return);
    };
    window->showDrawing(QStringLiteral("schematic"));
    ask(QStringLiteral("wrist starts"));
    QCOMPARE(window->selection().selected(), std::set<ElementId>{NoteId("N1")});
    QCOMPARE(&window->drawing(), static_cast<DrawingView*>(&window->digraph()));
    for (const char* word : {"comment", "annotation", "sticky"}) {
      window->digraph().setTool(ToolKind::select);
      ask(QLatin1String(word));
      QVERIFY2(window->digraph().tool() == ToolKind::note, word);
    }
  }

  void copyPasteAndDuplicate() {
    write(QStringLiteral("twice"));
    press(Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(window->statusLine().text(), QStringLiteral("Copied 1 note"));
    QTRY_VERIFY(QApplication::clipboard()->mimeData()->hasFormat(QStringLiteral("image/svg+xml")));
    press(Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(notes().size(), std::size_t{2});
    QCOMPARE(notes()[1].text, std::string("twice"));
    QCOMPARE(window->selection().selected(), std::set<ElementId>{NoteId("N2")});
    press(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(notes().size(), std::size_t{3});
    press(Qt::Key_X, Qt::ControlModifier);
    QCOMPARE(notes().size(), std::size_t{2});
    QCOMPARE(window->document().mechanism()->n(), 7);
  }

  void propertiesChangeTheText() {
    write(QStringLiteral("one"));
    const int steps = window->document().undoStack().index();
    auto* text = window->findChild<QPlainTextEdit*>(QStringLiteral("noteText"));
    QVERIFY(text != nullptr);
    QCOMPARE(text->toPlainText(), QStringLiteral("one"));
    text->setFocus();
    text->selectAll();
    QTest::keyClicks(text, QStringLiteral("two words "));
    QCOMPARE(notes()[0].text, std::string("two words"));
    QCOMPARE(text->toPlainText(), QStringLiteral("two words "));  // what is being typed stays
    QCOMPARE(window->document().undoStack().index(), steps + 1);
    text->clear();
    auto* wrong = window->findChild<QLabel*>(QStringLiteral("wrong"));
    QVERIFY(!wrong->isHidden());
    QCOMPARE(wrong->text(), QStringLiteral("A note needs a text."));
    window->digraph().setFocus();
    QCOMPARE(text->toPlainText(), QStringLiteral("two words"));
    window->actions()[CommandId::undo]->trigger();
    QCOMPARE(notes()[0].text, std::string("one"));
  }

  /// The field's own undo, as in a window that is not active.
  void undoInTheFieldIsNotDisturbed() {
    QTest::failOnWarning(QRegularExpression(QStringLiteral("QTextCursor")));
    write(QStringLiteral("one"));
    auto* text = window->findChild<QPlainTextEdit*>(QStringLiteral("noteText"));
    QVERIFY(!text->hasFocus());
    QTextCursor end(text->document());
    end.movePosition(QTextCursor::End);
    for (const char* typed : {"    ", "two"}) {
      end.beginEditBlock();  // which undo takes back alone
      end.insertText(QLatin1String(typed));
      end.endEditBlock();
    }
    QCOMPARE(notes()[0].text, std::string("one    two"));
    text->undo();
    QCOMPARE(notes()[0].text, std::string("one"));
    QCOMPARE(text->toPlainText(), QStringLiteral("one    "));
    text->redo();
    QCOMPARE(notes()[0].text, std::string("one    two"));
  }

  void filesAndPicturesHoldThem() {
    write(QStringLiteral("kept in the file"));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("noted.geargraph"));
    QVERIFY(window->saveDocument(path));
    MainWindow other;
    QVERIFY(other.openDocument(path));
    QCOMPARE(other.document().mechanism()->view.notes, notes());
    const std::string svg = svgOf(window->digraph().picture(), SheetStyle{});
    QVERIFY(svg.find("kept in the file") != std::string::npos);
  }

  /// Notes are as large as all else in the drawing.
  void presentationEnlargesThem() {
    window->resize(1280, 720);
    write(QStringLiteral("for all to see"));
    window->selection().clear();
    window->digraph().fit();
    const int before = window->digraph().boxOf(NoteId("N1")).height();
    window->actions()[CommandId::presentation]->trigger();
    QTRY_VERIFY(window->digraph().boxOf(NoteId("N1")).height() > before);
    window->actions()[CommandId::presentation]->trigger();
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::WindowNotesTest)
#include "test_window_notes.moc"
