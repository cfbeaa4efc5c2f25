#include "core/teaching/exercises/exercise_kinds.h"

#include <algorithm>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/exercises/exercise_entry.h"
#include "core/teaching/exercises/exercise_statics.h"
#include "core/teaching/exercises/link_gears.h"

namespace geargraph {
namespace {

const std::vector<ExerciseEntry>& exerciseEntries() {
  static const std::vector<ExerciseEntry> entries = [] {
    std::vector<ExerciseEntry> all;
    for (const auto entry : kExerciseEntries) {
      all.push_back(entry());
      GEARGRAPH_REQUIRE(all.back().kind == static_cast<ExerciseKind>(all.size() - 1));
    }
    return all;
  }();
  return entries;
}

const ExerciseEntry& entryOf(ExerciseKind kind) {
  return exerciseEntries().at(static_cast<std::size_t>(kind));
}

}  // namespace

const std::vector<ExerciseKind>& allExerciseKinds() {
  static const std::vector<ExerciseKind> kinds = [] {
    std::vector<ExerciseKind> all;
    for (const ExerciseEntry& entry : exerciseEntries()) all.push_back(entry.kind);
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
  const auto& entries = exerciseEntries();
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const ExerciseEntry& entry) { return entry.name == name; });
  if (found == entries.end()) return std::nullopt;
  return found->kind;
}

std::string kindHint(ExerciseKind kind) {
  return translated(entryOf(kind).hint);
}

LessonView kindView(ExerciseKind kind) {
  return entryOf(kind).view;
}

std::optional<std::string> reasonAgainst(const ExerciseSource& source, ExerciseKind kind) {
  return entryOf(kind).lack(source);
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

}  // namespace geargraph
