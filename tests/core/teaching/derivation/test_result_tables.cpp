#include <QTest>

#include "core/foundations/files/csv.h"
#include "core/mechanism/model/edits.h"
#include "core/teaching/derivation/named_results.h"
#include "core/teaching/derivation/result_text.h"
#include "tests/core/support/example_files.h"

namespace geargraph {

/// The tables beside the matrices of whole numbers, for the paper's robot.
class ResultTablesTest : public QObject {
  Q_OBJECT

  SnapshotPtr live;
  SnapshotPtr full;

  [[nodiscard]] static Mechanism robot() { return test::example("robot"); }
  [[nodiscard]] static ResultTablePtr tableOf(const SnapshotPtr& snapshot, const char* name, EntryForm form) {
    return resultTable(*resultNamed(name), {snapshot}, form);
  }
  [[nodiscard]] ResultTablePtr table(const char* name, EntryForm form) const {
    return tableOf(full, name, form);
  }
  /// "C15 | -i15 0 0 -1 0 0 0"
  [[nodiscard]] static QStringList lines(const ResultTable& table) {
    QStringList all;
    for (int i = 0; i < table.rows(); ++i) {
      QString line = QString::fromStdString(table.rowHeading(i).text).simplified() + " |";
      for (int j = 0; j < table.columns(); ++j) {
        const auto entry = table.entry(i, j);
        line += ' ' + (entry ? QString::fromStdString(entry->text) : QString("0"));
      }
      all << line;
    }
    return all;
  }
  [[nodiscard]] static QString explained(const ResultTable& table, int row, int column) {
    const CellExplanation cell = table.explanation(row, column);
    return QString::fromStdString(cell.title + " | " + cell.text);
  }

 private slots:
  void initTestCase() {
    live = analyzeLive(std::make_shared<const Mechanism>(robot()));
    full = analyzeFully(live);
  }

  void eq24_coefficientsInRatios() {
    const ResultTablePtr p = table("p", EntryForm::symbols);
    QStringList heads;
    for (int j = 0; j < p->columns(); ++j) heads << QString::fromStdString(p->columnHeading(j).text);
    QCOMPARE(heads.join(' '), QString("8 9 11 10 12 13 14"));  // the inputs first
    QCOMPARE(p->partition(), std::optional<int>(3));
    QCOMPARE(lines(*p), (QStringList{"C15 | -i15 0 0 -1 0 0 0", "C16 | 0 i16 0 -i16 1 0 0",
                                     "C17 | 0 0 i17 0 -i17 1 0", "C18 | 0 0 0 0 0 -i18 1"}));
  }

  void eq19_coefficientsInLengths() {
    const ResultTablePtr p = table("p", EntryForm::fractions);
    QVERIFY(!p->partition());
    // d4/2 = 18, d1/2 = 36, d5/2 = 20, d2/2 = 30, d6/2 = 24, d7'/2 = 18, d7''/2 = 16, d3/2 = 24
    QCOMPARE(lines(*p), (QStringList{"C15 | -18 0 -36 0 0 0 0", "C16 | 0 20 -20 0 30 0 0",
                                     "C17 | 0 0 0 24 -24 18 0", "C18 | 0 0 0 0 0 -16 24"}));
    const ResultTablePtr decimals = table("p", EntryForm::decimals);
    for (int row = 0; row < 4; ++row) {
      const auto exact = p->row(row);
      const auto rounded = decimals->row(row);
      QCOMPARE(exact.size(), rounded.size());
      for (std::size_t i = 0; i < exact.size(); ++i) QCOMPARE(exact[i].value, rounded[i].value);
    }
  }

  void eq25_solution() {
    const ResultTablePtr s = table("solution", EntryForm::symbols);
    QVERIFY(s->headsAreRates());
    QCOMPARE(lines(*s),
             (QStringList{"10 | -i15 0 0", "12 | -i16*i15 -i16 0", "13 | -i17*i16*i15 -i17*i16 -i17",
                          "14 | -i18*i17*i16*i15 -i18*i17*i16 -i18*i17"}));
    QCOMPARE(lines(*table("solution", EntryForm::fractions)).at(1), QString("12 | -1/3 -2/3 0"));
    QCOMPARE(lines(*table("solution", EntryForm::decimals)).at(0), QString("10 | -0.5 0 0"));
  }

  void eq06_screws() {
    const ResultTablePtr u = table("screw", EntryForm::fractions);
    QCOMPARE(u->rows(), 10);  // 2 + 3 + 3 + 2 joints of the four cycles
    QCOMPARE(u->columns(), 6);
    QCOMPARE(u->partition(), std::optional<int>(3));
    QCOMPARE(QString::fromStdString(u->rowHeading(2).text).simplified(), QString("C16 9"));
    for (int row = 0; row < u->rows(); ++row) {
      double square = 0;
      for (const ResultEntry& entry : u->row(row)) square += entry.column < 3 ? entry.value * entry.value : 0;
      QVERIFY(std::abs(square - 1) < 1e-12);
    }
    // Where all x are 0, Q = R = 0, Eq. (12): the moment is P alone.
    for (int row = 0; row < u->rows(); ++row) {
      QVERIFY(u->entry(row, 3));
      QVERIFY(!u->entry(row, 4) && !u->entry(row, 5));
    }
  }

  void pIsTTimesTheScrewsMoment() {
    const ResultTablePtr u = table("screw", EntryForm::decimals);
    const ResultTablePtr p = table("p", EntryForm::decimals);
    const IntegerMatrix& t = *full->matrix(MatrixKind::spanningTree);
    int row = 0;
    for (int mesh = 0; mesh < p->rows(); ++mesh) {
      for (const ResultEntry& entry : p->row(mesh)) {
        QCOMPARE(entry.value, t.entry(mesh, entry.column) * u->entry(row, 3)->value);
        ++row;
      }
    }
  }

  /// Columns are the branches, then the two chords of each mesh, named as the T-T graph's equations name
  /// them.
  void circuitsAndCutsetsOfTheTtGraph() {
    const ResultTablePtr b = table("tt-circuits", EntryForm::fractions);
    QStringList heads;
    for (int j = 0; j < b->columns(); ++j) heads << QString::fromStdString(b->columnHeading(j).text);
    QCOMPARE(heads.join(' '), QString("8 9 10 11 12 13 14 40' 10' 51'' 21'' 62''' 72''' 72'''' 32''''"));
    QCOMPARE(b->partition(), std::optional<int>(7));
    QCOMPARE(lines(*b).at(2), QString("51'' | 0 -1 1 0 0 0 0 0 0 1 0 0 0 0 0"));
    const ResultTablePtr q = table("tt-cutsets", EntryForm::fractions);
    QCOMPARE(lines(*q).at(2), QString("10 | 0 0 1 0 0 0 0 0 1 -1 0 0 0 0 0"));  // M_10 + M'_10 - M''_51 = 0
    QVERIFY(q->columnHeading(9).element == ElementId(MeshId("16")));
    QCOMPARE(q->elementsOfRow(2), (std::set<ElementId>{JointId("10"), MeshId("15"), MeshId("16")}));
    QCOMPARE(b->elementsOfRow(2), (std::set<ElementId>{JointId("9"), JointId("10"), MeshId("16")}));
    QCOMPARE(explained(*q, 2, 9),
             QString("f-cutset of joint 10, 51'': −1 | The torque of the chord 51'' from gear 5 to carrier 1 "
                     "acts across the cut, against the sense of joint 10: minus its entry in the f-circuit. "
                     "Not in the paper."));
    QVERIFY(explained(*q, 2, 7).contains("Both ends of the chord 40' from gear 4 to carrier 0"));
    QVERIFY(explained(*b, 2, 1).contains("joint 9 counts with plus. On one side with the chord it is −1."));
    QVERIFY(explained(*b, 2, 0).contains("Joint 8 is not between the ends of the chord 51''"));
    QVERIFY(tableOf(full, "tt-cutsets", EntryForm::decimals) == nullptr);  // whole numbers
    QVERIFY(resultText(*q, TableFormat::csv).starts_with("Qtt,8,9,10,11,12,13,14,40',10',51'',"));
    QVERIFY(resultText(*q, TableFormat::latex).starts_with("\\begin{array}{c|rrrrrrr|rrrrrrrr}"));
  }

  void anEngagedCouplingIsAChord() {
    Mechanism simpson = test::example("simpson");
    simpson.engaged = simpson.states.front().engaged;
    const SnapshotPtr snapshot = analyzeLive(std::make_shared<const Mechanism>(std::move(simpson)));
    const ResultTablePtr q = tableOf(snapshot, "tt-cutsets", EntryForm::fractions);
    QVERIFY(q != nullptr);
    const int last = q->columns() - 1;
    const ElementId coupling(snapshot->mechanism->engaged.back());
    QVERIFY(q->columnHeading(last).element == coupling);
    int crossing = 0;
    for (int row = 0; row < q->rows(); ++row) {
      if (!q->entry(row, last)) continue;
      ++crossing;
      QVERIFY(q->elementsOfRow(row).contains(coupling));
      QVERIFY(explained(*q, row, last).contains("the chord of coupling"));
    }
    QVERIFY(crossing > 0);
  }

  void cellsTellTheirRule() {
    const ResultTablePtr p = table("p", EntryForm::symbols);
    QCOMPARE(
        explained(*p, 1, 1),
        QString("C16, joint 9: i16 | The row divided by the radius of the head's gear: joint 9 turns about "
                "the axis of the tail's gear, which leaves the ratio i16 = 2/3. Eq. (24)"));
    QVERIFY(explained(*p, 1, 0).contains("C16 does not use joint 8"));
    const ResultTablePtr s = table("solution", EntryForm::symbols);
    QVERIFY(explained(*s, 1, 0).contains("With these teeth: -1/3. Eq. (25)"));
    QVERIFY(explained(*s, 0, 2).contains("does not feel input 11"));
    const ResultTablePtr u = table("screw", EntryForm::decimals);
    QVERIFY(explained(*u, 2, 3).contains("C16, joint 9, P"));
    QVERIFY(explained(*u, 2, 3).contains("pitch point of mesh 16"));
    QVERIFY(explained(*u, 2, 2).contains("Eqs. (7)-(9)"));
  }

  void rowsNameWhatLightsUp() {
    const ResultTablePtr s = table("solution", EntryForm::symbols);
    QCOMPARE(s->elementsOfRow(1), (std::set<ElementId>{JointId("12"), LinkId("2")}));
    const ResultTablePtr p = table("p", EntryForm::symbols);
    QCOMPARE(p->elementsOfRow(0), (std::set<ElementId>{JointId("8"), JointId("10"), MeshId("15")}));
    const ResultTablePtr u = table("screw", EntryForm::decimals);
    QCOMPARE(u->elementsOfRow(2), (std::set<ElementId>{JointId("9"), MeshId("16")}));
    QVERIFY(u->columnHeading(0).element.id.empty());
  }

  void textsForOtherPrograms() {
    const ResultTablePtr p = table("p", EntryForm::symbols);
    QVERIFY(resultText(*p, TableFormat::csv).starts_with("P,8,9,11,10,12,13,14\nC15,-i15,0,0,-1,0,0,0\n"));
    QVERIFY(resultText(*p, TableFormat::tsv).find("C16\t0\ti16\t0\t-i16\t1\t0\t0\n") != std::string::npos);
    const std::string latex = resultText(*p, TableFormat::latex);
    QVERIFY(latex.starts_with("\\begin{array}{c|rrr|rrrr}\n & 8 & 9"));
    QVERIFY(latex.find("C_{15} & -i_{15} & 0") != std::string::npos);
    const ResultTablePtr s = table("solution", EntryForm::fractions);
    QVERIFY(
        resultText(*s, TableFormat::latex).find("\\dot{\\theta}_{12} & -\\frac{1}{3} & -\\frac{2}{3} & 0") !=
        std::string::npos);
    QVERIFY(resultText(*s, TableFormat::matlab).find("S = [\n  -1/2 0 0\n") != std::string::npos);
    // Decimals that read back as the same double.
    QVERIFY(resultText(*table("solution", EntryForm::decimals), TableFormat::numpy)
                .find("[-0.3333333333333333, -0.6666666666666666, 0]") != std::string::npos);
    QVERIFY(resultText(*table("screw", EntryForm::decimals), TableFormat::csv)
                .starts_with("U,L,M,N,P,Q,R\nC15 8,"));
  }

  void csvIsWrittenAsSpreadsheetsWantIt() {
    const auto csvOf = [](const ResultTable& of, const CsvOptions& options) {
      TextSink sink;
      writeResultCsv(sink, of, options, CsvEntries::asShown);
      return sink.take();
    };
    const ResultTablePtr s = table("solution", EntryForm::decimals);
    QCOMPARE(csvOf(*s, {}), resultText(*s, TableFormat::csv));
    QVERIFY(csvOf(*s, {';', ',', true, true}).starts_with("\xEF\xBB\xBFS;8;9;11\n10;-0,5;0;0\n"));
    QVERIFY(csvOf(*s, {'\t', '.', false, false}).starts_with("-0.5\t0\t0\n"));
    QVERIFY(csvOf(*s, {',', ',', false, false}).starts_with("\"-0,5\",0,0\n"));
    const ResultTablePtr p = table("p", EntryForm::symbols);
    QCOMPARE(csvOf(*p, {',', ',', true, false}), resultText(*p, TableFormat::csv));
  }

  void whatIsNotThereYetIsNotShown() {
    QVERIFY(tableOf(live, "solution", EntryForm::decimals) != nullptr);
    QVERIFY(tableOf(live, "solution", EntryForm::fractions) == nullptr);
    QVERIFY(tableOf(live, "p", EntryForm::symbols) != nullptr);
    const SnapshotPtr empty = analyzeLive(std::make_shared<const Mechanism>(emptyMechanism()));
    for (const NamedResult* result : namedResults()) {
      const ResultTablePtr none = resultTable(*result, {empty}, EntryForm::decimals);
      QVERIFY(!none || none->rows() == 0);
    }
    Mechanism loose = *withLink(robot(), {0, 0});
    const SnapshotPtr broken = analyzeLive(std::make_shared<const Mechanism>(std::move(loose)));
    for (const NamedResult* result : namedResults())
      if (result->of != ResultOf::graph) QVERIFY2(result->forms({broken}).empty(), result->name.data());
  }

  void rootsAreSaidToBeRounded() {
    // An axis in the direction (1 1 0): its unit vector is no fraction.
    Mechanism bevel = emptyMechanism();
    bevel = *withLink(std::move(bevel), {0, 0});
    bevel = *withLink(std::move(bevel), {1, 0});
    const LinkId ground = bevel.links[0].id;
    bevel = *withTurningJoint(bevel, ground, bevel.links[1].id);
    bevel = *withTurningJoint(bevel, ground, bevel.links[2].id);
    const NumberTriple origin{Number(0), Number(0), Number(0)};
    bevel = *withAxisPlaced(bevel, bevel.axes[0].id, origin, NumberTriple{Number(1), Number(1), Number(0)});
    bevel = *withAxisPlaced(bevel, bevel.axes[1].id, origin, NumberTriple{Number(0), Number(0), Number(1)});
    bevel = *withGearMesh(bevel, bevel.links[1].id, bevel.links[2].id, 20, 20);
    const SnapshotPtr snapshot = analyze(std::make_shared<const Mechanism>(std::move(bevel)));
    QVERIFY2(snapshot->matroid() != nullptr,
             snapshot->diagnostics.empty() ? "" : snapshot->diagnostics.front().message.c_str());
    const ResultTablePtr u = tableOf(snapshot, "screw", EntryForm::fractions);
    QCOMPARE(QString::fromStdString(u->entry(0, 0)->text), QString("≈ 0.707107"));
    QVERIFY(resultText(*u, TableFormat::csv).find("0.7071067811865") != std::string::npos);
    QVERIFY(resultText(*u, TableFormat::csv).find("≈") == std::string::npos);
  }
};

}  // namespace geargraph

QTEST_GUILESS_MAIN(geargraph::ResultTablesTest)
#include "test_result_tables.moc"
