#include "core/teaching/lessons/prepared_step.h"

#include <algorithm>

#include "core/foundations/base/rational.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/grading/question_reader.h"
#include "core/teaching/grading/read_answer.h"
#include "core/teaching/lessons/quantities.h"

namespace geargraph {
namespace {

constexpr std::uint64_t kMaxSeeds = 500;  ///< that are tried for a question about an element

Diagnostic taskFault(const std::string& pointer, const std::string& message) {
  return {Code::schema, message, {}, pointer};
}

/// Diagnostics of a quantity at the place that asks for it.
Diagnostics atPointer(Diagnostics diagnostics, const std::string& pointer) {
  for (Diagnostic& diagnostic : diagnostics) diagnostic.pointer = pointer;
  return diagnostics;
}

std::vector<std::string> labelsOf(const Mechanism& mechanism, const std::vector<ElementKind>& kinds) {
  std::vector<std::string> labels;
  const auto add = [&](ElementKind kind, int count, auto labelAt) {
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) return;
    for (int i = 0; i < count; ++i) labels.push_back(std::to_string(labelAt(i)));
  };
  add(ElementKind::link, mechanism.n() + 1, [&](int i) { return mechanism.linkLabel(i); });
  add(ElementKind::turningJoint, mechanism.t(), [&](int i) { return mechanism.jointLabel(i); });
  add(ElementKind::gearMesh, mechanism.c(), [&](int i) { return mechanism.meshLabel(i); });
  return labels;
}

/// Makes the question of a task that an author wrote.
class QuestionMaker {
 public:
  QuestionMaker(const LessonStep& step, const AnswerTask& task, const MechanismPtr& mechanism,
                std::string pointer, const std::stop_token& stop)
      : m_step(step), m_task(task), m_analysis(mechanism, stop), m_pointer(std::move(pointer)) {}

  Expected<Question> make() {
    Question question;
    question.kind = "lesson";
    question.prompt = m_step.prompt;
    question.elements = m_step.elements;
    question.table = m_task.table;
    question.rule = m_task.rule;
    for (const TaskField& field : m_task.fields) question.fields.push_back(field.field);
    if (!m_task.from.empty()) question.fields.front().options = labelsOf(m_analysis.mechanism(), m_task.from);
    if (const auto faults = addKey(question)) return *faults;
    for (std::size_t i = 0; i < m_task.mistakes.size(); ++i) {
      Mistake mistake = m_task.mistakes[i].mistake;
      const std::string place = m_pointer + "/mistakes/" + std::to_string(i);
      if (const auto fault = normalise(question, mistake.when, place)) return *fault;
      question.mistakes.push_back(std::move(mistake));
    }
    if (const auto part = unsoundPart(question))
      return taskFault(m_pointer + '/' + *part, translated("This part does not fit the fields of its task."));
    return question;
  }

 private:
  std::optional<Diagnostics> addKey(Question& question) {
    if (!m_task.conditions.empty()) {
      question.accepted = m_task.conditions;
      question.solution = m_task.solution;
    } else if (!m_task.accepted.empty()) {
      question.accepted = {{Test::values, {}, m_task.accepted}};
      question.solution = m_task.accepted.front();
    } else {
      std::vector<std::string> values;
      for (std::size_t i = 0; i < m_task.fields.size(); ++i) {
        auto value = decided(question.fields[i], *m_task.fields[i].is);
        if (!value) {
          const bool hasFields = m_task.kind == AnswerKind::type || m_task.kind == AnswerKind::predict;
          const std::string field = hasFields ? "/fields/" + std::to_string(i) : "";
          return atPointer(value.error(), m_pointer + field + "/is");
        }
        values.push_back(std::move(value).value());
      }
      question.accepted = {{Test::values, {}, {values}}};
      question.solution = std::move(values);
    }
    if (question.solution.size() != question.fields.size())
      return Diagnostics{
          taskFault(m_pointer + "/accepted", translated("An answer has a text for each field."))};
    for (std::size_t i = 0; i < question.fields.size(); ++i)
      question.solution[i] = written(question.fields[i], question.solution[i]);
    if (const auto fault = normalise(question, question.accepted, m_pointer + "/accepted"))
      return Diagnostics{*fault};
    return std::nullopt;
  }

  /// What the analysis says, as a text of this field.
  Expected<std::string> decided(const AnswerField& field, const AskedQuantity& asked) {
    const auto values = m_analysis.valuesOf(asked);
    if (!values) return values.error();
    if (isSetOfElements(asked.quantity)) {
      std::vector<std::string> labels;
      for (const ElementId& element : values->elements)
        labels.push_back(labelOf(m_analysis.mechanism(), element).value_or(element.id.text()));
      const bool fits =
          field.kind == FieldKind::set || (field.kind == FieldKind::choice && labels.size() == 1);
      if (!fits || labels.empty())
        return taskFault({}, translated("What the analysis gives here is no answer to this field."));
      return setText(labels);
    }
    const bool isNumber = field.kind == FieldKind::integer || field.kind == FieldKind::number;
    if (!isNumber || values->numbers.size() != 1)
      return taskFault({}, translated("What the analysis gives here is no answer to this field."));
    return values->numbers.front().toString();
  }

  /// A text of a condition in the spelling that it is compared with: sets in the order of their options.
  static std::string written(const AnswerField& field, const std::string& text) {
    if (field.kind != FieldKind::set) return text;
    const ReadField read = readField(field, text);
    return read.fault == AnswerFault::none ? setText(read.elements) : text;
  }

  /// Values that the field can never read would be conditions that never hold: faults of the author.
  std::optional<Diagnostic> normalise(const Question& question, std::vector<Condition>& conditions,
                                      const std::string& place) {
    for (Condition& condition : conditions) {
      if (condition.test != Test::values && condition.test != Test::differs) continue;
      const std::size_t fields = condition.fields.empty() ? question.fields.size() : condition.fields.size();
      for (std::vector<std::string>& row : condition.values) {
        if (row.size() != fields)
          return taskFault(place, translated("An answer has a text for each field: %1, not %2.",
                                             {std::to_string(fields), std::to_string(row.size())}));
        for (std::size_t i = 0; i < row.size(); ++i) {
          const std::size_t position =
              condition.fields.empty() ? i : static_cast<std::size_t>(std::max(0, condition.fields[i]));
          if (position >= question.fields.size())
            return taskFault(place, translated("There is no such field."));
          const AnswerField& field = question.fields[position];
          if (readField(field, row[i]).fault != AnswerFault::none)
            return taskFault(place, translated("The field \"%1\" cannot hold \"%2\".", {field.name, row[i]}));
          row[i] = written(field, row[i]);
        }
      }
    }
    return std::nullopt;
  }

  const LessonStep& m_step;
  const AnswerTask& m_task;
  LessonAnalysis m_analysis;
  std::string m_pointer;
};

Expected<Question> exerciseQuestion(const LessonStep& step, const ExerciseTask& task,
                                    const Mechanism& mechanism, const std::string& pointer) {
  if (mechanism.n() > kMaxExerciseLinks)
    return taskFault(pointer, translated("Exercises are made of mechanisms of at most %1 moving links.",
                                         {std::to_string(kMaxExerciseLinks)}));
  const ExerciseSource source(mechanism);
  if (const auto reason = reasonAgainst(source, task.kind))
    return taskFault(pointer + "/exercise",
                     translated("The document gives no exercise of this kind: %1.", {*reason}));
  for (std::uint64_t seed = task.seed; seed < task.seed + kMaxSeeds; ++seed) {
    ExerciseRandom random(seed);
    Question question = makeQuestion(source, task.kind, random);
    const auto& elements = question.elements;
    if (task.about && std::find(elements.begin(), elements.end(), *task.about) == elements.end()) continue;
    if (!step.prompt.empty()) question.prompt = step.prompt;
    return question;
  }
  return taskFault(pointer + "/about", translated("No exercise of this kind is about this element."));
}

bool isBetween(const Rational& value, const DrawingCondition& condition) {
  return (!condition.least || value >= *Rational::fromText(*condition.least)) &&
         (!condition.most || value <= *Rational::fromText(*condition.most));
}

}  // namespace

Expected<MechanismPtr> mechanismOf(const LessonDocument& document, const ExampleSource& examples,
                                   const std::string& pointer) {
  if (document.example.empty()) {
    if (!document.mechanism) return taskFault(pointer, translated("A mechanism is missing here."));
    return document.mechanism;
  }
  auto example = examples(document.example);
  if (!example) return atPointer(example.error(), pointer);
  return example;
}

Expected<PreparedStep> prepareStep(const Lesson& lesson, std::size_t step, const ExampleSource& examples,
                                   const std::stop_token& stop) {
  const LessonStep& written = lesson.steps[step];
  const std::string pointer = "/steps/" + std::to_string(step);
  auto mechanism = mechanismOf(written.document, examples, pointer);
  if (!mechanism) return mechanism.error();
  PreparedStep prepared{*mechanism, std::nullopt};
  for (std::size_t i = 0; i < written.elements.size(); ++i) {
    const ElementId& element = written.elements[i];
    if (labelOf(**mechanism, element) || element.kind == ElementKind::coupling) continue;
    return Diagnostic{Code::unknownId,
                      translated("The document has no such element."),
                      {},
                      pointer + "/elements/" + std::to_string(i)};
  }
  if (std::holds_alternative<DrawTask>(written.task)) return prepared;
  if (const auto* made = std::get_if<QuestionTask>(&written.task)) {
    prepared.question = made->question;
    return prepared;
  }
  const std::string place = pointer + "/task";
  auto question =
      std::holds_alternative<ExerciseTask>(written.task)
          ? exerciseQuestion(written, std::get<ExerciseTask>(written.task), **mechanism, place)
          : QuestionMaker(written, std::get<AnswerTask>(written.task), *mechanism, place, stop).make();
  if (!question) return question.error();
  prepared.question = std::move(question).value();
  return prepared;
}

DrawingVerdict checkDrawing(const DrawTask& task, const MechanismPtr& drawing, const std::stop_token& stop) {
  LessonAnalysis analysis(drawing, stop);
  DrawingVerdict result;
  for (std::size_t i = 0; i < task.conditions.size(); ++i) {
    const DrawingCondition& condition = task.conditions[i];
    const auto values = analysis.valuesOf(condition.quantity);
    const bool holds =
        values && std::any_of(values->numbers.begin(), values->numbers.end(),
                              [&](const Rational& value) { return isBetween(value, condition); });
    if (holds) continue;
    result.failing = static_cast<int>(i);
    FoundMistake mistake{"", {}, {}, condition.reason};
    if (condition.quantity.quantity == LessonQuantity::errors) {
      for (const Diagnostic& diagnostic : analysis.diagnostics()) {
        if (diagnostic.severity() != Severity::error) continue;
        mistake.reason += ' ' + diagnostic.message;
        mistake.elements = diagnostic.elements;
        break;
      }
    }
    result.verdict.reason = mistake.reason;
    result.verdict.mistake = std::move(mistake);
    return result;
  }
  result.verdict.isRight = true;
  result.verdict.reason = task.rule;
  return result;
}

std::string_view taskTitle(const LessonStep& step) {
  if (std::holds_alternative<DrawTask>(step.task)) return toTranslate("Draw");
  const auto* answer = std::get_if<AnswerTask>(&step.task);
  if (answer == nullptr) return toTranslate("Your task");
  switch (answer->kind) {
    case AnswerKind::type:
      return toTranslate("Work out");
    case AnswerKind::choose:
      return toTranslate("Choose");
    case AnswerKind::pick:
      return toTranslate("Pick in the drawing");
    case AnswerKind::predict:
      return toTranslate("Predict");
    case AnswerKind::find:
      return toTranslate("Find the mistake");
  }
  return toTranslate("Your task");
}

std::optional<ElementId> elementLabelled(const Mechanism& mechanism, const std::string& label) {
  const auto match = [&](const auto& list) -> std::optional<ElementId> {
    for (const auto& element : list) {
      if (labelOf(mechanism, element.id) == label) return ElementId(element.id);
    }
    return std::nullopt;
  };
  for (const auto& found :
       {match(mechanism.links), match(mechanism.turningJoints), match(mechanism.gearMeshes)}) {
    if (found) return found;
  }
  for (const ShiftElement& coupling : mechanism.couplings) {
    if (coupling.id.text() == label) return ElementId(coupling.id);
  }
  return std::nullopt;
}

}  // namespace geargraph
