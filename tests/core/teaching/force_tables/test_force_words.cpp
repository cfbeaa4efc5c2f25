#include <QTest>

#include "core/foundations/base/locale.h"
#include "core/teaching/force_tables/cutset_words.h"
#include "core/teaching/force_tables/efficiency_table.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/pseudo_language.h"
#include "tests/core/support/statics_case.h"
#include "tests/core/support/train_sketch.h"

using namespace geargraph;
using namespace geargraph::test;

namespace {

/// Units and symbols that are the same in every language, and the names of the elements.
std::vector<std::string> namesIn(const Mechanism& mechanism) {
  std::vector<std::string> names{"rad"};
  for (const Link& link : mechanism.links) names.push_back(link.name);
  for (const ShiftElement& coupling : mechanism.couplings) names.push_back(coupling.id.text());
  return names;
}

/// A planetary set of three planets, whose meshes share the load, or one.
struct Loaded {
  StaticsCase train;
  StaticsReport report;

  /// Without losses the shares of three planets stay open.
  explicit Loaded(int planets, bool losses = true)
      : train(mechanismOf(planets)), report(reportOf(train, optionsOf(train, losses))) {}

  static Mechanism mechanismOf(int planets) {
    Mechanism mechanism = planetary(24, 18, planets);
    const auto& joints = mechanism.turningJoints;
    mechanism.inputs = std::vector<Input>{{joints[0].id, Number(100), {}}, {joints[1].id, Number(0), {}}};
    return mechanism;
  }
  static StaticsOptions optionsOf(const StaticsCase& train, bool losses) {
    StaticsOptions options;
    const auto& joints = train.mechanism.turningJoints;
    options.loads = {{{}, JointTorque{joints[0].id, Number(10)}}};
    options.balances = {{joints[1].id}, {joints[2].id}};
    options.losses = losses;
    options.efficiency = Rational(98, 100);
    return options;
  }

  [[nodiscard]] ForceTable table(ForceTableKind kind) const {
    return forceTable(train.mechanism, train.model, train.placement, report, kind);
  }
};

std::string csvOf(const ValueTable& table) {
  TextSink sink;
  writeForceCsv(sink, table);
  return sink.text();
}

/// All tables, one below the other, as files hold them.
std::string allCsv() {
  std::string all;
  for (const Loaded& loaded : {Loaded(1), Loaded(3), Loaded(3, false)})
    for (const ForceTableKind kind : allForceTableKinds()) all += csvOf(loaded.table(kind));
  return all + csvOf(shiftTable(eightSpeed(), {}));
}

}  // namespace

/// The tables of forces are looked up in the catalogue; files hold them in English.
class ForceWordsTest : public QObject {
  Q_OBJECT

  static void verifyTranslated(const std::string& text, const std::vector<std::string>& names) {
    const auto words = PseudoLanguage::english(text, names);
    QVERIFY2(words.empty(), (text + " [" + (words.empty() ? "" : words.front()) + ']').c_str());
  }

  static void verifyTable(const ValueTable& table, const std::vector<std::string>& names) {
    for (const ForceColumn& column : table.columns) {
      verifyTranslated(column.head, names);
      verifyTranslated(column.meaning, names);
    }
    for (const ForceRow& row : table.rows)
      for (const ForceCell& cell : row.cells) verifyTranslated(cell.text, names);
  }

 private slots:
  void tablesAreTranslated() {
    const PseudoLanguage pseudo;
    for (const int planets : {1, 3}) {
      const Loaded loaded(planets);
      const std::vector<std::string> names = namesIn(loaded.train.mechanism);
      std::vector<ForceTableKind> kinds = allForceTableKinds();
      kinds.push_back(ForceTableKind::needs);
      for (const ForceTableKind kind : kinds) {
        verifyTranslated(translated(forceTableTitle(kind)), names);
        verifyTable(loaded.table(kind), names);
      }
    }
    verifyTranslated(translated(forceTableTitle(ForceTableKind::states)), {});
    const Mechanism box = eightSpeed();
    verifyTable(shiftTable(box, {}), namesIn(box));
  }

  void sentencesAreTranslated() {
    const PseudoLanguage pseudo;
    int read = 0;
    for (const int planets : {1, 3}) {
      const Loaded loaded(planets);
      const Mechanism& mechanism = loaded.train.mechanism;
      const std::vector<std::string> names = namesIn(mechanism);
      for (const Diagnostic& diagnostic : loaded.report.diagnostics)
        verifyTranslated(diagnostic.message, names);
      for (int joint = 0; joint < mechanism.t(); ++joint) {
        const auto cutset =
            cutsetWords(mechanism, loaded.train.model, loaded.train.placement, loaded.report, joint);
        if (!cutset) continue;
        verifyTranslated(cutset->sentence, names);
        verifyTranslated(cutset->equation, names);
        ++read;
      }
      for (int mesh = 0; mesh < mechanism.c(); ++mesh) {
        const auto sentence = driverSentence(mechanism, loaded.train.placement, loaded.report, mesh);
        if (!sentence) continue;
        verifyTranslated(*sentence, names);
        ++read;
      }
    }
    QVERIFY(read > 8);
  }

  void filesAreEnglishInEveryLanguage() {
    const std::string english = allCsv();
    const PseudoLanguage pseudo;
    setDecimalSign(',');
    const std::string other = allCsv();
    setDecimalSign('.');
    QCOMPARE(QString::fromStdString(other), QString::fromStdString(english));
    QVERIFY(english.find("carried by") != std::string::npos);
    QVERIFY(english.find("shared") != std::string::npos);
  }

  void numbersAreWrittenWithTheSignInUse() {
    setDecimalSign(',');
    const std::string german = shownNumber(12.5);
    std::string inEnglish;
    {
      const EnglishScope english;
      inEnglish = shownNumber(12.5);
    }
    setDecimalSign('.');
    QCOMPARE(german, std::string("12,5"));
    QCOMPARE(inEnglish, std::string("12.5"));
    QCOMPARE(shownNumber(12.5), std::string("12.5"));
  }
};

QTEST_APPLESS_MAIN(ForceWordsTest)
#include "test_force_words.moc"
