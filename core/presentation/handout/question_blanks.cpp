#include "core/presentation/handout/question_blanks.h"

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
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

std::string questionBlanks(const Question& question, const std::string& name) {
  return "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escapedXml(name) + "\">" +
         (question.table.columns.empty() ? blankList(question) : blankTable(question)) + "</div>\n";
}

void writeQuestionsWithKeys(JsonWriter& json, const std::vector<Question>& questions) {
  json.key("questions");
  json.beginArray();
  for (const Question& question : questions) writeQuestion(json, question, QuestionPart::withKey);
  json.endArray();
  json.key("shown");
  json.beginArray();
  for (const Question& question : questions) writeShown(json, question);
  json.endArray();
}

}  // namespace geargraph
