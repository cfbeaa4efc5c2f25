#include "core/teaching/grading/nearest_answer.h"

#include <algorithm>
#include <numeric>

#include "core/teaching/grading/conditions.h"

namespace geargraph {
namespace {

using Row = std::vector<std::string>;
using AnswerAgreement = std::vector<char>;  ///< by field of the condition

constexpr std::size_t kMinOfMultiple = 2;  ///< cells that fix the factor of a row

AnswerAgreement answerAgreement(const ReadAnswer& answer, const std::vector<int>& fields, const Row& row) {
  AnswerAgreement agrees;
  for (std::size_t i = 0; i < fields.size(); ++i)
    agrees.push_back(answer[static_cast<std::size_t>(fields[i])].readsLike(row[i]) ? 1 : 0);
  return agrees;
}

/// With the multiple of the row that most cells agree with; empty if no two of them do.
AnswerAgreement agreementWithMultiple(const ReadAnswer& answer, const std::vector<int>& fields,
                                      const Row& row) {
  const auto number = [&](std::size_t i) -> const ReadField& {
    return answer[static_cast<std::size_t>(fields[i])];
  };
  const auto isRead = [&](std::size_t i) {
    return number(i).fault == AnswerFault::none && !number(i).isEmpty;
  };
  AnswerAgreement best;
  std::size_t most = kMinOfMultiple - 1;
  for (std::size_t pivot = 0; pivot < row.size(); ++pivot) {
    const Rational expected = *Rational::fromText(row[pivot]);
    if (!isRead(pivot) || expected.isZero() || number(pivot).number.value.isZero()) continue;
    const Rational factor = number(pivot).number.value / expected;
    AnswerAgreement agrees;
    std::size_t count = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Rational value = factor * *Rational::fromText(row[i]);
      agrees.push_back(isRead(i) && number(i).number.agreesWith(value) ? 1 : 0);
      count += agrees.back() != 0 && !value.isZero() ? 1U : 0U;
    }
    if (count > most) {
      most = count;
      best = std::move(agrees);
    }
  }
  return best;
}

}  // namespace

CellMarks compareCells(const Question& question, const ReadAnswer& answer) {
  CellMarks marks;
  std::vector<int> all(question.fields.size());
  std::iota(all.begin(), all.end(), 0);
  const bool isTable = !question.table.columns.empty();
  for (const Condition& condition : question.accepted) {
    const std::vector<int>& fields = condition.fields.empty() ? all : condition.fields;
    const Row* row = &condition.values.front();
    const bool hasRow = condition.test == Test::values || condition.test == Test::multiple;
    AnswerAgreement agrees;
    if (condition.test == Test::values) {
      std::ptrdiff_t most = -1;
      for (const Row& other : condition.values) {
        AnswerAgreement with = answerAgreement(answer, fields, other);
        const auto count = std::count(with.begin(), with.end(), 1);
        if (count <= most) continue;
        most = count;
        agrees = std::move(with);
        row = &other;
      }
    } else if (condition.test == Test::multiple) {
      agrees = agreementWithMultiple(answer, fields, *row);
    } else if (holds(condition, answer)) {
      agrees.assign(fields.size(), 1);
    } else if (fields.size() == 1) {
      agrees.assign(1, 0);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const bool isRight = !agrees.empty() && agrees[i] != 0;
      const bool isFiller = isTable && hasRow && ((*row)[i] == "0" || (*row)[i].empty());
      if (isRight && isFiller) continue;
      ++marks.counted;
      marks.right += isRight ? 1 : 0;
      if (!isRight && !agrees.empty()) marks.wrong.push_back(fields[i]);
    }
  }
  std::sort(marks.wrong.begin(), marks.wrong.end());
  marks.wrong.erase(std::unique(marks.wrong.begin(), marks.wrong.end()), marks.wrong.end());
  return marks;
}

}  // namespace geargraph
