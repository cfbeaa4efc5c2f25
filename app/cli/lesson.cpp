// `lesson check|list`: lessons for the window, checked as a learner would work on them.

#include <algorithm>
#include <array>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/teaching/lessons/course.h"
#include "core/teaching/lessons/lesson_checker.h"
#include "core/teaching/lessons/lesson_reader.h"

namespace geargraph::cli {
namespace {

constexpr std::size_t kLargestLesson = std::size_t{4} * 1024 * 1024;

struct CheckedLesson {
  std::string file;
  Diagnostics diagnostics;
  std::string summary;  ///< of a lesson without faults
};

CheckedLesson checked(const std::string& file, const std::string& text, const std::stop_token& stop) {
  const auto lesson = readLesson(text);
  if (!lesson) return {file, lesson.error(), {}};
  const Diagnostics diagnostics = checkLesson(*lesson, bundledExample, stop);
  if (!diagnostics.empty()) return {file, placedInText(text, diagnostics), {}};
  const std::size_t steps = lesson->steps.size();
  return {file,
          {},
          steps == 1 ? translated("1 step, no faults")
                     : translated("%1 steps, no faults", {std::to_string(steps)})};
}

std::string asJson(const std::vector<CheckedLesson>& lessons) {
  TextSink sink;
  {
    JsonWriter json(sink);
    json.beginObject();
    json.member("format", "geargraph-lesson-check");
    json.member("version", 1);
    json.key("lessons");
    json.beginArray();
    for (const CheckedLesson& lesson : lessons) {
      json.beginObject();
      json.member("file", lesson.file);
      json.key("diagnostics");
      writeDiagnostics(json, lesson.diagnostics);
      json.endObject();
    }
    json.endArray();
    json.endObject();
  }
  return sink.take();
}

int check(const Arguments& arguments) {
  if (arguments.files.size() < 2) return wrongUsage(kLesson, translated("check needs a file."));
  std::vector<CheckedLesson> lessons;
  for (const std::string& file : std::span(arguments.files).subspan(1)) {
    const auto bytes = readFile(file, kLargestLesson);
    if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
    lessons.push_back(checked(file, std::get<std::string>(bytes), arguments.stop));
    if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the check"));
  }
  const bool isFine = std::all_of(lessons.begin(), lessons.end(),
                                  [](const CheckedLesson& lesson) { return lesson.diagnostics.empty(); });
  const int status = isFine ? kFine : kMechanismErrors;
  if (arguments.has("--json")) return print(asJson(lessons), status);
  std::string text;
  for (const CheckedLesson& lesson : lessons) {
    text += lesson.diagnostics.empty() ? lesson.file + ": " + lesson.summary + '\n'
                                       : diagnosticLines(lesson.file, lesson.diagnostics);
  }
  return print(text, status);
}

int list(const Arguments& arguments) {
  if (arguments.files.size() > 1 || arguments.has("--json"))
    return wrongUsage(kLesson, translated("list has no options."));
  std::string text;
  int minutes = 0;
  for (const Lesson& lesson : course()) {
    constexpr std::size_t kTitleColumn = 25;
    std::string line = lesson.id;
    line.resize(std::max(line.size() + 1, kTitleColumn), ' ');
    text += line + lesson.title + " (" + translated("%1 min", {std::to_string(lesson.minutes)}) +
            "): " + lesson.goal + '\n';
    minutes += lesson.minutes;
  }
  return print(text +
               translated("%1 lessons, %2 min", {std::to_string(course().size()), std::to_string(minutes)}) +
               '\n');
}

int runLesson(const Arguments& arguments) {
  const std::string action = arguments.files.empty() ? std::string() : arguments.files.front();
  if (action == "check") return check(arguments);
  if (action == "list") return list(arguments);
  return wrongUsage(kLesson, translated("The first word is check or list."));
}

constexpr std::array kLessonOptions = {Option{"--json", "", toTranslate("the findings as JSON"), "check"}};

}  // namespace

const Command kLesson = {
    .name = "lesson",
    .usage = "check FILE... [--json] | list",
    .summary = toTranslate("Checks lessons: their form, answers and reasons; lists those of the program."),
    .options = kLessonOptions,
    .run = runLesson,
    .isServed = false};

}  // namespace geargraph::cli
