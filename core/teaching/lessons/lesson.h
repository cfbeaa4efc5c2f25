#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/mechanism/model/mechanism.h"
#include "core/teaching/exercises/exercise_kinds.h"
#include "core/teaching/grading/question.h"

namespace geargraph::inline lessons {

/// What the analysis tells about a mechanism and a task asks for. Those with a name in the comment need it.
enum class Quantity : std::uint8_t {
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
  errors,          ///< findings that are errors
  finding,         ///< how many findings there are with this code or sub-code
  blamed,          ///< the joints, meshes and links that the findings with this code name
  rate,            ///< of this joint with the document's inputs, rad/s
  outputRates,     ///< of all joints on the ground that are not driven
  ratio,           ///< of this state
  torque,          ///< that holds the loads in this joint or coupling, N m
  cycle,           ///< the turning joints on the cycle of this mesh
  transferVertex,  ///< of this mesh
};

struct AskedQuantity {
  Quantity quantity = Quantity::links;
  std::string of;  ///< an id, a state's name, or a code; empty where the quantity needs none
  friend bool operator==(const AskedQuantity&, const AskedQuantity&) = default;
};

/// A mechanism of a lesson: one that it holds, or an example's.
struct LessonDocument {
  std::string example;  ///< its name; empty: `mechanism`
  MechanismPtr mechanism;
};

enum class AnswerKind : std::uint8_t {
  type,     ///< numbers are written
  choose,   ///< one of some sentences
  pick,     ///< elements are selected in the drawing
  predict,  ///< numbers that the analysis gives are foretold
  find,     ///< the elements of a mistake in the document are selected
};

/// A field and, where the analysis decides, what it has to hold.
struct TaskField {
  AnswerField field;
  std::optional<AskedQuantity> is;
};

struct TaskMistake {
  Mistake mistake;                   ///< its conditions, fields, elements and reason
  std::vector<std::string> example;  ///< an answer in which it is made, one text a field
};

/// A question that the lesson's author wrote. Fields of which the analysis decides need no accepted answers.
struct AnswerTask {
  AnswerKind kind = AnswerKind::type;
  std::vector<ElementKind> from;  ///< what can be picked; the options are the labels
  std::vector<TaskField> fields;
  AnswerTable table;
  std::vector<std::vector<std::string>> accepted;  ///< answers, one text a field each
  std::vector<Condition> conditions;               ///< instead of them: all hold of a right answer
  std::vector<std::string> solution;               ///< one right answer; where `accepted` does not give it
  std::vector<TaskMistake> mistakes;
  std::string rule;
};

/// A question that the generator of exercises makes of the step's document.
struct ExerciseTask {
  ExerciseKind kind = ExerciseKind::incidence;
  std::uint64_t seed = 1;
  std::optional<ElementId> about;  ///< seeds are counted up until the question is about this element
};

/// A question that was made before, of a sheet: what practiceLesson() makes. No file of a lesson holds one.
struct QuestionTask {
  Question question;
};

/// What a drawing has to fulfil: some value of the quantity lies between the bounds.
struct DrawingCondition {
  AskedQuantity quantity;
  std::optional<std::string> least;  ///< numbers, as texts
  std::optional<std::string> most;
  std::string reason;  ///< told where it does not hold
};

struct WrongDrawing {
  LessonDocument drawing;
  int failing = 0;  ///< position of the first condition that does not hold of it
};

/// The learner edits a copy of the step's document until all conditions hold, in any way.
struct DrawTask {
  std::vector<DrawingCondition> conditions;
  LessonDocument solution;
  std::vector<WrongDrawing> mistakes;
  std::string rule;
};

using LessonTask = std::variant<AnswerTask, ExerciseTask, QuestionTask, DrawTask>;

/// The drawing in front while a step is worked on.
enum class LessonView : std::uint8_t { digraph, ttGraph, schematic };

struct LessonStep {
  std::string title;
  std::string text;      ///< sentences, with formulas in TeX between dollar signs
  std::string formula;   ///< in TeX, on a line of its own; may be empty
  std::string equation;  ///< its number, "5"; may be empty
  LessonView view = LessonView::digraph;
  LessonDocument document;
  std::vector<ElementId> elements;  ///< lit up when the step begins
  std::string prompt;               ///< the task in words; of an exercise it may be empty: the question's own
  std::vector<std::string> hints;   ///< where to look, the rule, the first half of the answer
  LessonTask task;
};

/// A lesson as its author wrote it: an immutable value. Whether its tasks can be solved is checkLesson()'s.
struct Lesson {
  std::string id;  ///< "cycle-basis": progress is kept under it; empty: it is not kept
  std::string title;
  int minutes = 5;                 ///< that it takes; 0: not said
  std::string goal;                ///< what the learner can do afterwards: "fill in a row of C"
  std::vector<std::string> terms;  ///< names of the glossary
  std::vector<LessonStep> steps;
};

constexpr int kMostLessonWords = 60;  ///< of a step's text
constexpr std::size_t kMostLessonSteps = 40;

}  // namespace geargraph::inline lessons
