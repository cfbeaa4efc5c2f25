#include "core/presentation/handout/handout_exercises.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/foundations/files/gzip.h"
#include "core/foundations/files/json_writer.h"
#include "core/presentation/handout/handout_sections.h"
#include "core/presentation/handout/question_blanks.h"
#include "core/presentation/report/report.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph {
namespace {

std::string points(int number) {
  return counted(number, toTranslate("%1 point"), toTranslate("%1 points"));
}

/// Folded until it is asked for, also without scripts.
std::string hintText(ExerciseKind kind) {
  return "<details class=\"hint\"><summary>" + escapedXml(translated("Hint")) + "</summary>\n" +
         reportHtmlBlocks({ReportParagraph{reportWords(kindHint(kind))}}) + "</details>\n";
}

std::string questionText(const Question& question, int number) {
  const ExerciseKind kind = *kindFromName(question.kind);
  std::vector<ReportBlock> blocks{ReportParagraph{reportWords(question.prompt)}};
  if (!question.formula.empty()) blocks.emplace_back(ReportEquation{question.formula, std::nullopt, {}});
  const std::string place = "question-" + std::to_string(number);
  return "<article class=\"question\" aria-labelledby=\"" + place + "\">\n<h3 id=\"" + place + "\">" +
         std::to_string(number) + ". " + escapedXml(kindTitle(kind)) + " (" +
         escapedXml(points(question.points)) + ")</h3>\n" + reportHtmlBlocks(blocks) +
         questionBlanks(question, translated("Answer to question %1", {std::to_string(number)})) +
         hintText(kind) + "</article>\n";
}

}  // namespace

HandoutExercises handoutExercises(const ExerciseSource& source, const SheetPlan& plan, int variant) {
  const ExerciseSource varied = variantSource(source, plan, variant);
  return {plan,
          sheetMark({plan, source.mechanism()}),
          makeVariant(varied, plan, variant),
          varied.snapshot()->mechanism,
          {}};
}

std::string exercisesSection(const HandoutExercises& exercises) {
  const SheetVariant& sheet = exercises.sheet;
  std::string title = exercises.plan.title;
  if (exercises.plan.variants > 1)
    title = translated("%1, variant %2", {title, std::to_string(sheet.variant)});
  const std::string size = counted(static_cast<int>(sheet.questions.size()), toTranslate("%1 question"),
                                   toTranslate("%1 questions")) +
                           ", " + points(sheet.points());
  const std::string advice =
      translated("The answers are hidden in this file, not secret, and other parts of it help: try first.");
  std::string text =
      "<h2>" + escapedXml(title) + "</h2>\n<p>" + escapedXml(size) + ". " + escapedXml(advice) +
      "</p>\n<p class=\"onpaper\">" + escapedXml(translated("Name")) + ": " +
      (exercises.student.empty() ? std::string(30, '_') : escapedXml(exercises.student)) + "</p>\n";
  int number = 0;
  for (const Question& question : sheet.questions) text += questionText(question, ++number);
  return text;
}

std::string exercisesKey(const HandoutExercises& exercises) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("sheet", exercises.mark);
    json.member("variant", exercises.sheet.variant);
    json.member("student", exercises.student);
    writeQuestionsWithKeys(json, exercises.sheet.questions);
    json.endObject();
  }
  return base64(gzip(sink.take()));
}

}  // namespace geargraph
