#include <QRegularExpression>
#include <QTest>
#include <set>

#include "core/foundations/base/locale.h"
#include "core/machine/body_layout/derived_geometry.h"
#include "core/mechanism/model/load_edits.h"
#include "core/presentation/report/report.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/pseudo_language.h"

namespace geargraph {
namespace {

using test::PseudoLanguage;

SnapshotPtr solved(Mechanism mechanism) {
  return analyze(std::make_shared<const Mechanism>(std::move(mechanism)));
}

/// The names that a document gives, and those that stay as they are in every language.
std::vector<std::string> namesIn(const Mechanism& mechanism) {
  std::vector<std::string> names{"rad",         "axes",   "eta",           "csv",
                                 "export",      "matrix", "spanning-tree", "reduced-incidence",
                                 "cycle-basis", "deg",    mechanism.name,  mechanism.notes,
                                 mechanism.unit};
  for (int m = 0; m < mechanism.c(); ++m) {  // gears, as options name them
    for (const char* side : {":tail", ":head"})
      names.push_back(std::to_string(mechanism.meshLabel(m)) + side);
  }
  for (const Link& link : mechanism.links) {
    names.push_back(link.name);
    names.push_back(link.id.text());
  }
  for (const Axis& axis : mechanism.axes) names.push_back(axis.id.text());
  for (const ShiftElement& coupling : mechanism.couplings) names.push_back(coupling.id.text());
  for (const ShiftState& state : mechanism.states) names.push_back(state.name);
  return names;
}

/// All that people read of a report, apart from its formulas.
class ReportTexts {
 public:
  explicit ReportTexts(const Report& report) {
    texts = {report.title, report.subtitle};
    for (const ReportBlock& block : report.blocks) std::visit(*this, block);
  }

  void operator()(const ReportHeading& heading) { texts.push_back(heading.text); }
  void operator()(const ReportParagraph& paragraph) { add(paragraph.words); }
  void operator()(const ReportEquation& /*equation*/) {}
  void operator()(const ReportTable& table) {
    texts.insert(texts.end(), table.head.begin(), table.head.end());
    for (const auto& row : table.rows)
      for (const ReportWords& cell : row) add(cell);
  }
  void operator()(const ReportList& list) {
    for (const ReportWords& item : list.items) add(item);
  }
  void operator()(const ReportFigure& figure) { texts.push_back(figure.caption); }
  void operator()(const ReportCurves& curves) {
    texts.push_back(curves.caption);
    for (const CurveChart& chart : curves.charts) {
      texts.push_back(chart.title);
      texts.push_back(chart.xTitle);
      for (const auto& curve : chart.curves) texts.push_back(curve.name);
    }
  }

  std::vector<std::string> texts;

 private:
  void add(const ReportWords& words) {
    for (const ReportSpan& span : words)
      if (!span.isFormula) texts.push_back(span.text);
  }
};

/// The examples, with loads where they have none, and the gearbox in a state.
template <class Visit>
void visitDocuments(const Visit& visit) {
  for (const std::string& name : test::exampleNames()) {
    const Mechanism mechanism = test::example(name);
    if (mechanism.n() > kMaxReportLinks) continue;
    visit(mechanism);
    if (!mechanism.loads.empty() || mechanism.turningJoints.empty()) continue;
    const auto loaded =
        withLoad(mechanism, {LoadId("load"), JointTorque{mechanism.turningJoints.front().id, Number(10)}});
    if (loaded) visit(*loaded);
  }
  Mechanism box = test::eightSpeed();
  box.engaged = box.states.front().engaged;
  visit(box);
}

}  // namespace

/// The derivation, the report and the diagnostics of documents are looked up in the catalogue, all of them.
class ReportWordsTest : public QObject {
  Q_OBJECT

  static void verifyTranslated(const std::string& text, const std::vector<std::string>& names) {
    const auto words = PseudoLanguage::english(text, names);
    QVERIFY2(words.empty(), (text + " [" + (words.empty() ? "" : words.front()) + ']').c_str());
  }

 private slots:
  void reportsOfTheExamplesAreTranslated() {
    const PseudoLanguage pseudo;
    std::size_t read = 0;
    visitDocuments([&](const Mechanism& mechanism) {
      const std::vector<std::string> names = namesIn(mechanism);
      for (const std::string& text : ReportTexts(derivationReport(solved(mechanism))).texts) {
        verifyTranslated(text, names);
        ++read;
      }
    });
    QVERIFY(read > 5000);
  }

  void diagnosticsOfTheExamplesAreTranslated() {
    const PseudoLanguage pseudo;
    std::set<Code> seen;
    visitDocuments([&](const Mechanism& mechanism) {
      const std::vector<std::string> names = namesIn(mechanism);
      const SnapshotPtr snapshot = solved(mechanism);
      Diagnostics all = snapshot->diagnostics;
      if (snapshot->geometry != nullptr)
        if (const auto ofTrain = snapshot->geometry->diagnostics({})) append(all, *ofTrain);
      for (const Diagnostic& diagnostic : all) {
        seen.insert(diagnostic.code);
        verifyTranslated(diagnostic.message, names);
      }
    });
    for (const Code code : {Code::assembly, Code::redundantMesh}) QVERIFY(seen.contains(code));
  }

  /// A page says which language it is in.
  void pagesNameTheirLanguage() {
    const Report report = derivationReport(solved(test::example("robot")));
    QVERIFY(reportHtml(report, {}).starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    setCatalogue([](const char* text, int /*n*/) {
      return std::string_view(text) == "en" ? std::string("de") : std::string();
    });
    const std::string page = reportHtml(report, {});
    setCatalogue(nullptr);
    QVERIFY(page.starts_with("<!DOCTYPE html>\n<html lang=\"de\">"));
  }

  /// Decimals have the decimal sign in use in sentences and formulas; what files hold has a point.
  void decimalsAreWrittenWithTheSignInUse() {
    const auto allFormulas = [] {
      const Mechanism loaded = *withLoad(test::example("planetary-ring-held"),
                                         {LoadId("l"), JointTorque{JointId("6"), Number(Rational(1, 3))}});
      std::string all;
      for (const ReportBlock& block : derivationReport(solved(loaded)).blocks)
        if (const auto* equation = std::get_if<ReportEquation>(&block)) all += equation->tex + '\n';
      return all;
    };
    const QString english = QString::fromStdString(allFormulas());
    setDecimalSign(',');
    const QString german = QString::fromStdString(allFormulas());
    QString inEnglish;
    {
      const EnglishScope scope;
      inEnglish = QString::fromStdString(allFormulas());
    }
    setDecimalSign('.');
    static const QRegularExpression decimalPoint(QStringLiteral("[0-9][.][0-9]"));
    QVERIFY(decimalPoint.match(english).hasMatch());
    QVERIFY2(!decimalPoint.match(german).hasMatch(), qPrintable(german));
    QString expected = english;
    expected.replace(QRegularExpression(QStringLiteral("([0-9])[.]([0-9])")), QStringLiteral("\\1{,}\\2"));
    QCOMPARE(german, expected);
    QCOMPARE(inEnglish, english);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ReportWordsTest)
#include "test_report_words.moc"
