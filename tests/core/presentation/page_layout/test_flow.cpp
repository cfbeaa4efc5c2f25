#include <QTest>

#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/page_layout/flow.h"
#include "core/presentation/report/report_words.h"

namespace geargraph {
namespace {

/// Every character is half an em wide.
class EvenMeasure : public WordMeasure {
 public:
  [[nodiscard]] double widthOf(std::string_view utf8, const TextStyle& style) const override {
    return static_cast<double>(utf8.size()) * style.size / 2;
  }
};

constexpr double kWidth = 200;

FlowParameters flowParameters() {
  FlowParameters flow;
  flow.width = kWidth;
  return flow;
}

std::vector<FlowLine> linesOf(std::vector<ReportBlock> blocks,
                              const FlowParameters& flow = flowParameters()) {
  return SetReport(Report{"Train", std::move(blocks)}).lines(flow, EvenMeasure());
}

QString textOf(const FlowLine& line) {
  std::string text;
  for (const FlowWords& words : line.words) text += words.text;
  return QString::fromStdString(text);
}

double endOf(const FlowLine& line) {
  double end = 0;
  for (const FlowWords& words : line.words)
    end = std::max(end, words.x + EvenMeasure().widthOf(words.text, words.style));
  for (const FlowFormula& formula : line.formulas)
    end = std::max(end, formula.x + formula.box->width * formula.size);
  return end;
}

std::string matrixOf(std::size_t rows, std::size_t columns) {
  return texMatrix(std::vector(rows, std::vector<std::string>(columns, "-1")));
}

}  // namespace

/// Where the blocks of a report come to stand.
class FlowTest : public QObject {
  Q_OBJECT

 private slots:
  void sentencesBreakBetweenWords() {
    const auto lines = linesOf(
        {ReportParagraph{reportWords("Every link becomes a node, and each turning joint a solid arrow.")}});
    QCOMPARE(lines.size(), std::size_t{2});
    QCOMPARE(textOf(lines[0]), QStringLiteral("Every link becomes a node, and each"));
    QCOMPARE(textOf(lines[1]), QStringLiteral("turning joint a solid arrow."));
    for (const FlowLine& line : lines) QVERIFY(endOf(line) <= kWidth);
    QVERIFY(lines[0].keepsWithNext && !lines[1].keepsWithNext);
  }

  void aFormulaStaysWithTheCommaBehindIt() {
    const auto lines = linesOf({ReportParagraph{reportWords("a $x$, b")}});
    QCOMPARE(lines.size(), std::size_t{1});
    QCOMPARE(lines[0].formulas.size(), std::size_t{1});
    QCOMPARE(lines[0].words.size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(lines[0].words[1].text), QStringLiteral(", b"));
    QCOMPARE(lines[0].words[1].x, lines[0].formulas[0].x + lines[0].formulas[0].box->width * 10);
    QCOMPARE(lines[0].formulas[0].y, lines[0].words[0].y);
  }

  void aWordLongerThanALineIsTorn() {
    const auto lines = linesOf({ReportParagraph{plainWords(std::string(100, 'x'))}});
    QCOMPARE(lines.size(), std::size_t{3});
    for (const FlowLine& line : lines) QVERIFY(endOf(line) <= kWidth);
  }

  void aHeadingAndWhatLeadsToAnEquationKeepWithIt() {
    const auto lines = linesOf(
        {ReportHeading{1, "Part"}, ReportParagraph{reportWords("It is")}, ReportEquation{"a = 1", 3, {}}});
    QCOMPARE(lines.size(), std::size_t{3});
    QVERIFY(lines[0].keepsWithNext && lines[1].keepsWithNext && !lines[2].keepsWithNext);
    QVERIFY(lines[0].words[0].style.bold);
  }

  void anEquationIsInTheMiddleAndItsNumberAtTheMargin() {
    const auto lines = linesOf({ReportEquation{"a = 1", 12, {}}});
    const FlowFormula& formula = lines[0].formulas[0];
    QCOMPARE(formula.x + formula.box->width * formula.size / 2, kWidth / 2);
    QCOMPARE(textOf(lines[0]), QStringLiteral("(12)"));
    QCOMPARE(endOf(lines[0]), kWidth);
    QCOMPARE(lines[0].words[0].y, formula.y);
  }

  void aNumberStandsBetweenTwoLines() {
    const auto lines = linesOf({ReportEquation{texLines({"a = 1", "b = 2"}), 7, {}}});
    QCOMPARE(lines.size(), std::size_t{2});
    QVERIFY(lines[0].keepsWithNext);
    QCOMPARE(textOf(lines[0]) + textOf(lines[1]), QStringLiteral("(7)"));
    const double second = lines[0].height + lines[1].above + lines[1].formulas[0].y;
    QVERIFY(lines[0].words[0].y > lines[0].formulas[0].y && lines[0].words[0].y < second);
  }

  void aWideMatrixShrinks() {
    const auto lines = linesOf({ReportEquation{matrixOf(2, 10), 1, {}}});
    QCOMPARE(lines.size(), std::size_t{1});
    const FlowFormula& formula = lines[0].formulas[0];
    QVERIFY(formula.size < 10 && formula.size >= 6);
    QVERIFY(formula.x + formula.box->width * formula.size <= lines[0].words[0].x);
  }

  void aMatrixTooWideForThePageIsSaidToBe() {
    const auto lines = linesOf({ReportEquation{matrixOf(2, 40), 1, {}}});
    QCOMPARE(lines.size(), std::size_t{1});
    QVERIFY(lines[0].formulas.empty());
    QVERIFY(textOf(lines[0]).startsWith(QStringLiteral("Too wide")));
    QVERIFY(textOf(lines[0]).endsWith(QStringLiteral("(1)")));
    FlowParameters scrolled = flowParameters();
    scrolled.leavesOutWide = false;
    QVERIFY(endOf(linesOf({ReportEquation{matrixOf(2, 40), 1, {}}}, scrolled)[0]) > kWidth);
  }

  void aMatrixTallerThanAPageShrinks() {
    FlowParameters flow = flowParameters();
    flow.tallest = 100;
    const auto lines = linesOf({ReportEquation{matrixOf(10, 2), std::nullopt, {}}}, flow);
    QVERIFY(lines[0].height <= 100 + 1e-6);
    QVERIFY(lines[0].formulas[0].size < 10);
  }

  void eachLineOfAListOfEquationsIsAboutItsOwnElement() {
    const ElementId first(JointId("j8")), second(JointId("j9"));
    auto lines = linesOf({ReportEquation{texLines({"a = 1", "b = 2"}), 1, {first, second}}});
    QVERIFY(lines[0].element == first && lines[1].element == second);
    lines = linesOf({ReportEquation{texLines({"a = 1", "b = 2"}), 1, {first}}});
    QVERIFY(lines[0].element == first && lines[1].element == first);
    // One that goes on in the next line does so there, too.
    const std::string wide = "a = 1" + std::string(40, '2') + " + 1" + std::string(40, '2');
    lines = linesOf({ReportEquation{texLines({wide, "b = 2"}), 1, {first, second}}});
    QVERIFY(lines.size() > 2 && lines[1].element == first && lines.back().element == second);
    lines = linesOf({ReportEquation{"a = 1", 1, {}}});
    QVERIFY(!lines[0].element);
  }

  void aTableKeepsWithinTheWidth() {
    ReportTable table{{"Link", "Name"}, {}};
    table.rows.push_back(
        {plainWords("1"), plainWords("a name that is longer than what a line of this page can hold")});
    table.rows.push_back({plainWords("2"), plainWords("sun")});
    const auto lines = linesOf({table});
    QCOMPARE(lines.size(), std::size_t{3});
    for (const FlowLine& line : lines) QVERIFY(endOf(line) <= kWidth + 0.1);
    QVERIFY(lines[1].height > 1.7 * lines[2].height);
    QCOMPARE(lines[1].words[0].x, lines[2].words[0].x);
    QCOMPARE(lines[1].words[1].x, lines[2].words[1].x);
    QVERIFY(lines[0].keepsWithNext && lines[1].keepsWithNext && !lines[2].keepsWithNext);
  }

  void figuresAreLeftOutOrKeepTheirShape() {
    QVERIFY(linesOf({ReportFigure{ReportDrawing::digraph, "Digraph"}}).empty());
    FlowParameters flow = flowParameters();
    flow.figureSize = [](ReportDrawing) { return std::optional(FlowParameters::FigureSize{500, 250}); };
    const auto lines = linesOf({ReportFigure{ReportDrawing::digraph, "Digraph"}}, flow);
    QCOMPARE(lines.size(), std::size_t{2});
    QCOMPARE(lines[0].figure->width, 2 * lines[0].figure->height);
    QVERIFY(lines[0].figure->width <= kWidth && lines[0].keepsWithNext);
    flow.figureSize = [](ReportDrawing) { return std::optional(FlowParameters::FigureSize{50, 25}); };
    QCOMPARE(linesOf({ReportFigure{ReportDrawing::digraph, "Digraph"}}, flow)[0].figure->width, 50.0);
  }

  void curvesBringTheirOwnDrawing() {
    const CurveChart chart{"chain", "moving links", {{"Substitution", {{1, 2}, {3, 4}}}}};
    const auto lines = linesOf({ReportCurves{{chart, chart, chart}, "Operations"}});
    QCOMPARE(lines.size(), std::size_t{2});
    const FlowFigure& figure = *lines[0].figure;
    const Extent sheet = sheetOf(*figure.curves, {});
    QVERIFY(std::abs(figure.width / figure.height - sheet.halfWidth / sheet.halfHeight) < 1e-9);
    QVERIFY(figure.x > -1e-9 && figure.x + figure.width <= kWidth + 1e-9 && lines[0].keepsWithNext);
    QCOMPARE(lines[1].words[0].text, std::string("Operations"));
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::FlowTest)
#include "test_flow.moc"
