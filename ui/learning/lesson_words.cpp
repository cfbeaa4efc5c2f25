#include "ui/learning/lesson_words.h"

#include <algorithm>

#include "core/presentation/report/report_words.h"
#include "core/presentation/typeset/tex_reader.h"

namespace geargraph {
namespace {

bool canBeSet(const std::string& tex) {
  return readTex(tex).fault.empty();
}

/// Authors may forget a dollar sign or misspell a command: then all of it is words.
ReportWords wordsOf(const std::string& sentence) {
  if (std::count(sentence.begin(), sentence.end(), '$') % 2 != 0) return plainWords(sentence);
  ReportWords words = reportWords(sentence);
  for (ReportSpan& span : words) {
    if (span.isFormula && !canBeSet(span.text)) span.isFormula = false;
  }
  return words;
}

void addFormula(Report& report, const std::string& tex, PaperEquation equation) {
  if (tex.empty()) return;
  if (!canBeSet(tex)) {
    report.blocks.emplace_back(ReportParagraph{plainWords(tex)});
    return;
  }
  ReportEquation set{tex, std::nullopt, {}};
  if (equation != PaperEquation::none) set.number = numberOf(equation);
  report.blocks.emplace_back(std::move(set));
}

}  // namespace

SetReportPtr stepText(const std::string& title, const std::string& text, const std::string& formula,
                      PaperEquation equation, const std::string& task, const std::string& prompt,
                      const std::string& taskFormula) {
  Report report;
  report.title = title;
  report.blocks.emplace_back(ReportHeading{2, title});
  if (!text.empty()) report.blocks.emplace_back(ReportParagraph{wordsOf(text)});
  addFormula(report, formula, equation);
  report.blocks.emplace_back(ReportHeading{2, task});
  report.blocks.emplace_back(ReportParagraph{wordsOf(prompt)});
  addFormula(report, taskFormula, PaperEquation::none);
  return std::make_shared<const SetReport>(std::move(report));
}

QString plainSentence(const std::string& sentence) {
  return QString::fromStdString(sentence).remove(QLatin1Char('$'));
}

}  // namespace geargraph
