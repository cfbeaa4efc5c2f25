#include "core/teaching/grading/wrong_answers.h"

#include <algorithm>
#include <numeric>

#include "core/teaching/grading/conditions.h"

namespace geargraph {
namespace {

using Answer = std::vector<std::string>;
using Answers = std::vector<Answer>;

constexpr std::size_t kMaxCandidates = 20'000;
constexpr std::size_t kMaxCombined = 12;  ///< options of a set of which all subsets are tried

std::vector<int> fieldsOf(const Condition& condition, const Question& question) {
  if (!condition.fields.empty()) return condition.fields;
  std::vector<int> all(question.fields.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

Answer with(Answer answer, const std::vector<int>& fields, const std::vector<std::string>& values) {
  for (std::size_t i = 0; i < fields.size(); ++i) answer[static_cast<std::size_t>(fields[i])] = values[i];
  return answer;
}

std::vector<std::string> scaled(const std::vector<std::string>& values, const Rational& factor) {
  std::vector<std::string> texts;
  for (const std::string& value : values) texts.push_back((*Rational::fromText(value) * factor).toString());
  return texts;
}

/// Sets near this one first: without an element, with one more, with one exchanged; then all of a few
/// options.
std::vector<std::string> setsNear(const AnswerField& field, const std::string& text) {
  const std::vector<std::string> set = readField(field, text).elements;
  const auto isIn = [&](const std::string& option) {
    return std::find(set.begin(), set.end(), option) != set.end();
  };
  std::vector<std::string> out;
  for (const std::string& option : field.options) {
    if (!isIn(option)) out.push_back(option);
  }
  std::vector<std::string> texts{text};
  for (std::size_t i = 0; i < set.size(); ++i) {
    std::vector<std::string> less = set;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    if (!less.empty()) texts.push_back(setText(less));
    for (const std::string& other : out) {
      std::vector<std::string> exchanged = set;
      exchanged[i] = other;
      texts.push_back(setText(exchanged));
    }
  }
  for (const std::string& other : out) {
    std::vector<std::string> more = set;
    more.push_back(other);
    texts.push_back(setText(more));
  }
  for (std::size_t mask = 1;
       field.options.size() <= kMaxCombined && mask < (std::size_t{1} << field.options.size()); ++mask) {
    std::vector<std::string> some;
    for (std::size_t i = 0; i < field.options.size(); ++i) {
      if ((mask >> i & 1U) != 0) some.push_back(field.options[i]);
    }
    texts.push_back(setText(some));
  }
  return texts;
}

/// Texts that a field may be given.
std::vector<std::string> textsFor(const AnswerField& field, const std::string& solution) {
  if (field.kind == FieldKind::choice) return field.options;
  if (field.kind == FieldKind::set) return setsNear(field, solution);
  return {"0", "1", "2", "3", "5", "7", "11", "13", "-17/19"};
}

/// The candidate changed so that the condition may hold.
void addCandidates(Answers& candidates, const Answer& from, const Condition& condition,
                   const Question& question) {
  const std::vector<int> fields = fieldsOf(condition, question);
  const auto first = static_cast<std::size_t>(fields.front());
  switch (condition.test) {
    case Test::values:
      for (const auto& row : condition.values) candidates.push_back(with(from, fields, row));
      break;
    case Test::multiple:
      for (const Rational& factor : {Rational(1), Rational(-3, 2)})
        candidates.push_back(with(from, fields, scaled(condition.values.front(), factor)));
      break;
    case Test::quotient: {
      const Rational quotient = *Rational::fromText(condition.values.front().front());
      for (int factor = 1; factor <= 200; ++factor)
        candidates.push_back(
            with(from, fields, {(quotient * factor).toString(), Rational(factor).toString()}));
      break;
    }
    case Test::outside:
      for (const Rational& factor : {Rational(1'000), Rational(1, 7'919)}) {
        std::vector<std::string> values;
        for (const int field : fields) values.push_back(from[static_cast<std::size_t>(field)]);
        candidates.push_back(with(from, fields, scaled(values, factor)));
      }
      candidates.push_back(with(from, {fields.front()}, {"2"}));
      break;
    case Test::differs:
      candidates.push_back(from);
      for (const int field : fields) {
        const auto at = static_cast<std::size_t>(field);
        for (const std::string& text : textsFor(question.fields[at], from[at]))
          candidates.push_back(with(from, {field}, {text}));
      }
      break;
    case Test::within:
      for (const int field : fields) {
        for (const int other : fields) {
          for (const std::string& text : condition.values.front())
            candidates.push_back(with(with(from, {field}, {text}), {other}, {text}));
        }
      }
      break;
    case Test::rows:
      candidates.push_back(from);
      break;
    default:
      for (const std::string& text : setsNear(question.fields[first], from[first]))
        candidates.push_back(with(from, {fields.front()}, {text}));
      break;
  }
}

}  // namespace

std::optional<std::vector<std::string>> wrongAnswer(const Question& question, const Mistake& mistake) {
  Answers candidates{question.solution};
  for (const Condition& condition : mistake.when) {
    Answers next;
    for (const Answer& candidate : candidates) {
      if (next.size() < kMaxCandidates) addCandidates(next, candidate, condition, question);
    }
    candidates = std::move(next);
  }
  const Answer* found = nullptr;
  for (const Answer& candidate : candidates) {
    const ReadAnswer read = readAnswer(question, candidate);
    if (!allHold(mistake.when, read) || allHold(question.accepted, read)) continue;
    const bool isTold = std::none_of(question.mistakes.data(), &mistake,
                                     [&](const Mistake& earlier) { return allHold(earlier.when, read); });
    if (isTold) return candidate;
    if (found == nullptr) found = &candidate;
  }
  if (found == nullptr) return std::nullopt;
  return *found;
}

}  // namespace geargraph
