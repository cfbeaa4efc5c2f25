#include <algorithm>

#include "core/presentation/typeset/formula_setter.h"

namespace geargraph {
namespace {

// Of lines of text, in em.
constexpr double kStrutHeight = 0.84, kStrutDepth = 0.36;
constexpr double kCellGap = 0.45;    // on either side of a column
constexpr double kBarPart = 1.3;     // how much wider that is at a bar
constexpr double kLineGap = 0.3;     // between rows that are higher than a line
constexpr double kAlignedGap = 0.3;  // between lines of "aligned"
constexpr double kBracketGap = 0.22;
constexpr double kLabelLead = 0.35;  // between a sign and the labels of rows
constexpr double kLabelGap = 0.25;
constexpr double kHeadSize = 0.7;
constexpr double kDash = 0.045;

class TableSetter {
 public:
  TableSetter(const FormulaNode& table, SetStyle style)
      : m_table(table),
        m_style(style),
        m_lines(table.table == FormulaTableKind::aligned),
        m_labelled(table.isLabelled()) {
    setCells();
    placeRows();
    placeColumns();
  }

  [[nodiscard]] const std::vector<double>& widths() const { return m_widths; }
  [[nodiscard]] FormulaBox box() const {
    FormulaBox body;
    for (std::size_t row = 0; row < m_cells.size(); ++row) {
      for (std::size_t column = 0; column < m_cells[row].size(); ++column) {
        body.put(m_cells[row][column], left(row, column), m_baselines[row]);
      }
    }
    body.height = -m_top;
    body.depth = m_bottom;
    body.width = m_right;
    addRules(body);
    if (m_labelled) addBrackets(body);
    if (m_table.table == FormulaTableKind::brackets) return inParentheses(body);
    return body;
  }

 private:
  [[nodiscard]] double size() const { return m_style.size(); }
  [[nodiscard]] bool isLabel(std::size_t row, std::size_t column) const {
    return m_labelled && (row == 0 || column == 0);
  }
  [[nodiscard]] std::size_t firstRow() const { return m_labelled ? 1 : 0; }

  void setCells() {
    const SetStyle inside{m_lines ? 0 : std::max(m_style.level, 1)};
    for (std::size_t row = 0; row < m_table.cells.size(); ++row) {
      m_cells.emplace_back();
      for (std::size_t column = 0; column < m_table.cells[row].size(); ++column) {
        const bool label = isLabel(row, column);
        m_cells.back().push_back(
            setCell(m_table.cells[row][column], label ? inside.above() : inside, column));
        if (!label) continue;
        for (PlacedGlyph& glyph : m_cells.back().back().glyphs) glyph.ink = FormulaInk::label;
      }
    }
  }
  /// The lines of "aligned" go on where the cell before them ended: a relation keeps its room.
  [[nodiscard]] FormulaBox setCell(const FormulaNode& cell, SetStyle style, std::size_t column) const {
    FormulaBox box;
    const std::vector<SetAtom> atoms = setAtoms(cell.parts, style);
    if (m_lines && column % 2 == 1 && !atoms.empty()) box.width = roomBetween({}, atoms.front(), style);
    for (std::size_t i = 0; i < atoms.size(); ++i) {
      if (i > 0) box.width += roomBetween(atoms[i - 1], atoms[i], style);
      box.append(atoms[i].box);
    }
    return box;
  }

  /// Baselines from the first row's down, then all of them so that the middle of the body is on the axis.
  void placeRows() {
    double y = 0, begin = 0, end = 0;
    for (std::size_t row = 0; row < m_cells.size(); ++row) {
      const bool labels = m_labelled && row == 0;
      const double scale = labels ? kHeadSize : 1;
      double height = kStrutHeight * size() * scale, depth = kStrutDepth * size() * scale;
      for (const FormulaBox& cell : m_cells[row]) {
        height = std::max(height, cell.height + (m_lines || labels ? 0 : kLineGap / 2 * size()));
        depth = std::max(depth, cell.depth + (m_lines || labels ? 0 : kLineGap / 2 * size()));
      }
      if (row > 0 && m_lines) y += kAlignedGap * size();
      if (row == firstRow()) begin = y;
      m_heights.push_back(height);
      m_baselines.push_back(y + height);
      y += height + depth;
      end = y;
    }
    const double shift = (begin + end) / 2 + kFormulaAxis * size();
    for (double& baseline : m_baselines) baseline -= shift;
    m_top = -shift;
    m_bodyTop = begin - shift;
    m_bottom = end - shift;
    if (!m_labelled) return;
    const FormulaBox bracket = bracketBox('[', bracketTotal(), size());
    const double beyond = std::max(0.0, (bracket.height + bracket.depth - (end - begin)) / 2);
    m_top -= beyond;
    m_baselines[0] -= beyond;
  }

  void placeColumns() {
    std::size_t columns = 0;
    for (const auto& row : m_cells) columns = std::max(columns, row.size());
    double x = 0;
    for (std::size_t column = 0; column < columns; ++column) {
      double width = 0;
      for (const auto& row : m_cells) {
        if (column < row.size()) width = std::max(width, row[column].width);
      }
      x += gapBefore(column);
      m_lefts.push_back(x);
      m_widths.push_back(width);
      x += width;
    }
    m_right = x + (m_labelled ? bracketWidth() + kBracketGap * size() : m_lines ? 0 : kBracketGap * size());
  }
  [[nodiscard]] double gapBefore(std::size_t column) const {
    if (m_lines) return column > 0 && column % 2 == 0 ? 2 * size() : 0;
    if (column == 0) return (m_labelled ? kLabelLead : kBracketGap) * size();
    if (m_labelled && column == 1) return (kLabelGap + kBracketGap) * size() + bracketWidth();
    return 2 * kCellGap * (m_table.hasBar(column) ? kBarPart : 1) * size();
  }
  [[nodiscard]] double bracketTotal() const { return geargraph::bracketTotal(m_bottom - m_bodyTop, size()); }
  [[nodiscard]] double bracketWidth() const {
    return m_labelled ? bracketBox('[', bracketTotal(), size()).width : 0;
  }
  [[nodiscard]] double left(std::size_t row, std::size_t column) const {
    const double free = m_widths[column] - m_cells[row][column].width;
    const char alignment = m_labelled && column == 0 ? 'r' : m_table.alignmentOf(column);
    return m_lefts[column] + (alignment == 'r' ? free : alignment == 'c' ? free / 2 : 0);
  }

  void addRules(FormulaBox& body) const {
    const double thick = kDash * size();
    for (std::size_t column = m_labelled ? 2 : 1; column < m_lefts.size(); ++column) {
      if (!m_table.hasBar(column)) continue;
      const double x = m_lefts[column] - kCellGap * kBarPart * size();
      body.rules.push_back({x - thick / 2, m_bodyTop, thick, m_bottom - m_bodyTop, true});
    }
    for (std::size_t row = m_labelled ? 2 : 0; row < m_heights.size(); ++row) {
      if (!m_table.hasRule(row)) continue;
      body.rules.push_back({0, m_baselines[row] - m_heights[row] - thick / 2, m_right, thick});
    }
  }
  void addBrackets(FormulaBox& body) const {
    const double total = bracketTotal(), width = bracketWidth();
    if (m_table.opens) body.put(bracketBox('[', total, size()), m_lefts[1] - kBracketGap * size() - width, 0);
    if (m_table.closes) body.put(bracketBox(']', total, size()), m_right - width, 0);
  }
  [[nodiscard]] FormulaBox inParentheses(const FormulaBox& body) const {
    FormulaBox result;
    const double total = bracketTotal();
    result.append(bracketBox('(', total, size()));
    result.append(body);
    result.append(bracketBox(')', total, size()));
    return result;
  }

  const FormulaNode& m_table;
  SetStyle m_style;
  bool m_lines;
  bool m_labelled;
  std::vector<std::vector<FormulaBox>> m_cells;
  std::vector<double> m_baselines, m_heights;  ///< by row
  std::vector<double> m_lefts, m_widths;       ///< by column
  double m_top = 0, m_bodyTop = 0, m_bottom = 0, m_right = 0;
};

}  // namespace

FormulaBox setTable(const FormulaNode& table, SetStyle style) {
  return TableSetter(table, style).box();
}

std::vector<double> columnWidths(const FormulaNode& table, SetStyle style) {
  return TableSetter(table, style).widths();
}

}  // namespace geargraph
