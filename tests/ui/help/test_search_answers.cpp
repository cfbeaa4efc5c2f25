#include <QTest>

#include "core/mechanism/model/edits.h"
#include "core/mechanism/model/shift_edits.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/snapshot_of.h"
#include "ui/help/link_ratio.h"
#include "ui/help/search_answers.h"
#include "ui/help/search_model.h"

namespace geargraph {

/// Questions that the search field answers, and what it offers to do.
class SearchAnswersTest : public QObject {
  Q_OBJECT

  static AnswerSource sourceOf(const char* example) {
    const SnapshotPtr snapshot = test::snapshotOf(test::example(example));
    return {snapshot->mechanism, snapshot, {}, true};
  }
  static QStringList titles(const std::vector<SearchEntry>& entries) {
    QStringList all;
    for (const SearchEntry& entry : entries) all << entry.title;
    return all;
  }
  /// What an edit makes of the document.
  static Mechanism after(const SearchEntry& entry, const Mechanism& before) {
    Document document;
    document.replace(before, {});
    if (!document.apply(*entry.edit)) return before;
    return *document.mechanism();
  }

 private slots:
  /// A sun of 24 and a ring of 60 teeth that is held: the carrier makes 24/84 turns for one of the sun.
  void ratiosAreExactAndSigned_data() {
    QTest::addColumn<QString>("query");
    QTest::addColumn<QString>("title");
    QTest::newRow("labels") << "ratio of link 1 to 2"
                            << "link 1 (sun) : link 2 (carrier) = 7/2";
    QTest::newRow("two words") << "ratio carrier sun"
                               << "link 2 (carrier) : link 1 (sun) = 2/7";
    QTest::newRow("colon") << "Ratio 3:1" << QStringLiteral("link 3 (planet) : link 1 (sun) = −2/3");
    QTest::newRow("and") << "ratio between planet and sun"
                         << QStringLiteral("link 3 (planet) : link 1 (sun) = −2/3");
  }
  void ratiosAreExactAndSigned() {
    QFETCH(QString, query);
    QFETCH(QString, title);
    const std::vector<SearchEntry> answers = answersTo(query, sourceOf("planetary-ring-held"));
    QCOMPARE(titles(answers), QStringList{title});
    QVERIFY(answers.front().isAnswer && !answers.front().edit);
    QCOMPARE(answers.front().elements.size(), std::size_t{2});
    QCOMPARE(answers.front().detail.contains("the other way round"), title.contains(QChar(0x2212)));
  }

  void whatDependsOnTheInputsSaysSo() {
    const AnswerSource source = sourceOf("simpson");  // two inputs, the suns with 1 rad/s and one at rest
    const LinkRatio ofRings = linkRatio(*source.snapshot, 3, 1);
    QCOMPARE(ofRings.kind, LinkRatio::Kind::now);
    const std::vector<SearchEntry> answers = answersTo("ratio output suns", source);
    QCOMPARE(answers.size(), std::size_t{1});
    QVERIFY(answers.front().title.contains(" = "));
    QVERIFY2(answers.front().detail.contains("inputs"), qPrintable(answers.front().detail));
    // Two links that one mesh ties on a standing carrier have one ratio in every motion.
    QCOMPARE(linkRatio(*sourceOf("spur-pair").snapshot, 1, 2).kind, LinkRatio::Kind::exact);
  }

  void whatHasNoRatioSaysWhy() {
    const AnswerSource ground = sourceOf("planetary-ring-held");
    QVERIFY(answersTo("ratio 1 to 0", ground).front().detail.contains("stands still"));
    const AnswerSource wrist = sourceOf("bevel-wrist");
    QCOMPARE(linkRatio(*wrist.snapshot, 6, 2).kind, LinkRatio::Kind::notParallel);
    AnswerSource later = ground;  // edited, and not analysed yet
    later.mechanism =
        std::make_shared<const Mechanism>(*withName(*ground.mechanism, LinkId("1"), "sun wheel"));
    QCOMPARE(answersTo("ratio 1 2", later).front().title, QString("link 1 (sun wheel) : link 2 (carrier)"));
    QVERIFY(answersTo("ratio 1 1", ground).empty() && answersTo("ratio 1 77", ground).empty());
  }

  void aLessonKeepsItsAnswer() {
    AnswerSource source = sourceOf("planetary-ring-held");
    source.areAnswersOpen = false;
    const std::vector<SearchEntry> answers = answersTo("ratio sun carrier", source);
    QCOMPARE(titles(answers), QStringList{"link 1 (sun) : link 2 (carrier)"});
    QVERIFY(!answers.front().detail.contains("7/2") && answers.front().side.isEmpty());
  }

  void aBrakeIsOfferedAsAnEdit() {
    const AnswerSource source = sourceOf("simpson");
    const std::vector<SearchEntry> offers = answersTo("hold ring", source);
    QCOMPARE(titles(offers), QStringList{"Hold link 2 (first ring) with a brake"});
    QVERIFY(offers.front().edit && !offers.front().isAnswer);
    const Mechanism held = after(offers.front(), *source.mechanism);
    QVERIFY(held.couplings.size() == 4 && isEngaged(held, held.couplings.back().id));
    AnswerSource now{std::make_shared<const Mechanism>(held), nullptr, {}, true};
    QVERIFY(!answersTo("hold ring", now).front().edit);  // it is held already
    const std::vector<SearchEntry> released = answersTo("release ring", now);
    QVERIFY(released.front().edit);
    QVERIFY(!isEngaged(after(released.front(), held), held.couplings.back().id));
    QVERIFY(!answersTo("hold 0", source).front().edit);
    QVERIFY(answersTo("hold", source).empty());
  }

  void teethAreOfferedForTheSelectedMesh() {
    AnswerSource source = sourceOf("planetary-ring-held");
    QCOMPARE(answersTo("teeth 20 30", source).size(), std::size_t{2});  // each mesh
    const GearMesh& mesh = source.mechanism->gearMeshes.front();
    source.selected = {ElementId(mesh.id)};
    const std::vector<SearchEntry> offers = answersTo("teeth 20 30", source);
    QCOMPARE(offers.size(), std::size_t{1});
    const Mechanism changed = after(offers.front(), *source.mechanism);
    QCOMPARE(changed.gearMeshes.front().tailTeeth, 20);
    QCOMPARE(changed.gearMeshes.front().headTeeth, 30);
    const int label = source.mechanism->meshLabel(1);
    const auto named = answersTo(QStringLiteral("teeth %1 20 : 30").arg(label), source);
    QCOMPARE(named.size(), std::size_t{1});
    QCOMPARE(named.front().elements.front(), ElementId(source.mechanism->gearMeshes[1].id));
    QVERIFY(!answersTo(QStringLiteral("teeth %1 %2").arg(mesh.tailTeeth).arg(mesh.headTeeth), source)
                 .front()
                 .edit);
    QVERIFY(answersTo("teeth 20", source).empty() && answersTo("teeth of a wheel", source).empty());
  }

  void answersComeFirstAndOnlyToQuestions() {
    const AnswerSource source = sourceOf("planetary-ring-held");
    SearchModel model;
    model.setEntries(elementEntries(*source.mechanism));
    model.setQuery("sun", answersTo("sun", source));
    QCOMPARE(model.index(0).data(SearchModel::KindRole).toString(), QString("element"));
    model.setQuery("ratio sun carrier", answersTo("ratio sun carrier", source));
    QCOMPARE(model.index(0).data(SearchModel::KindRole).toString(), QString("answer"));
    QVERIFY(model.entryAt(0).isAnswer);
    model.setQuery("sun");
    QVERIFY(!model.entryAt(0).isAnswer);
  }
};

}  // namespace geargraph

QTEST_MAIN(geargraph::SearchAnswersTest)
#include "test_search_answers.moc"
