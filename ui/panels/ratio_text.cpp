#include "ui/panels/ratio_text.h"

#include <QFontMetricsF>
#include <QPainter>

namespace geargraph::inline panels {
namespace {

struct Faces {
  QFont upright;
  QFont italic;
  QFont lowered;
};

Faces facesFor(const QFont& font) {
  Faces faces{font, font, font};
  faces.italic.setFamilies({QStringLiteral("KaTeX_Math"), QStringLiteral("DejaVu Serif"), font.family()});
  faces.italic.setItalic(true);
  faces.lowered.setPixelSize(qMax(8, qRound(font.pixelSize() * 0.75)));
  return faces;
}

}  // namespace

double paintRatios(QPainter* painter, const QFont& font, const QPointF& at, const QString& formula) {
  const Faces faces = facesFor(font);
  double x = 0;
  const auto put = [&](const QString& text, const QFont& face, double drop) {
    if (painter != nullptr) {
      painter->setFont(face);
      painter->drawText(at + QPointF(x, drop), text);
    }
    x += QFontMetricsF(face).horizontalAdvance(text);
  };
  const double drop = font.pixelSize() * 0.2;
  for (qsizetype i = 0; i < formula.size(); ++i) {
    const QChar letter = formula[i];
    if (letter.isLetter()) {
      put(letter, faces.italic, 0);
      qsizetype end = i + 1;
      while (end < formula.size() && formula[end].isDigit()) ++end;
      put(formula.mid(i + 1, end - i - 1), faces.lowered, drop);
      i = end - 1;
    } else if (letter == QLatin1Char('*')) {
      x += font.pixelSize() * 0.16;
    } else {
      put(letter == QLatin1Char('-') ? QStringLiteral("−") : QString(letter), faces.upright, 0);
    }
  }
  return x;
}

}  // namespace geargraph::inline panels
