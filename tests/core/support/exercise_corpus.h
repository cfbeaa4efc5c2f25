#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "core/design/synthesis/drive_sets.h"
#include "core/teaching/exercises/exercise_sheet.h"
#include "tests/core/support/example_files.h"
#include "tests/core/support/gearboxes.h"
#include "tests/core/support/mechanisms.h"
#include "tests/core/support/textbook_trains.h"
#include "tests/core/support/train_sketch.h"

// The questions and answers by which graders are tried: on the examples, on textbook trains and on random
// ones.

namespace geargraph::test {

using AnswerTexts = std::vector<std::string>;

/// Calls visit(question, kind, random) for `seeds` questions of every kind that the mechanism gives. `random`
/// goes on from where the question left it.
template <class Visit>
void visitQuestions(const Mechanism& mechanism, std::uint64_t seeds, const Visit& visit) {
  if (mechanism.n() > kMaxExerciseLinks) return;
  const ExerciseSource source(mechanism);
  for (const ExerciseKind kind : offeredKinds(source)) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      ExerciseRandom random(seed, static_cast<std::uint64_t>(mechanism.n()),
                            static_cast<std::uint64_t>(kind));
      visit(makeQuestion(source, kind, random), kind, random);
    }
  }
}

// Each calls visit(mechanism, seeds) for its mechanisms, with the number of seeds for each.

template <class Visit>
void visitExamples(const Visit& visit) {
  for (const std::string& name : exampleNames()) visit(example(name), 6);
}
/// Sets of couplings that no state engages make ratios of their own.
template <class Visit>
void visitGearboxesWithFewStates(const Visit& visit) {
  for (const std::size_t first : {0, 3, 6}) {
    Mechanism box = eightSpeed();
    box.states = {box.states[first], box.states[first + 1]};
    visit(box, 4);
  }
}
template <class Visit>
void visitTextbookTrains(const Visit& visit) {
  for (const TextbookTrain& train : textbookTrains()) visit(train.mechanism, 2);
}
template <class Visit>
void visitPlanetarySets(const Visit& visit) {
  for (int planets = 1; planets <= 5; ++planets) visit(planetary(20 + planets, 17, planets), 3);
}
template <class Visit>
void visitRandomTrains(const Visit& visit) {
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const int n = 2 + static_cast<int>(seed % 11);
    visit(randomTrain(seed, n, 1 + static_cast<int>(seed % static_cast<std::uint64_t>(n))), 1);
  }
}
/// Belts and pins in holes, which no example has.
template <class Visit>
void visitDrives(const Visit& visit) {
  visit(*beltStage({20, 50, Number(5), false}), 4);
  visit(*beltStage({20, 50, Number(5), true}), 4);
  visit(*cycloidalDrive(16), 4);
}
template <class Visit>
void visitRandomDigraphs(const Visit& visit) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    visit(randomTree(seed, 2 + static_cast<int>(seed % 9), 1 + static_cast<int>(seed % 4)), 1);
}

inline AnswerTexts wordsOf(const std::string& list) {
  AnswerTexts words(1);
  for (const char c : list) {
    if (c == ',') {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  return words;
}
inline std::string joined(const AnswerTexts& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// The same answer in other notations.
inline std::vector<AnswerTexts> notations(const Question& question, const AnswerTexts& answer) {
  std::vector<AnswerTexts> all(3, answer);
  for (std::size_t i = 0; i < answer.size(); ++i) {
    const AnswerField& field = question.fields[i];
    if (answer[i].empty()) continue;
    if (field.kind == FieldKind::set) {
      AnswerTexts words = wordsOf(answer[i]);
      std::reverse(words.begin(), words.end());
      all[0][i] = joined(words, "; ");
      all[1][i] = "{" + joined(words, " ") + "}";
    } else if (field.kind != FieldKind::choice) {
      const Rational value = *Rational::fromText(answer[i]);
      const bool isNegative = answer[i].front() == '-';
      all[0][i] = " " + (isNegative ? "\u2212" + answer[i].substr(1) : answer[i]) + " ";
      all[1][i] = (value * 7).toString() + "/7";
      all[2][i] = value.sign() < 0 ? "-(" + value.abs().toString() + ")" : "+" + value.toString() + "·1";
    }
  }
  return all;
}

/// Right answers of other values than the solution, and the solution.
inline std::vector<AnswerTexts> rightAnswers(const Question& question) {
  std::vector<AnswerTexts> right{question.solution};
  const Condition& first = question.accepted.front();
  if (question.accepted.size() == 1 && first.fields.empty() && first.test == Test::values)
    right = first.values;
  if (first.test == Test::multiple) {
    for (const Rational& factor : {Rational(-1), Rational(1, 12), Rational(-7, 3)}) {
      right.push_back({});
      for (const std::string& value : question.solution)
        right.back().push_back((factor * *Rational::fromText(value)).toString());
    }
  }
  if (first.test == Test::rows) {
    const auto width = static_cast<std::ptrdiff_t>(first.values.front().size());
    AnswerTexts turned = question.solution;
    std::rotate(turned.begin(), turned.begin() + width, turned.end());
    for (std::ptrdiff_t i = 0; i < width; ++i) {
      std::string& value = turned[static_cast<std::size_t>(i)];
      value = (-*Rational::fromText(value)).toString();
    }
    right.push_back(turned);
  }
  return right;
}

/// The solution with one to three fields changed; it may be the solution still.
inline AnswerTexts changedAnswer(const Question& question, ExerciseRandom& random) {
  AnswerTexts answer = question.solution;
  const int changes = random.between(1, 3);
  for (int i = 0; i < changes; ++i) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(answer.size())));
    const AnswerField& field = question.fields[at];
    answer[at] = field.options.empty() ? std::to_string(random.between(-2, 2)) : random.oneOf(field.options);
  }
  return answer;
}

}  // namespace geargraph::test
