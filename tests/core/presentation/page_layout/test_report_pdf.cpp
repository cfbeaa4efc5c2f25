#include <QRegularExpression>
#include <QTest>

#include "core/presentation/drawing/digraph_drawing.h"
#include "core/presentation/drawing/layout.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "tests/core/presentation/report/derived_report.h"
#include "tests/core/support/example_files.h"
#include "tests/support/pdf_streams.h"

namespace geargraph {
namespace {

using test::reportOf;

QByteArray pdfOf(const Mechanism& mechanism) {
  ReportLists drawings;
  drawings[ReportDrawing::digraph] = digraphDrawing(mechanism, completedPositions(mechanism), {});
  return QByteArray::fromStdString(reportPdf(reportOf(mechanism), drawings).value());
}

/// What each page paints, unpacked.
QList<QByteArray> contentsOf(const QByteArray& pdf) {
  QList<QByteArray> pages;
  for (const QByteArray& content : test::pdfStreams(pdf)) {
    if (content.contains(" Tf")) pages += content;
  }
  return pages;
}

/// The letters of a page's strings, one behind the other and without blanks.
QString lettersOf(const QByteArray& content) {
  QByteArray letters;
  for (qsizetype i = 0; i < content.size(); ++i) {
    if (content[i] != '(') continue;
    for (++i; i < content.size() && content[i] != ')'; ++i) {
      if (content[i] == '\\') ++i;
      if (content[i] != ' ') letters += content[i];
    }
  }
  return QString::fromLatin1(letters);
}

QString lettersOf(const QList<QByteArray>& pages) {
  QString letters;
  for (const QByteArray& page : pages) letters += lettersOf(page);
  return letters;
}

QStringList headingsOf(const Report& report) {
  QStringList headings;
  for (const ReportBlock& block : report.blocks) {
    if (const auto* heading = std::get_if<ReportHeading>(&block))
      headings += QString::fromStdString(heading->text);
  }
  return headings;
}

QString withoutBlanks(QString text) {
  return text.remove(' ');
}

}  // namespace

/// The derivation on pages.
class ReportPdfTest : public QObject {
  Q_OBJECT

 private slots:
  void theRobotsEquationsBearTheirNumbers() {
    const Mechanism robot = test::example("robot");
    const QByteArray pdf = pdfOf(robot);
    QVERIFY(pdf.startsWith("%PDF-1.") && pdf.trimmed().endsWith("%%EOF"));
    const QString letters = lettersOf(contentsOf(pdf));
    int numbers = 0, last = 0;
    for (const ReportBlock& block : reportOf(robot).blocks) {
      const auto* equation = std::get_if<ReportEquation>(&block);
      if (equation == nullptr || !equation->number) continue;
      QVERIFY2(letters.contains(QStringLiteral("(%1)").arg(*equation->number)), equation->tex.c_str());
      ++numbers;
      last = std::max(last, *equation->number);
    }
    QVERIFY(numbers > 30);
    QCOMPARE(last, 45);
    QVERIFY(letters.contains("Thescrewofjoint"));
    QVERIFY(letters.contains("bevel"));
  }

  void headingsAreOnThePagesAndInTheOutline() {
    const Mechanism robot = test::example("robot");
    const QByteArray pdf = pdfOf(robot), text = test::pdfText(pdf);
    const QString letters = lettersOf(contentsOf(pdf));
    for (const QString& heading : headingsOf(reportOf(robot))) {
      QVERIFY2(letters.contains(withoutBlanks(heading)), qPrintable(heading));
      QVERIFY2(text.contains("/Title (" + heading.toLatin1() + ")"), qPrintable(heading));
    }
  }

  /// A screen reader is told what is a heading, a table with its rows and cells, a formula, a drawing.
  void partsAreTagged() {
    const Mechanism robot = test::example("robot");
    const QByteArray pdf = pdfOf(robot), text = test::pdfText(pdf);
    QVERIFY(text.contains("/StructTreeRoot") && text.contains("/Marked true"));
    const auto count = [&](const char* name) {
      static const QRegularExpression space(QStringLiteral("\\s+"));
      return QString::fromLatin1(text)
          .replace(space, " ")
          .count(QStringLiteral("/S /%1 ").arg(QLatin1String(name)));
    };
    const Report report = reportOf(robot);
    qsizetype chapters = 0, headings = 0, equations = 0, tables = 0, rows = 0, cells = 0;
    for (const ReportBlock& block : report.blocks) {
      if (const auto* heading = std::get_if<ReportHeading>(&block))
        ++(heading->level == 1 ? chapters : headings);
      equations += std::holds_alternative<ReportEquation>(block) ? 1 : 0;
      const auto* table = std::get_if<ReportTable>(&block);
      if (table == nullptr) continue;
      ++tables;
      rows += 1 + static_cast<qsizetype>(table->rows.size());
      for (const auto& row : table->rows) cells += static_cast<qsizetype>(row.size());
    }
    QCOMPARE(count("H1"), qsizetype{1});
    QCOMPARE(count("H2"), chapters);
    QCOMPARE(count("H3"), headings);
    QVERIFY(count("Formula") >= equations);  // one of several pages is begun on each
    QVERIFY(count("Table") >= tables && tables > 3);
    QCOMPARE(count("TR"), rows);
    QVERIFY(count("TH") >= 2 * tables && count("TD") > cells * 9 / 10);
    QCOMPARE(count("Figure"), qsizetype{2});  // the digraph, and the curves
    QVERIFY(contentsOf(pdf).front().contains("BDC") && contentsOf(pdf).front().contains("EMC"));
  }

  void noHeadingStandsAtAPagesFootAndEveryPageIsNumbered() {
    const std::vector<std::string> names = test::exampleNames();
    QVERIFY(names.size() >= 17);
    for (const std::string& name : names) {
      const Mechanism mechanism = test::example(name);
      const QList<QByteArray> pages = contentsOf(pdfOf(mechanism));
      QVERIFY2(pages.size() >= 2, name.c_str());
      const QStringList headings = headingsOf(reportOf(mechanism));
      for (qsizetype i = 0; i < pages.size(); ++i) {
        QString letters = lettersOf(pages[i]);
        const QString foot = QStringLiteral("%1/%2").arg(i + 1).arg(pages.size());
        QVERIFY2(letters.endsWith(foot), qPrintable(name.c_str() + (" " + letters.right(20))));
        letters.chop(foot.size());
        for (const QString& heading : headings)
          QVERIFY2(!letters.endsWith(withoutBlanks(heading)), qPrintable(name.c_str() + (": " + heading)));
      }
    }
  }

  // The starred equations, too: with a load in the last joint of each example.
  void aLoadedExampleIsWorkedOut() {
    int loaded = 0;
    for (const std::string& name : test::exampleNames()) {
      Mechanism mechanism = test::example(name);
      mechanism.loads.push_back({{}, JointTorque{mechanism.turningJoints.back().id, Number(10)}, {}});
      const QByteArray pdf = pdfOf(mechanism);
      QVERIFY2(pdf.trimmed().endsWith("%%EOF"), name.c_str());
      if (headingsOf(reportOf(mechanism)).contains(QStringLiteral("Statics"))) ++loaded;
    }
    QVERIFY2(loaded >= 12, qPrintable(QString::number(loaded)));
  }

  // Whatever a user writes is text; what no face has is no reason to fail.
  void anyNameIsShown() {
    Mechanism mechanism = test::example("spur-pair");
    mechanism.name = "a_b & <i>c</i> $d$ (e) 50% \\x \u00fc \u6c49\u5b57 \U0001F600 \u0001 \u007f \uffff";
    mechanism.links[1].name = std::string(400, 'w') + " Zahnrad\xC3\xA4 \xED\xA0\x80 \xFF";
    const QByteArray pdf = pdfOf(mechanism);
    QVERIFY(pdf.trimmed().endsWith("%%EOF"));
    const QString letters = lettersOf(contentsOf(pdf));
    QVERIFY2(letters.contains("a_b&<i>c</i>$d$(e)50%"), qPrintable(letters.left(200)));
    QVERIFY(letters.contains("Zahnrad"));
    QCOMPARE(letters.count('w') >= 400, true);
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::ReportPdfTest)
#include "test_report_pdf.moc"
