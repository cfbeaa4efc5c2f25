#include "core/teaching/work_check/work_check.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/foundations/base/contract.h"
#include "core/foundations/base/translation.h"
#include "core/teaching/work_check/equation_check.h"
#include "core/teaching/work_check/table_check.h"

namespace geargraph {

std::string_view outcomeName(WorkOutcome outcome) {
  constexpr std::array<std::string_view, 3> kNames = {toTranslate("right"), toTranslate("wrong"),
                                                      toTranslate("ambiguous")};
  return kNames[static_cast<std::size_t>(outcome)];
}

std::span<const MistakeName> paperMistakeNames() {
  static constexpr MistakeName kNames[] = {
      {"another-matrix", toTranslate("another matrix than the one asked for")},
      {"another-size", toTranslate("size that the matrix does not have")},
      {"minus-left-out", toTranslate("minus of the solution left out")},
      {"another-output", toTranslate("row of another output")},
      {"another-ratio-symbol", toTranslate("ratio of another mesh with the same value")},
      {"input-without-effect", toTranslate("input that the output does not feel")},
      {"wrong-entry", toTranslate("entry that differs")},
      {"term-left-out", toTranslate("velocity left out of the equation")},
      {"another-velocity", toTranslate("velocity of another joint or link")},
      {"equation-does-not-hold", toTranslate("equation that does not follow from the mechanism")},
  };
  return kNames;
}

std::string_view paperMistakeTitle(std::string_view name) {
  for (const MistakeName& mistake : paperMistakeNames()) {
    if (mistake.name == name) return mistake.title;
  }
  return mistakeTitle(name);
}

Expected<WorkVerdict> checkPaper(const ExerciseSource& source, std::string_view text,
                                 std::optional<PaperMatrix> kind, const std::stop_token& stop) {
  auto paper = readPaper(text);
  if (!paper) return paper.error();
  if (hasErrors(source.snapshot()->diagnostics) && source.tree() == nullptr &&
      (!kind || *kind > PaperMatrix::reducedIncidence))
    return source.snapshot()->diagnostics;
  if (const auto* table = std::get_if<WrittenTable>(&*paper)) {
    auto verdict = checkTable(source, *table, kind, stop);
    if (!verdict) return verdict.error();
    return WorkVerdict(std::move(verdict).value());
  }
  if (source.matroid() == nullptr) return source.snapshot()->diagnostics;
  const Vocabulary vocabulary(source);
  auto verdicts = checkEquations(vocabulary, std::get<std::vector<WrittenEquation>>(*paper), stop);
  if (!verdicts) return verdicts.error();
  return WorkVerdict(std::move(verdicts).value());
}

}  // namespace geargraph
