#include "core/presentation/exercise_sheets/sheet_files.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/foundations/base/text_lists.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exercise_sheets/sheet_report.h"
#include "core/presentation/export_api/handout_train.h"
#include "core/presentation/export_api/report_lists.h"
#include "core/presentation/export_api/scorm_package.h"
#include "core/presentation/handout/handout.h"
#include "core/presentation/page_layout/report_pdf.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kForms = {  // name and suffix, by form
    {{"html", "html"},
     {"latex", "tex"},
     {"pdf", "pdf"},
     {"json", "json"},
     {"handout", "html"},
     {"scorm", "zip"}}};
constexpr const char* kIndexName = "index.html";

/// Is it one file with questions and key, instead of a sheet and a solution?
bool isPage(SheetFileForm form) {
  return form == SheetFileForm::handout || form == SheetFileForm::scorm;
}

bool hasPages(const SheetRequest& request) {
  return std::any_of(request.forms.begin(), request.forms.end(), isPage);
}

/// "07" of 30.
std::string numbered(int variant, int variants) {
  std::string number = std::to_string(variant);
  return std::string(std::to_string(variants).size() - number.size(), '0') + number;
}

std::string fileName(SheetForm part, const std::string& number, SheetFileForm form) {
  const std::string_view suffix = kForms[static_cast<std::size_t>(form)].second;
  return (part == SheetForm::questions ? "sheet-" : "solution-") + number + '.' + std::string(suffix);
}

std::string pageName(const std::string& number, SheetFileForm form) {
  const auto& [name, suffix] = kForms[static_cast<std::size_t>(form)];
  return std::string(name) + '-' + number + '.' + std::string(suffix);
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
class SheetFileWriter {
 public:
  SheetFileWriter(const ExerciseSource& source, const std::stop_token& stop) {
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
        return reportLatex(report, m_lists);
      case SheetFileForm::pdf:
        return reportPdf(report, m_lists);
      case SheetFileForm::json:
      case SheetFileForm::handout:
      case SheetFileForm::scorm:
        break;
    }
    return questionsJson(sheet.questions,
                         part == SheetForm::questions ? QuestionPart::withoutKey : QuestionPart::withKey);
  }

 private:
  ReportLists m_lists;
  ReportDrawings m_drawings;
};

/// The pages of one variant, with its train in 3D, which is made once.
class PageWriter {
 public:
  PageWriter(const ExerciseSource& varied, const HandoutExercises& exercises,
             const std::filesystem::path& folder, const std::stop_token& stop)
      : m_exercises(exercises), m_stop(stop), m_snapshot(analyze(varied.snapshot()->mechanism, 0, stop)) {
    if (!m_snapshot) return;
    m_train = handoutTrain(*m_snapshot, folder, stop).train;
    m_drawings = svgDrawings(arrangedLists(*m_snapshot, stop));
  }

  /// Empty if a stop was requested.
  [[nodiscard]] Expected<std::string> bytesOf(SheetFileForm form) const {
    if (!m_snapshot) return std::string();
    const bool isPackage = form == SheetFileForm::scorm;
    Expected<std::string> page =
        handoutHtml(m_snapshot, m_drawings, m_train,
                    isPackage ? HandoutUse::learningPlatform : HandoutUse::alone, m_exercises, m_stop);
    if (!page || !isPackage) return page;
    const std::string& title = m_exercises.plan.title;
    return scormPackage(title.empty() ? reportTitle(*m_snapshot->mechanism) : title, *page);
  }

 private:
  const HandoutExercises& m_exercises;
  std::stop_token m_stop;
  SnapshotPtr m_snapshot;
  HandoutTrain m_train;
  ReportDrawings m_drawings;
};

/// A page that lists what each student gets.
std::string indexPage(const SheetRequest& request) {
  const auto cell = [](const std::string& text) { return "<td>" + text + "</td>"; };
  const auto link = [](const std::string& file) { return "<a href=\"" + file + "\">" + file + "</a>"; };
  const std::string title =
      escapedXml(request.plan.title.empty() ? translated("Exercises") : request.plan.title);
  std::string head = "<th>" + translated("Variant") + "</th>";
  if (!request.students.empty()) head += "<th>" + translated("Student") + "</th>";
  head += "<th>" + translated("Questions") + "</th><th>" + translated("File for answers") + "</th>";
  std::string rows;
  for (int variant = 1; variant <= request.plan.variants; ++variant) {
    const std::string number = numbered(variant, request.plan.variants);
    std::string questions;
    for (const SheetFileForm form : request.forms)
      questions += (questions.empty() ? "" : ", ") +
                   link(isPage(form) ? pageName(number, form) : fileName(SheetForm::questions, number, form));
    rows += "<tr>" + cell(number) +
            (request.students.empty()
                 ? ""
                 : cell(escapedXml(request.students[static_cast<std::size_t>(variant) - 1]))) +
            cell(questions) + cell(link(answersName(number))) + "</tr>\n";
  }
  return "<!DOCTYPE html>\n<html lang=\"" + translated("en") +
         "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
         "initial-scale=1\">\n<title>" +
         title +
         R"html(</title>
<style>
body { font: 16px/1.5 sans-serif; margin: 2em auto; max-width: 60em; padding: 0 1em; color-scheme: light dark; }
table { border-collapse: collapse; }
th, td { border-bottom: 1px solid #8888; padding: 0.3em 1em 0.3em 0; text-align: left; }
</style>
</head>
<body>
<h1>)html" +
         title + "</h1>\n<table>\n<thead><tr>" + head + "</tr></thead>\n<tbody>\n" + rows +
         "</tbody>\n</table>\n</body>\n</html>\n";
}

}  // namespace

std::optional<SheetFileForm> sheetFileForm(std::string_view name) {
  for (std::size_t form = 0; form < kForms.size(); ++form) {
    if (kForms[form].first == name) return static_cast<SheetFileForm>(form);
  }
  return std::nullopt;
}

std::vector<std::string> sheetFileNames(const SheetRequest& request) {
  std::vector<std::string> names{"sheet.json"};
  if (hasPages(request)) names.emplace_back(kIndexName);
  for (int variant = 1; variant <= request.plan.variants; ++variant) {
    const std::string number = numbered(variant, request.plan.variants);
    names.push_back(answersName(number));
    for (const SheetForm part : {SheetForm::questions, SheetForm::solution}) {
      for (const SheetFileForm form : request.forms) {
        if (!isPage(form)) names.push_back(fileName(part, number, form));
      }
    }
    for (const SheetFileForm form : request.forms) {
      if (isPage(form)) names.push_back(pageName(number, form));
    }
  }
  return names;
}

Expected<FolderFiles> sheetFiles(const ExerciseSource& source, const SheetRequest& request,
                                 const std::function<void(int)>& progress, const std::stop_token& stop) {
  const SheetFile file{request.plan, source.mechanism()};
  const std::string mark = sheetMark(file);
  FolderFiles files{{"sheet.json", sheetJson(file)}};
  if (hasPages(request)) files.emplace_back(kIndexName, indexPage(request));
  for (int variant = 1; variant <= request.plan.variants && !stop.stop_requested(); ++variant) {
    const ExerciseSource varied = variantSource(source, request.plan, variant);
    const SheetFileWriter writer(varied, stop);
    const SheetVariant sheet = makeVariant(varied, request.plan, variant);
    const std::string number = numbered(variant, request.plan.variants);
    const std::string student =
        request.students.empty() ? "" : request.students[static_cast<std::size_t>(variant) - 1];
    files.emplace_back(answersName(number), answersFor(sheet, mark, student));
    for (const SheetForm part : {SheetForm::questions, SheetForm::solution}) {
      const Report report = sheetReport(varied, request.plan, sheet, student, part);
      for (const SheetFileForm form : request.forms) {
        if (isPage(form)) continue;
        auto bytes = writer.bytesOf(report, sheet, part, form);
        if (!bytes) return bytes.error();
        files.emplace_back(fileName(part, number, form), std::move(bytes).value());
      }
    }
    if (hasPages(request)) {
      const HandoutExercises exercises{request.plan, mark, sheet, varied.snapshot()->mechanism, student};
      const PageWriter pages(varied, exercises, request.folder, stop);
      for (const SheetFileForm form : request.forms) {
        if (!isPage(form)) continue;
        auto bytes = pages.bytesOf(form);
        if (!bytes) return bytes.error();
        files.emplace_back(pageName(number, form), std::move(bytes).value());
      }
    }
    if (progress) progress(variant);
  }
  return files;
}

}  // namespace geargraph
