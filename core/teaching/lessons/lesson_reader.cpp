#include "core/teaching/lessons/lesson_reader.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/json_checks.h"
#include "core/teaching/lessons/task_reader.h"

namespace geargraph {
namespace {

constexpr int kMinMinutes = 1;
constexpr int kMaxMinutes = 60;

bool isLessonId(const std::string& id) {
  constexpr std::size_t kMaxLength = 60;
  return !id.empty() && id.size() <= kMaxLength && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

int wordsIn(const std::string& text) {
  int words = 0;
  bool isInside = false;
  for (const char c : text) {
    const bool isBlank = c == ' ' || c == '\n' || c == '\t';
    if (!isBlank && !isInside) ++words;
    isInside = !isBlank;
  }
  return words;
}

/// A text that must not be empty.
std::string sentence(MemberReader& reader, const JsonValue& object, std::string_view name,
                     const std::string& pointer) {
  std::string text = reader.text(object, name, pointer);
  if (text.empty()) reader.fail(pointer + '/' + std::string(name), translated("A text is needed here."));
  return text;
}

StepView readView(MemberReader& reader, const JsonValue& step, const std::string& pointer) {
  constexpr std::array<std::string_view, 5> kNames = {"digraph", "tt-graph", "schematic", "levers",
                                                      "nomogram"};
  const std::string name = reader.text(step, "view", pointer, false);
  const auto* const found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end() && !name.empty())
    reader.fail(pointer + "/view", translated("A view is digraph, tt-graph, schematic, levers or nomogram."));
  return name.empty() || found == kNames.end() ? StepView::digraph
                                               : static_cast<StepView>(found - kNames.begin());
}

class LessonReader {
 public:
  explicit LessonReader(const JsonValue& root) : m_root(root) {}

  [[nodiscard]] const std::optional<Diagnostic>& fault() const { return m_reader.fault(); }

  Lesson read() {
    Lesson lesson;
    m_reader.heading(m_root, "geargraph-lesson", kLessonVersion);
    if (m_reader.fault()) return lesson;
    checkMembers(m_reader, m_root, "",
                 {"$schema", "format", "version", "id", "title", "minutes", "goal", "terms", "example",
                  "document", "steps", "practice"});
    lesson.id = m_reader.text(m_root, "id", "");
    if (!isLessonId(lesson.id))
      m_reader.fail(
          "/id", translated("An id consists of small letters, digits and hyphens, such as \"cycle-basis\"."));
    lesson.title = sentence(m_reader, m_root, "title", "");
    lesson.goal = sentence(m_reader, m_root, "goal", "");
    lesson.minutes = m_reader.memberNumber(m_root, "minutes", "").value_or(0);
    if (lesson.minutes < kMinMinutes || lesson.minutes > kMaxMinutes)
      m_reader.fail("/minutes", translated("A lesson takes 1 to 60 minutes."));
    lesson.terms = m_reader.texts(m_root, "terms", "", false);
    const LessonDocument common = documentOf(m_root, "");
    m_reader.each(m_root, "steps", "", true, [&](const JsonValue& step, const std::string& pointer) {
      if (!m_reader.fault()) lesson.steps.push_back(readStep(step, pointer, common));
    });
    if (lesson.steps.empty() || lesson.steps.size() > kMaxLessonSteps)
      m_reader.fail("/steps", translated("A lesson has 1 to %1 steps.", {std::to_string(kMaxLessonSteps)}));
    m_reader.each(m_root, "practice", "", false, [&](const JsonValue& task, const std::string& pointer) {
      if (!m_reader.fault()) lesson.practice.push_back(readPractice(task, pointer, common));
    });
    return lesson;
  }

 private:
  PracticeTask readPractice(const JsonValue& object, const std::string& pointer,
                            const LessonDocument& common) {
    PracticeTask task;
    checkMembers(m_reader, object, pointer, {"exercise", "example", "document"});
    const std::string name = m_reader.text(object, "exercise", pointer);
    const auto kind = kindFromName(name);
    if (!kind && !m_reader.fault())
      m_reader.fail(pointer + "/exercise", translated("There is no kind of question \"%1\".", {name}));
    task.kind = kind.value_or(ExerciseKind::incidence);
    task.document = documentOr(object, pointer, common);
    return task;
  }

  LessonDocument documentOf(const JsonValue& object, const std::string& pointer) {
    if (m_reader.fault() || !object.is(JsonKind::object)) return {};
    const bool hasExample = object.member("example").has_value();
    if (hasExample && object.member("document"))
      m_reader.fail(pointer + "/document",
                    translated("Either an example is named or a document is given, not both."));
    return readDocument(m_reader, object, hasExample ? "example" : "document", pointer);
  }

  /// That of a part of the lesson, or of the lesson.
  LessonDocument documentOr(const JsonValue& object, const std::string& pointer,
                            const LessonDocument& common) {
    LessonDocument document = documentOf(object, pointer);
    if (document.example.empty() && !document.mechanism) document = common;
    if (document.example.empty() && !document.mechanism)
      m_reader.fail(pointer,
                    translated("Neither the step nor its lesson names an example or gives a document."));
    return document;
  }

  /// "5", or nothing.
  PaperEquation readEquation(const JsonValue& object, const std::string& pointer) {
    const std::string text = m_reader.text(object, "equation", pointer, false);
    if (text.empty()) return PaperEquation::none;
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > kPaperEquations) {
      m_reader.fail(pointer + "/equation", translated("The paper numbers its equations from 1 to %1.",
                                                      {std::to_string(kPaperEquations)}));
      return PaperEquation::none;
    }
    return static_cast<PaperEquation>(number);
  }

  LessonStep readStep(const JsonValue& object, const std::string& pointer, const LessonDocument& common) {
    LessonStep step;
    checkMembers(
        m_reader, object, pointer,
        {"title", "text", "formula", "equation", "view", "example", "document", "elements", "hints", "task"});
    if (m_reader.fault()) return step;
    step.title = sentence(m_reader, object, "title", pointer);
    step.text = sentence(m_reader, object, "text", pointer);
    if (wordsIn(step.text) > kMaxLessonWords)
      m_reader.fail(pointer + "/text",
                    translated("A step explains in at most %1 words; these are %2.",
                               {std::to_string(kMaxLessonWords), std::to_string(wordsIn(step.text))}));
    step.formula = m_reader.text(object, "formula", pointer, false);
    step.equation = readEquation(object, pointer);
    step.view = readView(m_reader, object, pointer);
    step.document = documentOr(object, pointer, common);
    if (!m_reader.fault()) step.elements = m_reader.elements(object, pointer);
    step.hints = m_reader.texts(object, "hints", pointer, true);
    if (step.hints.empty()) m_reader.fail(pointer + "/hints", translated("A step gives at least one hint."));
    if (!m_reader.fault()) readTask(m_reader, object, pointer, step);
    return step;
  }

  JsonValue m_root;
  MemberReader m_reader;
};

/// The innermost value on the way of a pointer that is there.
JsonValue valueAt(const JsonValue& root, std::string_view pointer) {
  JsonValue value = root;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view step = pointer.substr(0, pointer.find('/'));
    pointer.remove_prefix(step.size());
    std::optional<JsonValue> next;
    if (value.is(JsonKind::object)) next = value.member(step);
    std::size_t position = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), position);
    if (value.is(JsonKind::array) && error == std::errc() && end == step.data() + step.size())
      next = value.element(position);
    if (!next) break;
    value = *next;
  }
  return value;
}

}  // namespace

Diagnostics placedInText(std::string_view text, const Diagnostics& diagnostics) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  JsonDiagnostics placed(*document);
  for (const Diagnostic& diagnostic : diagnostics)
    placed.add(diagnostic.code, diagnostic.message, diagnostic.elements, diagnostic.pointer,
               valueAt(document->root(), diagnostic.pointer));
  return placed.inOrder();
}

Expected<Lesson> readLesson(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  if (!document) return document.error();
  LessonReader reader(document->root());
  Lesson lesson = reader.read();
  if (reader.fault()) return placedInText(text, {*reader.fault()});
  return lesson;
}

}  // namespace geargraph
