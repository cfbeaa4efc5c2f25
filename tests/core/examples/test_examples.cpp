#include <QDir>
#include <QFile>
#include <QTest>

#include "core/io/mechanism_file.h"
#include "core/mechanism/validate.h"
#include "core/ttgraph/tt_solution.h"
#include "tests/core/support/tt_case.h"

namespace geargraph {
namespace {

const QString kFolder = QStringLiteral(GEARGRAPH_SOURCE_DIR "/resources/examples/");

std::string contentsOf(const QString& name) {
  QFile file(kFolder + name + QStringLiteral(".geargraph"));
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s cannot be read", qPrintable(file.fileName()));
  return file.readAll().toStdString();
}

/// An example's own inputs, and the rates that its notes promise: label of the joint, rate.
struct Promise {
  const char* example;
  int freedoms;
  int redundant;
  std::vector<std::pair<int, Rational>> rates;
};

const std::vector<Promise>& promises() {
  static const std::vector<Promise> all{
      {"robot",
       3,
       0,
       {{10, Rational(-1, 2)}, {12, Rational(-2, 3)}, {13, Rational(-8, 9)}, {14, Rational(-16, 27)}}},
      {"spur-pair", 1, 0, {{4, Rational(-2, 3)}}},
      {"planetary-ring-held", 1, 0, {{5, Rational(2, 7)}, {6, Rational(-20, 21)}}},
      {"three-planets", 1, 2, {{7, Rational(2, 7)}, {9, Rational(-20, 21)}}},
      {"redundant-planetary", 2, 4, {{11, 0}, {12, Rational(-16, 9)}, {16, Rational(-16, 9)}}},
      {"ferguson-paradox", 1, 0, {{8, Rational(-1, 99)}, {9, 0}, {10, Rational(1, 101)}}},
      {"bevel-differential", 2, 1, {{8, Rational(1, 2)}}},
      {"humpage-reduction", 1, 0, {{6, Rational(5, 24)}, {8, Rational(17, 1176)}}},
      {"ravigneaux", 2, 0, {{9, Rational(5, 12)}, {8, Rational(-5, 6)}}},
      {"simpson", 2, 0, {{9, Rational(75, 183)}, {7, Rational(-75, 33) * Rational(75, 183)}}},
      {"locked-train", 0, 0, {{4, 0}, {5, 0}, {6, 0}}},
      {"bevel-wrist", 3, 0, {{9, Rational(2, 3)}, {11, 0}, {12, Rational(-8, 9)}}},
  };
  return all;
}

}  // namespace

/// The files that come with the program: each is there, written as the program writes, free of errors, and
/// moves as its notes say.
class ExamplesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFileIsPromised() {
    std::set<QString> files;
    for (const QString& file : QDir(kFolder).entryList({QStringLiteral("*.geargraph")})) {
      files.insert(file.section('.', 0, 0));
    }
    std::set<QString> promised;
    for (const Promise& promise : promises()) promised.insert(QString::fromLatin1(promise.example));
    QCOMPARE(files, promised);
  }

  void examplesMoveAsTheirNotesSay_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const Promise& promise : promises()) QTest::newRow(promise.example) << index++;
  }

  void examplesMoveAsTheirNotesSay() {
    QFETCH(int, index);
    const Promise& promise = promises()[static_cast<std::size_t>(index)];
    const std::string bytes = contentsOf(QString::fromLatin1(promise.example));
    const Expected<Mechanism> read = readMechanism(bytes);
    QVERIFY(read.has_value());
    QCOMPARE(QString::fromStdString(writeMechanism(*read)), QString::fromStdString(bytes));
    QVERIFY(!read->notes.empty());
    QVERIFY(treeDiagnostics(*read).empty());

    const test::TtCase found(*read);
    for (const Diagnostic& finding : found.placement.diagnostics) qWarning("%s", finding.message.c_str());
    QVERIFY(found.placement.diagnostics.empty());
    QVERIFY(found.graph.diagnostics().empty());
    const SubstitutionPlan plan = substitutionPlan(found.graph, found.inputs());
    const TtDetermination determination = ttDetermination(found.graph, plan).value();
    QVERIFY(determination.valid());
    QCOMPARE(static_cast<int>(plan.inputs.size()), promise.freedoms);
    QCOMPARE(static_cast<int>(determination.surplusMeshes.size()), promise.redundant);
    const std::vector<Rational> rates = ttRates(found.graph, plan, found.speeds()).value();
    for (const auto& [label, rate] : promise.rates) {
      const auto joint = static_cast<std::size_t>(label - read->jointLabel(0));
      QCOMPARE(rates[joint].toString(), rate.toString());
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ExamplesTest)
#include "test_examples.moc"
