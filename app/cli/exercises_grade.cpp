// `exercises grade SHEET ANSWERS... [-o CSV] [--summary OUT]`: points and reasons.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>

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

/// Without blanks at its ends.
std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
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
    m_files.push_back({{file, "", ""}, {}, 0, rejection});
  }

  /// Texts for questions or fields that the sheet does not have are reported.
  void add(const std::string& file, const AnswerSheet& answers) {
    const std::vector<Question>& questions = questionsOf(answers.variant);
    GradedFile graded{{file, cutName(trimmed(answers.student)), std::to_string(answers.variant)}, {}, 0, {}};
    for (std::size_t i = 0; i < questions.size(); ++i) {
      graded.verdicts.push_back(verdictOf(file, static_cast<int>(i) + 1, questions[i], answers));
      graded.points += graded.verdicts.back().points;
    }
    if (!answers.answers.empty() && answers.answers.rbegin()->first > static_cast<int>(questions.size()))
      std::cerr << file << ": "
                << translated("The sheet has no question %1.",
                              {std::to_string(answers.answers.rbegin()->first)})
                << '\n';
    m_files.push_back(std::move(graded));
  }

  /// Writes what was added. A student counts once: of several files of one name that with the most points,
  /// the last of equal ones.
  void finish() {
    std::map<std::string, std::size_t> best;
    for (std::size_t i = 0; i < m_files.size(); ++i) {
      const GradedFile& file = m_files[i];
      if (file.rejection || file.student().empty()) continue;
      const auto [found, isFirst] = best.try_emplace(file.student(), i);
      if (!isFirst && file.points >= m_files[found->second].points) found->second = i;
    }
    for (std::size_t i = 0; i < m_files.size(); ++i) {
      const GradedFile& file = m_files[i];
      const auto counted = best.find(file.student());
      if (file.rejection) {
        line({file.head[0], file.head[1], file.head[2], "total", "", "", "", "rejected", file.rejection->code,
              "", file.rejection->reason});
      } else if (counted != best.end() && counted->second != i) {
        supersede(file, m_files[counted->second]);
      } else {
        write(file);
      }
    }
  }

  [[nodiscard]] const std::string& csv() const { return m_csv; }
  [[nodiscard]] const ClassSummary& summary() const { return m_summary; }

 private:
  /// The answers of one file.
  struct GradedFile {
    std::vector<std::string> head;  ///< file, student, variant
    std::vector<Verdict> verdicts;  ///< by question
    int points = 0;
    std::optional<AnswerRejection> rejection;

    [[nodiscard]] const std::string& student() const { return head[1]; }
  };

  Verdict verdictOf(const std::string& file, int number, const Question& question,
                    const AnswerSheet& answers) const {
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
      std::cerr << file << ": "
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
    return verdict;
  }
  /// The lines of a file that counts, also in the summary.
  void write(const GradedFile& file) {
    const std::vector<Question>& questions = questionsOf(std::stoi(file.head[2]));
    const std::string& student = file.student().empty() ? file.head[0] : file.student();
    int of = 0;
    int unreadable = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Question& question = questions[i];
      const Verdict& verdict = file.verdicts[i];
      std::string fields;
      for (const int field : verdict.wrongFields)
        fields += (fields.empty() ? "" : "; ") + question.fields[static_cast<std::size_t>(field)].name;
      m_summary.add(static_cast<int>(i) + 1, question, student, verdict);
      line({file.head[0], file.head[1], file.head[2], std::to_string(i + 1), question.kind,
            std::to_string(verdict.points), std::to_string(question.points), resultOf(verdict),
            verdict.mistake ? verdict.mistake->name : "", fields, verdict.isRight ? "" : verdict.reason});
      of += question.points;
      unreadable += verdict.isUnreadable ? 1 : 0;
    }
    const bool isRead = unreadable == 0;
    line({file.head[0], file.head[1], file.head[2], "total", "", std::to_string(file.points),
          std::to_string(of), isRead ? "" : "unreadable", "", "",
          isRead ? "" : translated("Answers that cannot be read: %1.", {std::to_string(unreadable)})});
  }
  /// The line of a file that does not count.
  void supersede(const GradedFile& file, const GradedFile& counted) {
    const std::string reason =
        translated("Of the files of %1, %2 counts.", {file.student(), counted.head[0]});
    std::cerr << file.head[0] << ": " << reason << '\n';
    line({file.head[0], file.head[1], file.head[2], "total", "", "", "", "superseded", "", "", reason});
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
  std::vector<GradedFile> m_files;
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
  grader.finish();
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
