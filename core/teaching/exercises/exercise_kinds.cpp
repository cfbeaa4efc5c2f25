#include "core/teaching/exercises/exercise_kinds.h"

#include <algorithm>
#include <array>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/words.h"
#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/link_gears.h"
#include "core/teaching/exercises/question_makers.h"

namespace geargraph::inline exercises {
namespace {

constexpr int kMaxTreeEdges = 24;
constexpr int kMaxAnyCycles = 3;
constexpr int kMaxAnyEdges = 14;

/// What a kind needs, each the reason where it is missing.
using Reason = std::optional<std::string>;

Reason withoutEdges(const ExerciseSource& source) {
  if (source.graph().edgeCount() == 0) return translated("no joints");
  return std::nullopt;
}
Reason withoutTree(const ExerciseSource& source) {
  if (source.tree() == nullptr) return translated("the turning joints are no spanning tree");
  if (source.graph().t() == 0) return translated("no joints");
  return std::nullopt;
}
Reason withoutMeshes(const ExerciseSource& source) {
  if (const Reason reason = withoutTree(source)) return reason;
  if (source.graph().c() == 0) return translated("no meshes");
  return std::nullopt;
}
Reason withoutEquations(const ExerciseSource& source) {
  if (const Reason reason = withoutMeshes(source)) return reason;
  if (source.ttGraph() == nullptr || source.matroid() == nullptr) return translated("a mesh has no geometry");
  return std::nullopt;
}
Reason withoutOneCycle(const ExerciseSource& source) {
  if (const Reason reason = withoutMeshes(source)) return reason;
  const bool isSmall = source.graph().c() <= kMaxAnyCycles && source.graph().edgeCount() <= kMaxAnyEdges;
  return isSmall ? Reason() : translated("too many cycles");
}
Reason withoutSmallGraph(const ExerciseSource& source) {
  if (const Reason reason = withoutMeshes(source)) return reason;
  return source.graph().edgeCount() <= kMaxTreeEdges ? Reason() : translated("too many edges");
}
Reason withoutSearchable(const ExerciseSource& source) {
  if (const Reason reason = withoutEdges(source)) return reason;
  return searchableMatrices(source).empty() ? Reason(translated("the matrices are too large or too small"))
                                            : std::nullopt;
}
Reason withoutRedundancy(const ExerciseSource& source) {
  if (const Reason reason = withoutEquations(source)) return reason;
  return source.matroid()->redundancies.empty() ? Reason(translated("no mesh is redundant")) : std::nullopt;
}
Reason withoutFreedom(const ExerciseSource& source) {
  if (const Reason reason = withoutEquations(source)) return reason;
  return source.matroid()->dof == 0 ? Reason(translated("nothing can move")) : std::nullopt;
}
Reason withoutPredictable(const ExerciseSource& source) {
  if (const Reason reason = withoutFreedom(source)) return reason;
  constexpr int kMaxInputs = 6;
  if (source.matroid()->dof > kMaxInputs) return translated("too many inputs");
  return predictableJoints(source).empty() ? Reason(translated("no speed follows from the inputs"))
                                           : std::nullopt;
}
Reason withoutPlanets(const ExerciseSource& source) {
  if (const Reason reason = withoutEquations(source)) return reason;
  return planetPairs(source).empty() ? Reason(translated("no planet between a sun and a ring"))
                                     : std::nullopt;
}
Reason withoutStates(const ExerciseSource& source) {
  if (const Reason reason = withoutEquations(source)) return reason;
  if (source.mechanism().couplings.empty()) return translated("no brakes or clutches");
  return statesWithRatio(source).empty() ? Reason(translated("no states with a ratio")) : std::nullopt;
}
Reason withoutBrakeTorques(const ExerciseSource& source) {
  if (const Reason reason = withoutStates(source)) return reason;
  return hasBrakeComparison(source) ? Reason()
                                    : translated("no two torques of brakes or clutches to compare");
}
Reason withoutReactions(const ExerciseSource& source) {
  if (const Reason reason = withoutStates(source)) return reason;
  return hasBrakeReaction(source) ? Reason()
                                  : translated("no brake that carries a torque about the drive's axis");
}
Reason withoutLosses(const ExerciseSource& source) {
  if (const Reason reason = withoutFreedom(source)) return reason;
  return drivenTrains(source).empty() ? Reason(translated("no drive passes power through 1 to 6 meshes"))
                                      : std::nullopt;
}

struct KindEntry {
  ExerciseKind kind;
  std::string_view name;
  std::string_view title;
  Reason (*reason)(const ExerciseSource&);
  Question (*make)(const ExerciseSource&, ExerciseRandom&);
};

constexpr std::array kKinds = {
    KindEntry{ExerciseKind::incidence, "incidence", toTranslate("Fill in Γ⁰"), withoutEdges,
              incidenceQuestion},
    KindEntry{ExerciseKind::orientation, "orientation", toTranslate("Orient the digraph"), withoutEdges,
              orientationQuestion},
    KindEntry{ExerciseKind::reducedIncidence, "reduced-incidence", toTranslate("Fill in Γ"), withoutEdges,
              reducedIncidenceQuestion},
    KindEntry{ExerciseKind::path, "path", toTranslate("Fill in Z"), withoutTree, pathQuestion},
    KindEntry{ExerciseKind::treeMatrix, "tree-matrix", toTranslate("Fill in T"), withoutMeshes,
              treeMatrixQuestion},
    KindEntry{ExerciseKind::cycle, "cycle", toTranslate("Find the cycle of a mesh"), withoutMeshes,
              cycleQuestion},
    KindEntry{ExerciseKind::cycleSense, "cycle-sense", toTranslate("Walk a cycle in either sense"),
              withoutMeshes, cycleSenseQuestion},
    KindEntry{ExerciseKind::cycleBasis, "cycle-basis", toTranslate("Fill in a row of C"), withoutMeshes,
              cycleBasisQuestion},
    KindEntry{ExerciseKind::anyCycles, "any-cycles", toTranslate("Write all cycles"), withoutOneCycle,
              anyCyclesQuestion},
    KindEntry{ExerciseKind::spanningTree, "spanning-tree", toTranslate("Choose a spanning tree"),
              withoutSmallGraph, spanningTreeQuestion},
    KindEntry{ExerciseKind::wrongEntry, "wrong-entry", toTranslate("Find the wrong entry"), withoutSearchable,
              wrongEntryQuestion},
    KindEntry{ExerciseKind::coefficients, "p", toTranslate("Fill in a row of P"), withoutEquations,
              coefficientQuestion},
    KindEntry{ExerciseKind::freedom, "freedom", toTranslate("Rank and DOF"), withoutEquations,
              freedomQuestion},
    KindEntry{ExerciseKind::redundantMesh, "redundant-mesh", toTranslate("Redundant mesh"), withoutRedundancy,
              redundantMeshQuestion},
    KindEntry{ExerciseKind::inputs, "inputs", toTranslate("Valid inputs"), withoutFreedom, inputsQuestion},
    KindEntry{ExerciseKind::speed, "speed", toTranslate("Predict a speed"), withoutPredictable,
              speedQuestion},
    KindEntry{ExerciseKind::levels, "levels", toTranslate("Levels and transfer vertex"), withoutEquations,
              levelsQuestion},
    KindEntry{ExerciseKind::terminalEquation, "terminal", toTranslate("Terminal equation, sign"),
              withoutEquations, terminalEquationQuestion},
    KindEntry{ExerciseKind::fundamentalCircuit, "f-circuit", toTranslate("f-circuit equation"),
              withoutEquations, fundamentalCircuitQuestion},
    KindEntry{ExerciseKind::cutset, "cutset", toTranslate("Fill in a row of Q"), withoutMeshes,
              cutsetQuestion},
    KindEntry{ExerciseKind::portTorque, "port-torque", toTranslate("Torque of a port, sign"),
              withoutEquations, portTorqueQuestion},
    KindEntry{ExerciseKind::teeth, "teeth", toTranslate("Teeth for a ratio"), withoutEquations,
              teethQuestion},
    KindEntry{ExerciseKind::ringTeeth, "ring-teeth", toTranslate("Teeth of the ring"), withoutPlanets,
              ringTeethQuestion},
    KindEntry{ExerciseKind::engagement, "brakes", toTranslate("Brakes for a gear"), withoutStates,
              engagementQuestion},
    KindEntry{ExerciseKind::brakeTorque, "brake-torque", toTranslate("Largest torque of a brake"),
              withoutBrakeTorques, brakeTorqueQuestion},
    KindEntry{ExerciseKind::selfLocking, "self-locking", toTranslate("Self-locking"), withoutLosses,
              selfLockingQuestion},
    KindEntry{ExerciseKind::brakeReaction, "brake-reaction", toTranslate("Reaction of a brake, sense"),
              withoutReactions, brakeReactionQuestion},
};

const KindEntry& entryOf(ExerciseKind kind) {
  const KindEntry& entry = kKinds[static_cast<std::size_t>(kind)];
  GEARGRAPH_REQUIRE(entry.kind == kind);
  return entry;
}

}  // namespace

const std::vector<ExerciseKind>& allExerciseKinds() {
  static const std::vector<ExerciseKind> kinds = [] {
    std::vector<ExerciseKind> all;
    for (const KindEntry& entry : kKinds) all.push_back(entry.kind);
    return all;
  }();
  return kinds;
}

std::string_view kindName(ExerciseKind kind) {
  return entryOf(kind).name;
}

std::string kindTitle(ExerciseKind kind) {
  return translated(entryOf(kind).title);
}

std::optional<ExerciseKind> kindFromName(std::string_view name) {
  const auto found =
      std::find_if(kKinds.begin(), kKinds.end(), [&](const KindEntry& e) { return e.name == name; });
  if (found == kKinds.end()) return std::nullopt;
  return found->kind;
}

std::optional<std::string> reasonAgainst(const ExerciseSource& source, ExerciseKind kind) {
  return entryOf(kind).reason(source);
}

Question makeQuestion(const ExerciseSource& source, ExerciseKind kind, ExerciseRandom& random) {
  GEARGRAPH_REQUIRE(!reasonAgainst(source, kind));
  Question question = entryOf(kind).make(source, random);
  question.comma = commaUse();
  const auto isNumber = [](const AnswerField& field) { return field.kind == FieldKind::number; };
  if (std::any_of(question.fields.begin(), question.fields.end(), isNumber))
    question.symbols = numberSymbols(source);
  return question;
}

}  // namespace geargraph::inline exercises
