#include "core/teaching/exercises/exercise_sheet.h"

#include <algorithm>

namespace geargraph {
namespace {

constexpr int kMaxDraws = 20;  ///< until a question differs from those before it

}  // namespace

int SheetVariant::points() const {
  int sum = 0;
  for (const Question& question : questions) sum += question.points;
  return sum;
}

std::vector<ExerciseKind> offeredKinds(const ExerciseSource& source) {
  std::vector<ExerciseKind> kinds;
  for (const ExerciseKind kind : allExerciseKinds()) {
    if (!reasonAgainst(source, kind)) kinds.push_back(kind);
  }
  return kinds;
}

SheetVariant makeVariant(const ExerciseSource& source, const SheetPlan& plan, int variant) {
  SheetVariant sheet{variant, {}};
  for (std::size_t place = 0; place < plan.kinds.size(); ++place) {
    ExerciseRandom random(plan.seed, static_cast<std::uint64_t>(variant), place);
    Question question = makeQuestion(source, plan.kinds[place], random);
    const auto isAsked = [&] {
      return std::find(sheet.questions.begin(), sheet.questions.end(), question) != sheet.questions.end();
    };
    for (int draw = 1; draw < kMaxDraws && isAsked(); ++draw)
      question = makeQuestion(source, plan.kinds[place], random);
    question.comma = plan.comma;
    sheet.questions.push_back(std::move(question));
  }
  return sheet;
}

}  // namespace geargraph
