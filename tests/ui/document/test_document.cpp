#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/limits.h"
#include "tests/core/support/toy_kind.h"
#include "tests/core/support/train_sketch.h"
#include "ui/document/document.h"
#include "ui/document/history_model.h"

namespace geargraph {
namespace {

Edit addLink(quint64 gesture = 0) {
  return {QStringLiteral("Add link"),
          [](const Mechanism& mechanism) {
            return withLink(mechanism, CanvasPoint{10, 20});
          },
          gesture};
}

Edit moveGround(double x, quint64 gesture) {
  return {QStringLiteral("Move"),
          [x](const Mechanism& mechanism) {
            const std::pair<LinkId, CanvasPoint> moved[] = {{mechanism.links.front().id, CanvasPoint{x, 0}}};
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

  void aKindThatOnlyATestKnowsIsUndone() {
    const test::ToyKind toy;
    Document document;
    QVERIFY(document.apply(
        {QStringLiteral("Draw"), [](const Mechanism&) {
           return Expected<Mechanism>(
               test::TrainSketch(2).joint(0, 1, "a").joint(0, 2, "b").mesh(1, 2, 20, 40).build());
         }}));
    const MeshId mesh = document.mechanism()->gearMeshes[0].id;
    QVERIFY(document.apply({QStringLiteral("Change kind"), [&](const Mechanism& before) {
                              return withMeshKind(before, mesh, toy.pair());
                            }}));
    QVERIFY(document.mechanism()->gearMeshes[0].kind == toy.pair());
    document.undoStack().undo();
    QVERIFY(!document.mechanism()->gearMeshes[0].kind);
    document.undoStack().redo();
    QVERIFY(document.mechanism()->gearMeshes[0].kind == toy.pair());
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

  void aJumpThroughTheHistoryIsOneChange() {
    Document document;
    std::vector<Mechanism> steps{*document.mechanism()};
    constexpr int kSteps = 60;  // most of them are not kept whole
    for (int i = 0; i < kSteps; ++i) {
      document.apply(addLink());
      steps.push_back(*document.mechanism());
    }
    document.markSaved(QStringLiteral("a.geargraph"));
    QSignalSpy changed(&document, &Document::changed);
    for (const int step : {3, 3, 57, 0, kSteps, kSteps - 1, 20}) {
      changed.clear();
      const bool isElsewhere = step != document.undoStack().index();
      document.goToStep(step);
      QCOMPARE(changed.count(), isElsewhere ? 1 : 0);
      QCOMPARE(document.undoStack().index(), step);
      QCOMPARE(*document.mechanism(), steps[static_cast<std::size_t>(step)]);
      QCOMPARE(document.isModified(), step != kSteps);
    }
    document.undoStack().undo();
    QCOMPARE(*document.mechanism(), steps[19]);
    document.apply(addLink());  // from here on the history is another one
    QCOMPARE(document.undoStack().count(), 20);
  }

  void theHistoryIsAList() {
    Document document;
    HistoryModel model(&document.undoStack());
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const auto textOf = [&](int row, int role = Qt::DisplayRole) {
      return model.index(row).data(role).toString();
    };
    document.apply(addLink());
    document.apply(moveGround(1, 0));
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(textOf(0), QStringLiteral("Before the first step (saved)"));
    QCOMPARE(textOf(2), QStringLiteral("Move"));
    document.goToStep(1);
    QCOMPARE(textOf(1, Qt::AccessibleTextRole), QStringLiteral("Add link, shown now"));
    QCOMPARE(textOf(2, Qt::AccessibleTextRole), QStringLiteral("Move, undone"));
    QVERIFY(!model.index(2).data(HistoryModel::DoneRole).toBool());
    document.apply(addLink());
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(textOf(2), QStringLiteral("Add link"));
    document.replace(emptyMechanism(), {});
    QCOMPARE(model.rowCount(), 1);
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

  void rejectedEditChangesNothing() {
    Document document;
    QSignalSpy rejected(&document, &Document::rejected);
    QSignalSpy changed(&document, &Document::changed);
    const MechanismPtr before = document.mechanism();
    QVERIFY(!document.apply(
        {QStringLiteral("Add joint"),
         [](const Mechanism& mechanism) { return withTurningJoint(mechanism, LinkId("0"), LinkId("0")); },
         0}));
    QCOMPARE(rejected.count(), 1);
    QCOMPARE(changed.count(), 0);
    QCOMPARE(document.mechanism().get(), before.get());
    QCOMPARE(document.undoStack().count(), 0);
  }

  void lengthsBeyondTheRangeAreRejected() {
    Document document;
    QVERIFY(document.apply(moveGround(1e15, 1)));
    QSignalSpy rejected(&document, &Document::rejected);
    QVERIFY(!document.apply(moveGround(1.1e15, 2)));
    QCOMPARE(rejected.count(), 1);
    QCOMPARE(rejected.front().front().value<Diagnostics>().front().code, Code::schema);
    QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, 1e15);
  }

  void whatCouldNotBeOpenedAgainIsRejected() {
    Document document;
    document.apply(addLink());
    QSignalSpy rejected(&document, &Document::rejected);
    const std::string name(kMaxNameLength + 1, 'x');
    QVERIFY(
        !document.apply({QStringLiteral("Rename link"),
                         [name](const Mechanism& m) { return withName(m, m.links.back().id, name); }, 0}));
    QCOMPARE(rejected.count(), 1);
    QCOMPARE(document.undoStack().count(), 1);
  }

  void oldStepsAreMadeFromTheirNeighbours() {
    Document document;
    std::vector<Mechanism> states{*document.mechanism()};
    for (int i = 0; i < 3 * static_cast<int>(Document::kKeptWhole); ++i) {
      document.apply(moveGround(i + 1, 0));
      states.push_back(*document.mechanism());
    }
    while (document.undoStack().canUndo()) {
      document.undoStack().undo();
      QVERIFY(*document.mechanism() == states[static_cast<std::size_t>(document.undoStack().index())]);
    }
    while (document.undoStack().canRedo()) {
      document.undoStack().redo();
      QVERIFY(*document.mechanism() == states[static_cast<std::size_t>(document.undoStack().index())]);
    }
  }

  void aLongDragGoesBackToItsStart() {
    Document document;
    document.apply(moveGround(5, 0));
    const MechanismPtr start = document.mechanism();
    const quint64 drag = document.newGesture();
    for (int x = 0; x < 100; ++x) document.apply(moveGround(x + 6, drag));
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.mechanism().get(), start.get());
  }

  void beyondTheLimitTheOldestStepsGo() {
    Document document;
    document.setHistoryLimit(100'000);
    QSignalSpy shortened(&document, &Document::historyShortened);
    QSignalSpy index(&document.undoStack(), &QUndoStack::indexChanged);
    document.markSaved(QStringLiteral("a.geargraph"));
    constexpr int kSteps = 2000;
    for (int i = 0; i < kSteps; ++i) {
      document.apply(moveGround(i + 1, 0));
      QVERIFY(document.historyBytes() <= 100'000);
      QVERIFY(document.isModified());
    }
    int dropped = 0;
    for (const QList<QVariant>& each : shortened) dropped += each.front().toInt();
    QUndoStack& stack = document.undoStack();
    QCOMPARE(stack.index(), kSteps - dropped);
    QCOMPARE(stack.count(), stack.index());
    QVERIFY(stack.count() > 20);
    QCOMPARE(index.back().front().toInt(), stack.index());
    for (double x = kSteps - 1; stack.canUndo(); --x) {
      stack.undo();
      QCOMPARE(document.mechanism()->view.nodes.at(LinkId("0")).x, x);
    }
    QVERIFY(document.isModified());  // the saved document cannot be reached any more
    document.replace(emptyMechanism(), {});
    QCOMPARE(document.historyBytes(), std::size_t{0});
  }

  void aSavedStepStaysSavedWhenOlderOnesGo() {
    Document document;
    document.setHistoryLimit(100'000);
    int i = 0;
    while (document.historyBytes() < 90'000) document.apply(moveGround(++i, 0));
    document.markSaved(QStringLiteral("a.geargraph"));
    QSignalSpy shortened(&document, &Document::historyShortened);
    QSignalSpy modified(&document, &Document::modifiedChanged);
    while (shortened.isEmpty()) document.apply(moveGround(++i, 0));
    QCOMPARE(modified.count(), 1);
    QUndoStack& stack = document.undoStack();
    QVERIFY(stack.cleanIndex() > 0);
    stack.setIndex(stack.cleanIndex());
    QVERIFY(!document.isModified());
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

  /// As a field that a change takes away commits its text.
  void anEditDuringAChangeIsAppliedAfterIt() {
    Document document;
    const auto heard = connect(&document, &Document::changed, this, [&] {
      if (document.mechanism()->n() == 1) QVERIFY(document.apply(moveGround(7, 0)));
    });
    QVERIFY(document.apply(addLink()));
    QCOMPARE(document.undoStack().count(), 1);
    disconnect(heard);
    QTRY_COMPARE(document.undoStack().count(), 2);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Move"));
    document.undoStack().undo();
    QCOMPARE(document.mechanism()->n(), 1);
  }

  void anEditOfADocumentBeingReplacedIsDiscarded() {
    Document document;
    bool isTaken = true;
    connect(&document, &Document::changed, this, [&] { isTaken = document.apply(moveGround(7, 0)); });
    document.replace(withLink(emptyMechanism(), CanvasPoint{10, 20}).value(), {});
    QVERIFY(!isTaken);
    QCoreApplication::processEvents();
    QVERIFY(!document.undoStack().canUndo());
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
