#include "ui/panels/rate_label.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QtMath>

namespace geargraph {
namespace {
const QString kTheta = QStringLiteral("θ");
constexpr int kLeastLetters = 12;  // "link 4" and the beginning of its name
}

double paintRate(QPainter* painter, const QFont& font, const QPointF& at, const QString& joint) {
  const QFontMetricsF metrics(font);
  const double theta = metrics.horizontalAdvance(kTheta);
  QFont below = font;
  below.setPixelSize(qMax(8, qRound(font.pixelSize() * 0.78)));
  const double subscript = QFontMetricsF(below).horizontalAdvance(joint);
  if (painter != nullptr) {
    painter->save();
    painter->setFont(font);
    painter->drawText(at, kTheta);
    const QRectF glyph = metrics.tightBoundingRect(kTheta).translated(at);
    const double radius = font.pixelSize() * 0.075;
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(painter->pen().color());
    const QPointF dot(glyph.center().x(), glyph.top() - 2.2 * radius);
    painter->setPen(Qt::NoPen);
    painter->drawEllipse(dot, radius, radius);
    painter->restore();
    painter->save();
    painter->setFont(below);
    painter->drawText(at + QPointF(theta + 0.5, font.pixelSize() * 0.16), joint);
    painter->restore();
  }
  return theta + subscript + 1;
}

RateLabel::RateLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void RateLabel::setRate(const QString& joint, const QString& words) {
  m_joint = joint;
  m_words = words;
  updateGeometry();
  update();
}

/// The size for words of this width, in pixels.
QSize RateLabel::withWords(double width) const {
  return {qCeil(paintRate(nullptr, font(), {}, m_joint) + width) + 2,
          qCeil(QFontMetricsF(font()).height()) + 4};
}

QSize RateLabel::sizeHint() const {
  return withWords(m_words.isEmpty() ? 0
                                     : QFontMetricsF(font()).horizontalAdvance(QLatin1Char(' ') + m_words));
}

QSize RateLabel::minimumSizeHint() const {
  return sizeHint().boundedTo(withWords(kLeastLetters * QFontMetricsF(font()).averageCharWidth()));
}

void RateLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::WindowText));
  const QFontMetricsF metrics(font());
  const double base = (height() + metrics.ascent() - metrics.descent()) / 2;
  const double advance = paintRate(&painter, font(), QPointF(0, base), m_joint);
  painter.setFont(font());
  painter.drawText(QPointF(advance, base),
                   metrics.elidedText(QLatin1Char(' ') + m_words, Qt::ElideRight, width() - advance));
}

}  // namespace geargraph

#include "moc_rate_label.cpp"
