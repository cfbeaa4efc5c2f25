#include <QTest>

#include "core/presentation/exercise_sheets/sheet_report.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/presentation/typeset/tex_reader.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/pseudo_language.h"

namespace geargraph {

/// Exercise sheets as documents.
class SheetsTest : public QObject {
  Q_OBJECT

  struct Made {
    ExerciseSource source;
    SheetPlan plan;
    SheetVariant variant;
    explicit Made(const std::string& example, int variants = 30)
        : source(test::example(example)),
          plan{"Sheet 3", offeredKinds(source), 2026, variants},
          variant(makeVariant(source, plan, 7 % (variants + 1))) {}
    [[nodiscard]] Report report(SheetForm form, const std::string& student = {}) const {
      return sheetReport(source, plan, variant, student, form);
    }
  };

  static std::string everyText(const Report& report) {
    return report.title + '\n' + report.subtitle + '\n' + reportMarkdown(report);
  }

  /// Every formula of a report; a fault in reading one fails.
  static int formulas(const Report& report) {
    int count = 0;
    const auto read = [&](const std::string& tex) {
      const ReadFormula formula = readTex(tex);
      if (!formula.fault.empty()) qFatal("%s: %s", tex.c_str(), formula.fault.c_str());
      ++count;
    };
    const auto readWords = [&](const ReportWords& words) {
      for (const ReportSpan& span : words) {
        if (span.isFormula) read(span.text);
      }
    };
    for (const ReportBlock& block : report.blocks) {
      if (const auto* paragraph = std::get_if<ReportParagraph>(&block)) readWords(paragraph->words);
      if (const auto* equation = std::get_if<ReportEquation>(&block)) read(equation->tex);
      if (const auto* table = std::get_if<ReportTable>(&block)) {
        for (const auto& row : table->rows) {
          for (const ReportWords& cell : row) readWords(cell);
        }
      }
    }
    return count;
  }

 private slots:
  void everyFormulaCanBeSet() {
    int all = 0;
    for (const std::string& name : test::exampleNames()) {
      if (test::example(name).n() > kMaxExerciseLinks) continue;
      const Made made(name);
      all += formulas(made.report(SheetForm::questions)) + formulas(made.report(SheetForm::solution));
    }
    QVERIFY2(all > 500, qPrintable(QString::number(all)));
  }

  void aSheetHoldsNoAnswers() {
    const Made made("robot");
    const std::string sheet = everyText(made.report(SheetForm::questions));
    const std::string solution = everyText(made.report(SheetForm::solution));
    QVERIFY(sheet.find("variant 7") != std::string::npos);
    int rules = 0;
    for (const Question& question : made.variant.questions) {
      QVERIFY2(sheet.find(question.rule) == std::string::npos, question.rule.c_str());
      for (const Mistake& mistake : question.mistakes)
        QVERIFY(sheet.find(mistake.reason) == std::string::npos);
      rules += solution.find(question.rule.substr(0, 20)) != std::string::npos ? 1 : 0;
    }
    QCOMPARE(rules, static_cast<int>(made.variant.questions.size()));
    QCOMPARE(made.report(SheetForm::questions).blocks.size() + made.variant.questions.size(),
             made.report(SheetForm::solution).blocks.size());
  }

  void headsOfTablesAreTranslated() {
    const Made made("robot");
    const test::PseudoLanguage pseudo;
    int words = 0;
    for (const ReportBlock& block : made.report(SheetForm::questions).blocks) {
      const auto* table = std::get_if<ReportTable>(&block);
      if (table == nullptr) continue;
      for (const std::string& head : table->head) {
        QVERIFY2(test::PseudoLanguage::english(head).empty(), head.c_str());
        words += head.find(test::PseudoLanguage::accented("from")) != std::string::npos ? 1 : 0;
      }
    }
    QVERIFY(words > 0);
  }

  /// The sheet of another solution with the same questions would be the same: blanks do not depend on
  /// answers.
  void blanksAreAlike() {
    Made made("robot");
    const std::string sheet = everyText(made.report(SheetForm::questions));
    for (Question& question : made.variant.questions) {
      for (std::string& text : question.solution) text = "1234567";
      question.rule = "another rule";
    }
    QCOMPARE(everyText(made.report(SheetForm::questions)), sheet);
    QVERIFY(everyText(made.report(SheetForm::solution)).find("1234567") != std::string::npos);
  }

  void namesArePrinted() {
    const Made made("planetary-ring-held", 1);
    const Report report = made.report(SheetForm::questions, "Ada $ Lovelace");
    QCOMPARE(report.title, std::string("Sheet 3"));
    QVERIFY(reportHtml(report, {}).find("Name: Ada $ Lovelace") != std::string::npos);
    QVERIFY(reportLatex(report).find("Ada \\$ Lovelace") != std::string::npos);
    QVERIFY(reportHtml(made.report(SheetForm::questions), {}).find("Name: ____") != std::string::npos);
  }

  /// Any LaTeX program has ASCII; users' names are their own.
  void latexNeedsNoSpecialFaces() {
    for (const std::string& name : test::exampleNames()) {
      if (test::example(name).n() > kMaxExerciseLinks) continue;
      const Made made(name);
      for (const SheetForm form : {SheetForm::questions, SheetForm::solution}) {
        for (const QChar c : QString::fromStdString(reportLatex(made.report(form))))
          QVERIFY2(c.unicode() < 128, qPrintable(QString::fromStdString(name) + c));
      }
    }
  }

  void everyFormIsWritten() {
    for (const char* name : {"robot", "eight-speed-gearbox", "redundant-planetary", "locked-train"}) {
      const Made made(name);
      for (const SheetForm form : {SheetForm::questions, SheetForm::solution}) {
        const Report report = made.report(form);
        QVERIFY(reportHtml(report, {}).find("</html>") != std::string::npos);
        QVERIFY(reportLatex(report).find("\\end{document}") != std::string::npos);
        const auto pdf = reportPdf(report, {});
        QVERIFY(pdf.has_value() && pdf->starts_with("%PDF"));
      }
    }
  }
};

}  // namespace geargraph

QTEST_APPLESS_MAIN(geargraph::SheetsTest)
#include "test_sheets.moc"
