#include "core/teaching/lessons/task_reader.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/rational.h"
#include "core/foundations/base/translation.h"
#include "core/mechanism/document_format/mechanism_file.h"
#include "core/teaching/grading/question_json.h"
#include "core/teaching/grading/question_reader.h"
#include "core/teaching/lessons/quantities.h"

namespace geargraph {
namespace {

using Answer = std::vector<std::string>;

constexpr std::array<std::string_view, 5> kAnswerKinds = {"type", "choose", "pick", "predict", "find"};
constexpr const char* kOnlyField = "answer";

/// A text, or a number as it is written.
std::optional<std::string> numberText(MemberReader& reader, const JsonValue& object, std::string_view name,
                                      const std::string& pointer) {
  const auto member = object.member(name);
  if (!member) return std::nullopt;
  const std::string text = member->is(JsonKind::string) ? member->string() : std::string(member->slice());
  if (!Rational::fromText(text))
    reader.fail(pointer + '/' + std::string(name),
                translated("A number or a fraction such as \"-2/3\" is needed here."));
  return text;
}

std::optional<AskedQuantity> readQuantity(MemberReader& reader, const JsonValue& object,
                                          const std::string& pointer) {
  const std::string name = reader.text(object, "quantity", pointer);
  const auto quantity = quantityFromName(name);
  if (!quantity) {
    reader.fail(pointer + "/quantity", translated("\"%1\" is no quantity that the analysis gives.", {name}));
    return std::nullopt;
  }
  AskedQuantity asked{*quantity, reader.text(object, "of", pointer, needsName(*quantity))};
  if (!needsName(*quantity) && !asked.of.empty())
    reader.fail(pointer + "/of", translated("The quantity \"%1\" is of the whole document.", {name}));
  return asked;
}

/// Answers: an array for several fields, a text for the only one.
std::vector<Answer> readAnswers(MemberReader& reader, const JsonValue& object, std::string_view name,
                                const std::string& pointer, bool isNeeded) {
  std::vector<Answer> answers;
  reader.each(object, name, pointer, isNeeded, [&](const JsonValue& element, const std::string& place) {
    Answer answer;
    if (element.is(JsonKind::string)) {
      answer = {element.string()};
    } else {
      reader.eachElement(element, place, [&](const JsonValue& text, const std::string& textPlace) {
        answer.push_back(reader.elementText(text, textPlace));
      });
    }
    answers.push_back(std::move(answer));
  });
  return answers;
}

std::vector<ElementKind> readPickable(MemberReader& reader, const JsonValue& task,
                                      const std::string& pointer) {
  constexpr std::array kPickable = {ElementKind::link, ElementKind::turningJoint, ElementKind::gearMesh};
  std::vector<ElementKind> kinds;
  for (const std::string& name : reader.texts(task, "from", pointer, true)) {
    const auto* const kind =
        std::find_if(kPickable.begin(), kPickable.end(), [&](ElementKind k) { return listName(k) == name; });
    if (kind == kPickable.end()) {
      reader.fail(pointer + "/from", translated("What can be picked is links, turningJoints or gearMeshes."));
    } else {
      kinds.push_back(*kind);
    }
  }
  if (kinds.empty()) reader.fail(pointer + "/from", translated("What can be picked is named here."));
  return kinds;
}

TaskField readField(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  TaskField field;
  checkMembers(reader, object, pointer, {"name", "kind", "options", "elements", "mayBeEmpty", "is"});
  field.field.name = reader.text(object, "name", pointer);
  const std::string kind = reader.text(object, "kind", pointer);
  constexpr std::array kKinds = {FieldKind::integer, FieldKind::number, FieldKind::choice, FieldKind::set};
  const auto* const known =
      std::find_if(kKinds.begin(), kKinds.end(), [&](FieldKind k) { return fieldKindName(k) == kind; });
  if (known == kKinds.end())
    return reader.fail(pointer + "/kind", translated("A field is an integer, a number, a choice or a set.")),
           field;
  field.field.kind = *known;
  field.field.options = reader.texts(object, "options", pointer, false);
  const bool hasOptions = *known == FieldKind::choice || *known == FieldKind::set;
  if (hasOptions == field.field.options.empty())
    reader.fail(pointer + "/options", translated("A choice or a set has options, a number has none."));
  if (!reader.fault()) field.field.elements = reader.elements(object, pointer);
  const auto mayBeEmpty = reader.member(object, "mayBeEmpty", JsonKind::boolean, pointer, false);
  field.field.mayBeEmpty = mayBeEmpty && mayBeEmpty->boolean();
  if (const auto is = reader.member(object, "is", JsonKind::object, pointer, false))
    field.is = readQuantity(reader, *is, pointer + "/is");
  return field;
}

TaskMistake readMistake(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  TaskMistake read;
  checkMembers(reader, object, pointer, {"answers", "when", "fields", "elements", "reason", "example"});
  if (reader.fault()) return read;
  read.mistake.fields = reader.numbers(object, "fields", pointer);
  if (object.member("when")) {
    read.mistake.when = readConditions(reader, object, "when", pointer);
    if (object.member("answers"))
      reader.fail(pointer + "/answers",
                  translated("A mistake is told by answers or by conditions, not by both."));
  } else {
    Condition condition{Test::values, read.mistake.fields,
                        readAnswers(reader, object, "answers", pointer, true)};
    read.mistake.when.push_back(std::move(condition));
  }
  if (!reader.fault()) read.mistake.elements = reader.elements(object, pointer);
  read.mistake.reason = reader.text(object, "reason", pointer);
  if (read.mistake.reason.empty()) reader.fail(pointer + "/reason", translated("A reason is a sentence."));
  if (read.mistake.when.empty())
    reader.fail(pointer + "/when", translated("A mistake has at least one condition."));
  if (reader.fault()) return read;
  read.example = reader.texts(object, "example", pointer, false);
  if (read.example.empty() && read.mistake.when.front().test != Test::values)
    reader.fail(pointer + "/example",
                translated("A mistake that conditions tell needs an example of an answer."));
  return read;
}

void readFields(MemberReader& reader, const JsonValue& object, const std::string& pointer, AnswerTask& task) {
  if (task.kind == AnswerKind::type || task.kind == AnswerKind::predict) {
    reader.each(object, "fields", pointer, true, [&](const JsonValue& element, const std::string& place) {
      if (!reader.fault()) task.fields.push_back(readField(reader, element, place));
      if (!reader.fault() && task.kind == AnswerKind::predict && !task.fields.back().is)
        reader.fail(place + "/is",
                    translated("A prediction names the quantity of the analysis that it is compared with."));
    });
    return;
  }
  TaskField field;
  field.field.name = kOnlyField;
  field.field.kind = FieldKind::choice;
  if (task.kind == AnswerKind::choose) {
    field.field.options = reader.texts(object, "options", pointer, true);
    if (field.field.options.size() < 2)
      reader.fail(pointer + "/options", translated("A choice needs two options or more."));
  } else {
    field.field.kind = FieldKind::set;
    task.from = readPickable(reader, object, pointer);
  }
  if (const auto is = reader.member(object, "is", JsonKind::object, pointer, false))
    field.is = readQuantity(reader, *is, pointer + "/is");
  task.fields.push_back(std::move(field));
}

AnswerTask readAnswerTask(MemberReader& reader, const JsonValue& object, const std::string& pointer,
                          AnswerKind kind) {
  AnswerTask task;
  task.kind = kind;
  checkMembers(reader, object, pointer,
               {"kind", "prompt", "fields", "options", "from", "is", "table", "accepted", "conditions",
                "solution", "mistakes", "rule"});
  readFields(reader, object, pointer, task);
  if (reader.fault()) return task;
  if (const auto table = reader.member(object, "table", JsonKind::object, pointer, false)) {
    task.table.rows = reader.texts(*table, "rows", pointer + "/table", true);
    task.table.columns = reader.texts(*table, "columns", pointer + "/table", true);
  }
  task.accepted = readAnswers(reader, object, "accepted", pointer, false);
  if (object.member("conditions")) task.conditions = readConditions(reader, object, "conditions", pointer);
  task.solution = reader.texts(object, "solution", pointer, false);
  reader.each(object, "mistakes", pointer, true, [&](const JsonValue& element, const std::string& place) {
    if (!reader.fault()) task.mistakes.push_back(readMistake(reader, element, place));
  });
  if (task.mistakes.empty())
    reader.fail(pointer + "/mistakes", translated("A task gives its reason for at least one wrong answer."));
  task.rule = reader.text(object, "rule", pointer);
  const bool isDecided = std::all_of(task.fields.begin(), task.fields.end(),
                                     [](const TaskField& field) { return field.is.has_value(); });
  const int keys = (isDecided ? 1 : 0) + (task.accepted.empty() ? 0 : 1) + (task.conditions.empty() ? 0 : 1);
  if (keys != 1)
    reader.fail(pointer, translated("What is right is told in one way: by \"accepted\", by \"conditions\", "
                                    "or by \"is\" of every field."));
  if (!task.conditions.empty() && task.solution.empty())
    reader.fail(pointer + "/solution", translated("Conditions need a solution that fulfils them."));
  return task;
}

ExerciseTask readExercise(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  ExerciseTask task;
  checkMembers(reader, object, pointer, {"kind", "prompt", "exercise", "seed", "about"});
  const std::string name = reader.text(object, "exercise", pointer);
  const auto kind = kindFromName(name);
  if (!kind) {
    reader.fail(
        pointer + "/exercise",
        translated("\"%1\" is no kind of exercise; `geargraph-cli exercises kinds` lists them.", {name}));
    return task;
  }
  task.kind = *kind;
  task.seed = static_cast<std::uint64_t>(
      std::max(0, reader.memberNumber(object, "seed", pointer, false).value_or(1)));
  task.about = readElement(reader, object, "about", pointer);
  return task;
}

DrawingCondition readCondition(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  DrawingCondition condition;
  checkMembers(reader, object, pointer, {"quantity", "of", "equals", "least", "most", "reason"});
  if (const auto quantity = reader.fault() ? std::nullopt : readQuantity(reader, object, pointer))
    condition.quantity = *quantity;
  if (isSetOfElements(condition.quantity.quantity))
    reader.fail(pointer + "/quantity", translated("A drawing is judged by numbers."));
  condition.least = numberText(reader, object, "least", pointer);
  condition.most = numberText(reader, object, "most", pointer);
  if (const auto equals = numberText(reader, object, "equals", pointer)) {
    if (condition.least || condition.most)
      reader.fail(pointer + "/equals", translated("Either one value is given or bounds, not both."));
    condition.least = condition.most = equals;
  }
  if (!condition.least && !condition.most)
    reader.fail(pointer, translated("A condition has \"equals\", \"least\" or \"most\"."));
  condition.reason = reader.text(object, "reason", pointer);
  return condition;
}

DrawTask readDrawTask(MemberReader& reader, const JsonValue& object, const std::string& pointer) {
  DrawTask task;
  checkMembers(reader, object, pointer, {"kind", "prompt", "conditions", "solution", "mistakes", "rule"});
  reader.each(object, "conditions", pointer, true, [&](const JsonValue& element, const std::string& place) {
    if (!reader.fault()) task.conditions.push_back(readCondition(reader, element, place));
  });
  if (task.conditions.empty())
    reader.fail(pointer + "/conditions", translated("A drawing has to fulfil something."));
  if (reader.fault()) return task;
  task.solution = readDocument(reader, object, "solution", pointer);
  reader.each(object, "mistakes", pointer, true, [&](const JsonValue& element, const std::string& place) {
    checkMembers(reader, element, place, {"drawing", "failing"});
    if (reader.fault()) return;
    WrongDrawing wrong{readDocument(reader, element, "drawing", place), 0};
    wrong.failing = reader.memberNumber(element, "failing", place).value_or(0);
    if (wrong.failing < 0 || wrong.failing >= static_cast<int>(task.conditions.size()))
      reader.fail(place + "/failing", translated("This is the position of a condition, counted from 0."));
    task.mistakes.push_back(std::move(wrong));
  });
  if (task.mistakes.empty())
    reader.fail(pointer + "/mistakes", translated("A task gives its reason for at least one wrong drawing."));
  task.rule = reader.text(object, "rule", pointer);
  return task;
}

}  // namespace

void checkMembers(MemberReader& reader, const JsonValue& object, const std::string& pointer,
                  std::initializer_list<std::string_view> known) {
  if (!object.is(JsonKind::object)) return reader.fail(pointer, translated("An object is needed here."));
  object.forEachMember([&](const JsonValue& key, const JsonValue&) {
    const std::string name = key.string();
    if (std::find(known.begin(), known.end(), name) == known.end())
      reader.fail(pointer + '/' + name, translated("The member \"%1\" is not known here.", {name}));
  });
}

LessonDocument readDocument(MemberReader& reader, const JsonValue& object, std::string_view name,
                            const std::string& pointer) {
  const auto member = object.is(JsonKind::object) ? object.member(name) : std::nullopt;
  if (!member) return {};
  if (member->is(JsonKind::string)) return {member->string(), nullptr};
  const std::string place = pointer + '/' + std::string(name);
  auto mechanism = readMechanism(member->slice());
  if (!mechanism) {
    reader.fail(place, translated("The document has a fault: %1", {mechanism.error().front().message}));
    return {};
  }
  return {"", std::make_shared<const Mechanism>(std::move(mechanism).value())};
}

std::optional<ElementId> readElement(MemberReader& reader, const JsonValue& object, std::string_view name,
                                     const std::string& pointer) {
  const std::string text = reader.text(object, name, pointer, false);
  if (text.empty()) return std::nullopt;
  const auto slash = text.find('/');
  for (const ElementKind kind :
       {ElementKind::link, ElementKind::turningJoint, ElementKind::gearMesh, ElementKind::coupling}) {
    if (slash != std::string::npos && listName(kind) == text.substr(0, slash))
      return ElementId(kind, InternedString(text.substr(slash + 1)));
  }
  reader.fail(pointer + '/' + std::string(name),
              translated("\"%1\" is no list of the document with an id.", {text}));
  return std::nullopt;
}

void readTask(MemberReader& reader, const JsonValue& step, const std::string& pointer, LessonStep& into) {
  const auto object = reader.member(step, "task", JsonKind::object, pointer);
  if (!object) return;
  const std::string place = pointer + "/task";
  const std::string kind = reader.text(*object, "kind", place);
  const auto* const answer = std::find(kAnswerKinds.begin(), kAnswerKinds.end(), kind);
  if (answer != kAnswerKinds.end()) {
    into.task =
        readAnswerTask(reader, *object, place, static_cast<AnswerKind>(answer - kAnswerKinds.begin()));
  } else if (kind == "exercise") {
    into.task = readExercise(reader, *object, place);
  } else if (kind == "draw") {
    into.task = readDrawTask(reader, *object, place);
  } else {
    reader.fail(place + "/kind",
                translated("A task is one of type, choose, pick, predict, find, exercise and draw."));
  }
  if (reader.fault()) return;
  into.prompt = reader.text(*object, "prompt", place, kind != "exercise");
}

}  // namespace geargraph
