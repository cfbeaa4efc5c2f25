#include "core/presentation/sheet_files/sheet_files.h"

#include <array>
#include <utility>

#include "core/presentation/pages/report_pdf.h"
#include "core/presentation/results/report_lists.h"
#include "core/presentation/sheets/sheet_report.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph::inline sheet_files {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kForms = {  // name and suffix, by form
    {{"html", "html"}, {"latex", "tex"}, {"pdf", "pdf"}, {"json", "json"}}};

/// "07" of 30.
std::string numbered(int variant, int variants) {
  std::string number = std::to_string(variant);
  return std::string(std::to_string(variants).size() - number.size(), '0') + number;
}

std::string fileName(SheetForm part, const std::string& number, SheetFileForm form) {
  const std::string_view suffix = kForms[static_cast<std::size_t>(form)].second;
  return (part == SheetForm::questions ? "sheet-" : "solution-") + number + '.' + std::string(suffix);
}

std::string answersName(const std::string& number) {
  return "answers-" + number + ".json";
}

std::string answersFor(const SheetVariant& sheet, const std::string& mark, const std::string& student) {
  AnswerSheet answers{mark, sheet.variant, student, {}};
  for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
    for (const AnswerField& field : sheet.questions[i].fields)
      answers.answers[static_cast<int>(i) + 1][field.name] = "";
  }
  return answersJson(answers);
}

/// Writes documents of one source in every form, with the same drawings.
class SheetWriter {
 public:
  SheetWriter(const ExerciseSource& source, const std::stop_token& stop) {
    for (const ReportDrawing each : {ReportDrawing::schematic, ReportDrawing::digraph})
      m_lists[each] = reportDrawing(each, *source.snapshot(), stop);
    m_drawings = svgDrawings(m_lists);
  }

  [[nodiscard]] Expected<std::string> bytesOf(const Report& report, const SheetVariant& sheet, SheetForm part,
                                              SheetFileForm form) const {
    switch (form) {
      case SheetFileForm::html:
        return reportHtml(report, m_drawings);
      case SheetFileForm::latex:
        return reportLatex(report);
      case SheetFileForm::pdf:
        return reportPdf(report, m_lists);
      case SheetFileForm::json:
        break;
    }
    return questionsJson(sheet.questions,
                         part == SheetForm::questions ? QuestionPart::withoutKey : QuestionPart::withKey);
  }

 private:
  ReportLists m_lists;
  ReportDrawings m_drawings;
};

}  // namespace

std::optional<SheetFileForm> sheetFileForm(std::string_view name) {
  for (std::size_t form = 0; form < kForms.size(); ++form) {
    if (kForms[form].first == name) return static_cast<SheetFileForm>(form);
  }
  return std::nullopt;
}

std::vector<std::string> sheetFileNames(const SheetRequest& request) {
  std::vector<std::string> names{"sheet.json"};
  for (int variant = 1; variant <= request.plan.variants; ++variant) {
    const std::string number = numbered(variant, request.plan.variants);
    names.push_back(answersName(number));
    for (const SheetForm part : {SheetForm::questions, SheetForm::solution}) {
      for (const SheetFileForm form : request.forms) names.push_back(fileName(part, number, form));
    }
  }
  return names;
}

Expected<FolderFiles> sheetFiles(const ExerciseSource& source, const SheetRequest& request,
                                 const std::function<void(int)>& progress, const std::stop_token& stop) {
  const SheetFile file{request.plan, source.mechanism()};
  const std::string mark = sheetMark(file);
  FolderFiles files{{"sheet.json", sheetJson(file)}};
  for (int variant = 1; variant <= request.plan.variants && !stop.stop_requested(); ++variant) {
    const ExerciseSource varied = variantSource(source, request.plan, variant);
    const SheetWriter writer(varied, stop);
    const SheetVariant sheet = makeVariant(varied, request.plan, variant);
    const std::string number = numbered(variant, request.plan.variants);
    const std::string student =
        request.students.empty() ? "" : request.students[static_cast<std::size_t>(variant) - 1];
    files.emplace_back(answersName(number), answersFor(sheet, mark, student));
    for (const SheetForm part : {SheetForm::questions, SheetForm::solution}) {
      const Report report = sheetReport(varied, request.plan, sheet, student, part);
      for (const SheetFileForm form : request.forms) {
        auto bytes = writer.bytesOf(report, sheet, part, form);
        if (!bytes) return bytes.error();
        files.emplace_back(fileName(part, number, form), std::move(bytes).value());
      }
    }
    if (progress) progress(variant);
  }
  return files;
}

}  // namespace geargraph::inline sheet_files
