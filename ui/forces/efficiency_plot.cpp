#include "ui/forces/efficiency_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "ui/models/printed_number.h"
#include "ui/theme/application_theme.h"
#include "ui/view3d/motion_plot.h"

namespace geargraph {
namespace {

constexpr double kLeft = 52, kTop = 22, kBelow = 34, kRight = 12;  // logical pixels

QString number(double value) {
  return printedNumber(std::abs(value) < 1e-12 ? 0 : value, 5);
}

}  // namespace

EfficiencyPlot::EfficiencyPlot(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::TabFocus);
  setMinimumSize(180, 96);
  setAccessibleName(tr("Plot of the efficiency"));
  setToolTip(tr("The pointer, or the left and right arrow keys, read the values"));
}

void EfficiencyPlot::setSheet(Sheet sheet) {
  m_sheet = std::move(sheet);
  m_read.reset();
  bool any = false;
  for (const Line& line : m_sheet.lines) {
    for (const std::optional<double>& value : line.values) {
      if (!value) continue;
      m_low = any ? std::min(m_low, *value) : *value;
      m_high = any ? std::max(m_high, *value) : *value;
      any = true;
    }
  }
  if (!any) {
    m_low = 0;
    m_high = 1;
  }
  const double margin = std::max(0.06 * (m_high - m_low), 1e-3 * std::max(1.0, std::abs(m_high)));
  m_low -= margin;
  m_high += margin;
  setAccessibleDescription({});
  update();
}

QRectF EfficiencyPlot::area() const {
  return {kLeft, kTop, std::max(1.0, width() - kLeft - kRight), std::max(1.0, height() - kTop - kBelow)};
}

QPointF EfficiencyPlot::placeOf(double place, double value) const {
  const QRectF room = area();
  const double from = m_sheet.places.empty() ? 0 : m_sheet.places.front();
  const double to = m_sheet.places.empty() ? 1 : m_sheet.places.back();
  return {room.left() + (place - from) / (to - from) * room.width(),
          room.bottom() - (value - m_low) / (m_high - m_low) * room.height()};
}

void EfficiencyPlot::paintAxes(QPainter& painter) const {
  const Theme theme = themeOf(palette());
  const QRectF room = area();
  const QColor hair = qColor(ColorRole::hairline, theme);
  const QColor words = qColor(ColorRole::secondary, theme);
  if (m_sheet.places.size() < 2) return;
  for (const double tick : niceTicks(m_low, m_high, std::max(2, static_cast<int>(room.height() / 28)))) {
    const double y = placeOf(m_sheet.places.front(), tick).y();
    painter.setPen(hair);
    painter.drawLine(QPointF(room.left(), y), QPointF(room.right(), y));
    painter.setPen(words);
    painter.drawText(QRectF(0, y - 10, kLeft - 6, 20), Qt::AlignRight | Qt::AlignVCenter, number(tick));
  }
  const int most = std::max(2, static_cast<int>(room.width() / 70));
  for (const double tick : niceTicks(m_sheet.places.front(), m_sheet.places.back(), most)) {
    const double x = placeOf(tick, m_low).x();
    painter.setPen(hair);
    painter.drawLine(QPointF(x, room.top()), QPointF(x, room.bottom()));
    painter.setPen(words);
    painter.drawText(QRectF(x - 30, room.bottom() + 1, 60, 16), Qt::AlignCenter, number(tick));
  }
  painter.setPen(words);
  painter.drawText(QRectF(room.left(), room.bottom() + 16, room.width(), 16), Qt::AlignCenter,
                   m_sheet.across);
}

void EfficiencyPlot::paintLine(QPainter& painter, const Line& line) const {
  QPainterPath path;
  bool isOpen = false;
  for (std::size_t i = 0; i < line.values.size(); ++i) {
    if (!line.values[i]) {
      isOpen = false;
      continue;
    }
    const QPointF at = placeOf(m_sheet.places[i], *line.values[i]);
    isOpen ? path.lineTo(at) : path.moveTo(at);
    isOpen = true;
  }
  painter.setPen(QPen(qColor(line.colour, themeOf(palette())), 1.8, line.style));
  painter.drawPath(path);
}

/// The names stand above the plot, each after a piece of its line; with the values at the hair line.
void EfficiencyPlot::paintLegend(QPainter& painter) const {
  const Theme theme = themeOf(palette());
  double x = kLeft;
  for (const Line& line : m_sheet.lines) {
    painter.setPen(QPen(qColor(line.colour, theme), 1.8, line.style));
    painter.drawLine(QPointF(x, kTop / 2), QPointF(x + 24, kTop / 2));
    QString text = line.name;
    if (m_read && line.values[*m_read]) text += QStringLiteral(" ") + number(*line.values[*m_read]);
    painter.setPen(qColor(ColorRole::ink, theme));
    const double width = painter.fontMetrics().horizontalAdvance(text);
    painter.drawText(QRectF(x + 30, 0, width + 4, kTop), Qt::AlignVCenter, text);
    x += 30 + width + 22;
  }
  painter.setPen(qColor(ColorRole::secondary, theme));
  painter.drawText(QRectF(x, 0, std::max(0.0, width() - kRight - x), kTop), Qt::AlignRight | Qt::AlignVCenter,
                   m_sheet.up);
}

void EfficiencyPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Theme theme = themeOf(palette());
  paintAxes(painter);
  const QRectF room = area();
  painter.save();
  painter.setClipRect(room.adjusted(-1, -1, 1, 1));
  const auto vertical = [&](double place, ColorRole role, Qt::PenStyle style) {
    painter.setPen(QPen(qColor(role, theme), 1, style));
    painter.drawLine(placeOf(place, m_low), placeOf(place, m_high));
  };
  if (m_sheet.now && m_sheet.places.size() > 1) vertical(*m_sheet.now, ColorRole::input, Qt::DashLine);
  if (m_read) vertical(m_sheet.places[*m_read], ColorRole::secondary, Qt::SolidLine);
  for (const Line& line : m_sheet.lines) paintLine(painter, line);
  painter.restore();
  paintLegend(painter);
  if (!hasFocus()) return;
  painter.setPen(QPen(qColor(ColorRole::accent, theme), 2));
  painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

QString EfficiencyPlot::reading() const {
  if (!m_read) return {};
  QStringList parts{tr("%1 %2").arg(m_sheet.across, number(m_sheet.places[*m_read]))};
  for (const Line& line : m_sheet.lines) {
    const std::optional<double>& value = line.values[*m_read];
    parts += tr("%1 %2").arg(line.name, value ? number(*value) : tr("none"));
  }
  return parts.join(QStringLiteral(", "));
}

void EfficiencyPlot::readAt(std::optional<std::size_t> index) {
  if (index == m_read) return;
  m_read = index;
  setAccessibleDescription(reading());
  update();
}

void EfficiencyPlot::mouseMoveEvent(QMouseEvent* event) {
  if (m_sheet.places.size() < 2) return;
  const QRectF room = area();
  const double share = std::clamp((event->position().x() - room.left()) / room.width(), 0.0, 1.0);
  readAt(static_cast<std::size_t>(std::lround(share * static_cast<double>(m_sheet.places.size() - 1))));
}

void EfficiencyPlot::leaveEvent(QEvent*) {
  readAt(std::nullopt);
}

void EfficiencyPlot::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  readAt(std::nullopt);
}

void EfficiencyPlot::keyPressEvent(QKeyEvent* event) {
  const int step = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  const auto count = static_cast<int>(m_sheet.places.size());
  if (step == 0 || count == 0) return QWidget::keyPressEvent(event);
  const int at = m_read ? static_cast<int>(*m_read) + step : step > 0 ? 0 : count - 1;
  readAt(static_cast<std::size_t>(std::clamp(at, 0, count - 1)));
}

}  // namespace geargraph

#include "moc_efficiency_plot.cpp"
