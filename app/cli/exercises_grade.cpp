// `exercises grade SHEET ANSWERS... [-o CSV]`: points and reasons.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/words.h"
#include "core/foundations/files/csv.h"
#include "core/foundations/files/file.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestAnswers = std::size_t{4} * 1024 * 1024;

/// The files that are named, and those of the folders that are, by name.
std::variant<std::vector<std::pair<fs::path, bool>>, FileError> filesOf(std::span<const std::string> words) {
  std::vector<std::pair<fs::path, bool>> files;  // and whether a folder was named
  for (const std::string& word : words) {
    if (!fs::is_directory(word)) {
      files.emplace_back(word, false);
      continue;
    }
    std::error_code error;
    std::vector<fs::path> inside;
    for (fs::directory_iterator entry(word, error), end; !error && entry != end; entry.increment(error)) {
      if (entry->path().extension() == ".json") inside.push_back(entry->path());
    }
    if (error)
      return FileError{translated("The folder \"%1\" could not be read: %2.", {word, error.message()})};
    std::sort(inside.begin(), inside.end());
    for (fs::path& path : inside) files.emplace_back(std::move(path), true);
  }
  return files;
}

/// Grades answers against the variants of one sheet, which are made when they are needed.
class AnswerGrader {
 public:
  explicit AnswerGrader(const SheetFile& sheet)
      : m_plan(sheet.plan), m_source(sheet.mechanism), m_mark(sheetMark(sheet)) {
    line({"file", "student", "variant", "question", "kind", "points", "of", "result", "mistake", "fields",
          "reason"});
  }

  /// What is wrong with the answers as a whole; then nothing is graded.
  [[nodiscard]] std::optional<std::string> fault(const AnswerSheet& answers) const {
    if (answers.sheet != m_mark) return translated("These are answers to another sheet.");
    if (answers.variant < 1 || answers.variant > m_plan.variants)
      return translated("The sheet has no variant %1.", {std::to_string(answers.variant)});
    return std::nullopt;
  }

  /// Texts for questions or fields that the sheet does not have are reported.
  void add(const std::string& file, const AnswerSheet& answers) {
    const std::vector<Question>& questions = questionsOf(answers.variant);
    int sum = 0;
    int of = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Question& question = questions[i];
      const auto given = answers.answers.find(static_cast<int>(i) + 1);
      std::vector<std::string> texts;
      std::size_t used = 0;
      for (const AnswerField& field : question.fields) {
        const bool isGiven = given != answers.answers.end() && given->second.contains(field.name);
        texts.push_back(isGiven ? given->second.at(field.name) : "");
        used += isGiven ? 1 : 0;
      }
      if (given != answers.answers.end() && used != given->second.size()) {
        std::cerr << file << ": "
                  << translated("Question %1 has no such field as some that are answered.",
                                {std::to_string(i + 1)})
                  << '\n';
      }
      const bool isBlank =
          std::all_of(texts.begin(), texts.end(), [](const std::string& t) { return t.empty(); });
      const Verdict verdict = grade(question, texts);
      std::string fields;
      for (const int field : isBlank ? std::vector<int>() : verdict.wrongFields)
        fields += (fields.empty() ? "" : "; ") + question.fields[static_cast<std::size_t>(field)].name;
      line({file, answers.student, std::to_string(answers.variant), std::to_string(i + 1), question.kind,
            std::to_string(verdict.points), std::to_string(question.points),
            verdict.isRight ? "right"
            : isBlank       ? "unanswered"
                            : "wrong",
            isBlank           ? "unanswered"
            : verdict.mistake ? verdict.mistake->name
                              : "",
            fields,
            verdict.isRight ? ""
            : isBlank       ? translated("The question is not answered.")
                            : verdict.reason});
      sum += verdict.points;
      of += question.points;
    }
    if (!answers.answers.empty() && answers.answers.rbegin()->first > static_cast<int>(questions.size()))
      std::cerr << file << ": "
                << translated("The sheet has no question %1.",
                              {std::to_string(answers.answers.rbegin()->first)})
                << '\n';
    line({file, answers.student, std::to_string(answers.variant), "total", "", std::to_string(sum),
          std::to_string(of), "", "", "", ""});
  }

  [[nodiscard]] const std::string& csv() const { return m_csv; }

 private:
  const std::vector<Question>& questionsOf(int variant) {
    const auto [found, isNew] = m_variants.try_emplace(variant);
    if (isNew) found->second = makeVariant(m_source, m_plan, variant).questions;
    return found->second;
  }
  void line(const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) m_csv += (i > 0 ? "," : "") + csvLabel(cells[i], ',');
    m_csv += '\n';
  }

  SheetPlan m_plan;
  ExerciseSource m_source;
  std::string m_mark;
  std::map<int, std::vector<Question>> m_variants;
  std::string m_csv;
};

}  // namespace

int gradeExercises(const Arguments& arguments) {
  if (arguments.files.size() < 2)
    return wrongUsage(kExercises, translated("grade needs a sheet and answers."));
  const std::string& sheetPath = arguments.files.front();
  const auto bytes = readFile(sheetPath, kLargestFile);
  if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
  const auto sheet = readSheet(std::get<std::string>(bytes));
  if (!sheet) {
    std::cerr << diagnosticLines(sheetPath, sheet.error());
    return kUsageOrFile;
  }
  const auto files = filesOf(std::span(arguments.files).subspan(1));
  if (const auto* error = std::get_if<FileError>(&files)) return fileFailure(error->message);
  AnswerGrader grader(*sheet);
  int status = kFine;
  for (const auto& [path, isOfFolder] : std::get<0>(files)) {
    if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the grading"));
    const auto text = readFile(path, kLargestAnswers);
    if (const auto* error = std::get_if<FileError>(&text)) {
      status = fileFailure(error->message);
      continue;
    }
    const auto answers = readAnswers(std::get<std::string>(text));
    if (!answers) {
      if (isOfFolder && answers.error().front().code == Code::format)
        continue;  // the sheet itself, other files
      std::cerr << diagnosticLines(path.string(), answers.error());
      status = kUsageOrFile;
      continue;
    }
    if (const auto fault = grader.fault(*answers)) {
      status = fileFailure('"' + path.string() + "\": " + *fault);
      continue;
    }
    grader.add(path.filename().string(), *answers);
  }
  const std::string out = arguments.value("-o").value_or("-");
  if (out == "-") return print(grader.csv(), status);
  const auto error = writeFile(out, grader.csv());
  return error ? fileFailure(error->message) : status;
}

}  // namespace geargraph::cli
