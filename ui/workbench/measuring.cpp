#include "ui/workbench/measuring.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>

#include "core/presentation/drawing/palette.h"
#include "ui/document/document.h"
#include "ui/workbench/measured_ink.h"

namespace geargraph {
namespace {

QColor ink(ColorRole role, bool isDark) {
  const Color color = colorOf(role, isDark ? Theme::dark : Theme::light);
  return {color.red, color.green, color.blue};
}

/// "a – b"
QString nameOf(const MeasureSpots& spots, const std::vector<Measuring::Taken>& taken) {
  QStringList names;
  for (const Measuring::Taken& each : taken) names << QString::fromStdString(spots.nameOf(each.spot));
  return names.join(QStringLiteral(" – "));
}

}  // namespace

Measuring::Measuring(Document* document, QObject* parent) : QObject(parent), m_document(document) {
  connect(document, &Document::changed, this, &Measuring::follow);
}

void Measuring::setOn(bool on) {
  if (on == m_isOn) return;
  m_isOn = on;
  m_taken.clear();
  m_isMissed = false;
  renew();
  emit switched(on);
}

const MeasureSpots& Measuring::spots() {
  if (m_spots == nullptr || m_measured != m_document->geometry()) {
    m_measured = m_document->geometry();
    m_spots = std::make_unique<MeasureSpots>(m_measured);
  }
  return *m_spots;
}

bool Measuring::take(const ElementId& element, const std::optional<Vector3>& near) {
  const Spot* const spot = spots().of(element, near);
  m_isMissed = spot == nullptr;
  if (spot != nullptr) {
    if (m_taken.size() == 2) m_taken.clear();
    m_taken.push_back({element, near, *spot});
  }
  renew();
  return spot != nullptr;
}

bool Measuring::cancel() {
  if (m_taken.empty()) return false;
  m_taken.pop_back();
  m_isMissed = false;
  renew();
  return true;
}

/// The same elements in the edited document; those that are gone are given back.
void Measuring::follow() {
  if (m_taken.empty() || m_measured == m_document->geometry()) return;
  const std::vector<Taken> before = std::exchange(m_taken, {});
  for (const Taken& each : before) {
    const Spot* const spot = spots().of(each.element, each.near);
    if (spot != nullptr) m_taken.push_back({each.element, each.near, *spot});
  }
  renew();
}

void Measuring::renew() {
  m_result = m_taken.empty()       ? Measurement()
             : m_taken.size() == 1 ? measured(m_taken[0].spot)
                                   : measured(m_taken[0].spot, m_taken[1].spot);
  m_lines.clear();
  const std::string& unit = m_document->mechanism()->unit;
  for (const MeasuredValue& value : m_result.values)
    m_lines << QString::fromStdString(geargraph::nameOf(value) + ' ' + textOf(value, unit));
  emit changed();
}

QString Measuring::text() const {
  if (m_lines.isEmpty()) return {};
  return nameOf(*m_spots, m_taken) + QStringLiteral(": ") + m_lines.join(QStringLiteral(", "));
}

QString Measuring::hint() const {
  if (m_isMissed) return tr("This has no place to measure from. Click an axis, a mesh or a gear");
  if (m_taken.empty()) return tr("Measure: click an axis, a pitch point or a gear");
  if (m_taken.size() == 1)
    return tr("%1. Click a second one. Esc takes it back").arg(nameOf(*m_spots, m_taken));
  return tr("%1. Ctrl+C copies the result, Esc goes back").arg(nameOf(*m_spots, m_taken));
}

QColor measuredInk(bool isDark) {
  return ink(ColorRole::accent, isDark);
}

void paintMeasured(QPainter& painter, const std::vector<QPointF>& ends, const QStringList& lines,
                   const QRectF& seen, bool isDark) {
  if (ends.empty()) return;
  constexpr double kRing = 5, kPadding = 7, kAway = 16, kMargin = 4;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = ink(ColorRole::accent, isDark), sheet = ink(ColorRole::sheet, isDark);
  painter.setBrush(Qt::NoBrush);
  // A casing keeps line and rings apart from what they lie on.
  for (const auto& [color, width] : {std::pair{sheet, 5.0}, std::pair{accent, 2.0}}) {
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
    if (ends.size() > 1) painter.drawLine(ends.front(), ends.back());
    for (const QPointF& end : ends) painter.drawEllipse(end, kRing, kRing);
  }
  if (!lines.isEmpty()) {
    const QFontMetricsF metrics(painter.font());
    double wide = 0;
    for (const QString& line : lines) wide = std::max(wide, metrics.horizontalAdvance(line));
    const QSizeF size(wide + 2 * kPadding, metrics.lineSpacing() * lines.size() + kPadding);
    const QPointF middle = (ends.front() + ends.back()) / 2;
    QRectF plate(middle + QPointF(kAway, -kAway - size.height()), size);
    plate.moveLeft(std::clamp(plate.left(), seen.left() + kMargin,
                              std::max(seen.left() + kMargin, seen.right() - size.width() - kMargin)));
    plate.moveTop(std::clamp(plate.top(), seen.top() + kMargin,
                             std::max(seen.top() + kMargin, seen.bottom() - size.height() - kMargin)));
    painter.setPen(QPen(accent, 1));
    painter.setBrush(sheet);
    painter.drawRoundedRect(plate, 5, 5);
    painter.setPen(ink(ColorRole::ink, isDark));
    QPointF base = plate.topLeft() + QPointF(kPadding, kPadding / 2 + metrics.ascent());
    for (const QString& line : lines) {
      painter.drawText(base, line);
      base.ry() += metrics.lineSpacing();
    }
  }
  painter.restore();
}

}  // namespace geargraph

#include "moc_measuring.cpp"
