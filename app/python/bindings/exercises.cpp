// Exercise sheets from a mechanism, and the grading of answers.

#include <map>

#include "app/python/bindings/document.h"
#include "app/python/bindings/interruptible.h"
#include "core/teaching/exercises/variant_source.h"
#include "core/teaching/grading/grade.h"
#include "core/teaching/grading/question_json.h"

namespace geargraph::python {
namespace {

using Answers = std::map<int, std::map<std::string, std::string>>;

ExerciseSource sourceOf(const Mechanism& mechanism) {
  if (mechanism.n() > kMaxExerciseLinks)
    raise("limit",
          "Exercises are made of mechanisms of at most " + std::to_string(kMaxExerciseLinks) + " links.");
  return interruptible([&](const std::stop_token& /*stop*/) { return ExerciseSource(mechanism); });
}

/// By kind: its name, its title, why the mechanism does not give it or None.
py::list exerciseKinds(const Document& document) {
  const ExerciseSource source = sourceOf(document.mechanism());
  py::list rows;
  for (const ExerciseKind kind : allExerciseKinds())
    rows.append(py::make_tuple(kindName(kind), kindTitle(kind), reasonAgainst(source, kind)));
  return rows;
}

/// A sheet with its variants; immutable.
class ExerciseSheet {
 public:
  ExerciseSheet(const Document& document, const std::optional<std::vector<std::string>>& kinds,
                std::uint64_t seed, int variants, const std::string& title)
      : m_sheet{{title, {}, seed, variants}, document.mechanism()}, m_source(sourceOf(m_sheet.mechanism)) {
    if (variants < 1 || variants > kMaxVariants) throw py::value_error("A sheet has 1 to 1,000 variants.");
    if (kinds) {
      for (const std::string& name : *kinds) m_sheet.plan.kinds.push_back(kindFrom(name));
    } else {
      m_sheet.plan.kinds = offeredKinds(m_source);
    }
    if (m_sheet.plan.kinds.empty() || m_sheet.plan.kinds.size() > std::size_t{kMaxQuestions})
      throw py::value_error("A sheet has 1 to 100 questions, and this mechanism gives none or too many.");
  }
  explicit ExerciseSheet(SheetFile sheet)
      : m_sheet(std::move(sheet)), m_source(sourceOf(m_sheet.mechanism)) {}

  static ExerciseSheet read(const std::string& text) { return ExerciseSheet(valueOrRaise(readSheet(text))); }

  [[nodiscard]] std::string text() const { return sheetJson(m_sheet); }
  [[nodiscard]] std::string mark() const { return sheetMark(m_sheet); }
  [[nodiscard]] const SheetPlan& plan() const { return m_sheet.plan; }

  /// As the file of questions, with their keys or without.
  [[nodiscard]] std::string questions(int variant, bool solved) const {
    return questionsJson(questionsOf(variant), solved ? QuestionPart::withKey : QuestionPart::withoutKey);
  }

  /// By question: its kind, points and all points, the mistake's name or None, fields marked, reason.
  [[nodiscard]] py::list graded(int variant, const Answers& answers) const {
    const std::vector<Question> asked = questionsOf(variant);
    py::list rows;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const auto given = answers.find(static_cast<int>(i) + 1);
      std::vector<std::string> texts;
      for (const AnswerField& field : asked[i].fields) {
        const bool isGiven = given != answers.end() && given->second.contains(field.name);
        texts.push_back(isGiven ? given->second.at(field.name) : "");
      }
      const Verdict verdict = grade(asked[i], texts);
      py::list marked;
      for (const int field : verdict.wrongFields)
        marked.append(asked[i].fields[static_cast<std::size_t>(field)].name);
      const auto mistake = verdict.mistake ? std::optional(verdict.mistake->name) : std::nullopt;
      rows.append(py::make_tuple(asked[i].kind, verdict.points, asked[i].points, verdict.isRight, mistake,
                                 marked, verdict.reason));
    }
    return rows;
  }

  /// The sheet that answers name, their variant, their student and the answers.
  static py::tuple answersFrom(const std::string& text) {
    const AnswerSheet answers = valueOrRaise(readAnswers(text));
    return py::make_tuple(answers.sheet, answers.variant, answers.student, answers.answers);
  }

 private:
  [[nodiscard]] ExerciseKind kindFrom(const std::string& name) const {
    const auto kind = kindFromName(name);
    if (!kind) throw py::value_error("There is no kind of question \"" + name + "\".");
    if (const auto reason = reasonAgainst(m_source, *kind))
      throw py::value_error("The mechanism gives no question " + name + ": " + *reason + ".");
    return *kind;
  }
  [[nodiscard]] std::vector<Question> questionsOf(int variant) const {
    if (variant < 1 || variant > m_sheet.plan.variants)
      throw py::value_error("The sheet has no variant " + std::to_string(variant) + ".");
    return interruptible([&](const std::stop_token& /*stop*/) {
      const ExerciseSource varied = variantSource(m_source, m_sheet.plan, variant);
      return makeVariant(varied, m_sheet.plan, variant).questions;
    });
  }

  SheetFile m_sheet;
  ExerciseSource m_source;
};

}  // namespace

void addExercises(py::module_& module) {
  module.def("exercise_kinds", exerciseKinds);
  module.def("exercise_answers", &ExerciseSheet::answersFrom);
  py::class_<ExerciseSheet>(module, "ExerciseSheet")
      .def(py::init<const Document&, const std::optional<std::vector<std::string>>&, std::uint64_t, int,
                    const std::string&>())
      .def_static("read", &ExerciseSheet::read)
      .def("text", &ExerciseSheet::text)
      .def("mark", &ExerciseSheet::mark)
      .def("title", [](const ExerciseSheet& self) { return self.plan().title; })
      .def("seed", [](const ExerciseSheet& self) { return self.plan().seed; })
      .def("variants", [](const ExerciseSheet& self) { return self.plan().variants; })
      .def("questions", &ExerciseSheet::questions)
      .def("graded", &ExerciseSheet::graded);
}

}  // namespace geargraph::python
