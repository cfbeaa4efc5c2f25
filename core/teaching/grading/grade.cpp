#include "core/teaching/grading/grade.h"

#include <algorithm>

#include "core/foundations/base/words.h"
#include "core/teaching/grading/conditions.h"

namespace geargraph::inline grading {
namespace {

constexpr std::size_t kFewestForHalf = 4;

/// The mistake of a field that cannot be read.
FoundMistake unreadable(const AnswerField& field, int position, const std::string& text, AnswerFault fault) {
  FoundMistake found{{}, {position}, field.elements, {}};
  switch (fault) {
    case AnswerFault::none:
    case AnswerFault::empty:
      found.name = "unanswered";
      found.reason = translated("The field %1 is empty.", {field.shownName()});
      break;
    case AnswerFault::ambiguousNumber:
      found.name = "ambiguous-number";
      found.reason = translated(
          "“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.",
          {text});
      break;
    case AnswerFault::notANumber:
      found.name = "not-a-number";
      found.reason = translated(
          "“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.", {text});
      break;
    case AnswerFault::notAChoice:
      found.name = "not-a-choice";
      found.reason =
          translated("“%1” is not among what the question offers for %2.", {text, field.shownName()});
      break;
  }
  return found;
}

/// The fields that differ from the only accepted values; none where several answers are right.
std::vector<int> differingFields(const Question& question, const ReadAnswer& answer) {
  const bool hasOneAnswer = question.accepted.size() == 1 && question.accepted.front().test == Test::values &&
                            question.accepted.front().values.size() == 1;
  std::vector<int> fields;
  for (std::size_t i = 0; i < answer.size() && hasOneAnswer; ++i) {
    if (!answer[i].readsLike(question.solution[i])) fields.push_back(static_cast<int>(i));
  }
  return fields;
}

/// Is one of these fields marked by a mistake already?
bool isMarked(const std::vector<FoundMistake>& found, const std::vector<int>& fields) {
  return std::any_of(found.begin(), found.end(), [&](const FoundMistake& mistake) {
    return std::find_first_of(fields.begin(), fields.end(), mistake.fields.begin(), mistake.fields.end()) !=
           fields.end();
  });
}

}  // namespace

Verdict grade(const Question& question, const std::vector<std::string>& answer) {
  const ReadAnswer read = readAnswer(question, answer);
  Verdict verdict;
  if (allHold(question.accepted, read)) {
    verdict.isRight = true;
    verdict.points = question.points;
    verdict.reason = question.rule;
    return verdict;
  }
  std::vector<FoundMistake> found;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (read[i].fault == AnswerFault::none) continue;
    found.push_back(unreadable(question.fields[i], static_cast<int>(i), answer[i], read[i].fault));
  }
  for (const Mistake& mistake : question.mistakes) {
    if (!found.empty() && (mistake.fields.empty() || isMarked(found, mistake.fields))) continue;
    if (!allHold(mistake.when, read)) continue;
    found.push_back({mistake.name, mistake.fields, mistake.elements, mistake.reason});
    if (mistake.fields.empty()) break;
  }
  std::vector<int> wrong = differingFields(question, read);
  if (!found.empty()) {
    verdict.mistake = found.front();
    verdict.reason = found.front().reason;
    verdict.others.assign(found.begin() + 1, found.end());
    for (const FoundMistake& mistake : found)
      wrong.insert(wrong.end(), mistake.fields.begin(), mistake.fields.end());
  } else {
    verdict.reason = question.rule;
  }
  std::sort(wrong.begin(), wrong.end());
  wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  verdict.wrongFields = std::move(wrong);
  if (verdict.wrongFields.size() == 1 && answer.size() >= kFewestForHalf)
    verdict.points = question.points / 2;
  return verdict;
}

}  // namespace geargraph::inline grading
