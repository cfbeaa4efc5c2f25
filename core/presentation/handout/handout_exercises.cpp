#include "core/presentation/handout/handout_exercises.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/base64.h"
#include "core/foundations/files/gzip.h"
#include "core/foundations/files/json_writer.h"
#include "core/presentation/handout/handout_sections.h"
#include "core/presentation/report/report.h"
#include "core/presentation/report/report_words.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxOptions = 24;  ///< that are listed beside a blank

std::string blank(std::size_t field, bool beginsPart) {
  return "<td data-field=\"" + std::to_string(field) + "\"" + (beginsPart ? " class=\"part\"" : "") +
         "></td>";
}

std::string headCell(const std::string& text, const char* scope, bool beginsPart = false) {
  return "<th scope=\"" + std::string(scope) + "\"" + (beginsPart ? " class=\"part\"" : "") + ">" +
         escapedXml(text) + "</th>";
}

std::string points(int number) {
  return counted(number, toTranslate("%1 point"), toTranslate("%1 points"));
}

/// Blanks in rows and columns.
std::string blankTable(const Question& question) {
  const auto begins = [&](std::size_t column) {
    return question.table.partition == static_cast<int>(column);
  };
  std::string text = "<table class=\"matrix asked\"><thead><tr><td></td>";
  for (std::size_t column = 0; column < question.table.columns.size(); ++column)
    text += headCell(translated(std::string_view(question.table.columns[column])), "col", begins(column));
  text += "</tr></thead>\n<tbody>\n";
  std::size_t field = 0;
  for (const std::string& row : question.table.rows) {
    text += "<tr>" + headCell(row, "row");
    for (std::size_t column = 0; column < question.table.columns.size(); ++column)
      text += blank(field++, begins(column));
    text += "</tr>\n";
  }
  return text + "</tbody></table>";
}

/// What goes into a blank.
std::string noteOf(const AnswerField& field) {
  if (field.options.empty() || field.options.size() > kMaxOptions) return {};
  return field.kind == FieldKind::set
             ? translated("some of %1", {listed(field.options, kMaxOptions)})
             : translated("one of %1", {listed(field.options, kMaxOptions, toTranslate("or"))});
}

/// Blanks with their names, one below the other.
std::string blankList(const Question& question) {
  std::string text = "<table class=\"plain asked\"><tbody>\n";
  for (std::size_t field = 0; field < question.fields.size(); ++field) {
    const AnswerField& asked = question.fields[field];
    text += "<tr>" + headCell(asked.shownName(), "row") + blank(field, false) + "<td class=\"onpaper\">" +
            escapedXml(noteOf(asked)) + "</td></tr>\n";
  }
  return text + "</tbody></table>";
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
         "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" +
         escapedXml(translated("Answer to question %1", {std::to_string(number)})) + "\">" +
         (question.table.columns.empty() ? blankList(question) : blankTable(question)) + "</div>\n" +
         hintText(kind) + "</article>\n";
}

/// Names of fields and columns as the page shows them.
void writeShown(JsonWriter& json, const Question& question) {
  json.beginObject();
  json.key("fields");
  json.beginArray(JsonWriter::Layout::row);
  for (const AnswerField& field : question.fields) json.string(field.shownName());
  json.endArray();
  json.key("columns");
  json.beginArray(JsonWriter::Layout::row);
  for (const std::string& column : question.table.columns) json.string(translated(std::string_view(column)));
  json.endArray();
  json.endObject();
}

}  // namespace

HandoutExercises handoutExercises(const ExerciseSource& source, const SheetPlan& plan, int variant) {
  const ExerciseSource varied = variantSource(source, plan, variant);
  return {plan, sheetMark({plan, source.mechanism()}), makeVariant(varied, plan, variant),
          varied.snapshot()->mechanism};
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
  std::string text = "<h2>" + escapedXml(title) + "</h2>\n<p>" + escapedXml(size) + ". " +
                     escapedXml(advice) + "</p>\n<p class=\"onpaper\">" + escapedXml(translated("Name")) +
                     ": ______________________________</p>\n";
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
    json.key("questions");
    json.beginArray();
    for (const Question& question : exercises.sheet.questions)
      writeQuestion(json, question, QuestionPart::withKey);
    json.endArray();
    json.key("shown");
    json.beginArray();
    for (const Question& question : exercises.sheet.questions) writeShown(json, question);
    json.endArray();
    json.endObject();
  }
  return base64(gzip(sink.take()));
}

}  // namespace geargraph
