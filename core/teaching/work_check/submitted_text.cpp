#include "core/teaching/work_check/submitted_text.h"

#include <array>
#include <charconv>
#include <optional>

#include "core/foundations/base/translation.h"
#include "core/teaching/work_check/paper_text.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxCells = 100'000;

/// A matrix environment of LaTeX, or the brackets of MATLAB, by the ranges of its cells.
struct Grid {
  TextRange place;
  RangeRows rows;
  [[nodiscard]] bool isColumn() const {
    for (const auto& row : rows) {
      if (row.size() != 1) return false;
    }
    return true;
  }
};

bool isDots(std::string_view text) {
  return text == "\\vdots" || text == "\\cdots" || text == "\\dots" || text == "\\ldots" ||
         text == "\u22ee" || text == "\u22ef";
}

/// Without rows and columns that hold nothing but the dots of a partition.
void dropPartitions(const SubmittedText& text, RangeRows& rows) {
  const auto dots = [&](TextRange cell) { return isDots(text.text(text.trimmed(cell))); };
  std::erase_if(rows, [&](const auto& row) { return std::all_of(row.begin(), row.end(), dots); });
  if (rows.empty()) return;
  for (std::size_t column = rows.front().size(); column-- > 0;) {
    const bool isPartition = std::all_of(
        rows.begin(), rows.end(), [&](const auto& row) { return column < row.size() && dots(row[column]); });
    for (auto& row : rows) {
      if (isPartition) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    }
  }
}

std::optional<int> wholeNumber(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Numbers that ascend by one, or at least four that ascend: the labels of rows or columns, which no row of
/// a matrix looks like.
bool areNumberLabels(const std::vector<WrittenCell>& cells, int least) {
  int last = least - 1;
  int steps = 0;
  for (const WrittenCell& cell : cells) {
    const auto number = wholeNumber(cell.text);
    if (!number || *number <= last) return false;
    if (&cell != &cells.front() && *number == last + 1) ++steps;
    last = *number;
  }
  const int count = static_cast<int>(cells.size());
  return count >= 2 && last > 1 && (steps == count - 1 || count >= 4);
}

bool areLabels(const std::vector<WrittenCell>& cells, std::size_t first) {
  bool isNamed = false;
  for (std::size_t i = first; i < cells.size(); ++i) {
    const bool isName = isLabelText(cells[i].text);
    if (!isName && !wholeNumber(cells[i].text)) return false;
    isNamed = isNamed || isName;
  }
  return isNamed;
}

class PaperReader {
 public:
  explicit PaperReader(std::string_view text) : m_text(text) {}

  Expected<WrittenPaper> read() {
    const std::string_view all = m_text.all();
    if (all.size() > kLargestPaper)
      return m_text.fault(0, translated("The text has more than %1 bytes.", {std::to_string(kLargestPaper)}));
    if (m_text.piece({0, all.size()}).text.empty())
      return m_text.fault(0, translated("There is no matrix and no equation."));
    if (auto fault = findGrids()) return *fault;
    if (!m_grids.empty()) return tableOfGrids();
    if (areEquations()) return equations();
    Grid whole{{0, all.size()}, separatedRows(m_text)};
    return tableOf(std::move(whole.rows), {}, {});
  }

 private:
  /// Matrix environments and brackets that hold more than one entry.
  std::optional<Diagnostic> findGrids() {
    const std::string_view all = m_text.all();
    for (std::size_t at = 0; at < all.size();) {
      const std::size_t begin = all.find("\\begin{", at);
      if (begin == std::string_view::npos) break;
      const std::size_t nameEnd = all.find('}', begin);
      if (nameEnd == std::string_view::npos)
        return m_text.fault(begin, translated("This \\begin has no name in braces."));
      const std::string name(all.substr(begin + 7, nameEnd - begin - 7));
      at = nameEnd + 1;
      if (!isMatrixEnvironment(name)) continue;
      const std::size_t end = all.find("\\end{" + name + "}", at);
      if (end == std::string_view::npos)
        return m_text.fault(begin, translated("\\begin{%1} has no \\end{%1}.", {name}));
      if (name == "array" || name == "tabular") at = afterArgument(at, end);
      m_grids.push_back({{begin, end}, latexRows(m_text, {at, end})});
      at = end;
    }
    return m_grids.empty() ? findBrackets() : std::nullopt;
  }

  static bool isMatrixEnvironment(std::string_view name) {
    constexpr std::array<std::string_view, 9> kNames = {
        "matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix", "smallmatrix", "array", "tabular", "bmatrix*"};
    return std::find(kNames.begin(), kNames.end(), name) != kNames.end();
  }

  /// Behind "{c|rrr}".
  [[nodiscard]] std::size_t afterArgument(std::size_t at, std::size_t end) const {
    const std::string_view all = m_text.all();
    if (at >= end || all[at] != '{') return at;
    int depth = 0;
    for (std::size_t i = at; i < end; ++i) {
      depth += all[i] == '{' ? 1 : all[i] == '}' ? -1 : 0;
      if (depth == 0) return i + 1;
    }
    return at;
  }

  /// "[a b; c d]", and "[[a, b], [c, d]]" of Python.
  std::optional<Diagnostic> findBrackets() {
    const std::string_view all = m_text.all();
    const std::size_t open = openingBracket();
    if (open == std::string_view::npos) return std::nullopt;
    RangeRows rows;
    std::size_t inner = std::string_view::npos;
    bool isNested = false;
    int depth = 0;
    for (std::size_t at = open; at < all.size(); ++at) {
      if (all[at] == '[') {
        ++depth;
        isNested = isNested || depth == 2;
        inner = at + 1;
      } else if (all[at] == ']') {
        if (isNested && depth == 2) {
          const RangeRows row = bracketRows(m_text, {inner, at});
          rows.insert(rows.end(), row.begin(), row.end());
        }
        if (--depth > 0) continue;
        // The bracket of a heading such as "C = [T | U]" has the matrix behind it.
        if (m_text.text({at, all.size()}).find_first_of("0123456789") != std::string_view::npos)
          return std::nullopt;
        if (!isNested) rows = bracketRows(m_text, {open + 1, at});
        m_grids.push_back({{open, at + 1}, std::move(rows)});
        return std::nullopt;
      }
    }
    return m_text.fault(open, translated("This bracket is not closed."));
  }

  /// The first bracket outside of comments.
  [[nodiscard]] std::size_t openingBracket() const {
    const std::string_view all = m_text.all();
    bool isComment = false;
    for (std::size_t at = 0; at < all.size(); ++at) {
      if (all[at] == '\n') isComment = false;
      if (all[at] == '%' || all[at] == '#') isComment = true;
      if (all[at] == '[' && !isComment) return at;
    }
    return std::string_view::npos;
  }

  /// The matrix is the first grid of more than one column; a column before it names its rows, the one behind
  /// it its columns.
  Expected<WrittenPaper> tableOfGrids() {
    std::size_t matrix = 0;
    while (matrix + 1 < m_grids.size() && m_grids[matrix].isColumn()) ++matrix;
    if (m_grids[matrix].isColumn()) matrix = 0;
    for (Grid& grid : m_grids) dropPartitions(m_text, grid.rows);
    std::vector<WrittenCell> rowLabels;
    std::vector<WrittenCell> columnLabels;
    if (matrix > 0) rowLabels = columnOf(m_grids[matrix - 1]);
    if (matrix + 1 < m_grids.size()) columnLabels = columnOf(m_grids[matrix + 1]);
    return tableOf(m_grids[matrix].rows, std::move(rowLabels), std::move(columnLabels));
  }

  [[nodiscard]] std::vector<WrittenCell> columnOf(const Grid& grid) const {
    std::vector<WrittenCell> cells;
    for (const auto& row : grid.rows) cells.push_back(m_text.piece(row.front()));
    return areLabels(cells, 0) ? cells : std::vector<WrittenCell>();
  }

  Expected<WrittenPaper> tableOf(RangeRows rows, std::vector<WrittenCell> rowLabels,
                                 std::vector<WrittenCell> columnLabels) {
    WrittenTable table;
    table.name = nameBefore();
    std::size_t cells = 0;
    for (const auto& row : rows) {
      table.cells.emplace_back();
      cells += row.size();
      if (cells > kMaxCells)
        return m_text.fault(row.front().begin,
                            translated("The matrix has more than %1 entries.", {std::to_string(kMaxCells)}));
      for (const TextRange& cell : row) table.cells.back().push_back(m_text.piece(cell));
      // A separator at the end of every line begins no column.
      if (row.size() > 1 && table.cells.back().back().text.empty() && row.size() > rows.front().size())
        table.cells.back().pop_back();
    }
    if (table.cells.empty()) return m_text.fault(0, translated("The matrix has no rows."));
    splitLabels(table);
    if (!rowLabels.empty()) table.rowLabels = std::move(rowLabels);
    if (!columnLabels.empty()) table.columnLabels = std::move(columnLabels);
    if (auto fault = raggedRow(table)) return *fault;
    return WrittenPaper(std::move(table));
  }

  static void splitLabels(WrittenTable& table) {
    const std::vector<WrittenCell>& first = table.cells.front();
    const bool isShort = table.rows() > 1 && table.cells[1].size() == first.size() + 1;
    const bool hasCorner = isLabelText(first.front().text) && first.size() > 1 && table.rows() > 1;
    const bool isHeading =
        table.rows() > 1 && (isShort || areLabels(first, hasCorner ? 1 : 0) || areNumberLabels(first, 1) ||
                             (hasCorner && areNumbers(first, 1)));
    std::vector<WrittenCell> heading;
    if (isHeading) {
      heading = first;
      table.cells.erase(table.cells.begin());
    }
    std::vector<WrittenCell> side;
    for (const auto& row : table.cells) side.push_back(row.front());
    const bool hasSide =
        table.columns() > 1 && ((isHeading && (isShort || hasCorner)) || areLabels(side, 0) ||
                                (side.size() > 2 && areNumberLabels(side, 0)));
    if (hasSide) {
      for (auto& row : table.cells) row.erase(row.begin());
      table.rowLabels = std::move(side);
      if (isHeading && !isShort) heading.erase(heading.begin());
    }
    table.columnLabels = std::move(heading);
  }

  static bool areNumbers(const std::vector<WrittenCell>& cells, std::size_t first) {
    return std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(first), cells.end(),
                       [](const WrittenCell& cell) { return wholeNumber(cell.text).has_value(); });
  }

  static Diagnostic faultAt(const WrittenCell& cell, std::string message) {
    Diagnostic fault{Code::syntax, std::move(message), {}, {}};
    fault.line = cell.line;
    fault.column = cell.column;
    return fault;
  }

  static std::string raggedText(std::size_t row, std::size_t entries, std::size_t width) {
    return entries == 1 ? translated("Row %1 has 1 entry, the first has %2.",
                                     {std::to_string(row), std::to_string(width)})
                        : translated("Row %1 has %2 entries, the first has %3.",
                                     {std::to_string(row), std::to_string(entries), std::to_string(width)});
  }

  static std::optional<Diagnostic> raggedRow(const WrittenTable& table) {
    const std::size_t width = table.cells.front().size();
    for (std::size_t i = 0; i < table.cells.size(); ++i) {
      if (table.cells[i].empty())
        return faultAt(table.rowLabels[i], translated("This row has a label and no entry."));
      if (table.cells[i].size() != width)
        return faultAt(table.cells[i].front(), raggedText(i + 1, table.cells[i].size(), width));
    }
    if (!table.columnLabels.empty() && table.columnLabels.size() != width)
      return faultAt(table.columnLabels.front(),
                     translated("There are %1 labels for %2 columns.",
                                {std::to_string(table.columnLabels.size()), std::to_string(width)}));
    if (!table.rowLabels.empty() && table.rowLabels.size() != table.cells.size())
      return faultAt(table.rowLabels.front(),
                     translated("There are %1 labels for %2 rows.", {std::to_string(table.rowLabels.size()),
                                                                     std::to_string(table.cells.size())}));
    return std::nullopt;
  }

  /// "C" of "C = [": one word before the equals sign, on its line.
  [[nodiscard]] std::string nameBefore() const {
    if (m_grids.empty()) return {};
    const std::string_view before = m_text.all().substr(0, m_grids.front().place.begin);
    const auto equals = before.rfind('=');
    if (equals == std::string_view::npos) return {};
    const auto line = before.rfind('\n', equals);
    const std::size_t start = line == std::string_view::npos ? 0 : line + 1;
    std::string name = m_text.piece({start, equals}).text;
    return name.find_first_of(" \t") == std::string::npos ? name : std::string();
  }

  /// Most lines have an equals sign; a matrix has one in its heading at most.
  [[nodiscard]] bool areEquations() const {
    int equations = 0;
    int others = 0;
    const std::string_view all = m_text.all();
    for (std::size_t begin = 0; begin < all.size();) {
      const std::size_t end = std::min(all.find('\n', begin), all.size());
      const WrittenCell line = m_text.piece({begin, end});
      if (line.text.find('=') != std::string::npos) {
        ++equations;
      } else if (!line.text.empty() && !line.text.starts_with('\\')) {
        ++others;
      }
      begin = end + 1;
    }
    return equations > others;
  }

  /// One a line, or between double backslashes; the ampersands and environments of aligned equations say
  /// nothing.
  Expected<WrittenPaper> equations() {
    const std::string_view all = m_text.all();
    std::vector<WrittenEquation> equations;
    for (std::size_t begin = 0; begin <= all.size();) {
      std::size_t end = std::min(all.find('\n', begin), all.size());
      const std::size_t row = all.find("\\\\", begin);
      const bool endsByMark = row < end;
      if (endsByMark) end = row;
      if (auto fault = addEquation({begin, end}, equations)) return *fault;
      begin = end + (endsByMark ? 2 : 1);
    }
    if (equations.empty()) return m_text.fault(0, translated("There is no equation."));
    return WrittenPaper(std::move(equations));
  }

  std::optional<Diagnostic> addEquation(TextRange line, std::vector<WrittenEquation>& equations) const {
    line = m_text.trimmed(line);
    const std::string_view text = m_text.text(line);
    if (text.empty() || text.starts_with("\\begin{") || text.starts_with("\\end{") || text.starts_with('%'))
      return std::nullopt;
    if (text.find('=') == std::string_view::npos)
      return m_text.fault(line.begin, translated("This line has no equals sign."));
    WrittenEquation equation;
    for (std::size_t at = line.begin; at <= line.end;) {
      const std::size_t end = std::min(m_text.all().find('=', at), line.end);
      WrittenCell side = m_text.piece({at, end});
      std::erase(side.text, '&');
      if (side.text.find_first_not_of(" \t") == std::string::npos)
        return m_text.fault(at, translated("A side of this equation is empty."));
      equation.sides.push_back(std::move(side));
      at = end + 1;
    }
    equations.push_back(std::move(equation));
    return std::nullopt;
  }

  SubmittedText m_text;
  std::vector<Grid> m_grids;
};

}  // namespace

bool isLabelText(std::string_view text) {
  constexpr std::array<std::string_view, 18> kBeginnings = {
      "\\theta", "\\dot", "\\omega", "\\Gamma", "\u03b8", "\u03c9", "theta",  "omega", "joint",
      "mesh",    "link",  "row",     "cycle",   "gear",   "\u0393", "output", "L",     "C"};
  if (text.empty()) return true;
  const auto first = text.find_first_not_of(" \t");
  if (first != std::string_view::npos) text = text.substr(first);
  if (std::any_of(kBeginnings.begin(), kBeginnings.end(),
                  [&](std::string_view beginning) { return text.starts_with(beginning); }))
    return true;
  if (text.front() == 'w' || text.front() == 'q' || text.find('=') != std::string_view::npos) return true;
  return text == "Z" || text == "T" || text == "P" || text == "Q" || text == "S" || text == "U" ||
         text == "$" || text == "\u00fb";
}

Expected<WrittenPaper> readPaper(std::string_view text) {
  return PaperReader(text).read();
}

}  // namespace geargraph
