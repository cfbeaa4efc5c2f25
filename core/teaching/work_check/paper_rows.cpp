// Rows and cells in the notations that matrices are written in.

#include <optional>

#include "core/teaching/work_check/paper_text.h"

namespace geargraph {
namespace {

/// Cuts [begin, end) wherever isCut(at) tells how many bytes separate two parts, 0 where none do.
template <class Cut>
std::vector<TextRange> parts(TextRange whole, Cut isCut) {
  std::vector<TextRange> all{{whole.begin, whole.begin}};
  for (std::size_t at = whole.begin; at < whole.end;) {
    const std::size_t length = isCut(at);
    if (length > 0) {
      all.back().end = at;
      at += length;
      all.push_back({at, at});
    } else {
      ++at;
    }
  }
  all.back().end = whole.end;
  return all;
}

bool isEmpty(const SubmittedText& text, TextRange range) {
  const TextRange inner = text.trimmed(range);
  return inner.begin == inner.end;
}

/// The range of a LaTeX row without rules at its beginning and without the gap "[2pt]" of the row before.
TextRange withoutRules(const SubmittedText& text, TextRange row) {
  for (;;) {
    row = text.trimmed(row);
    const std::string_view rest = text.text(row);
    if (rest.starts_with("\\hline")) {
      row.begin += 6;
    } else if (rest.starts_with('[') && rest.find("]") != std::string_view::npos) {
      row.begin += rest.find(']') + 1;
    } else {
      return row;
    }
  }
}

bool isOperator(char c) {
  return c == '+' || c == '-' || c == '*' || c == '/' || c == '^';
}

/// A blank between two entries, not inside a sum such as "a - b": in "a -b" the sign begins an entry.
bool separatesEntries(std::string_view all, TextRange row, std::size_t at) {
  std::size_t before = at;
  while (before > row.begin && SubmittedText::isBlank(all[before - 1])) --before;
  std::size_t after = at;
  while (after < row.end && SubmittedText::isBlank(all[after])) ++after;
  if (before == row.begin || after == row.end) return false;
  const bool startsSum =
      isOperator(all[after]) && after + 1 < row.end && SubmittedText::isBlank(all[after + 1]);
  return !isOperator(all[before - 1]) && !startsSum && all[after] != '*' && all[after] != '/' &&
         all[after] != '^';
}

/// Bars part the cells of a table that begins with one, or has nothing else: headings hold them, too.
char separatorOf(std::string_view all) {
  const auto first = all.find_first_not_of(" \r\n");
  if (first != std::string_view::npos && all[first] == '|') return '|';
  for (const char c : {'\t', ';', ',', '|'}) {
    if (all.find(c) != std::string_view::npos) return c;
  }
  return ' ';
}

/// The cells of one line of blanks, commas or others, without the bars at the ends of a row of Markdown.
std::vector<TextRange> cellsOfLine(const SubmittedText& text, TextRange line, char separator) {
  const std::string_view all = text.all();
  if (separator == '|') {
    line = text.trimmed(line);
    if (line.begin < line.end && all[line.begin] == '|') ++line.begin;
    if (line.begin < line.end && all[line.end - 1] == '|') --line.end;
  }
  bool isQuoted = false;
  std::vector<TextRange> cells = parts(line, [&](std::size_t at) -> std::size_t {
    if (all[at] == '"') isQuoted = !isQuoted;
    if (isQuoted) return 0;
    if (separator != ' ') return all[at] == separator ? 1 : 0;
    if (!SubmittedText::isBlank(all[at]) || !separatesEntries(all, line, at)) return 0;
    std::size_t length = 1;
    while (at + length < line.end && SubmittedText::isBlank(all[at + length])) ++length;
    return length;
  });
  for (TextRange& cell : cells) {
    cell = text.trimmed(cell);
    if (cell.end - cell.begin < 2 || all[cell.begin] != '"' || all[cell.end - 1] != '"') continue;
    ++cell.begin;
    --cell.end;
  }
  return cells;
}

/// A line of dashes under the heading of a Markdown table.
bool isRule(std::string_view line) {
  return line.find('-') != std::string_view::npos &&
         line.find_first_not_of("-|: \t\r") == std::string_view::npos;
}

}  // namespace

RangeRows latexRows(const SubmittedText& text, TextRange body) {
  const std::string_view all = text.all();
  int depth = 0;
  const auto at = [&](std::size_t place, std::string_view mark) -> std::size_t {
    if (all[place] == '{') ++depth;
    if (all[place] == '}') --depth;
    return depth == 0 && all.substr(place).starts_with(mark) ? mark.size() : 0;
  };
  RangeRows rows;
  for (const TextRange& row : parts(body, [&](std::size_t place) { return at(place, "\\\\"); })) {
    depth = 0;
    const TextRange entries = withoutRules(text, row);
    if (isEmpty(text, entries)) continue;
    rows.push_back(parts(entries, [&](std::size_t place) { return at(place, "&"); }));
  }
  return rows;
}

RangeRows bracketRows(const SubmittedText& text, TextRange body) {
  const std::string_view all = text.all();
  RangeRows rows;
  for (const TextRange& line : parts(
           body, [&](std::size_t at) { return std::size_t{all[at] == ';' || all[at] == '\n' ? 1U : 0U}; })) {
    TextRange row = text.trimmed(line);
    const auto comment = text.text(row).find_first_of("%#");
    if (comment != std::string_view::npos) row.end = row.begin + comment;
    if (isEmpty(text, row)) continue;
    const bool hasCommas = text.text(row).find(',') != std::string_view::npos;
    rows.push_back(cellsOfLine(text, row, hasCommas ? ',' : ' '));
  }
  return rows;
}

RangeRows separatedRows(const SubmittedText& text) {
  const std::string_view all = text.all();
  const char separator = separatorOf(all);
  RangeRows rows;
  for (const TextRange& line :
       parts({0, all.size()}, [&](std::size_t at) { return std::size_t{all[at] == '\n' ? 1U : 0U}; })) {
    if (isEmpty(text, line) || isRule(text.text(line))) continue;
    rows.push_back(cellsOfLine(text, line, separator));
  }
  return rows;
}

}  // namespace geargraph
