#include "core/teaching/grading/grade.h"

#include <algorithm>

#include "core/foundations/base/translation.h"
#include "core/teaching/grading/conditions.h"
#include "core/teaching/grading/nearest_answer.h"
#include "core/teaching/grading/written_rows.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxQuoteLength = 40;  ///< characters of an answer that a sentence repeats
constexpr std::size_t kMaxNamed = 6;         ///< empty fields

/// The text, cut after some characters.
std::string quoted(const std::string& text) {
  std::size_t characters = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool isFirstByte = (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
    if (isFirstByte && ++characters > kMaxQuoteLength) return text.substr(0, at) + "\u2026";
  }
  return text;
}

/// The mistake of a field that cannot be read, with the place where reading stopped.
FoundMistake unreadable(const AnswerField& field, int position, const std::string& answer,
                        const ReadField& read) {
  const std::string text = quoted(answer);
  const std::string place = quoted(read.place);
  FoundMistake found{{}, {position}, field.elements, {}};
  switch (read.fault) {
    case AnswerFault::none:
    case AnswerFault::empty:
      break;
    case AnswerFault::ambiguousNumber:
      found.name = "ambiguous-number";
      found.reason = translated(
          "“%1” can be read as a thousand or as a decimal: write it without the comma, or as a fraction.",
          {text});
      break;
    case AnswerFault::notANumber:
      found.name = "not-a-number";
      found.reason =
          place.empty() || place == text
              ? translated(
                    "“%1” is not a number: write a whole number, a fraction such as −3/4 or a decimal.",
                    {text})
              : translated(
                    "“%1” cannot be read from “%2” on: write a whole number, a fraction such as −3/4 or a "
                    "decimal.",
                    {text, place});
      break;
    case AnswerFault::unknownName:
      found.name = "unknown-symbol";
      found.reason =
          translated("“%1” cannot be read from “%2” on: this question knows no such symbol.", {text, place});
      break;
    case AnswerFault::otherUnit:
      found.name = "other-unit";
      found.reason =
          field.unit.empty()
              ? translated("“%1” has the unit %2: write a number without a unit.", {text, place})
              : translated("“%1” has the unit %2: write the number in %3.", {text, place, field.unit});
      break;
    case AnswerFault::notAChoice:
      found.name = "not-a-choice";
      found.reason =
          translated("“%1” is not among what the question offers for %2.", {text, field.shownName()});
      break;
  }
  return found;
}

/// All empty fields in one sentence.
FoundMistake unanswered(const Question& question, const std::vector<int>& fields) {
  const auto fieldAt = [&](std::size_t i) -> const AnswerField& {
    return question.fields[static_cast<std::size_t>(fields[i])];
  };
  if (fields.size() == 1)
    return {"unanswered", fields, fieldAt(0).elements,
            translated("The field %1 is empty.", {fieldAt(0).shownName()})};
  std::string names;
  for (std::size_t i = 0; i < std::min(fields.size(), kMaxNamed); ++i)
    names += (i > 0 ? "; " : "") + fieldAt(i).shownName();
  if (fields.size() > kMaxNamed) names += "; \u2026";
  return {"unanswered",
          fields,
          {},
          translated("%1 fields are empty: %2.", {std::to_string(fields.size()), names})};
}

/// Is one of these fields marked by a mistake already?
bool isMarked(const std::vector<int>& marked, const std::vector<int>& fields) {
  return std::find_first_of(marked.begin(), marked.end(), fields.begin(), fields.end()) != marked.end();
}

/// Those of the mistake's fields that are wrong, if it is known which.
std::vector<int> wrongOf(const std::vector<int>& fields, const std::vector<int>& wrong) {
  std::vector<int> both;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(both),
               [&](int field) { return std::binary_search(wrong.begin(), wrong.end(), field); });
  return both.empty() ? fields : both;
}

/// What was found in an answer that is not accepted.
std::vector<FoundMistake> mistakesIn(const Question& question, const std::vector<std::string>& answer,
                                     const ReadAnswer& read, const std::vector<int>& wrong) {
  std::vector<FoundMistake> found;
  std::vector<int> marked;
  std::vector<int> blank;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const auto position = static_cast<int>(i);
    if (read[i].fault == AnswerFault::none) continue;
    marked.push_back(position);
    if (read[i].fault == AnswerFault::empty) {
      blank.push_back(position);
    } else {
      found.push_back(unreadable(question.fields[i], position, answer[i], read[i]));
    }
  }
  if (!blank.empty()) found.push_back(unanswered(question, blank));
  for (const Mistake& mistake : question.mistakes) {
    if (!found.empty() && (mistake.fields.empty() || isMarked(marked, mistake.fields))) continue;
    if (!allHold(mistake.when, read)) continue;
    found.push_back({mistake.name, wrongOf(mistake.fields, wrong), mistake.elements, mistake.reason});
    marked.insert(marked.end(), mistake.fields.begin(), mistake.fields.end());
    if (mistake.fields.empty()) break;
  }
  return found;
}

Verdict blankVerdict() {
  Verdict verdict;
  verdict.isBlank = true;
  verdict.reason = translated("The question is not answered.");
  verdict.mistake = FoundMistake{"unanswered", {}, {}, verdict.reason};
  return verdict;
}

}  // namespace

Verdict grade(const Question& question, const std::vector<std::string>& texts) {
  const std::vector<std::string> answer = withRowsSpread(question, texts);
  const ReadAnswer read = readAnswer(question, answer);
  Verdict verdict;
  if (allHold(question.accepted, read)) {
    verdict.isRight = true;
    verdict.points = question.points;
    verdict.reason = question.rule;
    return verdict;
  }
  const auto isFilled = [](const ReadField& field) { return !field.isEmpty; };
  const auto isMissing = [](const ReadField& field) { return field.fault == AnswerFault::empty; };
  if (std::none_of(read.begin(), read.end(), isFilled) && std::any_of(read.begin(), read.end(), isMissing))
    return blankVerdict();
  CellMarks cells = compareCells(question, read);
  verdict.points = question.points * cells.right / std::max(cells.counted, 1);
  verdict.isUnreadable = std::any_of(read.begin(), read.end(), [](const ReadField& field) {
    return field.fault != AnswerFault::none && field.fault != AnswerFault::empty;
  });
  const std::vector<FoundMistake> found = mistakesIn(question, answer, read, cells.wrong);
  verdict.reason = question.rule;
  std::vector<int> wrong = std::move(cells.wrong);
  if (!found.empty()) {
    verdict.mistake = found.front();
    verdict.reason = found.front().reason;
    verdict.others.assign(found.begin() + 1, found.end());
    for (const FoundMistake& mistake : found)
      wrong.insert(wrong.end(), mistake.fields.begin(), mistake.fields.end());
  }
  std::sort(wrong.begin(), wrong.end());
  wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  verdict.wrongFields = std::move(wrong);
  return verdict;
}

}  // namespace geargraph
