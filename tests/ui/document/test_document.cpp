#include <QSignalSpy>
#include <QTest>

#include "core/mechanism/edits.h"
#include "ui/document/document.h"

namespace geargraph {
namespace {

Edit addLink(quint64 gesture = 0) {
  return {QStringLiteral("Add link"),
          [](const Mechanism& mechanism) {
            return withLink(mechanism, SheetPoint{10, 20});
          },
          gesture};
}

Edit moveGround(double x, quint64 gesture) {
  return {QStringLiteral("Move"),
          [x](const Mechanism& mechanism) {
            const std::pair<LinkId, SheetPoint> moved[] = {{mechanism.links.front().id, SheetPoint{x, 0}}};
            return withNodesMoved(mechanism, moved);
          },
          gesture};
}

}  // namespace

class DocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void undoGivesBackTheSameValue() {
    Document document;
    const MechanismPtr before = document.mechanism();
    QVERIFY(document.apply(addLink()));
    const MechanismPtr after = document.mechanism();
    document.undoStack().undo();
    QCOMPARE(document.mechanism().get(), before.get());
    document.undoStack().redo();
    QCOMPARE(document.mechanism().get(), after.get());
  }

  void revisionOnlyGrows() {
    Document document;
    document.apply(addLink());
    const quint64 drawn = document.revision();
    document.undoStack().undo();
    QVERIFY(document.revision() > drawn);
  }

  void movingALinkLeavesTheMechanicsAsTheyWere() {
    Document document;
    document.apply(addLink());
    QCOMPARE(document.mechanicsRevision(), document.revision());
    const quint64 mechanics = document.mechanicsRevision();
    document.apply(moveGround(7, 0));
    QVERIFY(document.revision() > mechanics);
    QCOMPARE(document.mechanicsRevision(), mechanics);
    document.undoStack().undo();
    QCOMPARE(document.mechanicsRevision(), mechanics);
    document.undoStack().undo();
    QCOMPARE(document.mechanicsRevision(), document.revision());
  }

  void oneGestureIsOneStep() {
    Document document;
    document.apply(moveGround(0, 0));
    const quint64 drag = document.newGesture();
    for (const double x : {1.0, 2.0, 3.0}) document.apply(moveGround(x, drag));
    QCOMPARE(document.undoStack().count(), 2);
    document.apply(moveGround(4, document.newGesture()));
    QCOMPARE(document.undoStack().count(), 3);
    document.undoStack().undo();
    QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, 3.0);
    document.undoStack().undo();
    QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, 0.0);
  }

  void draggedBackLeavesNoStep() {
    Document document;
    document.apply(moveGround(5, 0));
    const quint64 drag = document.newGesture();
    document.apply(moveGround(9, drag));
    document.apply(moveGround(5, drag));
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, 5.0);
  }

  void refusedEditChangesNothing() {
    Document document;
    QSignalSpy refused(&document, &Document::refused);
    QSignalSpy changed(&document, &Document::changed);
    const MechanismPtr before = document.mechanism();
    QVERIFY(!document.apply(
        {QStringLiteral("Add joint"),
         [](const Mechanism& mechanism) { return withTurningJoint(mechanism, LinkId("0"), LinkId("0")); },
         0}));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(changed.count(), 0);
    QCOMPARE(document.mechanism().get(), before.get());
    QCOMPARE(document.undoStack().count(), 0);
  }

  void lengthsBeyondTheRangeAreRefused() {
    Document document;
    QVERIFY(document.apply(moveGround(1e15, 1)));
    QSignalSpy refused(&document, &Document::refused);
    QVERIFY(!document.apply(moveGround(1.1e15, 2)));
    QCOMPARE(refused.count(), 1);
    QCOMPARE(refused.front().front().value<Diagnostics>().front().code, Code::schema);
    QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, 1e15);
  }

  void modifiedFollowsTheFile() {
    Document document;
    QVERIFY(!document.isModified());
    document.apply(addLink());
    QVERIFY(document.isModified());
    document.markSaved(QStringLiteral("a.geargraph"));
    QVERIFY(!document.isModified());
    document.undoStack().undo();
    QVERIFY(document.isModified());
    document.undoStack().redo();
    QVERIFY(!document.isModified());
  }

  void replaceForgetsTheHistory() {
    Document document;
    document.apply(addLink());
    document.replace(emptyMechanism(), QStringLiteral("b.geargraph"));
    QVERIFY(!document.undoStack().canUndo());
    QVERIFY(!document.isModified());
    QCOMPARE(document.mechanism()->n(), 0);
    QCOMPARE(document.filePath(), QStringLiteral("b.geargraph"));
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::DocumentTest)
#include "test_document.moc"
