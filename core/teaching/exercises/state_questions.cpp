// Which couplings make a gear of a gearbox.

#include <algorithm>

#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/question_builder.h"
#include "core/teaching/exercises/question_facts.h"

namespace geargraph {
namespace {

std::string couplingSet(const ExerciseSource& source, const std::vector<int>& couplings) {
  std::vector<std::string> names;
  for (const ShiftElementOrdinal coupling : couplings)
    names.push_back(source.mechanism().couplings[coupling].id.text());
  return setText(names);
}

std::vector<ElementId> couplingIds(const ExerciseSource& source, const std::vector<int>& couplings) {
  std::vector<ElementId> ids;
  for (const ShiftElementOrdinal coupling : couplings)
    ids.emplace_back(source.mechanism().couplings[coupling].id);
  return ids;
}

std::string linkOf(const ExerciseSource& source, LinkId link) {
  return source.linkLabel(source.graph().nodeOf(link));
}

/// Questions are about gears: sets with one freedom, in which nothing idles.
std::optional<Rational> ratioOf(const EngagedSet& set) {
  return set.solution.dof == 1 ? set.solution.ratio : std::nullopt;
}

}  // namespace

std::vector<int> statesWithRatio(const ExerciseSource& source) {
  std::vector<int> states;
  for (std::size_t i = 0; i < source.mechanism().states.size(); ++i) {
    const auto state = static_cast<int>(i);
    const auto place = source.setOfState(state);
    if (!place) continue;
    const EngagedSet& set = source.engagedSets(state)[*place];
    if (ratioOf(set) && !set.couplings.empty()) states.push_back(state);
  }
  return states;
}

namespace {

Question engagementQuestion(const ExerciseSource& source, ExerciseRandom& random) {
  const int asked = random.oneOf(statesWithRatio(source));
  const ShiftState& state = source.mechanism().states[static_cast<std::size_t>(asked)];
  const std::vector<EngagedSet>& sets = source.engagedSets(asked);
  const EngagedSet& right = sets[*source.setOfState(asked)];
  const Rational ratio = *right.solution.ratio;
  QuestionBuilder build(ExerciseKind::engagement, 3);
  build.question.prompt = translated(
      "Which brakes and clutches have to be engaged for state “%1”, in which link $%2$ turns at $%3$ times "
      "the speed of link $%4$?",
      {namedInPrompt(state.name), linkOf(source, *state.drive), asTex(ratio), linkOf(source, *state.driven)});
  build.question.rule = translated("With %1 engaged one degree of freedom is left and the ratio is %2.",
                                   {couplingSet(source, right.couplings), inWords(ratio)});
  std::vector<std::string> options;
  for (const ShiftElement& coupling : source.mechanism().couplings) options.push_back(coupling.id.text());
  build.field(toTranslate("engaged"), FieldKind::set, options);
  build.question.fields.front().mayBeEmpty = true;
  std::vector<std::vector<std::string>> alternatives;
  for (const EngagedSet& set : sets) {
    if (ratioOf(set) == ratio) alternatives.push_back({couplingSet(source, set.couplings)});
  }
  build.accept({couplingSet(source, right.couplings)}, alternatives);
  for (std::size_t i = 0; i < source.mechanism().states.size(); ++i) {
    const auto place = source.setOfState(static_cast<int>(i));
    const ShiftState& other = source.mechanism().states[i];
    if (static_cast<int>(i) == asked || !place) continue;
    const std::vector<int>& couplings = source.engagedSets(static_cast<int>(i))[*place].couplings;
    build.wrong("another-gear", {couplingSet(source, couplings)},
                translated("These couplings engage state “%1”, not “%2”.", {other.name, state.name}),
                couplingIds(source, couplings));
  }
  Condition locked{Test::values, {}, {}};
  Condition free{Test::values, {}, {}};
  Condition different{Test::values, {}, {}};
  for (const EngagedSet& set : sets) {
    const std::string text = couplingSet(source, set.couplings);
    if (ratioOf(set) == ratio) continue;
    if (set.solution.dof > 1) {
      free.values.push_back({text});
    } else if (!set.solution.driveTurns) {
      locked.values.push_back({text});
    } else {
      different.values.push_back({text});
    }
  }
  if (!free.values.empty())
    build.wrongIf(
        "too-free", {free},
        translated("More than one degree of freedom is left: another brake or clutch has to be engaged."));
  if (!locked.values.empty())
    build.wrongIf("drive-locked", {locked}, translated("These couplings together lock the drive."));
  if (!different.values.empty()) {
    build.wrongIf(
        "another-ratio", {different},
        translated("The drive turns with these couplings, but its ratio is not %1.", {inWords(ratio)}));
  }
  return std::move(build.question);
}

}  // namespace

ExerciseEntry engagementEntry() {
  return {.kind = ExerciseKind::engagement,
          .name = "brakes",
          .title = toTranslate("Brakes for a gear"),
          .hint = toTranslate(
              "Each engaged element takes degrees of freedom away until one is left. An engaged brake "
              "makes the speed of its link zero: try which set gives the ratio."),
          .view = LessonView::schematic,
          .lack = withoutStates,
          .make = engagementQuestion};
}

}  // namespace geargraph
