#include "ui/reading/flow_painter.h"

#include <algorithm>
#include <cmath>

#include "core/presentation/drawing/svg_writer.h"
#include "ui/canvas/mark_painter.h"

namespace geargraph {
namespace {

QFont fontOf(const QFont& base, const TextStyle& style) {
  QFont font = base;
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(style.size))));
  font.setBold(style.bold);
  return font;
}

void paintCurves(QPainter& painter, const FlowFigure& figure, QPointF origin, Theme theme) {
  const Extent sheet = sheetOf(*figure.curves, {});
  const double scale = figure.width / (2 * sheet.halfWidth);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(origin + QPointF(figure.x, 0));
  painter.scale(scale, scale);
  painter.translate(-sheet.left(), -sheet.top());
  paintMarks(painter, figure.curves->marks, theme, scale);
  painter.restore();
}

}  // namespace

double FontMeasure::widthOf(std::string_view utf8, const TextStyle& style) const {
  const std::pair key{std::lround(style.size), style.bold};
  auto found = m_words.find(key);
  if (found == m_words.end())
    found = m_words.emplace(key, Words{QFontMetricsF(fontOf(m_base, style)), {}}).first;
  Words& words = found->second;
  const auto known = words.widths.find(utf8);
  if (known != words.widths.end()) return known->second;
  const double width =
      words.metrics.horizontalAdvance(QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())));
  constexpr std::size_t kMaxWords = 20000;
  if (words.widths.size() >= kMaxWords) words.widths.clear();
  words.widths.emplace(utf8, width);
  return width;
}

void FlowPainter::paint(QPainter& painter, const FlowLine& line, QPointF origin, const QFont& base,
                        const Colors& colors, double hair) {
  for (const FlowRule& rule : line.rules) {
    const QPointF from = origin + QPointF(rule.x, rule.y);
    painter.fillRect(QRectF(from.x(), std::floor(from.y()), rule.width, hair), colors.hairline);
  }
  for (const FlowWords& words : line.words) {
    painter.setFont(fontOf(base, words.style));
    painter.setPen(words.style.soft ? colors.soft : colors.ink);
    painter.drawText(origin + QPointF(words.x, std::round(words.y)), QString::fromStdString(words.text));
  }
  for (const FlowFormula& formula : line.formulas) {
    m_formulas.paint(painter, *formula.box, origin + QPointF(formula.x, std::round(formula.y)), formula.size,
                     {colors.ink, colors.soft});
  }
  if (line.figure && line.figure->curves) paintCurves(painter, *line.figure, origin, colors.theme);
}

}  // namespace geargraph
