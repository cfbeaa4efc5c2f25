#include "ui/panels/ratio_text.h"

#include <QCoreApplication>
#include <QGlyphRun>
#include <QHash>
#include <QPainter>
#include <QRawFont>
#include <QVector>
#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace geargraph {
namespace {

enum Face { kUpright, kItalic, kLowered, kFaces };
constexpr qsizetype kMaxKept = 200'000;  // glyphs of all formulas, 20 bytes each
constexpr QChar kMinus(0x2212);

/// The glyphs of a formula in one face, from the left to the right.
struct Glyphs {
  QVector<quint32> indexes;
  QVector<QPointF> places;  ///< logical pixels, from the beginning of the formula's base line
};

struct SetFormula {
  std::array<Glyphs, kFaces> glyphs;
  double advance = 0;
};

/// Sets formulas in one font, and keeps them: a table paints and measures hundreds at a time, with as many
/// factors as there are meshes between two joints.
class Setter {
 public:
  explicit Setter(const QFont& font) : m_font(font) {
    std::array<QFont, kFaces> faces{font, font, font};
    faces[kItalic].setFamilies({QStringLiteral("KaTeX_Math"), QStringLiteral("DejaVu Serif"), font.family()});
    faces[kItalic].setItalic(true);
    faces[kLowered].setPixelSize(qMax(8, qRound(font.pixelSize() * 0.75)));
    for (int face = 0; face < kFaces; ++face) m_faces[face] = QRawFont::fromFont(faces[face]);
  }

  [[nodiscard]] const QFont& font() const { return m_font; }
  [[nodiscard]] const QRawFont& face(int face) const { return m_faces[face]; }
  [[nodiscard]] const SetFormula& operator()(const QString& formula) {
    const auto known = m_kept.constFind(formula);
    if (known != m_kept.constEnd()) return *known;
    if (m_glyphs > kMaxKept) {
      m_kept.clear();
      m_glyphs = 0;
    }
    const SetFormula& made = *m_kept.insert(formula, set(formula));
    for (const Glyphs& ofFace : made.glyphs) m_glyphs += ofFace.indexes.size();
    return made;
  }

 private:
  [[nodiscard]] SetFormula set(const QString& formula) const {
    SetFormula result;
    const double drop = m_font.pixelSize() * 0.2;
    for (qsizetype i = 0; i < formula.size(); ++i) {
      const QChar letter = formula[i];
      if (letter.isLetter()) {
        put(letter, kItalic, 0, result);
        qsizetype end = i + 1;
        while (end < formula.size() && formula[end].isDigit()) ++end;
        put(formula.mid(i + 1, end - i - 1), kLowered, drop, result);
        i = end - 1;
      } else if (letter == QLatin1Char('*')) {
        result.advance += m_font.pixelSize() * 0.16;
      } else {
        const bool isMinus = letter == QLatin1Char('-') && m_faces[kUpright].supportsCharacter(kMinus);
        put(isMinus ? QString(kMinus) : QString(letter), kUpright, 0, result);
      }
    }
    return result;
  }

  void put(const QString& text, Face face, double drop, SetFormula& result) const {
    const QRawFont& raw = m_faces[face];
    const QVector<quint32> indexes = raw.glyphIndexesForString(text);
    const QVector<QPointF> advances = raw.advancesForGlyphIndexes(indexes);
    for (qsizetype i = 0; i < indexes.size(); ++i) {
      result.glyphs[face].indexes << indexes[i];
      result.glyphs[face].places << QPointF(result.advance, drop);
      result.advance += advances[i].x();
    }
  }

  QFont m_font;
  std::array<QRawFont, kFaces> m_faces;
  QHash<QString, SetFormula> m_kept;
  qsizetype m_glyphs = 0;  ///< in m_kept
};

/// For the font of the last formula: one table has one font.
Setter& setterFor(const QFont& font) {
  static std::unique_ptr<Setter> setter;
  if (setter == nullptr) qAddPostRoutine([] { setter.reset(); });  // before the fonts go
  if (setter == nullptr || setter->font() != font) setter = std::make_unique<Setter>(font);
  return *setter;
}

}  // namespace

double paintRatios(QPainter* painter, const QFont& font, const QPointF& at, const QString& formula) {
  Setter& setter = setterFor(font);
  const SetFormula& set = setter(formula);
  if (painter == nullptr) return set.advance;
  const double end = painter->hasClipping() ? painter->clipBoundingRect().right() - at.x()
                                            : std::numeric_limits<double>::infinity();
  for (int face = 0; face < kFaces; ++face) {
    const auto& [indexes, places] = set.glyphs[face];
    const auto seen = std::partition_point(places.begin(), places.end(),
                                           [end](const QPointF& place) { return place.x() < end; });
    QGlyphRun run;
    run.setRawFont(setter.face(face));
    run.setRawData(indexes.constData(), places.constData(), static_cast<int>(seen - places.begin()));
    painter->drawGlyphRun(at, run);
  }
  return set.advance;
}

}  // namespace geargraph
