#include "ui/view3d/motion_plot.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/models/printed_number.h"
#include "ui/theme/theme_colors.h"

namespace geargraph {
namespace {

constexpr int kLeft = 50, kTop = 24, kBelow = 34, kLegend = 160, kRight = 8;  // px at the normal type size
constexpr int kLegendInset = 112;  // px of a legend without its names: a piece of the curve, and the value
constexpr int kLeastWithLegend = 360;
constexpr double kSeenAtFirst = 40;  // s: of a long period all would be a wall of lines
constexpr double kZoomPerNotch = 1.25;
constexpr double kNearest = 1e-4;  // of the whole time: no nearer
constexpr int kDragBegins = 4;
constexpr double kUnseen = 0.2;  // px, that a curve may be off
constexpr std::size_t kMaxFineCurves = 40;
constexpr double kMaxFineLength = 20'000;  // px, of all curves together
constexpr double kMargin = 0.08;           // share of the range of values that is added above and below

QString text(double value, int digits = 5) {
  return printedNumber(std::abs(value) < 1e-12 ? 0 : value, digits);
}

bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < 128;
}

/// "joint 12 (carrier)" in so much room: the label of the joint is seen, whatever happens to the name.
QString shortened(const QString& name, int room, const QFontMetrics& metrics) {
  if (metrics.horizontalAdvance(name) <= room) return name;
  const QString label = name.section(QStringLiteral(" ("), 0, 0);
  const QString elided = metrics.elidedText(name, Qt::ElideRight, room);
  if (elided.size() > label.size() + 3) return elided;
  return metrics.elidedText(label, Qt::ElideMiddle, room);
}

}  // namespace

std::vector<double> niceTicks(double low, double high, int most) {
  const double rough = (high - low) / most;
  const double decade = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * decade;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= rough) {
      step = factor * decade;
      break;
    }
  }
  std::vector<double> ticks;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push_back(k * step);
  return ticks;
}

std::vector<QPointF> simplified(const std::vector<QPointF>& points, double tolerance) {
  if (points.size() < 3) return points;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<QPointF> kept{points.front()};
  QPointF before = points.front();
  double low = -kInfinity;  // slopes from the last kept point that pass all since
  double high = kInfinity;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const QPointF& point = points[i];
    const auto slopeTo = [&](double y) { return (y - kept.back().y()) / (point.x() - kept.back().x()); };
    const double slope = slopeTo(point.y());
    if (!(slope >= low && slope <= high)) {
      kept.push_back(before);
      low = -kInfinity;
      high = kInfinity;
    }
    low = std::max(low, slopeTo(point.y() - tolerance));
    high = std::min(high, slopeTo(point.y() + tolerance));
    before = point;
  }
  kept.push_back(before);
  return kept;
}

MotionPlot::MotionPlot(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setMinimumSize(260, 96);
  setToolTip(tr("Wheel: zoom in time; Ctrl+wheel: in value; drag: move; click: go there; double click: all"));
}

void MotionPlot::setSheet(const CurveSheet& sheet) {
  const bool sameTimes =
      !m_sheet.times.empty() && !sheet.times.empty() && m_sheet.times.back() == sheet.times.back();
  m_sheet = sheet;
  ++m_sheetNumber;
  if (!sameTimes) m_times = {0, sheet.times.empty() ? 1 : std::min(sheet.times.back(), kSeenAtFirst)};
  fitValues();
  m_longestName = 0;
  for (const MotionCurve& curve : sheet.curves) {
    const QString name = QString::fromStdString(curve.name);
    m_longestName = std::max(m_longestName, fontMetrics().horizontalAdvance(name));
  }
  update();
}

void MotionPlot::setTime(double seconds) {
  if (seconds == m_time) return;
  m_time = seconds;
  update();
}

void MotionPlot::showAll() {
  m_times = {0, m_sheet.times.empty() ? 1 : m_sheet.times.back()};
  fitValues();
  update();
}

void MotionPlot::fitValues() {
  Range range{0, 0};  // zero is always seen: a speed is read against it
  for (const MotionCurve& curve : m_sheet.curves) {
    for (const double value : curve.values) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  const double margin = range.size() > 0 ? kMargin * range.size() : 1;
  m_values = {range.low < 0 ? range.low - margin : 0, range.high + margin};
}

/// As wide as the longest name asks for, but a third of the plot at most where that is wider than usual.
double MotionPlot::legendWidth() const {
  const double usual = scaledPixels(kLegend);
  const double wanted = scaledPixels(kLegendInset) + m_longestName;
  return std::clamp(wanted, usual, std::max(usual, width() / 3.0));
}

QRectF MotionPlot::area() const {
  const bool hasLegend = width() > scaledPixels(kLeastWithLegend);
  return QRectF(rect()).adjusted(scaledPixels(kLeft), scaledPixels(kTop),
                                 -(hasLegend ? legendWidth() : scaledPixels(kRight)), -scaledPixels(kBelow));
}

QPointF MotionPlot::placeOf(double time, double value) const {
  return placeOf(time, value, area());
}

QPointF MotionPlot::placeOf(double time, double value, const QRectF& inside) const {
  return {inside.left() + (time - m_times.low) / m_times.size() * inside.width(),
          inside.bottom() - (value - m_values.low) / m_values.size() * inside.height()};
}

double MotionPlot::timeAt(double x) const {
  return m_times.low + (x - area().left()) / area().width() * m_times.size();
}

// Colours of links are made for shapes; a line on a dark ground has to be lighter to be seen.
QColor MotionPlot::inkOf(const MotionCurve& curve) const {
  const QColor own = QColor::fromRgbF(curve.colour.red, curve.colour.green, curve.colour.blue);
  return isDark(palette()) && own.lightness() < 120 ? own.lighter(125) : own;
}

double MotionPlot::valueAt(const MotionCurve& curve, double time) const {
  const std::vector<double>& times = m_sheet.times;
  const auto next = std::upper_bound(times.begin(), times.end(), time);
  if (next == times.begin()) return curve.values.front();
  if (next == times.end()) return curve.values.back();
  const auto after = static_cast<std::size_t>(next - times.begin());
  const double part = (time - times[after - 1]) / (times[after] - times[after - 1]);
  return (1 - part) * curve.values[after - 1] + part * curve.values[after];
}

void MotionPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (m_sheet.times.size() < 2) return;
  updatePainted();
  painter.drawPixmap(0, 0, m_painted.picture);
  paintMoments(painter);
  paintLegend(painter);
}

/// Axes and curves are kept as a picture: while the motion plays only the moment moves over them.
void MotionPlot::updatePainted() {
  Painted wanted{
      {},    m_sheetNumber, m_times, m_values, size(), devicePixelRatioF(), palette().color(QPalette::Base),
      font()};
  if (!m_painted.picture.isNull() && m_painted.looksLike(wanted)) return;
  m_painted = std::move(wanted);
  m_painted.picture = QPixmap((QSizeF(size()) * m_painted.ratio).toSize());
  m_painted.picture.setDevicePixelRatio(m_painted.ratio);
  m_painted.picture.fill(m_painted.ground);
  QPainter painter(&m_painted.picture);
  painter.setFont(font());
  painter.setRenderHint(QPainter::Antialiasing);
  paintAxes(painter);
  paintCurves(painter);
}

void MotionPlot::paintAxes(QPainter& painter) const {
  const QRectF inside = area();
  const QColor ink = palette().color(QPalette::Text),
               quiet = qColor(ColorRole::secondary, themeOf(palette()));
  const QColor hair = qColor(ColorRole::hairline, themeOf(palette()));
  painter.setPen(ink);
  painter.drawText(
      QRectF(inside.left(), 2, inside.width(), scaledPixels(kTop) - 4), Qt::AlignLeft | Qt::AlignVCenter,
      tr("%1, %2").arg(QString::fromStdString(m_sheet.title), QString::fromStdString(m_sheet.unit)));
  for (const double tick :
       niceTicks(m_values.low, m_values.high, qMax(2, qRound(inside.height() / scaledPixels(34))))) {
    const double y = placeOf(0, tick).y();
    painter.setPen(QPen(tick == 0 ? quiet : hair, 1));
    painter.drawLine(QPointF(inside.left(), y), QPointF(inside.right(), y));
    painter.setPen(quiet);
    painter.drawText(QRectF(0, y - scaledPixels(9), scaledPixels(kLeft) - 6, scaledPixels(18)),
                     Qt::AlignRight | Qt::AlignVCenter, text(tick));
  }
  for (const double tick :
       niceTicks(m_times.low, m_times.high, qMax(2, qRound(inside.width() / scaledPixels(80))))) {
    const double x = placeOf(tick, 0).x();
    painter.setPen(QPen(hair, 1));
    painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
    painter.setPen(quiet);
    painter.drawText(QRectF(x - scaledPixels(40), inside.bottom() + 1, scaledPixels(80), scaledPixels(16)),
                     Qt::AlignHCenter | Qt::AlignTop, text(tick));
  }
  painter.drawText(QRectF(inside.left(), inside.bottom() + 15, inside.width(), 18), Qt::AlignHCenter,
                   tr("time, s"));
}

void MotionPlot::paintCurves(QPainter& painter) const {
  painter.save();
  const QRectF inside = area();
  painter.setClipRect(inside);
  std::vector<QPolygonF> lines;
  double length = 0;
  for (const MotionCurve& curve : m_sheet.curves) {
    std::vector<QPointF> points;
    for (std::size_t i = 0; i < curve.values.size(); ++i)
      points.push_back(placeOf(m_sheet.times[i], curve.values[i], inside));
    QPolygonF line{points.front()};
    for (const QPointF& point : simplified(points, kUnseen)) {
      length += QLineF(line.back(), point).length();
      line << point;
    }
    lines.push_back(std::move(line));
  }
  // Many curves, and those with many turns, hide their style, and wide lines with gaps take a hundred times
  // as long.
  const bool isFine = m_sheet.curves.size() <= kMaxFineCurves && length <= kMaxFineLength;
  painter.setRenderHint(QPainter::Antialiasing, isFine);
  int coordinate = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const MotionCurve& curve = m_sheet.curves[i];
    coordinate = curve.isComponent ? coordinate + 1 : 0;
    QPen pen(inkOf(curve), curve.isComponent ? 1.2 : 2.0);
    constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    if (isFine) pen.setStyle(kStyles[coordinate % 4]);
    if (!isFine) pen.setWidth(1);
    painter.setPen(pen);
    painter.drawPolyline(lines[i]);
  }
  painter.restore();
}

void MotionPlot::paintMoments(QPainter& painter) const {
  const QRectF inside = area();
  const QColor accent = qColor(ColorRole::accent, themeOf(palette()));
  const auto line = [&](double time, const QColor& colour, Qt::PenStyle style) {
    if (time < m_times.low || time > m_times.high) return;
    painter.setPen(QPen(colour, 1, style));
    const double x = placeOf(time, 0).x();
    painter.drawLine(QPointF(x, inside.top()), QPointF(x, inside.bottom()));
  };
  line(m_time, accent, Qt::SolidLine);
  if (m_pointed) line(*m_pointed, palette().color(QPalette::Text), Qt::DotLine);
}

void MotionPlot::paintLegend(QPainter& painter) const {
  const QRectF inside = area();
  if (inside.right() > width() - scaledPixels(kLegend) / 2) return;
  const double whole = width() - inside.right();
  const double time = m_pointed.value_or(std::clamp(m_time, 0.0, m_sheet.times.back()));
  const double row = painter.fontMetrics().height() + 1;
  double y = inside.top();
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(QRectF(inside.right() + 12, 2, whole - 16, scaledPixels(kTop) - 4),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("at %1 s").arg(text(time)));
  int coordinate = 0;
  for (const MotionCurve& curve : m_sheet.curves) {
    coordinate = curve.isComponent ? coordinate + 1 : 0;
    if (y + row > height()) break;
    constexpr Qt::PenStyle kStyles[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    painter.setPen(QPen(inkOf(curve), 2, kStyles[coordinate % 4]));
    painter.drawLine(QPointF(inside.right() + 12, y + row / 2), QPointF(inside.right() + 30, y + row / 2));
    painter.setPen(palette().color(QPalette::Text));
    const QString value = text(valueAt(curve, time), 4);
    const QRectF line(inside.right() + 34, y, whole - 42, row);
    const double room = line.width() - painter.fontMetrics().horizontalAdvance(value) - 6;
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, value);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     shortened(QString::fromStdString(curve.name), qRound(room), painter.fontMetrics()));
    y += row;
  }
}

void MotionPlot::moveTimes(double low, double size) {
  const double whole = m_sheet.times.empty() ? 1 : m_sheet.times.back();
  const double kept = std::clamp(size, kNearest * whole, whole);
  m_times.low = std::clamp(low, 0.0, whole - kept);
  m_times.high = m_times.low + kept;
  update();
}

void MotionPlot::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(kZoomPerNotch, -event->angleDelta().y() / 120.0);
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    const double part = (area().bottom() - event->position().y()) / area().height();
    const double at = m_values.low + part * m_values.size(), size = factor * m_values.size();
    m_values = {at - part * size, at + (1 - part) * size};
    update();
  } else {
    const double at = timeAt(event->position().x()), part = (at - m_times.low) / m_times.size();
    moveTimes(at - part * factor * m_times.size(), factor * m_times.size());
  }
  event->accept();
}

void MotionPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_pressed = event->position();
  m_lowAtPress = m_times.low;
  m_dragged = false;
}

void MotionPlot::mouseMoveEvent(QMouseEvent* event) {
  if (m_pressed) {
    const double moved = event->position().x() - m_pressed->x();
    m_dragged = m_dragged || std::abs(moved) >= kDragBegins;
    if (m_dragged) moveTimes(m_lowAtPress - moved / area().width() * m_times.size(), m_times.size());
    return;
  }
  const double whole = m_sheet.times.empty() ? 0 : m_sheet.times.back();
  m_pointed.reset();
  if (area().contains(event->position()) && whole > 0)
    m_pointed = std::clamp(timeAt(event->position().x()), 0.0, whole);
  update();
}

void MotionPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !m_pressed) return;
  m_pressed.reset();
  if (!m_dragged && area().contains(event->position())) emit timeWanted(timeAt(event->position().x()));
}

void MotionPlot::mouseDoubleClickEvent(QMouseEvent*) {
  showAll();
}

void MotionPlot::leaveEvent(QEvent*) {
  m_pointed.reset();
  update();
}

}  // namespace geargraph

#include "moc_motion_plot.cpp"
