#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/mechanism/graph/paper_equation.h"
#include "core/mechanism/model/mechanism.h"
#include "core/teaching/exercises/exercise_kinds.h"
#include "core/teaching/grading/question.h"

namespace geargraph {

/// The results of the analysis that a task can ask for. Those with "this" in the comment need
/// AskedQuantity::of.
enum class LessonQuantity : std::uint8_t {
  links,          ///< moving ones
  turningJoints,  ///< and so on: counts
  gearMeshes,
  externalMeshes,
  internalMeshes,
  bevelMeshes,
  couplings,
  rank,
  dof,
  kutzbachDof,
  errors,          ///< diagnostics that are errors
  finding,         ///< the number of diagnostics with this code or sub-code
  blamed,          ///< the joints, meshes and links that diagnostics with this code name
  rate,            ///< of this joint with the document's inputs, rad/s
  outputRates,     ///< of all joints on the ground that are not inputs
  ratio,           ///< of this state
  torque,          ///< that holds the loads in this joint or coupling, N m
  cycle,           ///< the turning joints on the cycle of this mesh
  transferVertex,  ///< of this mesh
  groundJoints,    ///< turning joints of the ground
  axes,            ///< different lines about which joints turn
  jointsOf,        ///< turning joints of this link
  meshesOf,        ///< gear meshes of this link
  gearSizes,       ///< different numbers of teeth on this link
  unequalCentres,  ///< pairs of meshes of one gear between the same axes whose teeth give different distances
  leverPlace,      ///< of this link, on the first lever that has it, 0 to 1
};

struct AskedQuantity {
  LessonQuantity quantity = LessonQuantity::links;
  std::string of;  ///< an id, a state's name, or a code; empty where the quantity needs none
  friend bool operator==(const AskedQuantity&, const AskedQuantity&) = default;
};

/// A mechanism of a lesson: contained in the lesson, or an example.
struct LessonDocument {
  std::string example;  ///< its name; empty: `mechanism`
  MechanismPtr mechanism;
};

enum class AnswerKind : std::uint8_t {
  type,     ///< numbers are typed
  choose,   ///< one of several sentences
  pick,     ///< elements are selected in the drawing
  predict,  ///< results of the analysis are predicted
  find,     ///< the elements of a mistake in the document are selected
};

/// A field and, if the analysis determines it, the required quantity.
struct TaskField {
  AnswerField field;
  std::optional<AskedQuantity> is;
};

struct TaskMistake {
  Mistake mistake;                   ///< its conditions, fields, elements and reason
  std::vector<std::string> example;  ///< an answer with the mistake, one text per field
};

/// A question written by the lesson's author. Fields determined by the analysis need no accepted answers.
struct AnswerTask {
  AnswerKind kind = AnswerKind::type;
  std::vector<ElementKind> from;  ///< the kinds that can be picked; the options are the labels
  std::vector<TaskField> fields;
  AnswerTable table;
  std::vector<std::vector<std::string>> accepted;  ///< answers, one text per field
  std::vector<Condition> conditions;               ///< instead of `accepted`: all hold for a right answer
  std::vector<std::string> solution;               ///< one right answer, if not given by `accepted`
  std::vector<TaskMistake> mistakes;
  std::string rule;
};

/// A question generated from the step's document.
struct ExerciseTask {
  ExerciseKind kind = ExerciseKind::incidence;
  std::uint64_t seed = 1;
  std::optional<ElementId> about;  ///< seeds are incremented until the question is about this element
};

/// A ready-made question of a sheet, from practiceLesson(); never in a lesson's file.
struct QuestionTask {
  Question question;
};

/// A condition on a drawing: some value of the quantity is within the bounds.
struct DrawingCondition {
  AskedQuantity quantity;
  std::optional<std::string> least;  ///< numbers, as texts
  std::optional<std::string> most;
  std::string reason;  ///< shown if it does not hold
};

struct WrongDrawing {
  LessonDocument drawing;
  int failing = 0;  ///< position of the first condition that does not hold
};

/// The learner edits a copy of the step's document until all conditions hold.
struct DrawTask {
  std::vector<DrawingCondition> conditions;
  LessonDocument solution;
  std::vector<WrongDrawing> mistakes;
  std::string rule;
};

using LessonTask = std::variant<AnswerTask, ExerciseTask, QuestionTask, DrawTask>;

/// The drawing in front: those of questions (LessonView), in the same order, and two to be read off.
enum class StepView : std::uint8_t { digraph, ttGraph, schematic, levers, nomogram };
[[nodiscard]] constexpr StepView stepViewOf(LessonView view) {
  return static_cast<StepView>(view);
}

struct LessonStep {
  std::string title;
  std::string text;                              ///< sentences, with formulas in TeX between dollar signs
  std::string formula;                           ///< in TeX, displayed; may be empty
  PaperEquation equation = PaperEquation::none;  ///< whose number stands beside the formula
  StepView view = StepView::digraph;
  LessonDocument document;
  std::vector<ElementId> elements;  ///< highlighted when the step begins
  std::string prompt;              ///< the task in words; if empty for an exercise, the question's own prompt
  std::vector<std::string> hints;  ///< where to look, the rule, the first half of the answer
  LessonTask task;
};

/// What fresh questions about a lesson are made of.
struct PracticeTask {
  ExerciseKind kind = ExerciseKind::incidence;
  LessonDocument document;
};

/// A lesson: an immutable value. checkLesson() tests whether its tasks can be solved.
struct Lesson {
  std::string id;  ///< "cycle-basis": key of the stored progress; empty: none is stored
  std::string title;
  int minutes = 5;                 ///< duration; 0: not given
  std::string goal;                ///< what the learner can do afterwards: "fill in a row of C"
  std::vector<std::string> terms;  ///< names of the glossary
  std::vector<LessonStep> steps;
  std::vector<PracticeTask> practice;  ///< empty: as its exercise steps (practiceOf())
  bool isReview = false;               ///< begins with its fresh questions; never in a lesson's file
};

constexpr int kMaxLessonWords = 60;  ///< of a step's text
constexpr std::size_t kMaxLessonSteps = 40;

}  // namespace geargraph
