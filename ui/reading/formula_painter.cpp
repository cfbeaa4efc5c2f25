#include "ui/reading/formula_painter.h"

#include <QGlyphRun>
#include <cmath>

#include "core/foundations/base/contract.h"

namespace geargraph {
namespace {

constexpr std::size_t kMaxFonts = 200;  // before sizes that were zoomed through are forgotten

QRawFont faceOf(FontFace face, double pixels) {
  const auto file = fontFile(face);
  const auto bytes = QByteArray::fromRawData(reinterpret_cast<const char*>(file.data()),  // NOLINT: bytes
                                             static_cast<qsizetype>(file.size()));
  QRawFont font(bytes, pixels, QFont::PreferNoHinting);
  GEARGRAPH_REQUIRE(font.isValid());
  return font;
}

}  // namespace

const QRawFont& FormulaPainter::fontOf(FontFace face, double pixels) {
  const std::pair key{face, static_cast<int>(std::lround(100 * pixels))};
  if (const auto found = m_fonts.find(key); found != m_fonts.end()) return found->second;
  if (m_fonts.size() > kMaxFonts) m_fonts.clear();
  return m_fonts.emplace(key, faceOf(face, key.second / 100.0)).first->second;
}

void FormulaPainter::paint(QPainter& painter, const FormulaBox& box, QPointF origin, double size,
                           const Colors& colors) {
  for (std::size_t i = 0; i < box.glyphs.size();) {
    const PlacedGlyph& first = box.glyphs[i];
    QList<quint32> glyphs;
    QList<QPointF> places;
    for (; i < box.glyphs.size(); ++i) {
      const PlacedGlyph& glyph = box.glyphs[i];
      if (glyph.face != first.face || glyph.size != first.size || glyph.ink != first.ink) break;
      glyphs.append(glyph.glyph);
      places.append(QPointF(glyph.x * size, glyph.y * size));
    }
    QGlyphRun run;
    run.setRawFont(fontOf(first.face, first.size * size));
    run.setGlyphIndexes(glyphs);
    run.setPositions(places);
    painter.setPen(first.ink == FormulaInk::label ? colors.label : colors.ink);
    painter.drawGlyphRun(origin, run);
  }
  for (const PlacedRule& rule : box.rules) {
    const QRectF area(origin.x() + rule.x * size, origin.y() + rule.y * size, rule.width * size,
                      rule.height * size);
    if (rule.dashed) {
      QPen pen(colors.label, 1);
      pen.setDashPattern({4, 3});
      painter.setPen(pen);
      const double x = std::round(area.center().x()) + 0.5;
      painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    } else {
      const double y = std::round(area.center().y());
      painter.fillRect(QRectF(area.left(), y, area.width(), std::max(1.0, std::round(area.height()))),
                       colors.ink);
    }
  }
}

}  // namespace geargraph
