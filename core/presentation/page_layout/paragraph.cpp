#include "core/presentation/page_layout/paragraph.h"

#include <algorithm>

#include "core/presentation/typeset/font_face.h"

namespace geargraph {
namespace {

bool isBlank(char c) {
  return static_cast<unsigned char>(c) <= ' ';
}

/// Words or a formula, with no place to break.
struct Piece {
  std::string text;
  std::shared_ptr<const FormulaBox> formula;
  double width = 0;
};
/// Pieces between two blanks.
using Chunk = std::vector<Piece>;

class ParagraphBreaker {
 public:
  ParagraphBreaker(const SetReport& report, const TextStyle& style, const FlowParameters& flow,
                   const WordMeasure& measure, double x, double width)
      : m_report(report), m_style(style), m_flow(flow), m_measure(measure), m_x(x), m_width(width) {}

  std::vector<FlowLine> linesOf(const ReportWords& words) {
    m_blank = m_measure.widthOf(" ", m_style);
    for (const Chunk& chunk : chunksOf(words)) place(chunk);
    if (!m_pieces.empty() || m_lines.empty()) endLine();
    return std::move(m_lines);
  }

 private:
  [[nodiscard]] std::vector<Chunk> chunksOf(const ReportWords& words) const {
    std::vector<Chunk> chunks;
    bool isOpen = false;  // does the next piece belong to the last chunk?
    const auto add = [&](Piece piece) {
      if (!isOpen) chunks.emplace_back();
      chunks.back().push_back(std::move(piece));
      isOpen = true;
    };
    for (const ReportSpan& span : words) {
      if (span.isFormula) {
        const auto& box = m_report.inLine(span.text);
        add({{}, box, box->width * m_flow.formulaSize * m_style.size / m_flow.size});
        continue;
      }
      std::string_view rest = span.text;
      while (!rest.empty()) {
        if (isBlank(rest.front())) {
          isOpen = false;
          rest.remove_prefix(1);
          continue;
        }
        const auto end = std::find_if(rest.begin(), rest.end(), isBlank);
        const std::string word(rest.begin(), end);
        add({word, nullptr, m_measure.widthOf(word, m_style)});
        rest.remove_prefix(word.size());
      }
    }
    return chunks;
  }

  void place(const Chunk& chunk) {
    double width = 0;
    for (const Piece& piece : chunk) width += piece.width;
    const double blank = m_pieces.empty() ? 0 : m_blank;
    if (!m_pieces.empty() && m_used + blank + width > m_width) endLine();
    if (m_pieces.empty() && width > m_width) return placeTorn(chunk);
    if (!m_pieces.empty()) put({" ", nullptr, m_blank});
    for (const Piece& piece : chunk) put(piece);
  }

  /// Character by character.
  void placeTorn(const Chunk& chunk) {
    for (const Piece& piece : chunk) {
      if (piece.formula) {
        if (m_used + piece.width > m_width && !m_pieces.empty()) endLine();
        put(piece);
        continue;
      }
      std::string_view rest = piece.text;
      while (!rest.empty()) {
        std::string_view after = rest;
        (void)takeCharacter(after);
        const std::string character(rest.substr(0, rest.size() - after.size()));
        const double width = m_measure.widthOf(character, m_style);
        if (m_used + width > m_width && !m_pieces.empty()) endLine();
        put({character, nullptr, width});
        rest = after;
      }
    }
  }

  void put(const Piece& piece) {
    if (!piece.formula && !m_pieces.empty() && !m_pieces.back().formula) {
      m_pieces.back().text += piece.text;
      m_pieces.back().width += piece.width;
    } else {
      m_pieces.push_back(piece);
    }
    m_used += piece.width;
  }

  void endLine() {
    const double em = m_flow.formulaSize * m_style.size / m_flow.size;
    double ascent = kAscent * m_style.size, descent = (kLeading - kAscent) * m_style.size;
    for (const Piece& piece : m_pieces) {
      if (!piece.formula) continue;
      ascent = std::max(ascent, (piece.formula->height + 0.1) * em);
      descent = std::max(descent, (piece.formula->depth + 0.15) * em);
    }
    FlowLine line;
    line.height = ascent + descent;
    double x = m_x;
    for (Piece& piece : m_pieces) {
      if (piece.formula) {
        line.formulas.push_back({piece.formula, x, ascent, em});
      } else {
        line.words.push_back({std::move(piece.text), x, ascent, m_style});
      }
      x += piece.width;
    }
    m_lines.push_back(std::move(line));
    m_pieces.clear();
    m_used = 0;
  }

  const SetReport& m_report;
  TextStyle m_style;
  const FlowParameters& m_flow;
  const WordMeasure& m_measure;
  double m_x, m_width;
  double m_blank = 0;
  double m_used = 0;
  std::vector<Piece> m_pieces;  ///< of the line that is being filled
  std::vector<FlowLine> m_lines;
};

}  // namespace

std::vector<FlowLine> paragraphLines(const SetReport& report, const ReportWords& words,
                                     const TextStyle& style, const FlowParameters& flow,
                                     const WordMeasure& measure, double x, double width) {
  return ParagraphBreaker(report, style, flow, measure, x, width).linesOf(words);
}

}  // namespace geargraph
