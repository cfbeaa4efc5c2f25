#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/presentation/typeset/formula_setter.h"
#include "core/presentation/typeset/typeset.h"

namespace geargraph {
namespace {

constexpr SetStyle kOwnLine{0};
constexpr double kIndent = 2;               ///< em, of what goes on
constexpr double kBesideMatrix = 5.0 / 18;  ///< em, between a relation and a part of a matrix

const FormulaNode* alignedIn(const FormulaNode& formula) {
  if (formula.parts.size() != 1) return nullptr;
  const FormulaNode& only = formula.parts.front();
  return only.kind == FormulaKind::table && only.table == FormulaTableKind::aligned ? &only : nullptr;
}

bool mayBreakBefore(const SetAtom& atom) {
  return atom.kind == InternedStringClass::relation || atom.kind == InternedStringClass::binary ||
         atom.kind == InternedStringClass::inner;
}

/// Where a row breaks, so that no line is wider than `width` and what goes on is indented.
class BreakableRow {
 public:
  explicit BreakableRow(const FormulaNode& row) : m_atoms(setAtoms(row.parts, kOwnLine)) {}

  /// Lines from `start` on, of which the first begins behind a relation's room when `afterCell`.
  [[nodiscard]] std::vector<FormulaBox> lines(double start, double indent, double width,
                                              bool afterCell) const {
    std::vector<FormulaBox> lines(1);
    lines.back().width = start;
    bool lineHasSome = false;
    for (std::size_t i = 0; i < m_atoms.size();) {
      std::size_t end = i + 1;
      while (end < m_atoms.size() && !mayBreakBefore(m_atoms[end])) ++end;
      const FormulaBox piece = together(i, end);
      double room = i > 0       ? roomBetween(m_atoms[i - 1], m_atoms[i], kOwnLine)
                    : afterCell ? roomBetween({}, m_atoms[i], kOwnLine)
                                : 0;
      if (lineHasSome && lines.back().width + room + piece.width > width) {
        lines.emplace_back();
        lines.back().width = indent;
        room = 0;
      }
      lines.back().width += room;
      lines.back().append(piece);
      lineHasSome = true;
      i = end;
    }
    return lines;
  }

 private:
  [[nodiscard]] FormulaBox together(std::size_t begin, std::size_t end) const {
    FormulaBox box;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin) box.width += roomBetween(m_atoms[i - 1], m_atoms[i], kOwnLine);
      box.append(m_atoms[i].box);
    }
    return box;
  }

  std::vector<SetAtom> m_atoms;
};

/// The first column to one right edge.
std::vector<FormulaLine> alignedLines(const FormulaNode& table, double width) {
  std::vector<FormulaBox> firsts;
  double column = 0;
  for (const auto& row : table.cells) {
    firsts.push_back(setRow(row.front(), kOwnLine));
    column = std::max(column, firsts.back().width);
  }
  std::vector<FormulaLine> lines;
  for (std::size_t row = 0; row < table.cells.size(); ++row) {
    FormulaBox begin;
    begin.width = column - firsts[row].width;
    begin.append(firsts[row]);
    if (table.cells[row].size() < 2) {
      lines.push_back({begin, row});
      continue;
    }
    auto rest = BreakableRow(table.cells[row][1]).lines(column, column + kIndent, width, true);
    rest.front().put(begin, 0, 0);
    for (FormulaBox& line : rest) lines.push_back({std::move(line), row});
  }
  return lines;
}

/// The labels of the rows and the columns from `begin` to before `end`.
FormulaNode partOf(const FormulaNode& table, std::size_t begin, std::size_t end) {
  FormulaNode part{FormulaKind::table};
  part.rules = table.rules;
  const auto columns = [&](const auto& all, auto& chosen) {
    for (std::size_t column = 0; column < all.size(); ++column) {
      if (column == 0 || (column >= begin && column < end)) chosen.push_back(all[column]);
    }
  };
  columns(table.alignment, part.alignment);
  columns(table.bars, part.bars);
  part.bars.resize(std::max<std::size_t>(part.bars.size(), 2),
                   0);  // rows may have more columns than were stated
  part.bars[1] = 1;
  for (const auto& row : table.cells) {
    part.cells.emplace_back();
    columns(row, part.cells.back());
  }
  part.opens = begin == 1;
  part.closes = end == table.cells.front().size();
  return part;
}

/// A lower bound of the width of a matrix broken into parts of `each` columns: its widest part without
/// brackets and without the gaps between columns. Much cheaper than setting the parts.
double leastWidth(const std::vector<double>& columns, std::size_t each) {
  double widest = 0;
  for (std::size_t begin = 1; begin < columns.size(); begin += each) {
    const auto first = columns.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto count = static_cast<std::ptrdiff_t>(std::min(each, columns.size() - begin));
    widest = std::max(widest, std::accumulate(first, first + count, columns.front()));
  }
  return widest;
}

/// In as few parts as fit, or none where not even single columns do.
std::vector<FormulaLine> matrixParts(const FormulaNode& formula, double width) {
  const FormulaNode& table = formula.parts.back();
  const std::size_t columns = table.cells.front().size() - 1;
  FormulaNode before{FormulaKind::row, {}, 0, formula.parts};
  before.parts.back() = {};
  const double start = setRow(before, kOwnLine).width + kBesideMatrix;
  const std::vector<double> widths = columnWidths(table, kOwnLine);
  for (std::size_t parts = 2; parts <= columns; ++parts) {
    std::vector<FormulaLine> lines;
    const std::size_t each = (columns + parts - 1) / parts;
    if (start + leastWidth(widths, each) > width) continue;
    for (std::size_t begin = 1; begin <= columns; begin += each) {
      FormulaLine line;
      if (begin == 1) line.box = setRow(before, kOwnLine);
      const FormulaBox matrix = setTable(partOf(table, begin, std::min(begin + each, columns + 1)), kOwnLine);
      line.box.width = start;
      line.box.append(matrix);
      lines.push_back(std::move(line));
    }
    if (widthOf(lines) <= width) return lines;
  }
  return {};
}

}  // namespace

std::vector<FormulaLine> typesetLines(const FormulaNode& formula, double width) {
  if (const FormulaNode* table = alignedIn(formula)) return alignedLines(*table, width);
  FormulaBox whole = typesetFormula(formula, FormulaPlace::ownLine);
  if (whole.width <= width) return {{std::move(whole)}};
  if (!formula.parts.empty() && formula.parts.back().kind == FormulaKind::table &&
      formula.parts.back().isLabelled()) {
    if (auto parts = matrixParts(formula, width); !parts.empty()) return parts;
  }
  std::vector<FormulaLine> lines;
  for (FormulaBox& line : BreakableRow(formula).lines(0, kIndent, width, false))
    lines.push_back({std::move(line)});
  return lines;
}

double widthOf(const std::vector<FormulaLine>& lines) {
  double width = 0;
  for (const FormulaLine& line : lines) width = std::max(width, line.box.width);
  return width;
}

}  // namespace geargraph
