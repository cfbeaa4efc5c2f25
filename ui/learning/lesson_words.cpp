#include "ui/learning/lesson_words.h"

#include "core/presentation/report/written_words.h"

namespace geargraph {
SetReportPtr stepText(const std::string& title, const std::string& text, const std::string& formula,
                      PaperEquation equation, const std::string& task, const std::string& prompt,
                      const std::string& taskFormula) {
  Report report;
  report.title = title;
  report.blocks.emplace_back(ReportHeading{2, title});
  if (!text.empty()) report.blocks.emplace_back(ReportParagraph{writtenWords(text)});
  addWrittenFormula(report.blocks, formula, equation);
  report.blocks.emplace_back(ReportHeading{2, task});
  report.blocks.emplace_back(ReportParagraph{writtenWords(prompt)});
  addWrittenFormula(report.blocks, taskFormula, PaperEquation::none);
  return std::make_shared<const SetReport>(std::move(report));
}

QString plainSentence(const std::string& sentence) {
  return QString::fromStdString(sentence).remove(QLatin1Char('$'));
}

}  // namespace geargraph
