#include "core/presentation/exporters/exercise_plan.h"

#include <algorithm>

#include "core/foundations/base/translation.h"

namespace geargraph {

std::vector<std::string> wordsOf(const std::string& list, char separator) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin <= list.size()) {
    const std::size_t end = std::min(list.find(separator, begin), list.size());
    std::string word = list.substr(begin, end - begin);
    while (!word.empty() && (word.back() == '\r' || word.back() == ' ')) word.pop_back();
    if (!word.empty()) words.push_back(std::move(word));
    begin = end + 1;
  }
  return words;
}

std::variant<std::vector<ExerciseKind>, UsageError> kindsFrom(const OptionValues& given,
                                                              const ExerciseSource& source) {
  const auto list = given.value("--kinds");
  if (!list) return offeredKinds(source);
  std::vector<ExerciseKind> kinds;
  for (const std::string& name : wordsOf(*list, ',')) {
    const auto kind = kindFromName(name);
    if (!kind)
      return UsageError{
          translated("There is no kind of question \"%1\"; geargraph-cli exercises kinds FILE lists "
                     "them.",
                     {name})};
    if (const auto reason = reasonAgainst(source, *kind))
      return UsageError{translated("The mechanism gives no question \"%1\": %2.", {name, *reason})};
    kinds.push_back(*kind);
  }
  if (kinds.empty() || static_cast<int>(kinds.size()) > kMaxQuestions)
    return UsageError{translated("--kinds names 1 to 100 questions.")};
  return kinds;
}

std::variant<SheetPlan, UsageError> planFrom(const OptionValues& given) {
  SheetPlan plan;
  plan.title = given.value("--title").value_or(translated("Exercises"));
  if (const auto word = given.value("--seed")) {
    const auto seed = numberFrom<std::uint64_t>(*word);
    if (!seed) return UsageError{translated("--seed is a whole number from 0 on.")};
    plan.seed = *seed;
  } else {
    plan.seed = randomSeed();
  }
  if (const auto word = given.value("--variants")) {
    const auto variants = numberFrom<int>(*word);
    if (!variants || *variants < 1 || *variants > kMaxVariants)
      return UsageError{translated("--variants is a whole number from 1 to 1000.")};
    plan.variants = *variants;
  }
  return plan;
}

std::string exercisesTooLarge() {
  return translated("Exercises are made of mechanisms of at most %1 moving links.",
                    {std::to_string(kMaxExerciseLinks)});
}

}  // namespace geargraph
