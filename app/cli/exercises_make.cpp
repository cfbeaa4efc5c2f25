// `exercises make`: sheets, solutions and files for answers.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/exercise_plan.h"
#include "app/cli/load.h"
#include "app/cli/time_limit.h"
#include "core/foundations/files/folder.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/presentation/drawing/svg_writer.h"
#include "core/presentation/pages/report_pdf.h"
#include "core/presentation/results/named_drawings.h"
#include "core/presentation/sheets/sheet_report.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

struct MakeOptions {
  SheetPlan plan;
  std::vector<std::string> names;  ///< by variant; empty without --names
  std::vector<std::string> forms;
};

/// Everything but the kinds, which depend on the mechanism.
std::variant<MakeOptions, UsageError, FileError> optionsFrom(const Arguments& arguments) {
  MakeOptions options;
  if (arguments.has("--variants") && arguments.has("--names"))
    return UsageError{"Give --variants or --names: a name is a variant."};
  auto plan = planFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&plan)) return *error;
  options.plan = std::get<SheetPlan>(std::move(plan));
  if (const auto path = arguments.value("--names")) {
    const auto bytes = readFile(*path, kLargestFile);
    if (const auto* error = std::get_if<FileError>(&bytes)) return *error;
    options.names = wordsOf(std::get<std::string>(bytes), '\n');
    if (options.names.empty() || options.names.size() > kMostVariants)
      return UsageError{"--names is a text file of 1 to 1000 lines."};
    options.plan.variants = static_cast<int>(options.names.size());
  }
  options.forms = wordsOf(arguments.value("--to").value_or("html,latex,pdf"), ',');
  for (const std::string& form : options.forms) {
    if (form != "html" && form != "latex" && form != "pdf" && form != "json")
      return UsageError{"--to lists forms out of html, latex, pdf and json, not \"" + form + "\"."};
  }
  return options;
}

/// "07" of 30.
std::string numbered(int variant, int variants) {
  std::string number = std::to_string(variant);
  return std::string(std::to_string(variants).size() - number.size(), '0') + number;
}

std::string fileName(const char* what, const std::string& number, const std::string& form) {
  return std::string(what) + '-' + number + '.' + (form == "latex" ? "tex" : form);
}

std::string answersFor(const SheetVariant& sheet, const std::string& mark, const std::string& student) {
  AnswerSheet answers{mark, sheet.variant, student, {}};
  for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
    for (const AnswerField& field : sheet.questions[i].fields)
      answers.answers[static_cast<int>(i) + 1][field.name] = "";
  }
  return answersJson(answers);
}

/// Makes all files of a sheet, variant by variant, then writes them.
class SheetFolder {
 public:
  SheetFolder(const Arguments& arguments, const ExerciseSource& source, const MakeOptions& options,
              SheetFile sheet)
      : m_arguments(arguments),
        m_source(source),
        m_options(options),
        m_sheet(std::move(sheet)),
        m_folder(*arguments.value("-o")) {}

  int write() {
    if (const auto taken = fileInTheWay()) {
      return fileFailure("\"" + (m_folder / *taken).string() +
                         "\" is there already; nothing was written (--force overwrites).");
    }
    const AnalysisSnapshot& snapshot = *m_source.snapshot();
    m_lists = {drawingNamed("schematic")->draw(snapshot, nullptr, m_arguments.stop),
               drawingNamed("digraph")->draw(snapshot, nullptr, m_arguments.stop),
               {}};
    const SheetLook look;
    m_drawings = {svgOf(m_lists.schematic, look), svgOf(m_lists.digraph, look), {}};
    put("sheet.json", sheetJson(m_sheet));
    const std::string mark = sheetMark(m_sheet);
    for (int variant = 1; variant <= m_options.plan.variants; ++variant) {
      if (m_arguments.stop.stop_requested())
        return outOfTime(m_arguments, "variant " + std::to_string(variant));
      const auto fault = makeFiles(makeVariant(m_source, m_options.plan, variant), mark);
      if (fault) return fileFailure(fault->message);
    }
    const auto failure = writeFolder(m_folder, m_files, {m_arguments.has("--force"), {}, {}});
    return failure ? fileFailure(failure->message) : kFine;
  }

 private:
  /// A file of the sheet that is there already: told before the long work of making them.
  [[nodiscard]] std::optional<std::string> fileInTheWay() const {
    if (m_arguments.has("--force")) return std::nullopt;
    std::vector<std::string> names{"sheet.json"};
    for (int variant = 1; variant <= m_options.plan.variants; ++variant) {
      const std::string number = numbered(variant, m_options.plan.variants);
      names.push_back(fileName("answers", number, "json"));
      for (const std::string& form : m_options.forms) {
        names.push_back(fileName("sheet", number, form));
        names.push_back(fileName("solution", number, form));
      }
    }
    const auto taken = std::find_if(names.begin(), names.end(),
                                    [&](const std::string& name) { return fs::exists(m_folder / name); });
    if (taken == names.end()) return std::nullopt;
    return *taken;
  }

  void put(std::string name, std::string bytes) { m_files.emplace_back(std::move(name), std::move(bytes)); }

  /// What a variant consists of; nothing where all of it was made.
  [[nodiscard]] std::optional<Diagnostic> makeFiles(const SheetVariant& sheet, const std::string& mark) {
    const std::string number = numbered(sheet.variant, m_options.plan.variants);
    const std::string student =
        m_options.names.empty() ? "" : m_options.names[static_cast<std::size_t>(sheet.variant) - 1];
    put(fileName("answers", number, "json"), answersFor(sheet, mark, student));
    for (const SheetForm part : {SheetForm::questions, SheetForm::solution}) {
      const Report report = sheetReport(m_source, m_options.plan, sheet, student, part);
      for (const std::string& form : m_options.forms) {
        auto bytes = bytesOf(report, sheet, part, form);
        if (!bytes) return bytes.error().front();
        put(fileName(part == SheetForm::questions ? "sheet" : "solution", number, form),
            std::move(bytes).value());
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Expected<std::string> bytesOf(const Report& report, const SheetVariant& sheet, SheetForm part,
                                              const std::string& form) const {
    if (form == "html") return reportHtml(report, m_drawings);
    if (form == "latex") return reportLatex(report);
    if (form == "pdf") return reportPdf(report, m_lists);
    return questionsJson(sheet.questions,
                         part == SheetForm::questions ? QuestionPart::withoutKey : QuestionPart::withKey);
  }

  const Arguments& m_arguments;
  const ExerciseSource& m_source;
  const MakeOptions& m_options;
  SheetFile m_sheet;
  fs::path m_folder;
  ReportLists m_lists;
  ReportDrawings m_drawings;
  FolderFiles m_files;  ///< written when all are made
};

}  // namespace

int makeExercises(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExercises, "make needs one file.");
  if (!arguments.has("-o")) return wrongUsage(kExercises, "make needs a folder: -o FOLDER.");
  auto read = optionsFrom(arguments);
  if (const auto* error = std::get_if<UsageError>(&read)) return wrongUsage(kExercises, error->message);
  if (const auto* error = std::get_if<FileError>(&read)) return fileFailure(error->message);
  auto& options = std::get<MakeOptions>(read);
  auto loaded = loadOrSay(arguments.files.front());
  if (const int* status = std::get_if<int>(&loaded)) return *status;
  auto& mechanism = std::get<Mechanism>(loaded);
  if (mechanism.n() > kMostExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(mechanism);
  const Diagnostics& diagnostics = source.snapshot()->diagnostics;
  std::cerr << diagnosticLines(arguments.files.front(), diagnostics);
  auto kinds = kindsFrom(arguments, source);
  if (const auto* error = std::get_if<UsageError>(&kinds)) return wrongUsage(kExercises, error->message);
  options.plan.kinds = std::get<std::vector<ExerciseKind>>(std::move(kinds));
  const int status = hasErrors(diagnostics) ? kMechanismErrors : kFine;
  if (options.plan.kinds.empty()) {
    std::cerr << "geargraph-cli: Nothing can be asked about this mechanism; no sheet was written.\n";
    return status == kFine ? kUsageOrFile : status;
  }
  const int written = SheetFolder(arguments, source, options, {options.plan, std::move(mechanism)}).write();
  return written == kFine ? status : written;
}

}  // namespace geargraph::cli
