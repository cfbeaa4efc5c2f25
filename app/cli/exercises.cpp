// `exercises kinds|make|grade`: exercise sheets for a class, and their grading.

#include <algorithm>
#include <array>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/exercise_forms.h"
#include "app/cli/load.h"
#include "core/foundations/base/translation.h"
#include "core/presentation/exporters/exercise_plan.h"
#include "core/teaching/exercises/exercise_sheet.h"

namespace geargraph::cli {
namespace {

struct Action {
  std::string_view name;
  std::span<const std::string_view> options;
  int (*run)(const Arguments&);
};

constexpr std::array<std::string_view, 8> kMakeOptions = {"--kinds", "--seed", "--variants", "--names",
                                                          "--title", "--to",   "--force",    "-o"};
constexpr std::array<std::string_view, 2> kGradeOptions = {"--summary", "-o"};
constexpr std::array kActions = {Action{"kinds", {}, listExerciseKinds},
                                 Action{"make", kMakeOptions, makeExercises},
                                 Action{"grade", kGradeOptions, gradeExercises}};

int runExercises(const Arguments& arguments) {
  const auto action = std::find_if(kActions.begin(), kActions.end(), [&](const Action& a) {
    return !arguments.files.empty() && arguments.files.front() == a.name;
  });
  if (action == kActions.end())
    return wrongUsage(kExercises, translated("The first word is kinds, make or grade."));
  for (const auto& [option, values] : arguments.options) {
    const bool isKnown =
        option == "--limit-seconds" ||
        std::find(action->options.begin(), action->options.end(), option) != action->options.end();
    if (!isKnown)
      return wrongUsage(kExercises,
                        translated("%1 has no meaning for exercises %2.", {option, action->name}));
  }
  Arguments rest = arguments;
  rest.files.erase(rest.files.begin());
  return action->run(rest);
}

constexpr std::array kExercisesOptions = {
    Option{"--kinds", "LIST", toTranslate("kinds of questions, with commas; a kind may occur again (all)"),
           "make"},
    Option{"--seed", "N", toTranslate("the same number makes the same sheets everywhere (random)"), "make"},
    Option{"--variants", "N", toTranslate("how many different sheets, at most 1,000 (1)"), "make"},
    Option{"--names", "FILE", toTranslate("a variant for each line of this text file"), "make"},
    Option{"--title", "TEXT", toTranslate("the heading of the sheets (\"Exercises\")"), "make"},
    Option{"--to", "LIST", toTranslate("forms: html,latex,pdf,json,handout,scorm (html,latex,pdf)"), "make"},
    Option{"--force", "", toTranslate("overwrites files in the folder"), "make"},
    Option{"--summary", "OUT",
           toTranslate("which mistake, how often, by whom: a .csv or a page with bars (.html)"), "grade"},
    Option{"-o", "OUT", toTranslate("make: the folder; grade: the CSV file (standard output)")},
};

}  // namespace

const Command kExercises = {
    "exercises",
    "kinds FILE | make FILE [--seed N] ... -o FOLDER | grade SHEET ANSWERS... [-o CSV]",
    toTranslate("Makes exercise sheets from a mechanism and grades the answers."),
    kExercisesOptions,
    runExercises,
    false,
    false};

int listExerciseKinds(const Arguments& arguments) {
  if (arguments.files.size() != 1) return wrongUsage(kExercises, translated("One file is needed."));
  const auto mechanism = loadOrSay(arguments.files.front(), kExercises);
  if (const int* status = std::get_if<int>(&mechanism)) return *status;
  if (std::get<Mechanism>(mechanism).n() > kMaxExerciseLinks) return tooLargeForExercises();
  const ExerciseSource source(std::get<Mechanism>(mechanism));
  std::string text = difficultyOf(source).text + '\n';
  for (const ExerciseKind kind : allExerciseKinds()) {
    std::string line = "  " + std::string(kindName(kind));
    line.resize(std::max<std::size_t>(line.size() + 1, 22), ' ');
    text += line + std::string(kindTitle(kind));
    if (const auto reason = reasonAgainst(source, kind))
      text += ' ' + translated("(not offered: %1)", {*reason});
    text += '\n';
  }
  return print(text);
}

int tooLargeForExercises() {
  std::cerr << "geargraph-cli: " << exercisesTooLarge() << '\n';
  return kResourceLimit;
}

}  // namespace geargraph::cli
