#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <numeric>
#include <set>

#include "core/mechanism/model/load_edits.h"
#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/report/latex_lines.h"
#include "core/presentation/report/report.h"
#include "core/presentation/typeset/tex_reader.h"
#include "core/presentation/typeset/typeset.h"
#include "core/teaching/derivation/comparison_families.h"
#include "tests/core/presentation/report/derived_report.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/train_sketch.h"

namespace geargraph {
namespace {

using test::reportOf;

/// The formula beside a number; with a star or without.
std::map<int, std::string> numbered(const Report& report, bool isDual = false) {
  std::map<int, std::string> equations;
  for (const ReportBlock& block : report.blocks) {
    const auto* equation = std::get_if<ReportEquation>(&block);
    if (equation == nullptr || !equation->number || equation->isDual != isDual) continue;
    if (!equations.emplace(*equation->number, equation->tex).second) {
      qFatal("two equations (%s)", equation->label().c_str());
    }
  }
  return equations;
}

/// The robot's hand turned by 10 N m.
Mechanism loadedRobot() {
  return *withLoad(test::example("robot"), {LoadId("hand"), JointTorque{JointId("14"), Number(10)}});
}

/// Every <math> of the page, read as XML; the number of them.
int mathsOf(const QString& page) {
  static const QRegularExpression math(QStringLiteral("<math.*?</math>"),
                                       QRegularExpression::DotMatchesEverythingOption);
  int count = 0;
  for (auto found = math.globalMatch(page); found.hasNext(); ++count) {
    QXmlStreamReader reader(found.next().captured());
    while (!reader.atEnd()) reader.readNext();
    if (reader.hasError()) qFatal("%s", qPrintable(reader.errorString()));
  }
  return count;
}

/// Braces and environments close in order, no line within a formula is empty, no dollar is left over.
QString latexFault(const QString& text) {
  std::vector<QString> open;
  static const QRegularExpression mark(QStringLiteral(R"(\\(begin|end)\{([a-z*]+)\}|\\[{}\\$]|[{}])"));
  for (auto found = mark.globalMatch(text); found.hasNext();) {
    const auto match = found.next();
    const QString word = match.captured();
    if (word == "{") open.push_back(word);
    if (match.captured(1) == "begin") open.push_back(match.captured(2));
    const QString closed = word == "}"                  ? QStringLiteral("{")
                           : match.captured(1) == "end" ? match.captured(2)
                                                        : QString();
    if (closed.isEmpty()) continue;
    if (open.empty() || open.back() != closed)
      return QStringLiteral("%1 at %2").arg(word).arg(match.capturedStart());
    open.pop_back();
  }
  if (!open.empty()) return open.back() + " is open";
  static const QRegularExpression gap(
      QStringLiteral(R"(\\begin\{equation\*\}((?!\\end\{equation).)*\n\s*\n)"),
      QRegularExpression::DotMatchesEverythingOption);
  return gap.match(text).hasMatch() ? QStringLiteral("an empty line in a formula") : QString();
}

}  // namespace

/// The derivation as data and in its three forms.
class ReportTest : public QObject {
  Q_OBJECT

  static void check(const Report& report) {
    for (const bool isDual : {false, true}) (void)numbered(report, isDual);
    const QString page = QString::fromStdString(reportHtml(report, {"<svg/>", "", "<svg/>"}));
    qsizetype formulas = 0;
    for (const ReportBlock& block : report.blocks)
      formulas += std::holds_alternative<ReportEquation>(block) ? 1 : 0;
    QVERIFY(mathsOf(page) >= formulas);
    QCOMPARE(latexFault(QString::fromStdString(reportLatex(report))), QString());
    QVERIFY(reportMarkdown(report).size() > 100);
  }

 private slots:
  /// The table's numbers as curves: a chart for each family, drawn in the web page.
  void theMethodsAreComparedByCurves() {
    const Report report = reportOf(test::example("robot"));
    std::vector<ReportCurves> found;
    for (const ReportBlock& block : report.blocks) {
      if (const auto* curves = std::get_if<ReportCurves>(&block)) found.push_back(*curves);
    }
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].charts.size(), std::size_t{3});
    std::size_t points = 0;
    for (const CurveChart& chart : found[0].charts) {
      QCOMPARE(chart.curves.size(), std::size_t{2});
      QCOMPARE(chart.curves[0].points.size(), chart.curves[1].points.size());
      points += chart.curves[0].points.size();
    }
    QCOMPARE(points, familyCounts().size());
    // A row of n gears: (n - 1)(n - 2) / 2 products by the inverse, n - 2 by substitution, and no sums.
    for (std::size_t i = 0; i < found[0].charts[0].curves[0].points.size(); ++i) {
      const CanvasPoint inverse = found[0].charts[0].curves[0].points[i];
      const double n = inverse.x;
      QCOMPARE(inverse.y, (n - 1) * (n - 2) / 2);
      QCOMPARE(found[0].charts[0].curves[1].points[i].y, n - 2);
    }
    const std::string page = reportHtml(report, {});
    QVERIFY(page.find("<figcaption>" + found[0].caption) != std::string::npos);
    QVERIFY(page.find(">Substitution</text>") != std::string::npos);
  }

  /// Places and speeds of the points, the drawings where the form has them; nothing without a lever.
  void leversAreATableAndTwoDrawings() {
    const auto levers = [](const Report& report) {
      std::vector<std::vector<std::string>> rows;
      bool isInside = false;
      for (const ReportBlock& block : report.blocks) {
        if (const auto* heading = std::get_if<ReportHeading>(&block))
          isInside = heading->level == 1 && heading->text == "Levers";
        const auto* table = std::get_if<ReportTable>(&block);
        if (!isInside || table == nullptr) continue;
        for (const auto& row : table->rows) {
          std::vector<std::string>& words = rows.emplace_back();
          for (const ReportWords& cell : row) words.push_back(cell.front().text);
        }
      }
      return rows;
    };
    const Report held = reportOf(test::example("planetary-ring-held"));
    QCOMPARE(levers(held), (std::vector<std::vector<std::string>>{
                               {"0", "0", "0"}, {"2", "\\frac{2}{7}", "\\frac{2}{7}"}, {"1", "1", "1"}}));
    QVERIFY(levers(reportOf(test::example("robot"))).empty());
    const Report simpson = reportOf(test::example("simpson"));
    QCOMPARE(levers(simpson).size(), std::size_t{4});
    ReportDrawings drawings;
    drawings[ReportDrawing::levers] = "<svg>bars</svg>";
    drawings[ReportDrawing::nomogram] = "<svg>states</svg>";
    const std::string page = reportHtml(simpson, drawings);
    QVERIFY(page.find("bars") < page.find("states") && page.find("states") != std::string::npos);
    QVERIFY(reportHtml(held, drawings).find("states") == std::string::npos);  // no states, no nomogram
  }

  // The paper's own text, with its own numbers.
  void theRobotIsThePaper() {
    const Report report = reportOf(test::example("robot"));
    std::vector<int> numbers;
    for (const ReportBlock& block : report.blocks)
      if (const auto* equation = std::get_if<ReportEquation>(&block); equation && equation->number)
        numbers.push_back(*equation->number);
    std::vector<int> all(45);
    std::iota(all.begin(), all.end(), 1);
    QCOMPARE(numbers, all);
    const auto equations = numbered(report);
    QCOMPARE(equations.at(9),
             std::string("L_k = 0 , \\quad M_k = -\\sin\\varphi_k , \\quad N_k = \\cos\\varphi_k"));
    QVERIFY(equations.at(19).find("\\dot{\\theta}_{14} \\end{pmatrix} = 0") != std::string::npos);
    QCOMPARE(equations.at(21), std::string("E = t - r = 7 - 4 = 3"));
    QCOMPARE(equations.at(27), std::string("\\omega_{40}' = -n_{14} \\omega_{10}'"));
    QCOMPARE(equations.at(31), std::string("\\omega_{51}'' = \\omega_{50} - \\omega_{10}"));
    QVERIFY(equations.at(20).find("i_{16} &= \\frac{N_{5}}{N_{2}} = \\frac{20}{30} = \\frac{2}{3}") !=
            std::string::npos);
    QVERIFY(equations.at(25).find("-i_{17} i_{16} i_{15} & -i_{17} i_{16} & -i_{17}") != std::string::npos);
    QVERIFY(equations.at(40).find("&= -n_{52} n_{41} \\omega_{40} - n_{52} \\omega_{50}") !=
            std::string::npos);
    // The rows of (45) are in the paper's order, not in that of (25).
    const std::size_t third =
        equations.at(45).find("-i_{18} i_{17} i_{16} i_{15} & -i_{18} i_{17} i_{16} & -i_{18} i_{17}");
    const std::size_t fourth = equations.at(45).find("-i_{17} i_{16} i_{15} & -i_{17} i_{16} & -i_{17}");
    QVERIFY(third != std::string::npos && fourth != std::string::npos && third < fourth);
    QVERIFY(equations.at(43).find("\\omega_{32} \\\\ \\omega_{72}") != std::string::npos);
  }

  /// Axes beside the plane of y and z have no offset angle: (8) is left out, (9) is their length.
  void directionsInSpaceHaveNoOffsetAngle() {
    Mechanism mechanism = test::example("robot");
    for (Axis& axis : mechanism.axes) {
      if (axis.direction) std::swap((*axis.direction)[0], (*axis.direction)[1]);
      if (axis.point) std::swap((*axis.point)[0], (*axis.point)[1]);
    }
    for (GearMesh& mesh : mechanism.gearMeshes)
      if (mesh.pitchPoint) std::swap((*mesh.pitchPoint)[0], (*mesh.pitchPoint)[1]);
    const auto equations = numbered(reportOf(std::move(mechanism)));
    QVERIFY(!equations.contains(8));
    QCOMPARE(equations.at(9), std::string("L_k^2 + M_k^2 + N_k^2 = 1"));
    QVERIFY(equations.contains(25));
  }

  // The equations of statics, each with the number of its dual.
  void theStaticsOfTheRobot() {
    const Report report = reportOf(loadedRobot());
    check(report);
    const auto equations = numbered(report, true);
    QVERIFY(numbered(report).size() == numbered(reportOf(test::example("robot"))).size());
    QVERIFY(equations.at(5).find("Q \\, C^T = 0") != std::string::npos);
    QVERIFY(equations.at(17).find("\\tau + \\ell = P^T F") != std::string::npos);
    QVERIFY2(equations.at(19).find("\\tau_{14} &= ") != std::string::npos, equations.at(19).c_str());
    QVERIFY2(equations.at(25).find(
                 "i_{15} & i_{16} i_{15} & i_{17} i_{16} i_{15} & i_{18} i_{17} i_{16} i_{15}") !=
                 std::string::npos,
             equations.at(25).c_str());
    // The T-T graph's own route, from the load back to the motors.
    QCOMPARE(equations.at(27), std::string("M_{10}' = n_{14} M_{40}'"));
    QCOMPARE(equations.at(30), std::string("M_{32}'''' = -n_{37} M_{72}''''"));
    QCOMPARE(equations.at(31), std::string("M_{40} + M_{40}' = 0"));
    QCOMPARE(equations.at(33), std::string("M_{10} + M_{10}' - M_{51}'' = 0"));
    QCOMPARE(equations.at(36), std::string("M_{72} + M_{72}''' + M_{72}'''' = 0"));
    QVERIFY2(equations.at(39).find("M_{32}'''' = -10") != std::string::npos, equations.at(39).c_str());
    QVERIFY(equations.at(39).find("(37^*)") != std::string::npos);
    const std::string markdown = reportMarkdown(report);
    QVERIFY(markdown.find("\\tau_{8} &= \\frac{80}{27}") != std::string::npos);
    QVERIFY(markdown.find("\\tag{25*}") != std::string::npos);
    QVERIFY(reportLatex(report).find("\\tag{17*}") != std::string::npos);
    QVERIFY(reportHtml(report, {}).find("id=\"eq17-dual\">(17*)<") != std::string::npos);
    // The cutset matrix of the T-T graph with its names, then Q of the Matroid method: mesh 16 leads from 5
    // to 2, and its column of Q is that of the chord of gear 2 less that of gear 5.
    const auto block = [&](const std::string& begin) {
      const auto at = markdown.find(begin);
      return at == std::string::npos ? std::string() : markdown.substr(at, 2500);
    };
    const std::string chords = block("These cutsets as the rows of a matrix");
    QVERIFY2(chords.find("1 & 0 & 0 & 0 & 0 & 0 & 0 & 1 & 0 & 0 & 0 & 0 & 0 & 0 & 0") != std::string::npos,
             chords.c_str());
    QVERIFY(chords.find("M_{40}") < chords.find("M_{40}'"));
    const std::string edges = block("Q \\, W = ");
    QVERIFY2(edges.find("W_{8}") < edges.find("W_{18}"), edges.c_str());
    QVERIFY2(edges.find("0 & 1 & 0 & 0 & 0 & 0 & 0 & 0 & -1 & 0 & 0") != std::string::npos, edges.c_str());
    // Without loads there is no such part.
    QVERIFY(numbered(reportOf(test::example("robot")), true).empty());
  }

  // An engaged coupling is in the cutset equations of the joints on its circuit.
  void engagedCouplingsAreInTheCutsets() {
    Mechanism gearbox = test::eightSpeed();
    gearbox.engaged = gearbox.states[0].engaged;
    gearbox.loads = {{{}, LinkTorque{gearbox.links[1].id, {}, Number(1)}}};
    const Report report = reportOf(gearbox);
    check(report);
    const std::string cutsets = numbered(report, true).at(19);
    for (const ShiftElementId& engaged : gearbox.engaged)
      QVERIFY2(cutsets.find("T_{" + engaged.text() + "}") != std::string::npos, cutsets.c_str());
    QVERIFY(cutsets.find("T_{E}") == std::string::npos);
  }

  void loadsThatNothingHoldsAreReportedInTheDerivation() {
    Mechanism robot = loadedRobot();
    robot.balances = std::vector<HoldingTorque>{{JointId("8")}};
    const Report report = reportOf(robot);
    check(report);
    QVERIFY(reportMarkdown(report).find("Nothing holds this motion") != std::string::npos);
  }

  void loadsOnAnyTrainAreWritten() {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      Mechanism train = test::randomTrain(seed, 8 + static_cast<int>(seed), 6 + static_cast<int>(seed));
      train = *withLoad(train, {{}, JointTorque{train.turningJoints.back().id, Number(3)}});
      train = *withLoad(train, {{}, LinkTorque{train.links.back().id, {}, Number(-2)}});
      check(reportOf(train));
    }
  }

  void everyExampleIsWrittenInEveryForm() {
    const std::vector<std::string> names = test::exampleNames();
    QVERIFY(names.size() > 10);
    for (const std::string& name : names) check(reportOf(test::example(name)));
  }

  void anyTrainIsWritten() {
    for (unsigned seed = 1; seed <= 12; ++seed)
      check(
          reportOf(test::randomTrain(seed, 8 + 3 * static_cast<int>(seed), 6 + 2 * static_cast<int>(seed))));
  }

  // Views light up an equation with its element.
  void equationsSayWhatTheyAreAbout() {
    const Report report = reportOf(test::example("robot"));
    std::map<int, std::vector<ElementId>> about;
    for (const ReportBlock& block : report.blocks) {
      const auto* equation = std::get_if<ReportEquation>(&block);
      if (equation != nullptr && equation->number) about[*equation->number] = equation->elements;
    }
    const std::vector<ElementId> meshes{MeshId("15"), MeshId("16"), MeshId("17"), MeshId("18")};
    QVERIFY(about.at(20) == meshes);
    QVERIFY(about.at(27) == std::vector<ElementId>{MeshId("15")});
    QVERIFY(about.at(31) == std::vector<ElementId>{MeshId("16")});
    QVERIFY(about.at(39) == std::vector<ElementId>{JointId("10")});
    QVERIFY(about.at(45).empty());
  }

  // Where a part is missing, what comes before it is there, and no other number is shown.
  void looseLinksHaveAnIncidenceMatrixAndNoMore() {
    Mechanism mechanism = test::example("robot");
    mechanism.turningJoints.pop_back();
    const Report report = reportOf(std::move(mechanism));
    const auto equations = numbered(report);
    QVERIFY(equations.contains(1) && equations.contains(2));
    QVERIFY(!equations.contains(3) && !equations.contains(25) && !equations.contains(45));
    QVERIFY(reportMarkdown(report).find("no spanning tree") != std::string::npos);
  }

  void whatAUserWritesIsTextInEveryForm() {
    Mechanism mechanism = test::example("spur-pair");
    mechanism.name = "a_b & <i>c</i> $d$ {e} 50% #1 \\x";
    mechanism.links[1].name = "| pipe\nline `code` ~ ^";
    const Report report = reportOf(std::move(mechanism));
    const std::string html = reportHtml(report, {});
    QVERIFY(html.find("<h1>a_b &amp; &lt;i&gt;c&lt;/i&gt; $d$ {e} 50% #1 \\x</h1>") != std::string::npos);
    const std::string latex = reportLatex(report);
    QVERIFY(latex.find("\\title{a\\_b \\& <i>c</i> \\$d\\$ \\{e\\} 50\\% \\#1 \\textbackslash{}x}") !=
            std::string::npos);
    QVERIFY(latex.find("\\textasciitilde{} \\textasciicircum{}") != std::string::npos);
    const std::string markdown = reportMarkdown(report);
    QVERIFY(markdown.find("# a\\_b & \\<i\\>c\\</i\\> \\$d\\$ \\{e\\} 50% \\#1 \\\\x\n") !=
            std::string::npos);
    QVERIFY(markdown.find("| \\| pipe line \\`code\\` \\~ ^ |") != std::string::npos);
  }

  /// Whatever is wider than a page is broken into lines, or set smaller as a whole.
  void latexFitsThePage() {
    constexpr double kWidth = 45;  // em: 17 cm less the room of a number
    int fitted = 0;
    int equations = 0;
    for (const std::string& name : test::exampleNames()) {
      const Report report = reportOf(test::example(name));
      for (const ReportBlock& block : report.blocks) {
        const auto* equation = std::get_if<ReportEquation>(&block);
        if (equation == nullptr) continue;
        ++equations;
        Report one;
        one.blocks = {*equation};
        const std::string latex = reportLatex(one);
        const bool isFitted = latex.find("\\fit{\\dimexpr") != std::string::npos;
        fitted += isFitted ? 1 : 0;
        if (isFitted) continue;
        const std::size_t begin = latex.find("\\begin{equation*}\n") + 18;
        std::string tex = latex.substr(begin, latex.find("\n\\end{equation*}") - begin);
        tex = tex.substr(0, tex.find(" \\tag{"));
        const double width = widthOf(typesetLines(formulaOf(tex), 1e9));
        QVERIFY2(width < kWidth, (name + ": " + std::to_string(width) + " em: " + tex).c_str());
      }
    }
    QVERIFY2(equations > 500 && fitted > 0 && fitted < equations / 10, qPrintable(QString::number(fitted)));
  }

  /// Only breaks and indents are added.
  void longLinesAreBrokenAndKeepTheirTerms() {
    std::string sum = "\\omega_{12} &= n_{1}";
    for (int i = 2; i < 40; ++i) sum += (i % 3 == 0 ? " - " : " + ") + ("n_{" + std::to_string(i) + "}");
    const std::string tex = "\\begin{aligned}\n" + sum + " \\\\\n\\omega_{2} &= 1\n\\end{aligned}";
    QString broken = QString::fromStdString(brokenLines(tex, 30));
    QVERIFY(broken.count("\\\\\n") > 2);
    QVERIFY(widthOf(typesetLines(formulaOf(broken.toStdString()), 1e9)) <= 31);
    broken.remove(" \\\\\n&\\quad\\quad {}");
    QCOMPARE(broken.toStdString(), tex);
    QCOMPARE(brokenLines("a = b + c", 30), std::string("a = b + c"));
    const std::string group = "a = \\left( " + sum.substr(sum.find("n_")) + " \\right)";
    QCOMPARE(brokenLines(group, 30), group);  // there is no place for a break within a bracket
  }

  void latexDrawsWhereThereAreDrawings() {
    const Report report = reportOf(test::example("robot"));
    ReportLists lists;
    const Mechanism robot = test::example("robot");
    lists[ReportDrawing::digraph] = digraphDrawing(robot, completedPositions(robot), {});
    const QString latex = QString::fromStdString(reportLatex(report, lists));
    QCOMPARE(latexFault(latex), QString());
    QVERIFY(latex.contains("\\usepackage{tikz}"));
    QCOMPARE(latex.count("\\begin{tikzpicture}"), 2);  // and the curves of the comparison
    QVERIFY(latex.count("\\draw[") > 15 && latex.contains("dash pattern=") &&
            latex.contains("{\\sffamily\\bfseries{}8}"));
    for (const QChar c : latex) QVERIFY2(c.unicode() < 128, qPrintable(QString(c)));
    QVERIFY(!QString::fromStdString(reportLatex(report)).contains("tikz"));
  }

  /// By LaTeX itself, where there is one.
  void latexSetsEveryExampleWithoutOverfullBoxes() {
    const QString program = QStandardPaths::findExecutable(QStringLiteral("pdflatex"));
    if (program.isEmpty()) QSKIP("there is no pdflatex");
    QTemporaryDir folder;
    for (const char* name : {"robot", "eight-speed-gearbox"}) {
      QFile file(folder.filePath("report.tex"));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(QByteArray::fromStdString(reportLatex(reportOf(test::example(name)))));
      file.close();
      QProcess latex;
      latex.setWorkingDirectory(folder.path());
      latex.start(program, {"-interaction=nonstopmode", "-no-shell-escape", "report.tex"});
      QVERIFY(latex.waitForFinished(-1));
      const QByteArray told = latex.readAllStandardOutput();
      QVERIFY2(latex.exitCode() == 0 && !told.contains("Overfull"), told.right(2000).constData());
    }
  }

  void aMatrixThatNobodyCouldReadIsNamedInstead() {
    const Report report = reportOf(test::randomTrain(7, 60, 40));
    QVERIFY(!numbered(report).contains(1));
    QVERIFY(reportMarkdown(report).find("export --to csv --matrix incidence") != std::string::npos);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ReportTest)
#include "test_report.moc"
