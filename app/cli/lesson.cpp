// `lesson check|list|make`: lessons, checked as a learner would work on them, and written as pages and
// packages.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/diagnostics_output.h"
#include "app/cli/time_limit.h"
#include "core/foundations/base/translation.h"
#include "core/foundations/files/file.h"
#include "core/foundations/files/folder.h"
#include "core/presentation/exporters/exercise_plan.h"
#include "core/presentation/lesson_pages/lesson_files.h"
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
  if (arguments.files.size() > 1) return wrongUsage(kLesson, translated("list needs no file."));
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

/// A lesson of the program by its id, or that of a file.
std::variant<Lesson, int> lessonNamed(const std::string& name) {
  for (const Lesson& lesson : course()) {
    if (lesson.id == name) return lesson;
  }
  const auto bytes = readFile(name, kLargestLesson);
  if (const auto* error = std::get_if<FileError>(&bytes)) return fileFailure(error->message);
  auto lesson = readLesson(std::get<std::string>(bytes));
  if (lesson) return std::move(lesson).value();
  std::cerr << diagnosticLines(name, lesson.error());
  return kMechanismErrors;
}

int make(const Arguments& arguments) {
  if (!arguments.has("-o")) return wrongUsage(kLesson, translated("make needs a folder: -o FOLDER."));
  std::vector<LessonFileForm> forms;
  for (const std::string& name : wordsOf(arguments.value("--to").value_or("html"), ',')) {
    const auto form = lessonFileForm(name);
    if (!form)
      return wrongUsage(kLesson, translated("--to lists forms out of html and scorm, not \"%1\".", {name}));
    forms.push_back(*form);
  }
  std::vector<Lesson> lessons;
  for (const std::string& name : std::span(arguments.files).subspan(1)) {
    auto lesson = lessonNamed(name);
    if (const int* status = std::get_if<int>(&lesson)) return *status;
    lessons.push_back(std::get<Lesson>(std::move(lesson)));
  }
  if (lessons.empty()) lessons = course();
  const std::filesystem::path folder = *arguments.value("-o");
  const bool overwrites = arguments.has("--force");
  for (const std::string& name : lessonFileNames(lessons, forms)) {
    if (!overwrites && std::filesystem::exists(folder / name))
      return fileFailure(translated("\"%1\" is there already; nothing was written (--force overwrites).",
                                    {(folder / name).string()}));
  }
  const auto files = lessonFiles(lessons, forms, bundledExample, arguments.stop);
  if (arguments.stop.stop_requested()) return outOfTime(arguments, translated("the pages"));
  if (!files) {
    std::cerr << diagnosticLines("geargraph-cli", files.error());
    return kMechanismErrors;
  }
  const auto failure = writeFolder(folder, *files, {overwrites, {}, {}});
  return failure ? fileFailure(failure->message) : kFine;
}

int runLesson(const Arguments& arguments) {
  const std::string action = arguments.files.empty() ? std::string() : arguments.files.front();
  for (const std::string_view option : {"--json", "--to", "--force", "-o"}) {
    const bool isKnown = action == "make" ? option != "--json" : action == "check" && option == "--json";
    if (arguments.has(option) && !isKnown && (action == "make" || action == "check" || action == "list"))
      return wrongUsage(kLesson, translated("%1 has no meaning for lesson %2.", {option, action}));
  }
  if (action == "check") return check(arguments);
  if (action == "list") return list(arguments);
  if (action == "make") return make(arguments);
  return wrongUsage(kLesson, translated("The first word is check, list or make."));
}

constexpr std::array kLessonOptions = {
    Option{"--json", "", toTranslate("the findings as JSON"), "check"},
    Option{"--to", "LIST", toTranslate("forms: html for browsers, scorm for learning platforms (html)"),
           "make"},
    Option{"--force", "", toTranslate("overwrites files in the folder"), "make"},
    Option{"-o", "FOLDER", toTranslate("a folder for the pages and packages"), "make"}};

}  // namespace

const Command kLesson = {
    .name = "lesson",
    .usage = "check FILE... [--json] | list | make [LESSON...] [--to html,scorm] [--force] -o FOLDER",
    .summary = toTranslate(
        "Checks lessons: their form, answers and reasons; lists those of the program; makes pages of them."),
    .options = kLessonOptions,
    .run = runLesson,
    .isServed = false};

}  // namespace geargraph::cli
