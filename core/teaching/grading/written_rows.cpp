#include "core/teaching/grading/written_rows.h"

#include <algorithm>

#include "core/teaching/grading/read_answer.h"

namespace geargraph {
namespace {

std::vector<std::string> entriesOf(const std::string& text, CommaUse comma) {
  std::string separators = ";\t";
  if (comma == CommaUse::ambiguous && text.find(';') == std::string::npos) separators += ',';
  std::vector<std::string> entries(1);
  for (const char c : text) {
    if (separators.find(c) != std::string::npos) {
      entries.emplace_back();
    } else {
      entries.back() += c;
    }
  }
  return entries;
}

}  // namespace

std::vector<std::string> withRowsSpread(const Question& question, std::vector<std::string> answer) {
  const std::size_t width = question.table.columns.size();
  if (width < 2) return answer;
  const auto isBlank = [](const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
  };
  for (std::size_t first = 0; first + width <= answer.size(); first += width) {
    const auto begin = answer.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(width);
    if (isBlank(*begin) || !std::all_of(begin + 1, end, isBlank)) continue;
    const std::vector<std::string> entries = entriesOf(*begin, question.comma);
    const NumberNotation notation{question.comma, question.fields[first].unit, question.symbols};
    const bool isRead = readField(question.fields[first], *begin, notation).fault == AnswerFault::none;
    if (entries.size() == width && !isRead) std::copy(entries.begin(), entries.end(), begin);
  }
  return answer;
}

}  // namespace geargraph
