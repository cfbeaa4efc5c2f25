// `exercises grade SHEET ANSWERS... [-o CSV] [--summary OUT]`: points and reasons.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/csv.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/json.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/teaching/exercises/class_summary.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestAnswers = std::size_t{4} * 1024 * 1024;
constexpr std::size_t kMaxPupilName = 80;  ///< characters of a student's name in the CSV

/// A file of answers, and whether it was found in a folder.
struct HandedIn {
  fs::path path;
  bool isOfFolder = false;
};

/// The files that are named, and those of the folders that are, by name.
std::variant<std::vector<HandedIn>, FileError> filesOf(std::span<const std::string> words) {
  std::vector<HandedIn> files;
  for (const std::string& word : words) {
    if (!fs::is_directory(word)) {
      files.push_back({word, false});
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
    for (fs::path& path : inside) files.push_back({std::move(path), true});
  }
  return files;
}

/// Why a file is not graded: the code in its row, and a sentence.
struct AnswerRejection {
  std::string code;
  std::string reason;
};

/// Is it a folder, a pipe or a device? A pipe would keep the program waiting.
bool isNoFile(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return path != "-" && fs::exists(status) && !fs::is_regular_file(status);
}

/// The bytes of a file of answers.
std::variant<std::string, AnswerRejection> textOf(const fs::path& path) {
  const std::string name = '"' + path.string() + '"';
  if (isNoFile(path)) return AnswerRejection{"no-file", translated("%1 is no regular file.", {name})};
  auto text = readFile(path, kLargestAnswers);
  if (const auto* failure = std::get_if<FileError>(&text))
    return AnswerRejection{"no-file", failure->message};
  auto& bytes = std::get<std::string>(text);
  if (bytes.size() > kLargestAnswers)
    return AnswerRejection{"too-large",
                           translated("%1 is larger than %2 MB, which no answers are.", {name, "4"})};
  return std::move(bytes);
}

/// Is it another file that `make` writes beside the answers: the sheet, or its questions?
bool isOtherFile(const std::string& text) {
  const auto document = JsonDocument::parse(text);
  if (!document || !document->root().is(JsonKind::object)) return false;
  const auto format = document->root().member("format");
  if (!format || !format->is(JsonKind::string)) return false;
  const std::string name = format->string();
  return name.starts_with("geargraph") && name != "geargraph-answers";
}

/// The text, cut after some characters.
std::string cutName(const std::string& text) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isFirstByte = (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
    if (isFirstByte && ++characters > kMaxPupilName) return text.substr(0, at) + "\u2026";
  }
  return text;
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
  [[nodiscard]] std::optional<AnswerRejection> fault(const AnswerSheet& answers) const {
    if (answers.sheet != m_mark)
      return AnswerRejection{"other-sheet", translated("These are answers to another sheet.")};
    if (answers.variant < 1 || answers.variant > m_plan.variants)
      return AnswerRejection{"no-variant",
                             translated("The sheet has no variant %1.", {std::to_string(answers.variant)})};
    return std::nullopt;
  }

  /// The row of a file that is not graded.
  void reject(const std::string& file, const AnswerRejection& rejection) {
    line({file, "", "", "total", "", "", "", "rejected", rejection.code, "", rejection.reason});
  }

  /// Texts for questions or fields that the sheet does not have are reported.
  void add(const std::string& file, const AnswerSheet& answers) {
    const std::vector<Question>& questions = questionsOf(answers.variant);
    const std::vector<std::string> head{file, cutName(answers.student), std::to_string(answers.variant)};
    int sum = 0;
    int of = 0;
    int unreadable = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Verdict verdict = addQuestion(head, static_cast<int>(i) + 1, questions[i], answers);
      sum += verdict.points;
      of += questions[i].points;
      unreadable += verdict.isUnreadable ? 1 : 0;
    }
    if (!answers.answers.empty() && answers.answers.rbegin()->first > static_cast<int>(questions.size()))
      std::cerr << file << ": "
                << translated("The sheet has no question %1.",
                              {std::to_string(answers.answers.rbegin()->first)})
                << '\n';
    const bool isRead = unreadable == 0;
    line({head[0], head[1], head[2], "total", "", std::to_string(sum), std::to_string(of),
          isRead ? "" : "unreadable", "", "",
          isRead ? "" : translated("Answers that cannot be read: %1.", {std::to_string(unreadable)})});
  }

  [[nodiscard]] const std::string& csv() const { return m_csv; }
  [[nodiscard]] const ClassSummary& summary() const { return m_summary; }

 private:
  Verdict addQuestion(const std::vector<std::string>& head, int number, const Question& question,
                      const AnswerSheet& answers) {
    const auto given = answers.answers.find(number);
    const bool isGiven = given != answers.answers.end();
    std::vector<std::string> texts;
    std::size_t used = 0;
    for (const AnswerField& field : question.fields) {
      const bool hasText = isGiven && given->second.contains(field.name);
      texts.push_back(hasText ? given->second.at(field.name) : "");
      used += hasText ? 1 : 0;
    }
    if (isGiven && used != given->second.size()) {
      std::cerr << head[0] << ": "
                << translated("Question %1 has no such field as some that are answered.",
                              {std::to_string(number)})
                << '\n';
    }
    Verdict verdict = grade(question, texts);
    // Also where an empty answer would be one: a blank that is handed in was not chosen.
    const bool isEmpty =
        std::all_of(texts.begin(), texts.end(), [](const auto& text) { return text.empty(); });
    if (isEmpty && !verdict.isRight) {
      verdict = {};
      verdict.isBlank = true;
      verdict.reason = translated("The question is not answered.");
      verdict.mistake = FoundMistake{"unanswered", {}, {}, verdict.reason};
    }
    std::string fields;
    for (const int field : verdict.wrongFields)
      fields += (fields.empty() ? "" : "; ") + question.fields[static_cast<std::size_t>(field)].name;
    m_summary.add(number, question, head[1].empty() ? head[0] : head[1], verdict);
    line({head[0], head[1], head[2], std::to_string(number), question.kind, std::to_string(verdict.points),
          std::to_string(question.points), resultOf(verdict), verdict.mistake ? verdict.mistake->name : "",
          fields, verdict.isRight ? "" : verdict.reason});
    return verdict;
  }
  static std::string resultOf(const Verdict& verdict) {
    return verdict.isRight        ? "right"
           : verdict.isBlank      ? "unanswered"
           : verdict.isUnreadable ? "unreadable"
                                  : "wrong";
  }
  const std::vector<Question>& questionsOf(int variant) {
    const auto [found, isNew] = m_variants.try_emplace(variant);
    if (isNew)
      found->second = makeVariant(variantSource(m_source, m_plan, variant), m_plan, variant).questions;
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
  ClassSummary m_summary;
};

/// Is it to be the page with bars, by its suffix?
bool isWebPage(const fs::path& path) {
  return path.extension() == ".html" || path.extension() == ".htm";
}

}  // namespace

int gradeExercises(const Arguments& arguments) {
  if (arguments.files.size() < 2)
    return wrongUsage(kExercises, translated("grade needs a sheet and answers."));
  const auto summary = arguments.value("--summary");
  if (summary && !isWebPage(*summary) && fs::path(*summary).extension() != ".csv")
    return wrongUsage(kExercises, translated("--summary is a file that ends in .csv or .html."));
  const std::string& sheetPath = arguments.files.front();
  if (isNoFile(sheetPath)) return fileFailure(translated("%1 is no regular file.", {'"' + sheetPath + '"'}));
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
  for (const auto& [path, isOfFolder] : std::get<std::vector<HandedIn>>(files)) {
    if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the grading"));
    const std::string file = path == "-" ? "-" : path.filename().string();
    const auto reject = [&](const AnswerRejection& rejection, const std::string& shown) {
      std::cerr << shown;
      grader.reject(file, rejection);
      status = kUsageOrFile;
    };
    const auto text = textOf(path);
    if (const auto* rejection = std::get_if<AnswerRejection>(&text)) {
      reject(*rejection, "geargraph-cli: " + rejection->reason + '\n');
      continue;
    }
    const auto answers = readAnswers(std::get<std::string>(text));
    if (!answers) {
      if (isOfFolder && isOtherFile(std::get<std::string>(text))) continue;
      const Diagnostic& first = answers.error().front();
      reject({std::string(codeName(first.code)), first.message},
             diagnosticLines(path.string(), answers.error()));
      continue;
    }
    if (const auto rejection = grader.fault(*answers)) {
      reject(*rejection, "geargraph-cli: \"" + path.string() + "\": " + rejection->reason + '\n');
      continue;
    }
    grader.add(file, *answers);
  }
  if (summary) {
    const ClassSummary& made = grader.summary();
    if (const auto error =
            writeFile(*summary, isWebPage(*summary) ? made.html(sheet->plan.title) : made.csv()))
      return fileFailure(error->message);
  }
  const std::string out = arguments.value("-o").value_or("-");
  if (out == "-") return print(grader.csv(), status);
  const auto error = writeFile(out, grader.csv());
  return error ? fileFailure(error->message) : status;
}

}  // namespace geargraph::cli
